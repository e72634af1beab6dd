//! `f`: what the shapes after it are made of.

use super::statement::Statement;
use crate::{Error, Material};

/// Reads a material. Opaque ones carry an index of refraction of 0 in real files; it means nothing there, and is
/// taken for 1.
pub(super) fn fill(name: String, mut statement: Statement) -> Result<Material, Error> {
    let color = [statement.fraction()?, statement.fraction()?, statement.fraction()?];
    let (diffuse, specular) = (statement.fraction()?, statement.fraction()?);
    let (shininess, transmit) = (statement.not_negative()?, statement.fraction()?);
    let ior = statement.number()?;
    if transmit > 0.0 && ior.value <= 0.0 {
        return Err(statement.impossible(ior.place, "must be above 0 where light is transmitted"));
    }
    Ok(Material {
        name,
        color,
        ambient: 0.0,
        diffuse,
        specular,
        shininess,
        mirror: specular,
        transmit,
        ior: if transmit > 0.0 { ior.value } else { 1.0 },
        texture: None,
    })
}

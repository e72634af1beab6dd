//! `[material.NAME]`

use std::collections::HashMap;

use super::key::{Key, key, listed, meant};
use super::texture::texture;
use super::value::{Value, shown};
use crate::assets::Assets;
use crate::{Error, Material};

const KEYS: &[Key] = &[
    key("color", "[1.0, 1.0, 1.0]"),
    key("ambient", "0.1"),
    key("diffuse", "0.9"),
    key("specular", "0.2"),
    key("shininess", "32.0"),
    key("mirror", "0.2"),
    key("transmit", "0.5"),
    key("ior", "1.5"),
    key("texture", "{ checker = [[1, 1, 1], [0, 0, 0]], scale = 1.0 }"),
];

/// The materials of a scene, and the place of each among them by its name.
#[derive(Default)]
pub(super) struct Materials<'t> {
    pub(super) all: Vec<Material>,
    pub(super) places: HashMap<&'t str, usize>,
}

impl<'t> Materials<'t> {
    /// What `[material.…]` tables say, in the order of the file.
    pub(super) fn read(value: Value<'t>, assets: &mut Assets) -> Result<Materials<'t>, Error> {
        let mut materials = Materials::default();
        let mut entries: Vec<_> = value.entries()?.iter().collect();
        entries.sort_by_key(|(name, _)| name.span().start);
        for (name, entry) in entries {
            materials.places.insert(name.get_ref(), materials.all.len());
            materials.all.push(material(name.get_ref(), value.entry(name, entry), assets)?);
        }
        Ok(materials)
    }

    /// What to write instead of a name that no material has.
    pub(super) fn instead_of(&self, name: &str) -> String {
        let bare = !name.is_empty()
            && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"-_".contains(&byte));
        let describe = match bare {
            true => format!("describe it under {}", shown(&format!("[material.{name}]"))),
            false => format!("describe it under {}", shown(&format!("[material.{name:?}]"))),
        };
        let names = || self.all.iter().map(|material| material.name.as_str());
        match meant(name, names()) {
            Some(meant) => format!("write {}", shown(&format!("material = {meant:?}"))),
            None if self.all.is_empty() => describe,
            None => format!("write one of {}, or {describe}", listed(names().take(20))),
        }
    }
}

fn material(name: &str, value: Value, assets: &mut Assets) -> Result<Material, Error> {
    let table = value.table("material", KEYS)?;
    let texture = table.find("texture").map(|value| Ok(value.at(texture(value, assets)?)));
    Ok(Material {
        name: name.to_string(),
        color: table.or("color", [1.0; 3], Value::color)?,
        ambient: table.or("ambient", 0.1, Value::fraction)?,
        diffuse: table.or("diffuse", 0.9, Value::fraction)?,
        specular: table.or("specular", 0.0, Value::fraction)?,
        shininess: table.or("shininess", 32.0, Value::not_negative)?,
        mirror: table.or("mirror", 0.0, Value::fraction)?,
        transmit: table.or("transmit", 0.0, Value::fraction)?,
        ior: table.or("ior", 1.0, Value::positive)?,
        texture: texture.transpose()?,
    })
}

//! `l`: a point light.

use super::statement::Statement;
use crate::{At, Error, Light};

/// A light whose color may depend on how many there are.
pub(super) struct RawLight {
    position: At<[f64; 3]>,
    color: Option<[f64; 3]>,
}

/// Reads a light. A number after its position is the first of a color; any other word is the next keyword.
pub(super) fn light(mut statement: Statement) -> Result<RawLight, Error> {
    let position = statement.point()?;
    let colored = statement.words.peek().is_some_and(|word| word.text.parse::<f64>().is_ok());
    let color = if colored { Some(statement.radiance()?) } else { None };
    Ok(RawLight { position, color })
}

/// All lights of a file: n of them have intensity 1/√n where they say nothing else.
pub(super) fn lights(raw: Vec<RawLight>) -> Vec<Light> {
    let silent = 1.0 / (raw.len() as f64).sqrt();
    let light = |RawLight { position, color }| Light { position, intensity: color.unwrap_or([silent; 3]) };
    raw.into_iter().map(light).collect()
}

//! `[[light]]`

use super::key::{Key, key};
use super::value::Value;
use crate::{Error, Light};

const KEYS: &[Key] = &[key("position", "[5.0, 10.0, -5.0]"), key("intensity", "[1.0, 1.0, 1.0]")];

pub(super) fn light(value: Value) -> Result<Light, Error> {
    let table = value.table("light", KEYS)?;
    let position = table.get("position")?;
    let intensity = table.get("intensity")?.radiance()?;
    Ok(Light { position: position.at(position.numbers()?), intensity })
}

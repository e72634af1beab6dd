//! Scenes in TOML, as the contract describes them.

mod camera;
mod id;
mod key;
mod light;
mod material;
mod number;
mod object;
mod shape;
mod table;
mod texture;
mod transform;
mod value;

use std::sync::Arc;

use ::toml::de::DeTable;

use crate::assets::Assets;
use crate::source::Source;
use crate::{Error, Scene};
use camera::camera;
use id::Ids;
use key::{Key, key};
use light::light;
use material::Materials;
use object::object;
use table::Table;
use value::Value;

use value::one_line;
pub(crate) use value::shown;

const KEYS: &[Key] = &[
    key("max_depth", "5"),
    key("background", "[1.0, 1.0, 1.0]"),
    key("ambient", "[1.0, 1.0, 1.0]"),
    key("camera", "[camera]"),
    key("light", "[[light]]"),
    key("material", "[material.red]"),
    key("object", "[[object]]"),
];

/// Reads a scene in TOML and the meshes and pictures that it names.
pub(crate) fn scene(source: Source, assets: &mut Assets) -> Result<Scene, Error> {
    let source = Arc::new(source);
    let document = DeTable::parse(&source.text).map_err(|error| not_toml(&source, &error))?;
    let table = Table::new(source.spot(0..0), "scene", KEYS, document.get_ref())?;

    let max_depth = table.or("max_depth", 5, max_depth)?;
    let background = table.or("background", [0.0; 3], Value::radiance)?;
    let ambient = table.or("ambient", [1.0; 3], Value::radiance)?;
    let camera = camera(table.get("camera")?)?;
    let lights = table.or("light", Vec::new(), |lights| lights.items()?.map(light).collect())?;
    let materials = table.or("material", Materials::default(), |value| Materials::read(value, assets))?;
    let mut ids = Ids::default();
    let objects = table.or("object", Vec::new(), |objects| {
        objects.items()?.map(|value| object(value, &materials, &mut ids, assets)).collect()
    })?;
    let materials = materials.all;
    Ok(Scene { max_depth, background, ambient, camera, lights, materials, objects, source: source.clone() })
}

fn max_depth(value: Value) -> Result<u32, Error> {
    match value.whole()? {
        depth @ 1..=1000 => Ok(depth as u32),
        _ => Err(value.impossible("must be 1 to 1000")),
    }
}

/// An error of the TOML reader, which says itself what it expects.
fn not_toml(source: &Source, error: &::toml::de::Error) -> Error {
    let message = one_line(error.message());
    let (problem, remedy) = match message.split_once(", expected ") {
        Some((problem, expected)) => (problem, format!("write {expected}")),
        None => (&*message, "see https://toml.io for how TOML is written".to_string()),
    };
    source.spot(error.span().unwrap_or(0..0)).fault(&format!("this is no TOML: {problem}"), &remedy)
}

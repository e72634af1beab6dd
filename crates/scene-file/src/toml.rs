//! Scenes in TOML.
//!
//! The `toml` crate gives a tree of values with their places, and the tree is walked by hand: each table here is a list
//! of its keys with a value that would do ([`key::Key`]), from which both the checks and the words of an error come.
//! Structs derived with serde would be shorter; their errors know neither the key that was meant nor what to write.

mod camera;
mod id;
mod key;
mod light;
mod material;
mod number;
mod object;
mod shape;
mod size;
mod syntax;
mod table;
mod texture;
mod transform;
mod value;

use std::sync::Arc;

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

pub(crate) use value::{one_line, shown};

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
    let document = syntax::parse(&source)?;
    let table = Table::new(source.spot(0..0), "scene", KEYS, &document)?;

    let max_depth = table.or("max_depth", 5, max_depth)?;
    let background = table.or("background", [0.0; 3], Value::radiance)?;
    let ambient = table.or("ambient", [1.0; 3], Value::radiance)?;
    let camera = camera(table.find("camera").ok_or_else(|| no_camera(&source))?)?;
    let lights = table.or("light", Vec::new(), |lights| lights.items()?.map(light).collect())?;
    let materials = table.or("material", Materials::default(), |value| Materials::read(value, assets))?;
    let mut ids = Ids::default();
    let objects = table.or("object", Vec::new(), |objects| {
        objects.items()?.map(|value| object(value, &materials, &mut ids, assets)).collect()
    })?;
    let materials = materials.all;
    Ok(Scene { max_depth, background, ambient, camera, lights, materials, objects, source: source.clone() })
}

fn no_camera(source: &Source) -> Error {
    let remedy = "write `[camera]`, and below it `eye = [0.0, 1.0, -6.0]` and `look_at = [0.0, 0.5, 0.0]`";
    source.spot(0..0).fault("this scene has no camera", remedy)
}

fn max_depth(value: Value) -> Result<u32, Error> {
    match value.whole()? {
        depth @ 1..=1000 => Ok(depth as u32),
        _ => Err(value.impossible("must be 1 to 1000")),
    }
}

//! `[[object]]`

use super::id::Ids;
use super::key::{Key, key, listed};
use super::material::Materials;
use super::shape::{SHAPES, shape};
use super::table::Table;
use super::transform::transform;
use super::value::{Value, shown};
use crate::assets::Assets;
use crate::{Error, Object, Shape};

/// A shape first: see [`SHAPES`].
const KEYS: &[Key] = &[
    SHAPES[0],
    SHAPES[1],
    SHAPES[2],
    SHAPES[3],
    SHAPES[4],
    SHAPES[5],
    SHAPES[6],
    key("material", "\"red\""),
    key("transform", "[{ scale = [2, 1, 1] }, { translate = [0, 0, 5] }]"),
    key("id", "3"),
];

pub(super) fn object<'t>(
    value: Value<'t>,
    materials: &Materials,
    ids: &mut Ids<'t>,
    assets: &mut Assets,
) -> Result<Object, Error> {
    let table = value.table("object", KEYS)?;
    let id = ids.next(&table)?;
    let which = only_shape(&table)?;
    let shape = shape(which, assets)?;
    let transform = table.or("transform", Vec::new(), transform)?;
    let material = material(&table, materials, &shape, which.key)?;
    Ok(Object { place: which.whole_place(), id: Some(id), shape, transform, material })
}

/// The one shape of an object.
fn only_shape<'t>(table: &Table<'t>) -> Result<Value<'t>, Error> {
    let mut shapes: Vec<Value> = SHAPES.iter().filter_map(|key| table.find(key.name)).collect();
    shapes.sort_by_key(|shape| shape.whole_place().start);
    match shapes[..] {
        [shape] => Ok(shape),
        [] => {
            let remedy = format!(
                "write {}, or another of {}",
                SHAPES[0].sample(),
                listed(SHAPES.iter().map(|s| s.name))
            );
            Err(table.spot.fault("this object has no shape", &remedy))
        }
        [_, second, ..] => {
            let names: Vec<_> = shapes.iter().map(|shape| shape.key.name).collect();
            let problem = format!("this object has more than one shape: {}", listed(names));
            Err(second.key_spot.fault(&problem, "write an `[[object]]` for each"))
        }
    }
}

/// The place of the material among all, if the shape can bear it.
fn material(table: &Table, materials: &Materials, shape: &Shape, key: Key) -> Result<usize, Error> {
    let value = table.get("material")?;
    let name = value.word()?;
    let Some(&place) = materials.places.get(name) else {
        return Err(value
            .spot
            .fault(&format!("there is no material {}", shown(name)), &materials.instead_of(name)));
    };
    let has_uv = matches!(shape, Shape::Plane { .. } | Shape::Sphere { .. } | Shape::Triangle { .. });
    match &materials.all[place].texture {
        Some(texture) if !has_uv => {
            let texture = value.spot.source.spot(texture.place);
            let (name, shape, line) = (shown(name), key.name, texture.line());
            let problem =
                format!("the material {name} has a texture (line {line}), and a {shape} no (u, v) for it");
            let remedy = "write a material without a texture; planes, spheres and triangles can bear one";
            Err(value.spot.clash(&problem, remedy, texture, "the texture"))
        }
        _ => Ok(place),
    }
}

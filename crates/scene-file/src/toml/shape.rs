//! The shapes of an object.

use super::key::{Key, key};
use super::value::Value;
use crate::assets::Assets;
use crate::{Error, Shape};

/// The shapes by the keys that an object has for them.
pub(super) const SHAPES: &[Key] = &[
    key("sphere", "{ center = [0.0, 1.0, 0.0], radius = 1.0 }"),
    key("plane", "{ point = [0, 0, 0], normal = [0, 1, 0] }"),
    key("triangle", "{ vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]] }"),
    key("polygon", "{ vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }"),
    key("cylinder", "{}"),
    key("cone", "{}"),
    key("mesh", "{ file = \"teapot.obj\" }"),
];

const SPHERE: &[Key] = &[key("center", "[0.0, 1.0, 0.0]"), key("radius", "1.0")];
const PLANE: &[Key] = &[key("point", "[0.0, 0.0, 0.0]"), key("normal", "[0.0, 1.0, 0.0]")];
const TRIANGLE: &[Key] = &[key("vertices", "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]")];
const POLYGON: &[Key] = &[key("vertices", "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]")];
const MESH: &[Key] = &[key("file", "\"teapot.obj\""), key("smooth", "true")];

pub(super) fn shape(value: Value, assets: &mut Assets) -> Result<Shape, Error> {
    match value.key.name {
        "sphere" => {
            let sphere = value.table("sphere", SPHERE)?;
            let center = sphere.get("center")?.numbers()?;
            Ok(Shape::Sphere { center, radius: sphere.get("radius")?.positive()? })
        }
        "plane" => {
            let plane = value.table("plane", PLANE)?;
            let point = plane.get("point")?.numbers()?;
            Ok(Shape::Plane { point, normal: plane.get("normal")?.direction()? })
        }
        "triangle" => triangle(value.table("triangle", TRIANGLE)?.get("vertices")?),
        "polygon" => polygon(value.table("polygon", POLYGON)?.get("vertices")?),
        "cylinder" => value.table("cylinder", &[]).map(|_| Shape::Cylinder),
        "cone" => value.table("cone", &[]).map(|_| Shape::Cone),
        _ => {
            let mesh = value.table("mesh", MESH)?;
            let file = mesh.get("file")?;
            let smooth = mesh.or("smooth", false, Value::yes)?;
            Ok(Shape::Mesh { mesh: assets.mesh(file.word()?, file.spot)?, smooth })
        }
    }
}

/// Three corners. Whether they span an area is decided by whoever meets the triangle; a corner that comes twice is
/// seen here.
fn triangle(value: Value) -> Result<Shape, Error> {
    let [a, b, c] = value.exactly()?;
    let vertices = [a.numbers()?, b.numbers()?, c.numbers()?];
    for (value, i, j) in [(b, 0, 1), (c, 0, 2), (c, 1, 2)] {
        if vertices[i] == vertices[j] {
            let remedy = "write three different corners";
            return Err(value.spot.fault("this triangle has the same corner twice", remedy));
        }
    }
    Ok(Shape::Triangle { vertices })
}

fn polygon(value: Value) -> Result<Shape, Error> {
    let vertices = value.points()?;
    match vertices.len() {
        0..3 => Err(value.impossible("must have 3 corners or more")),
        _ => Ok(Shape::Polygon { vertices }),
    }
}

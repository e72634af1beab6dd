//! `s`, `c`, `p` and `pp`: the shapes.

use super::statement::Statement;
use crate::{At, Error, Shape};

/// Reads a shape. Whether the corners of a polygon are in one plane, or in one line, is for whoever meets it.
pub(super) fn shape(statement: &mut Statement) -> Result<Shape, Error> {
    match statement.name() {
        "s" => {
            let center = statement.point()?.value;
            let radius = statement.number()?;
            match radius.value > 0.0 {
                true => Ok(Shape::Sphere { center, radius: radius.value }),
                false => Err(statement.impossible(radius.place, "must be above 0")),
            }
        }
        "c" => cone(statement),
        "p" => {
            let count = corners(statement, 3)?;
            let mut vertices = Vec::with_capacity(count);
            for _ in 0..count {
                vertices.push(statement.point()?.value);
            }
            Ok(Shape::Polygon { vertices })
        }
        _ => {
            let count = corners(statement, 6)?;
            let (mut vertices, mut normals) = (Vec::with_capacity(count), Vec::with_capacity(count));
            for _ in 0..count {
                vertices.push(statement.point()?.value);
                normals.push(statement.point()?.value);
            }
            Ok(Shape::Patch { vertices, normals })
        }
    }
}

fn cone(statement: &mut Statement) -> Result<Shape, Error> {
    let base = statement.point()?.value;
    let base_radius = statement.not_negative()?;
    let apex = statement.point()?;
    let apex_radius = statement.not_negative()?;
    if base_radius == 0.0 && apex_radius == 0.0 {
        return Err(statement.refused(statement.place(), "one of the two radii must be above 0"));
    }
    if base == apex.value {
        return Err(statement.refused(apex.place, "the second end must not be where the first is"));
    }
    Ok(Shape::OpenCone { base, base_radius, apex: apex.value, apex_radius })
}

/// The number of corners, which the rest of the file is long enough to hold: every corner takes so many numbers, and
/// every number a blank and a digit.
fn corners(statement: &mut Statement, numbers: usize) -> Result<usize, Error> {
    let At { value, place } = statement.count()?;
    if value < 3 {
        return Err(statement.impossible(place, "must be 3 or more"));
    }
    let most = statement.words.rest().len() / (2 * numbers);
    match usize::try_from(value) {
        Ok(count) if count <= most => Ok(count),
        _ => Err(statement.impossible(
            place,
            &format!("must be {most} at most, as the rest of the file has room for no more corners"),
        )),
    }
}

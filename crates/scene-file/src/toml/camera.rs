//! `[camera]`

use super::key::{Key, key};
use super::table::Table;
use super::value::Value;
use crate::limits::PIXELS;
use crate::{At, Camera, Error, Extent, Grid, Handedness, View};

const KEYS: &[Key] = &[
    key("eye", "[0.0, 1.0, -6.0]"),
    key("look_at", "[0.0, 0.5, 0.0]"),
    key("forward", "[0.0, 0.0, 1.0]"),
    key("up", "[0.0, 1.0, 0.0]"),
    key("handedness", "\"right\""),
    key("distance", "1.0"),
    key("window", "[-0.5, 0.5, -0.5, 0.5]"),
    key("size", "[640, 480]"),
    key("grid", "\"centers\""),
];

pub(super) fn camera(value: Value) -> Result<Camera, Error> {
    let table = value.table("camera", KEYS)?;
    let eye = table.get("eye")?;
    let eye = eye.at(eye.numbers()?);
    let view = view(&table)?;
    let up = table.at_or("up", [0.0, 1.0, 0.0], Value::direction)?;
    let hands = [("right", Handedness::Right), ("left", Handedness::Left)];
    let handedness = table.or("handedness", Handedness::Right, |word| word.one_of(&hands))?;
    let distance = table.at_or("distance", 1.0, Value::positive)?;
    let extent = table.at_or("window", Extent::Height1, window)?;
    let size = table.at_or("size", (640, 480), size)?;
    let grids = [("centers", Grid::Centers), ("edges", Grid::Edges), ("lattice", Grid::Lattice)];
    let grid = table.at_or("grid", Grid::Centers, |word| word.one_of(&grids))?;
    if let (Grid::Edges, (1, _) | (_, 1), Some(value)) = (grid.value, size.value, table.find("size")) {
        let problem = "the grid `edges` needs at least two columns and two rows";
        let remedy = "write a larger size, or `grid = \"centers\"`";
        let grid = value.spot.source.spot(grid.place);
        return Err(value.spot.clash(problem, remedy, grid, "the grid"));
    }
    Ok(Camera { place: table.spot.place, eye, view, up, handedness, distance, extent, size, grid })
}

fn view(table: &Table) -> Result<At<View>, Error> {
    match (table.find("look_at"), table.find("forward")) {
        (Some(point), None) => Ok(point.at(View::At(point.numbers()?))),
        (None, Some(along)) => Ok(along.at(View::Forward(along.direction()?))),
        (Some(point), Some(along)) => {
            let remedy = "keep one of the two: `look_at` is a point, `forward` is a direction";
            let problem = "this camera has both `look_at` and `forward`";
            Err(along.key_spot.clash(problem, remedy, point.key_spot, "the other one"))
        }
        (None, None) => {
            let problem = "this camera has neither `look_at` nor `forward`";
            Err(table
                .spot
                .fault(problem, "write `look_at = [0.0, 0.5, 0.0]`, the point in the middle of the picture"))
        }
    }
}

fn window(value: Value) -> Result<Extent, Error> {
    let [left, right, bottom, top] = value.numbers()?;
    if left >= right {
        return Err(value.impossible("must have its left below its right"));
    }
    if bottom >= top {
        return Err(value.impossible("must have its bottom below its top"));
    }
    Ok(Extent::Window([left, right, bottom, top]))
}

fn size(value: Value) -> Result<(u32, u32), Error> {
    let mut counts = [0; 2];
    for (count, item) in counts.iter_mut().zip(value.exactly::<2>()?) {
        *count = u32::try_from(item.whole()?).unwrap_or(0);
        if !(1..=PIXELS).contains(&u64::from(*count)) {
            return Err(item.impossible("must be 1 to 2^28 pixels either way"));
        }
    }
    let [width, height] = counts;
    if u64::from(width) * u64::from(height) > PIXELS {
        return Err(value.impossible("must be at most 2^28 pixels in all"));
    }
    Ok((width, height))
}

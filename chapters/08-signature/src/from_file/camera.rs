//! The camera of a scene file.

use math::{Camera, Degenerate, Grid, Handedness, Real, Vector, Window, portable};
use scene_file::{Error, Extent, Scene, View};

use super::{or_f64, vector};

/// The camera for a picture of `size` pixels, and its grid.
pub(super) fn camera<R: Real>(file: &Scene, size: (u32, u32)) -> Result<(Camera<R>, Grid), Error> {
    let it = &file.camera;
    let eye = vector::<R>(it.eye.value);
    let forward = match it.view.value {
        View::At(point) => {
            let [from, to] = [it.eye.value, point];
            vector::<R>(std::array::from_fn(|axis| to[axis] - from[axis]))
        }
        View::Forward(direction) => vector::<R>(direction),
    };
    let up = vector::<R>(it.up.value);
    let distance = R::round_from(it.distance.value);
    let window = window::<R>(it.extent.value, it.distance.value, size);
    let handedness = match it.handedness {
        scene_file::Handedness::Right => Handedness::Right,
        scene_file::Handedness::Left => Handedness::Left,
    };
    let grid = match it.grid.value {
        scene_file::Grid::Centers => Grid::Centers,
        scene_file::Grid::Edges => Grid::Edges,
        scene_file::Grid::Lattice => Grid::Lattice,
    };
    if grid.point(&window, size, (0, 0)).is_err() {
        return Err(file.fault(
            it.grid.place,
            "the grid `edges` divides by width − 1 and height − 1",
            "ask for at least two columns and two rows, or take the grid `centers`",
        ));
    }

    let camera = Camera::looking(eye, forward, up, handedness, distance, window);
    let camera = camera.map_err(|degenerate| match degenerate {
        Degenerate::NotFinite => {
            let problem = format!("a number of the camera is too large for {}", R::NAME);
            file.fault(it.place, &problem, &or_f64::<R>("make it smaller"))
        }
        _ if forward.is_zero() => file.fault(
            it.view.place,
            "the camera looks nowhere: this is where the eye is",
            "write another point, or move the eye",
        ),
        _ => file.fault(
            it.up.place,
            "`up` runs along the way the camera looks: nothing says what is up in the picture",
            &format!("write an `up` that points to the side of it, such as `{}`", aside::<R>(forward)),
        ),
    })?;
    // what overflows does so at an end of the grid, if not in between
    let ends = [(0, 0), (size.0.saturating_sub(1), size.1.saturating_sub(1))]
        .map(|pixel| grid.point(&window, size, pixel));
    let is_ray = |end: &Result<(R, R), _>| end.as_ref().is_ok_and(|end| camera.ray(*end).check().is_ok());
    if distance <= R::from(0.0) || !ends.iter().all(is_ray) {
        return Err(file.fault(
            it.distance.place,
            &format!("the rays through the window at this distance are none in {}", R::NAME),
            &or_f64::<R>("take numbers that are neither so small nor so large"),
        ));
    }
    Ok((camera, grid))
}

/// The axis that is farthest from a direction.
fn aside<R: Real>(direction: R::Vec3) -> &'static str {
    let [x, y, z] = direction.in_f64().map(f64::abs);
    if y <= x && y <= z {
        "[0.0, 1.0, 0.0]"
    } else if z <= x {
        "[0.0, 0.0, 1.0]"
    } else {
        "[1.0, 0.0, 0.0]"
    }
}

/// The part of the view plane that is seen.
fn window<R: Real>(extent: Extent, distance: f64, size: (u32, u32)) -> Window<R> {
    match extent {
        Extent::Height1 => Window::around_axis(R::from(1.0), size),
        Extent::Window(window) => {
            let [left, right, bottom, top] = window.map(R::round_from);
            Window { left, right, bottom, top }
        }
        // half of it is above the axis
        Extent::Angle(degrees) => {
            let height = 2.0 * distance * portable::tan((degrees / 2.0).to_radians());
            Window::around_axis(R::round_from(height), size)
        }
    }
}

//! `balls`, the sphere flake: nine balls sit on each ball, a third as large, down to a level.

use std::f64::consts::{PI, SQRT_2};

use crate::nff::{Nff, Point, View};
use crate::turn::{about, about_z, cross, plus, times};

/// 1 + 9 + … + 9^level balls on a square: 7381 at level 4, which is Haines's own.
pub(crate) fn balls(level: u32) -> String {
    let lights = [[4.0, 3.0, 2.0], [1.0, -4.0, 4.0], [-3.0, 1.0, 5.0]];
    let view =
        View { from: [2.1, 1.3, 1.7], at: [0.0; 3], up: [0.0, 0.0, 1.0], hither: 0.01, lights: &lights };
    let mut nff = Nff::new(&view);
    nff.material([1.0, 0.75, 0.33], [0.8, 0.0, 100_000.0, 0.0, 1.0]);
    nff.polygon(&[[12.0, 12.0, -0.5], [-12.0, 12.0, -0.5], [-12.0, -12.0, -0.5], [12.0, -12.0, -0.5]]);
    nff.material([1.0, 0.9, 0.7], [0.5, 0.5, 3.0827, 0.0, 1.0]);
    grow(&mut nff, &nine(), level, [0.0; 3], 0.5, [0.0, 0.0, 1.0]);
    nff.text()
}

/// The ways from the middle of a ball to those that sit on it, for a ball that itself sits in the direction
/// z: three around the top, six around the middle. Neighbors in a plane of balls as close as they can be,
/// tilted upright.
fn nine() -> [Point; 9] {
    let side = 1.0 / SQRT_2;
    let three = [[side, side, 0.0], [side, 0.0, -side], [0.0, side, -side]];
    let upright = (2.0 / 6.0_f64.sqrt()).asin();
    let three = three.map(|way| about([1.0, -1.0, 0.0], upright, way));
    std::array::from_fn(|at| about_z((at / 3) as f64 * 2.0 * PI / 3.0, three[at % 3]))
}

fn grow(nff: &mut Nff, nine: &[Point; 9], level: u32, center: Point, radius: f64, direction: Point) {
    nff.sphere(center, radius);
    if level == 0 {
        return;
    }
    for way in nine {
        let way = from_z_to(direction, *way);
        let child = plus(center, times(way, radius * (1.0 + 1.0 / 3.0)));
        grow(nff, nine, level - 1, child, radius / 3.0, way);
    }
}

/// Turned as z is turned the shortest way into a direction.
fn from_z_to(direction: Point, way: Point) -> Point {
    let (z, height) = ([0.0, 0.0, 1.0], direction[2]);
    let axis = cross(z, direction);
    // Haines's own limit; no direction of a flake is nearer to −z and not it
    if height >= 0.9999 {
        way
    } else if height <= -0.9999 {
        about([0.0, 1.0, 0.0], PI, way)
    } else {
        about(axis, height.acos(), way)
    }
}

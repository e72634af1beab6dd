//! `rings`: six pentagons of rods around a dodecahedron, and a pyramid of such cages before a wall.

use std::f64::consts::PI;

use crate::nff::{Nff, Point, View};
use crate::turn::{about_x, about_z, plus};

/// The radius of the rods and of the balls at their ends.
const RADIUS: f64 = 0.07412;
const COLORS: [Point; 6] =
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0]];

/// 1² + 2² + … + layers² cages of 30 rods and 30 balls: 4200 of each at 7 layers, which are Haines's own.
pub(crate) fn rings(layers: u32) -> String {
    // so far apart are layers that look 45 degrees wide
    let apart = 1.0 / (PI / 8.0).sin();
    let from = [-1.0, -apart, 0.5];
    let view = View {
        from,
        at: [-1.0, 1.0 - apart, 0.5],
        up: [0.0, 0.0, 1.0],
        hither: 1.0,
        lights: &[[3.0, -apart, 3.0], [-4.0, -apart, 1.0], [2.0, -apart, -4.0]],
    };
    let mut nff = Nff::new(&view);
    nff.material([1.0, 1.0, 1.0], [1.0, 0.0, 100_000.0, 0.0, 0.0]);
    // the wall is a little larger than the view
    let y = apart * f64::from(layers + 1);
    let half = 1.01 * (y - from[1]) * (PI / 8.0).tan();
    let corner = |x: f64, z: f64| [x * half + from[0], y, z * half + from[2]];
    nff.polygon(&[corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)]);

    let pentagons = pentagons();
    let place = |step: u32, layer: u32| 2.0 * f64::from(step) - f64::from(layer);
    for layer in 0..layers {
        for (row, col) in (0..=layer).flat_map(|row| (0..=layer).map(move |col| (row, col))) {
            let offset = [place(col, layer), apart * f64::from(layer + 1), place(row, layer)];
            for (pentagon, color) in pentagons.iter().zip(COLORS) {
                nff.material(color, [0.5, 0.2, 3.0827, 0.0, 0.0]);
                for at in 0..5 {
                    let [base, apex] = [at, (at + 4) % 5].map(|at| plus(pentagon[at], offset));
                    nff.cone((base, RADIUS), (apex, RADIUS));
                    nff.sphere(base, RADIUS);
                }
            }
        }
    }
    nff.text()
}

/// The pentagons in the faces of one half of a dodecahedron, the whole within a sphere of radius 1.
fn pentagons() -> [[Point; 5]; 6] {
    let scale = 1.0 / (1.0 + RADIUS);
    let level: [Point; 5] = std::array::from_fn(|at| {
        let (sin, cos) = (at as f64 * 2.0 * PI / 5.0).sin_cos();
        [scale * cos, scale * sin, 0.0]
    });
    // the angle between two neighboring faces of a dodecahedron
    let between = 2.0 * ((PI / 3.0).cos() / (PI / 5.0).sin()).acos();
    std::array::from_fn(|at| match at {
        0 => level,
        _ => level.map(|p| about_z(PI * (2.0 * (at - 1) as f64 + 1.0) / 5.0, about_x(between, p))),
    })
}

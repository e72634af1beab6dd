//! `tetra`: a tetrahedron of four tetrahedra of half its size, down to a level.

use crate::nff::{Nff, Point, View};
use crate::turn::{plus, times};

/// Four corners of a cube of side 2 that are all as far from each other.
const CORNERS: [Point; 4] = [[-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0], [1.0, 1.0, 1.0]];
/// The corners of each face.
const FACES: [[usize; 3]; 4] = [[0, 1, 2], [3, 2, 1], [2, 3, 0], [1, 0, 3]];

/// 4^level triangles: 4096 at level 6, which is Haines's own.
pub(crate) fn tetra(level: u32) -> String {
    let view = View {
        from: [1.022846, -3.177154, -2.174512],
        at: [-0.004103, -0.004103, 0.216539],
        up: [-0.816497, -0.816497, 0.816497],
        hither: 1.0,
        lights: &[[2.0, -18.0, -5.0]],
    };
    let mut nff = Nff::new(&view);
    nff.material([1.0, 0.2, 0.2], [1.0, 0.0, 100_000.0, 0.0, 0.0]);
    grow(&mut nff, level, [0.0; 3], 1.0);
    nff.text()
}

/// One tetrahedron has four triangles, which are a level.
fn grow(nff: &mut Nff, level: u32, center: Point, half: f64) {
    if level <= 1 {
        let corners = CORNERS.map(|corner| plus(center, times(corner, half)));
        FACES.iter().for_each(|face| nff.polygon(&face.map(|corner| corners[corner])));
        return;
    }
    for corner in CORNERS {
        grow(nff, level - 1, plus(center, times(corner, half / 2.0)), half / 2.0);
    }
}

//! Eight triangles side by side, as columns.

use math::Real;
use triangle::Triangle;

use super::node::{Column, LANES};

/// The corners of up to eight triangles.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Block<R> {
    /// By corner, then axis.
    corners: [[Column<R>; 3]; 3],
    /// Which faces they are.
    pub(crate) faces: Column<u32>,
}

impl<R: Real> Block<R> {
    /// Not more than eight faces, and not none; the last one fills what is left.
    pub(crate) fn of(faces: &[u32], triangle: &impl Fn(usize) -> Triangle<R>) -> Block<R> {
        let zero = [R::from(0.0); LANES];
        let mut block = Block { corners: [[zero; 3]; 3], faces: [0; LANES] };
        for lane in 0..LANES {
            let face = faces[lane.min(faces.len() - 1)];
            block.faces[lane] = face;
            for (corner, columns) in triangle(face as usize).corners().into_iter().zip(&mut block.corners) {
                let [x, y, z] = R::xyz(corner);
                (columns[0][lane], columns[1][lane], columns[2][lane]) = (x, y, z);
            }
        }
        block
    }

    /// One of them.
    #[inline(always)]
    pub(crate) fn triangle(&self, lane: usize) -> Triangle<R> {
        let [a, b, c] = &self.corners;
        Triangle { p1: get::<R>(a, lane), p2: get::<R>(b, lane), p3: get::<R>(c, lane) }
    }
}

#[inline(always)]
fn get<R: Real>([x, y, z]: &[Column<R>; 3], lane: usize) -> R::Vec3 {
    R::vec3(x[lane], y[lane], z[lane])
}

/// A bit for every lane whose number is not negative.
#[inline(always)]
pub(crate) fn not_negative<R: Real>(column: &Column<R>) -> u32 {
    let mut bits = 0;
    for (lane, &number) in column.iter().enumerate() {
        bits |= u32::from(number >= R::from(0.0)) << lane;
    }
    bits
}

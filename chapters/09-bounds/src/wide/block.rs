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

/// Some of eight lanes: two bits for each.
///
/// One would do. But a 1 that is chosen or not is a truth value, made a number and shifted to its place, and
/// the compiler, which knows that the first one need not be shifted, then goes lane by lane. A 3 is chosen by
/// an instruction that does it for all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LaneSet(u32);

impl LaneSet {
    /// Those whose number is not negative.
    #[inline(always)]
    pub(crate) fn not_negative<R: Real>(column: &Column<R>) -> LaneSet {
        let mut bits = 0;
        for (lane, &number) in column.iter().enumerate() {
            bits |= if number >= R::from(0.0) { 3 << (2 * lane) } else { 0 };
        }
        LaneSet(bits)
    }

    /// The first so many lanes.
    #[inline(always)]
    pub(crate) fn first(count: usize) -> LaneSet {
        LaneSet((1 << (2 * count)) - 1)
    }

    #[inline(always)]
    pub(crate) fn and(self, other: LaneSet) -> LaneSet {
        LaneSet(self.0 & other.0)
    }

    #[inline(always)]
    pub(crate) fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Takes the lowest lane out, or the highest. The set must not be empty.
    #[inline(always)]
    pub(crate) fn take(&mut self, lowest: bool) -> usize {
        let (low, high) = (self.0.trailing_zeros() / 2, (31 - self.0.leading_zeros()) / 2);
        let lane = if lowest { low } else { high };
        self.0 &= !(3 << (2 * lane));
        lane as usize % LANES
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_in_two_sets_is_in_both() {
        let one = |lane: usize| {
            let mut column = [-1.0; LANES];
            column[lane] = 0.5;
            LaneSet::not_negative::<f64>(&column)
        };
        assert_eq!(LaneSet::first(2).and(LaneSet::first(5)), LaneSet::first(2));
        assert_eq!(
            (LaneSet::first(2).and(one(1)), LaneSet::first(2).and(one(2))),
            (one(1), LaneSet::first(0))
        );
    }
}

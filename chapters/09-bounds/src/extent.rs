//! A box as the builder wants it: one kind of comparison for all faces.

use crate::Box3;

/// The low faces, and the high ones with the other sign: then the union of two is the smaller of each, which
/// two instructions do for all. (A number is left over on either side, so that they are four and four.)
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent([f32; 8]);

/// What stands in for an infinite face: the only finite number that is above the largest of a box. The sum of
/// two does not overflow.
const BEYOND: f32 = 1.5 * Box3::FARTHEST;

impl Extent {
    pub(crate) const EMPTY: Extent = Extent([f32::INFINITY; 8]);

    #[inline(always)]
    pub(crate) fn of(bounds: &Box3) -> Extent {
        let mut faces = [0.0; 8];
        for axis in 0..3 {
            faces[axis] = bounds.low[axis].max(-BEYOND);
            faces[axis + 4] = (-bounds.high[axis]).max(-BEYOND);
        }
        Extent(faces)
    }

    pub(crate) fn to_box(self) -> Box3 {
        let outward = |face: f32| if face == -BEYOND { f32::NEG_INFINITY } else { face };
        let [low, high] = [0, 4].map(|side| [0, 1, 2].map(|axis| outward(self.0[side + axis])));
        Box3 { low, high: high.map(|face| -face) }
    }

    #[inline(always)]
    pub(crate) fn union(&self, other: &Extent) -> Extent {
        let mut smaller = [0.0; 8];
        for (place, smaller) in smaller.iter_mut().enumerate() {
            *smaller = self.0[place].min(other.0[place]);
        }
        Extent(smaller)
    }

    /// A box of one point, twice the middle of this one.
    #[inline(always)]
    pub(crate) fn twice_middles(&self) -> Extent {
        let mut middle = [0.0; 8];
        for axis in 0..4 {
            let twice = self.0[axis] - self.0[axis + 4];
            middle[axis] = twice;
            middle[axis + 4] = -twice;
        }
        Extent(middle)
    }

    /// One number of it.
    #[inline(always)]
    pub(crate) fn twice_middle(&self, axis: usize) -> f32 {
        self.0[axis] - self.0[axis + 4]
    }

    /// The low faces.
    #[inline(always)]
    pub(crate) fn lows(&self) -> [f32; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }

    /// How long it is on each axis: high − low.
    #[inline(always)]
    pub(crate) fn size(&self) -> [f32; 3] {
        [0, 1, 2].map(|axis| -self.0[axis + 4] - self.0[axis])
    }

    /// Half the area of its surface.
    #[inline(always)]
    pub(crate) fn half_area(&self) -> f64 {
        let [x, y, z] = [
            f64::from(-self.0[4] - self.0[0]),
            f64::from(-self.0[5] - self.0[1]),
            f64::from(-self.0[6] - self.0[2]),
        ];
        x * y + y * z + z * x
    }
}

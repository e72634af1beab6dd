//! Axis-aligned boxes.
//!
//! A box need not fit to the last digit, it must only leave nothing out. So its faces are `f32`, whatever the
//! precision of what is in it, rounded outward: half the memory of `f64`, twice as many to a register, and
//! one box serves rays of both precisions.

use math::{Real, Vector};

/// The points from `low` to `high` on every axis, faces included. No number is NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Box3 {
    /// The smallest x, y and z. Minus infinity for what is beyond −2¹²⁶.
    pub low: [f32; 3],
    /// The largest x, y and z. Infinity for what is beyond 2¹²⁶.
    pub high: [f32; 3],
}

impl Box3 {
    /// 2¹²⁶: the largest finite face or origin. The difference of two such numbers does not overflow, so that
    /// a distance is infinite only where a face is.
    pub(crate) const FARTHEST: f32 = f32::from_bits((127 + 126) << 23);

    /// The box with nothing in it; united with another it is the other.
    pub const EMPTY: Box3 = Box3 { low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] };

    /// The smallest such box around points, [`Box3::EMPTY`] around none. A NaN among their numbers is passed
    /// over: refuse such a shape before.
    #[inline]
    pub fn around<R: Real>(points: impl IntoIterator<Item = R::Vec3>) -> Box3 {
        let around_one = |point: R::Vec3| {
            let point: [f64; 3] = point.in_f64();
            Box3 { low: point.map(rounded_down), high: point.map(rounded_up) }
        };
        points.into_iter().fold(Box3::EMPTY, |all, point| all.union(&around_one(point)))
    }

    /// The box around a sphere. c ∓ r is rounded once more than a point, so it goes to the next number
    /// outward first.
    #[inline]
    pub fn around_sphere<R: Real>(center: R::Vec3, radius: R) -> Box3 {
        let (c, r): ([f64; 3], f64) = (center.in_f64(), radius.into());
        Box3 {
            low: c.map(|c| rounded_down((c - r).next_down())),
            high: c.map(|c| rounded_up((c + r).next_up())),
        }
    }

    /// The smallest box with both in it.
    #[inline]
    pub fn union(&self, other: &Box3) -> Box3 {
        Box3 {
            low: std::array::from_fn(|axis| self.low[axis].min(other.low[axis])),
            high: std::array::from_fn(|axis| self.high[axis].max(other.high[axis])),
        }
    }

    /// Half the area of its surface: what a random ray is as likely to meet as this is large. Finite; zero
    /// for a box with nothing in it.
    ///
    /// In `f64`, where the square of an `f32` neither overflows nor vanishes; an infinite face is taken for a
    /// large number, as 0 · ∞ would be NaN.
    #[inline]
    pub fn half_area(&self) -> f64 {
        let size = |axis: usize| {
            let (low, high) = (self.low[axis].max(f32::MIN), self.high[axis].min(f32::MAX));
            (f64::from(high) - f64::from(low)).max(0.0)
        };
        let [x, y, z] = [0, 1, 2].map(size);
        x * y + y * z + z * x
    }
}

/// The largest `f32` that is not above x. (The smallest one that may be infinite: what is large stays below.)
#[inline(always)]
pub(crate) fn rounded_down(x: f64) -> f32 {
    let nearest = x as f32;
    let below = if f64::from(nearest) > x { nearest.next_down() } else { nearest };
    if below < -Box3::FARTHEST { f32::NEG_INFINITY } else { below.min(Box3::FARTHEST) }
}

/// The smallest `f32` that is not below x.
#[inline(always)]
pub(crate) fn rounded_up(x: f64) -> f32 {
    let nearest = x as f32;
    let above = if f64::from(nearest) < x { nearest.next_up() } else { nearest };
    if above > Box3::FARTHEST { f32::INFINITY } else { above.max(-Box3::FARTHEST) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec3, Vec3};

    #[test]
    fn a_point_of_f64_is_between_its_faces() {
        let third = 1.0 / 3.0;
        let around = Box3::around::<f64>([DVec3::new(third, -third, 0.5)]);
        // by hand: ⅓ lies between two f32, and ½ is one
        for axis in 0..2 {
            assert_eq!(around.low[axis].next_up(), around.high[axis]);
        }
        assert!(f64::from(around.low[0]) < third && third < f64::from(around.high[0]));
        assert_eq!((around.low[2], around.high[2]), (0.5, 0.5));
    }

    #[test]
    fn what_overflows_is_infinite_outward_only() {
        let around = Box3::around::<f64>([DVec3::new(1e300, -1e300, 5e-324)]);
        assert_eq!(around.low, [Box3::FARTHEST, f32::NEG_INFINITY, 0.0]);
        assert_eq!(around.high, [f32::INFINITY, -Box3::FARTHEST, f32::from_bits(1)]);
        let largest = Box3::around_sphere::<f32>(Vec3::ZERO, f32::MAX);
        assert_eq!((largest.low, largest.high), ([f32::NEG_INFINITY; 3], [f32::INFINITY; 3]));
    }

    /// 2¹²⁶ is a face, and the next number is beyond; inward, what is beyond is 2¹²⁶.
    #[test]
    fn the_farthest_face_is_finite() {
        let farthest = f64::from(Box3::FARTHEST);
        assert_eq!(farthest, 2.0_f64.powi(126));
        for (x, outward, inward) in [
            (farthest, Box3::FARTHEST, Box3::FARTHEST),
            (farthest.next_up(), f32::INFINITY, Box3::FARTHEST),
            (farthest.next_down(), Box3::FARTHEST, Box3::FARTHEST.next_down()),
            (f64::from(f32::MAX), f32::INFINITY, Box3::FARTHEST),
        ] {
            assert_eq!((rounded_up(x), rounded_down(x)), (outward, inward), "{x:e}");
            assert_eq!((rounded_down(-x), rounded_up(-x)), (-outward, -inward), "{x:e}");
        }
    }

    #[test]
    fn a_sphere_touches_its_box() {
        // by hand: 2 ∓ 1, and a neighbor outward as c ∓ r might have been rounded
        let around = Box3::around_sphere::<f64>(DVec3::splat(2.0), 1.0);
        assert_eq!((around.low, around.high), ([1.0_f32.next_down(); 3], [3.0_f32.next_up(); 3]));
    }

    #[test]
    fn an_area_is_a_number() {
        let of = |low, high| Box3 { low, high }.half_area();
        assert_eq!(of([0.0; 3], [1.0, 2.0, 3.0]), 11.0); // 2 + 6 + 3
        assert_eq!(Box3::EMPTY.half_area(), 0.0);
        assert!(of([0.0; 3], [0.0, f32::INFINITY, f32::INFINITY]).is_finite());
        assert_eq!(of([0.0, f32::NEG_INFINITY, 0.0], [0.0, f32::INFINITY, 0.0]), 0.0, "a line");
        assert!(of([0.0; 3], [1e-30; 3]) > 0.0, "1e−60 is no f32");
    }
}

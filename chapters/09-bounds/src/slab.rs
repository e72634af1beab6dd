//! Does a ray pass a box? A slab an axis, and never a wrong no.
//!
//! Between the two faces of an axis a ray is for t from (first − o) / d to (last − o) / d, where `first` is
//! the face that it meets first. It is in the box where it is in all three slabs: from the largest of the
//! three beginnings to the smallest of the three ends, and past it if that is no stretch. (This is chapter
//! 02's wall, three times.)
//!
//! Rounded, a stretch that is a point may seem to be none: a flat box, a ray along a face, a corner. Then a
//! hit would be lost. So the beginning is computed to be too small and the end too large, by no more than it
//! takes. All of it in `f32`, for rays of `f64` too. With u = 2⁻²⁴, the error of one operation, and a ray
//! upward (d > 0):
//!
//! - **The origin.** An `f64` is rounded up for the first face and down for the last, so that first − o is
//!   too small and last − o too large.
//! - **The difference** may be (1 + u) times too large, and has to be within that of too small as well. Sums
//!   need no care when they are tiny, and none overflows (see [`Box3`]).
//! - **One over d** is off by u and, rounded twice for `f64`, by 2⁻⁵³. Times 1 ∓ 4u, rounded once more, it
//!   makes up for that and for the difference. What is subnormal has no relative error; four times the
//!   smallest number is more than all the halves of it that were rounded.
//! - **The product** needs nothing. If x ≤ t, then x rounded is not above t rounded, and t rounded is not
//!   above y rounded if t ≤ y: rounding keeps an order. So the beginning is not above the end, where a true t
//!   is between them.
//!
//! Where that has the wrong sign it does not matter: a first face behind the origin gives a number below
//! zero, and t starts from zero anyway; a last face behind it is a miss.
//!
//! **d = 0** makes one over d infinite, and the slab all or nothing: ±∞ for faces apart from o, which is
//! right, and 0 · ∞ = NaN for a face at o. A ray within a face is in the box, so such a face must not decide
//! anything: each comparison is written so that NaN leaves the other number. The same goes for an infinite
//! face times zero.
//!
//! See Ize, *Robust BVH Ray Traversal* (2013), who widens the end alone and by 4u + 2u, as his rays are `f32`
//! and start outside.

use math::{Ray3, Real, Span};

use crate::Box3;
use crate::box3::{rounded_down, rounded_up};

/// A ray as boxes need it: one number to take from a face and one to multiply with.
#[derive(Clone, Copy, Debug)]
pub struct Slabs {
    /// Which face the ray meets first on each axis: 0 for the low one, 1 for the high one.
    pub first: [usize; 3],
    /// For the first face of each axis.
    pub enter: [Passage; 3],
    /// For the last face of each axis.
    pub leave: [Passage; 3],
}

/// t of a face is (face − origin) · inverse.
#[derive(Clone, Copy, Debug)]
pub struct Passage {
    /// o, rounded so that t is too small where the ray enters and too large where it leaves.
    pub origin: f32,
    /// 1/d in the same way.
    pub inverse: f32,
}

/// u, the relative error of one operation of `f32`.
const UNIT: f32 = f32::EPSILON / 2.0;
/// For a subnormal 1/d.
const SMALLEST: f32 = f32::from_bits(1);

impl Slabs {
    /// Works out what all boxes have in common. What it says of a ray that is not finite, or without
    /// direction, means nothing.
    #[inline(always)]
    pub fn new<R: Real>(ray: &Ray3<R>) -> Slabs {
        let (o, d) = (R::xyz(ray.origin), R::xyz(ray.direction));
        let mut slabs = Slabs { first: [0; 3], enter: [Passage::NONE; 3], leave: [Passage::NONE; 3] };
        for axis in 0..3 {
            let (o, inverse): (f64, f64) = (o[axis].into(), (R::from(1.0) / d[axis]).into());
            let inverse = inverse as f32;
            let is_backward = inverse.is_sign_negative();
            let (low, high) = (rounded_down(o), rounded_up(o));
            let (enter, leave) = if is_backward { (low, high) } else { (high, low) };
            let size = inverse.abs();
            let smaller = (size.min(f32::MAX) * (1.0 - 4.0 * UNIT) - 4.0 * SMALLEST).max(0.0);
            let larger = size * (1.0 + 4.0 * UNIT) + 4.0 * SMALLEST;
            slabs.first[axis] = usize::from(is_backward);
            slabs.enter[axis] = Passage { origin: enter, inverse: smaller.copysign(inverse) };
            slabs.leave[axis] = Passage { origin: leave, inverse: larger.copysign(inverse) };
        }
        slabs
    }

    /// t where the ray enters the box, not below `reach.min` and never too late; `None` where it surely
    /// passes the box by, or is in it outside `reach` only.
    #[inline(always)]
    pub fn enter(&self, bounds: &Box3, reach: Reach) -> Option<f32> {
        // exercise begin: Before any slab is looked at: from which t to which is the box of interest?
        let (mut near, mut far): (f32, f32) = (reach.min, reach.max);
        // end begin
        for axis in 0..3 {
            let faces = [bounds.low[axis], bounds.high[axis]];
            // exercise faces: Which of the two faces does the ray meet first, and which last?
            let (first, last): (f32, f32) = (faces[self.first[axis] & 1], faces[1 - (self.first[axis] & 1)]);
            // end faces
            // exercise stretch: The ray has to be in this slab and in those before: where does that begin and end?
            near = larger(self.enter[axis].t(first), near);
            far = smaller(self.leave[axis].t(last), far);
            // end stretch
        }
        // exercise verdict: When is there no stretch left, and where does the ray enter if there is one?
        (near <= far).then_some(near)
        // end verdict
    }
}

impl Passage {
    const NONE: Passage = Passage { origin: 0.0, inverse: 0.0 };

    #[inline(always)]
    pub(crate) fn t(&self, face: f32) -> f32 {
        (face - self.origin) * self.inverse
    }
}

/// The larger of two numbers: the other one where `t` is NaN.
#[inline(always)]
pub(crate) fn larger(t: f32, other: f32) -> f32 {
    if t > other { t } else { other }
}

/// The smaller of two numbers: the other one where `t` is NaN.
#[inline(always)]
pub(crate) fn smaller(t: f32, other: f32) -> f32 {
    if t < other { t } else { other }
}

/// The range of t in which a box counts, in lengths of the ray's direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// Not below zero.
    pub min: f32,
    /// The nearest hit so far, or a little more: see [`Reach::of`].
    pub max: f32,
}

impl Reach {
    /// How far a method's t may be off, in units of its last digit. The robust ones are within 9; what is
    /// farther off may be looked for in a box that its true t is in, and not in the one of its computed t.
    pub const ULPS: f64 = math::glance::ULPS;

    /// A span widened by [`Reach::ULPS`]; what begins below zero begins at zero.
    ///
    /// A unit of the last digit of t is at most 2^(1 − DIGITS) |t|, or the smallest number. Twice that is
    /// taken, which leaves room for the roundings here. The last of them, to `f32`, keeps the order that
    /// [`Slabs::enter`] relies on.
    #[inline(always)]
    pub fn of<R: Real>(span: Span<R>) -> Reach {
        let digit = 2.0 / (1u64 << (R::DIGITS - 1)) as f64;
        let (relative, absolute): (f64, f64) = (Reach::ULPS * digit, Reach::ULPS * R::SMALLEST.into());
        let (min, max): (f64, f64) = (span.min.into(), span.max.into());
        let widened = |t: f64, sign: f64| (t * (1.0 + sign * relative) + sign * absolute) as f32;
        // a second ray begins at the smallest number, and products of subnormal numbers take a hundred times
        // as long
        let min = if min > absolute { widened(min, -1.0).max(0.0) + 0.0 } else { 0.0 };
        Reach { min, max: widened(max, 1.0) }
    }
}

#[cfg(test)]
mod tests;

//! The verdict in plain `f64`: both roots, and which of them are on the wall ahead. Enough for nearly every ray.
//!
//! With the axis at length 1, â = v / ‖v‖, and the slope κ = (r_a − r_b) / ‖v‖, what f asks for is near at hand: of the
//! origin p = o − b its height h = p·â, the way w = p − h â out from the axis and the radius r = r_b + κ h there; of the
//! direction g = d·â, e = d − g â and κ g. Then f is
//!
//! ```text
//! (e·e − (κ g)²) λ² − 2 (r κ g − w·e) λ + w·w − r²
//! ```
//!
//! What the numbers are off by, in units of u = 2^−53, follows from lengths alone:
//!
//! | number | is off by at most | because |
//! | --- | --- | --- |
//! | â, κ | 6.5, 6.5 κ | v 1, v·v 5, its root and quotient 4.5, a product; r_a − r_b, that and a product |
//! | h, g | 10.5 ‖p‖, 9.5 ‖d‖ | p 1 (d is exact), â, a dot product 3 |
//! | w, e | 20 ‖p‖, 18 ‖d‖ | those, â again, a product, p again, a difference |
//! | r, κ g | 19 (r_b + κ ‖p‖), 17 κ ‖d‖ | κ, those, a product, a sum |
//! | A, B, C | 40 E², 42 T E, 44 T² | twice each of their parts, dot products 3, a product, a difference |
//!
//! with E² ≥ ‖d‖² (1 + κ²) and T² ≥ ‖p‖² + (r_b + κ ‖p‖)², by Cauchy's inequality for B. From there on
//! [`math::Bounded`] carries the bounds.

use std::cmp::Ordering::{Equal, Greater, Less};
use std::ops::RangeInclusive;

use math::{Bounded, Real, Sure};

use super::{OpenCone, Verdict};

/// 48 u, more than any of the errors above by what the bounds are rounded themselves.
const OFF: f64 = 24.0 * f64::EPSILON;
/// 256 u, more than D is off by at most.
const D_OFF: f64 = 128.0 * f64::EPSILON;
/// Lengths between these have products of four that neither overflow nor vanish.
pub(super) const SAFE: RangeInclusive<f64> = 1e-60..=1e60;

/// The measures of a wall in plain `f64`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wall {
    /// â
    axis: [f64; 3],
    /// ‖v‖
    pub(super) length: f64,
    /// κ
    pub(super) slope: f64,
    /// r_b
    pub(super) radius: f64,
}

/// A, B and C of f with the origin in some place, and where that is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Numbers {
    pub(super) a: Bounded<f64>,
    pub(super) b: Bounded<f64>,
    pub(super) c: Bounded<f64>,
    /// h
    height: Bounded<f64>,
    /// g
    rise: Bounded<f64>,
    /// T E
    size: f64,
}

impl Wall {
    /// The measures; `None` for a cone that [`OpenCone::check`] refuses, and for sizes that are out of the ordinary.
    #[inline(always)]
    pub(super) fn of(cone: &OpenCone<f64>) -> Option<Wall> {
        let [base, apex] = [cone.base, cone.apex].map(f64::xyz);
        let v: [f64; 3] = std::array::from_fn(|axis| apex[axis] - base[axis]);
        let length = dot(v, v).sqrt();
        let inverse = 1.0 / length;
        let (radius, other) = (cone.base_radius, cone.apex_radius);
        let slope = (other - radius) * inverse;
        let is_sound = radius >= 0.0 && other >= 0.0 && radius + other > 0.0;
        let is_ordinary = SAFE.contains(&length) && slope.abs() <= *SAFE.end();
        (is_sound && is_ordinary).then(|| Wall { axis: v.map(|v| v * inverse), length, slope, radius })
    }

    /// p·â
    #[inline(always)]
    pub(super) fn height(&self, p: [f64; 3]) -> f64 {
        dot(p, self.axis)
    }

    /// A, B and C for a line from p = o − b, each component rounded once, which is off by u / 2^24 of `reach` besides.
    /// `None` for sizes that are out of the ordinary, and for what is no line.
    #[inline(always)]
    pub(super) fn numbers(&self, p: [f64; 3], reach: f64, d: [f64; 3]) -> Option<Numbers> {
        let (h, g) = (self.height(p), dot(d, self.axis));
        let w: [f64; 3] = std::array::from_fn(|axis| p[axis] - h * self.axis[axis]);
        let e: [f64; 3] = std::array::from_fn(|axis| d[axis] - g * self.axis[axis]);
        let (r, grows) = (self.radius + self.slope * h, self.slope * g);
        let steep = 1.0 + self.slope.abs();
        let size = (sum_of_sizes(p) + reach / (1 << 24) as f64) * steep + self.radius;
        let speed = sum_of_sizes(d) * steep;
        let off = |value: f64, size: f64| Bounded { value, error: OFF * size };
        let is_ordinary = SAFE.contains(&size) && SAFE.contains(&speed);
        if !is_ordinary {
            return None;
        }
        Some(Numbers {
            a: off(dot(e, e) - grows * grows, speed * speed),
            b: off(r * grows - dot(w, e), size * speed),
            c: off(dot(w, w) - r * r, size * size),
            height: off(h, size),
            rise: off(g, speed),
            size: size * speed,
        })
    }

    /// Whether λ is ahead, and there the line between the ends of the wall.
    #[inline(always)]
    fn is_met(&self, numbers: &Numbers, lambda: Bounded<f64>) -> Option<bool> {
        if lambda.sign()? != Greater {
            return if lambda.sign() == Some(Less) { Some(false) } else { None };
        }
        let height = numbers.height + lambda * numbers.rise;
        match (height.sign()?, (self.end() - height).sign()) {
            (Less, _) => Some(false),
            (Greater, Some(Less)) => Some(false),
            (Greater, Some(Greater)) => Some(true),
            _ => None,
        }
    }

    /// ‖v‖, which is off by 3.5 u.
    #[inline(always)]
    fn end(&self) -> Bounded<f64> {
        Bounded { value: self.length, error: 2.0 * f64::EPSILON * self.length }
    }

    /// What the ray meets first at λ > 0, and λ; `None` in doubt, and for everything that happens exactly at an end, at the
    /// origin or in one point.
    ///
    /// Between the ends the wall is all there is where f = 0. So a root is met if it is there, and it is known before
    /// λ is: f falls through (B − √D) / A and rises through (B + √D) / A, whatever the sign of A.
    #[inline(always)]
    pub(super) fn verdict(&self, numbers: &Numbers) -> Option<(Verdict, Bounded<f64>)> {
        let nowhere = Some((Verdict::Misses, Bounded::exactly(0.0)));
        let Numbers { a, b, c, height, rise, .. } = *numbers;
        let leaves = match rise.sign() {
            Some(Less) => height.sign() == Some(Less),
            Some(Greater) => (self.end() - height).sign() == Some(Less),
            _ => false,
        };
        if leaves {
            return nowhere;
        }
        // most of what misses does so clearly
        if numbers.is_clear_miss() {
            return nowhere;
        }
        let d = b * b - a * c;
        match d.sign()? {
            Less => return nowhere,
            Equal => return None,
            Greater => {}
        }
        let root = d.sqrt();
        // the sum that does not cancel: one root is it over A, the other one is C over it
        let adds = b.value >= 0.0;
        let q = if adds { b + root } else { b - root };
        let (one, other) = (c / q, q / a);
        let (is_one_met, is_other_met) = (self.is_met(numbers, one)?, self.is_met(numbers, other)?);
        let is_one = match (is_one_met, is_other_met) {
            (false, false) => return nowhere,
            (true, true) => (one - other).sign()? == Less,
            (is_one, _) => is_one,
        };
        // with B + √D for q, C / q is the root through which f falls
        let verdict = if is_one == adds { Verdict::Outer } else { Verdict::Inner };
        Some((verdict, if is_one { one } else { other }))
    }
}

impl Numbers {
    /// D is less than zero by more than it is off by: B² and A C are off by 97 u (T E)², and rounded.
    #[inline(always)]
    fn is_clear_miss(&self) -> bool {
        let Numbers { a, b, c, size, .. } = *self;
        b.value * b.value - a.value * c.value < -(D_OFF * size * size)
    }
}

/// a · b
#[inline(always)]
pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// |x| + |y| + |z|, which is no less than the length.
#[inline(always)]
pub(super) fn sum_of_sizes([x, y, z]: [f64; 3]) -> f64 {
    x.abs() + y.abs() + z.abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// 2^−53
    const U: f64 = f64::EPSILON / 2.0;

    /// A pipe of radius 1, 4 long.
    fn pipe() -> Wall {
        Wall::of(&OpenCone::new(DVec3::ZERO, 1.0, DVec3::Z * 4.0, 1.0)).unwrap()
    }

    /// By hand: T is 2 + 1, of the way that the origin was moved, and the radius 1; E is 1. 48 u of T², T E and E².
    #[test]
    fn a_long_way_makes_the_bounds_larger() {
        let numbers = pipe().numbers([2.0, 0.0, 0.0], 2.0_f64.powi(24), [0.0, 0.0, 1.0]).unwrap();
        assert_eq!(numbers.size, 4.0);
        let errors = [numbers.a, numbers.b, numbers.c].map(|number| number.error);
        assert_eq!(errors, [48.0 * U, 192.0 * U, 768.0 * U]);
    }

    /// By hand: 3.5 u of 4 are 14 u, and 4 u of it 16 u.
    #[test]
    fn the_length_is_off_by_a_share_of_itself() {
        assert_eq!(pipe().end(), Bounded { value: 4.0, error: 16.0 * U });
    }

    /// By hand: with A = 1, B = 0 and T E = 2 D is −C, and 256 u (T E)² are 1024 u.
    #[test]
    fn a_miss_is_clear_beyond_the_bound() {
        let is_clear_miss = |c: f64| {
            let [zero, one, c] = [0.0, 1.0, c].map(Bounded::exactly);
            Numbers { a: one, b: zero, c, height: zero, rise: zero, size: 2.0 }.is_clear_miss()
        };
        let bound = 1024.0 * U;
        assert_eq!([bound.next_up(), 1.0].map(is_clear_miss), [true; 2]);
        assert_eq!([bound, bound / 2.0, 0.0, -1.0].map(is_clear_miss), [false; 4]);
    }
}

//! At a glance: the first way of [`mod@robust`](mod@crate::robust), for who does not need the last digits.
//!
//! The verdict is the same, by the same bound: r² − P·P is off by at most 40u (L·L + r²). What t may be off by, in lengths of
//! the direction:
//!
//! | number | is off by | because |
//! | --- | --- | --- |
//! | t_close | 9u S, with S = √((L·L + r²)/A) | B, 1/A and a product |
//! | h = √(a²/A) | h (E/a²) and 4u h | a square root halves a relative error E/a², which is below ½; its own roundings |
//! | t_close ∓ h | u (t_close + h) | its sum, and both are at most S |
//!
//! which is less than 16u S + h E/a². Unless the line grazes, E/a² is at most a fixed share, which saves a quotient: where a²
//! is less than 2⁻²⁰ (L·L + r²), a glance is not enough. The two roots, S and h, are only for what is met, and neither waits
//! for the other.

use math::plain::dot;
use math::{Around, Glance, Ray3, Real, Vector};

use crate::Sphere;

/// u, the relative error of one operation.
const UNIT: f64 = f64::EPSILON / 2.0;
/// The error of r² − P·P in L·L + r²: more than 40u. L·L − r² is not as far off.
const ERROR: f64 = 64.0 * UNIT;
/// What a² is of L·L + r² at least, where the line does not graze.
const GRAZING: f64 = 1.0 / (1u64 << 20) as f64;
/// E/a² is at most this, then.
const OF_H: f64 = ERROR / GRAZING;
/// Between these, neither a square nor the errors of its products overflow or vanish.
const SAFE_SQUARE: std::ops::RangeInclusive<f64> = 1e-120..=1e120;

/// The line of a ray, with what it takes for any sphere.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    o: [f64; 3],
    d: [f64; 3],
    /// 1/A
    one_over_a: f64,
    /// A is a number that neither overflows nor vanishes.
    is_safe: bool,
}

/// How a line passes the center of a sphere.
#[derive(Clone, Copy, Debug)]
pub struct Passage {
    /// t_close = L·d / A, in lengths of the direction.
    pub t_close: f64,
    /// a² = r² − P·P, below zero where the line passes by.
    pub half_chord_squared: f64,
    /// L·L + r², of which the error is a share.
    pub scale: f64,
    /// The sphere is surely not met ahead of the origin: the line passes by it, or leaves it behind.
    pub is_missed: bool,
    /// The numbers are such that their errors are as they are bounded. Where they are not, nothing is
    /// certain.
    pub is_safe: bool,
}

impl Line {
    /// The line of a ray, which may be degenerate: then every glance along it is [`Glance::Unsure`].
    #[inline(always)]
    pub fn of<R: Real>(ray: &Ray3<R>) -> Line {
        let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
        let a = dot(d, d);
        Line { o, d, one_over_a: 1.0 / a, is_safe: SAFE_SQUARE.contains(&a) }
    }

    /// Past a sphere with the center c and the squared radius r², which must neither overflow nor vanish, see
    /// [`is_safe`].
    #[inline(always)]
    pub fn past(&self, c: [f64; 3], r_r: f64) -> Passage {
        let Line { o, d, .. } = *self;
        let l = [c[0] - o[0], c[1] - o[1], c[2] - o[2]];
        let (b, l_l) = (dot(l, d), dot(l, l));
        let t_close = b * self.one_over_a;
        let p = [l[0] - t_close * d[0], l[1] - t_close * d[1], l[2] - t_close * d[2]];
        let half_chord_squared = r_r - dot(p, p);
        let scale = l_l + r_r;
        let error = ERROR * scale;
        // from outside, and away from the center
        let is_left = (b <= 0.0) & (l_l - r_r > error);
        let is_safe = self.is_safe & (l_l <= *SAFE_SQUARE.end());
        let is_missed = ((half_chord_squared < -error) | is_left) & is_safe;
        Passage { t_close, half_chord_squared, scale, is_missed, is_safe }
    }

    /// What that says, of a passage of this line: [`Glance::Misses`] where nothing is met ahead, else
    /// [`Glance::Twice`], or [`Glance::Unsure`] where the line may graze or a number is out of range.
    #[inline(always)]
    pub fn glance(&self, passage: &Passage) -> Glance {
        let Passage { t_close, half_chord_squared, scale, is_missed, is_safe } = *passage;
        if is_missed {
            return Glance::Misses;
        }
        // NaN fails the test
        if !(is_safe && half_chord_squared >= GRAZING * scale) {
            return Glance::Unsure;
        }
        let [h, s] = [half_chord_squared, scale].map(|squared| (squared * self.one_over_a).sqrt());
        let off = 16.0 * UNIT * s + OF_H * h;
        Glance::Twice(Around { t: t_close - h, off }, Around { t: t_close + h, off })
    }
}

/// Whether the ray meets the sphere ahead, and roughly where its line crosses it, ahead or behind, as
/// [`Line::glance`] has it.
///
/// [`Glance::Unsure`] for a degenerate ray or sphere.
#[inline(always)]
pub fn glance<R: Real>(line: &Line, sphere: &Sphere<R>) -> Glance {
    let (c, r): ([f64; 3], f64) = (sphere.center.in_f64(), sphere.radius.into());
    match is_safe(r) {
        true => line.glance(&line.past(c, r * r)),
        false => Glance::Unsure,
    }
}

/// Whether a number is a radius that may be squared, see [`Line::past`].
#[inline(always)]
pub fn is_safe(r: f64) -> bool {
    r > 0.0 && SAFE_SQUARE.contains(&(r * r))
}

#[cfg(all(test, feature = "stage"))]
mod tests;

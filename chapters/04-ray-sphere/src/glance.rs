//! At a glance: the first way of [`mod@robust`](mod@crate::robust), for who does not need the last digits.
//!
//! The verdict is the same, by the same bound: r² − P·P is off by at most 40u (L·L + r²). What t may be off by, in lengths of
//! the direction, with S = √((L·L + r²)/A):
//!
//! | number | is off by | because |
//! | --- | --- | --- |
//! | t_close | 9u S | B, 1/A and a product |
//! | h = √(a²/A) | h (E/a²) and 4u h | a square root halves a relative error E/a², which is below ½; its own roundings |
//! | t_close ∓ h | u (t_close + h) | its sum, and both are at most S |
//!
//! which is less than 16u S + h E/a².

use math::{Around, Glance, Ray3, Real, Vector};

use crate::Sphere;

/// u, the relative error of one operation.
const UNIT: f64 = f64::EPSILON / 2.0;
/// The error of r² − P·P in L·L + r²: more than 40u.
const ERROR: f64 = 64.0 * UNIT;
/// Between these, neither a square nor the errors of its products overflow or vanish.
const SAFE_SQUARE: std::ops::RangeInclusive<f64> = 1e-120..=1e120;

/// Whether the line of the ray meets the sphere, and roughly where.
#[inline(always)]
pub fn glance<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Glance {
    let [o, d, c] = [ray.origin, ray.direction, sphere.center].map(Vector::in_f64::<3>);
    let r: f64 = sphere.radius.into();
    let l: [f64; 3] = std::array::from_fn(|axis| c[axis] - o[axis]);
    let (a, b, l_l, r_r) = (dot(d, d), dot(l, d), dot(l, l), r * r);
    // NaN fails the test
    if !(SAFE_SQUARE.contains(&r_r) && SAFE_SQUARE.contains(&a) && l_l <= *SAFE_SQUARE.end()) {
        return Glance::Unsure;
    }
    let one_over_a = 1.0 / a;
    let t_close = b * one_over_a;
    let p: [f64; 3] = std::array::from_fn(|axis| l[axis] - t_close * d[axis]);
    let half_chord_squared = r_r - dot(p, p);
    let error = ERROR * (l_l + r_r);
    if half_chord_squared < -error {
        return Glance::Misses;
    }
    if half_chord_squared <= 2.0 * error {
        return Glance::Unsure;
    }
    let h = (half_chord_squared * one_over_a).sqrt();
    let off = 16.0 * UNIT * ((l_l + r_r) * one_over_a).sqrt() + h * (error / half_chord_squared);
    Glance::Twice(Around { t: t_close - h, off }, Around { t: t_close + h, off })
}

/// a · b
#[inline(always)]
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

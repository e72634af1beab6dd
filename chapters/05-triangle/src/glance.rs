//! At a glance: the first way of [`mod@robust`](mod@crate::robust), for who does not need the last digits of λ.
//!
//! The verdict is the same, by the same bound: the three volumes and d · n are off by at most
//! 16u |d| (|e1| |e2| + |A| (|e1| + |e2|)). Where the line passes through the triangle, |A| is at most |λ| |d| + |e1| + |e2|,
//! so that with H = |e1| |e2| times that N = A · n is off by 8u H, and d · n times |λ| by 7u H. Two more roundings are in
//! λ = N / d · n, which is less than H / |d · n|: it is off by 17u H / |d · n|.

use math::plain::{cross, difference, dot, size};
use math::{Around, Glance, Ray3, Real, Vector};

use crate::Triangle;

/// u, the relative error of one operation.
const UNIT: f64 = f64::EPSILON / 2.0;
/// The error of the three volumes and d · n: more than 9u.
const ERROR: f64 = 16.0 * UNIT;
/// The error of λ: more than 17u.
const LAMBDA_ERROR: f64 = 24.0 * UNIT;
/// Between these, neither a product of four lengths nor the errors of its factors overflow or vanish.
const SAFE: std::ops::RangeInclusive<f64> = 1e-70..=1e70;

/// Whether the line of the ray passes through the triangle, and roughly where. Of a ray or a triangle that is none:
/// [`Glance::Unsure`].
#[inline(always)]
pub fn glance<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Glance {
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let [p1, p2, p3] = triangle.corners().map(Vector::in_f64::<3>);
    let (e1, e2, to_p1) = (difference(p2, p1), difference(p3, p1), difference(p1, o));
    let (n, q) = (cross(e1, e2), cross(d, to_p1));
    let d_dot_n = dot(d, n);
    let (v, w) = (-dot(e2, q), dot(e1, q));
    let u = d_dot_n - v - w;

    let [d_size, e1_size, e2_size, to_p1_size] = [d, e1, e2, to_p1].map(size);
    let (area, edges) = (e1_size * e2_size, e1_size + e2_size);
    let error = ERROR * d_size * (area + to_p1_size * edges);
    // NaN fails the test
    let in_range =
        SAFE.contains(&d_size) && e1_size.min(e2_size) >= *SAFE.start() && to_p1_size + edges <= *SAFE.end();
    if !in_range {
        return Glance::Unsure;
    }
    let (lowest, highest) = (u.min(v).min(w), u.max(v).max(w));
    if lowest < -error && highest > error {
        return if size(n) > ERROR * area { Glance::Misses } else { Glance::Unsure };
    }
    if !(lowest > error || highest < -error) {
        return Glance::Unsure;
    }
    let one_over = 1.0 / d_dot_n;
    let lambda = dot(to_p1, n) * one_over;
    let h = area * (lambda.abs() * d_size + edges);
    Glance::Once(Around { t: lambda, off: LAMBDA_ERROR * h * one_over.abs() })
}

/// α and β of the point where the line of the ray passes the plane of the triangle, each off by less than 2⁻³⁰, which is enough
/// for a color or a normal there; `None` where plain `f64` is not good enough for that.
///
/// They are v / d · n and w / d · n. The volumes and d · n are off by the error above, and neither is larger than d · n where the
/// line passes through: the quotient is then off by twice that error over d · n.
#[inline(always)]
pub fn alpha_beta<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<(R, R)> {
    const ENOUGH: f64 = 1.0 / (1u64 << 31) as f64;
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let [p1, p2, p3] = triangle.corners().map(Vector::in_f64::<3>);
    let (e1, e2, to_p1) = (difference(p2, p1), difference(p3, p1), difference(p1, o));
    let q = cross(d, to_p1);
    let (d_dot_n, v, w) = (dot(d, cross(e1, e2)), -dot(e2, q), dot(e1, q));
    let [d_size, e1_size, e2_size, to_p1_size] = [d, e1, e2, to_p1].map(size);
    let error = ERROR * d_size * (e1_size * e2_size + to_p1_size * (e1_size + e2_size));
    let in_range = SAFE.contains(&d_size)
        && e1_size.min(e2_size) >= *SAFE.start()
        && to_p1_size + e1_size + e2_size <= *SAFE.end();
    // NaN fails the test
    if !(in_range && error <= ENOUGH * d_dot_n.abs()) {
        return None;
    }
    Some((R::round_from(v / d_dot_n), R::round_from(w / d_dot_n)))
}

#[cfg(all(test, feature = "stage"))]
mod tests;

//! At a glance: the first way of [`mod@robust`](mod@crate::robust), for who does not need the last digits of
//! λ.
//!
//! The verdict is the same, by the same bound: the three volumes and d · n are off by at most 16u |d| (|e1|
//! |e2| + |A| (|e1| + |e2|)). Where the line passes through the triangle, |A| is at most |λ| |d| + |e1| +
//! |e2|, so that with H = |e1| |e2| times that N = A · n is off by 8u H, and d · n times |λ| by 7u H. Two
//! more roundings are in λ = N / d · n, which is less than H / |d · n|: it is off by 17u H / |d · n|.

use math::plain::{dot, size};
use math::{Around, Glance, Ray3, Real};

use crate::Triangle;
use crate::volumes::{ERROR, UNIT, Volumes};

/// The error of λ: more than 17u.
const LAMBDA_ERROR: f64 = 24.0 * UNIT;

/// Whether the line of the ray passes through the triangle, and roughly where: [`Glance::Once`], be it
/// ahead or behind, or [`Glance::Misses`].
///
/// [`Glance::Unsure`] near an edge or along the plane, and for a degenerate ray or triangle.
#[inline(always)]
pub fn glance<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Glance {
    let volumes = Volumes::of(ray, triangle);
    let Volumes { n, to_p1, d_dot_n, uvw: [u, v, w], error, .. } = volumes;
    if !volumes.are_in_range() {
        return Glance::Unsure;
    }
    let (lowest, highest) = (u.min(v).min(w), u.max(v).max(w));
    if lowest < -error && highest > error {
        return if size(n) > ERROR * volumes.area() { Glance::Misses } else { Glance::Unsure };
    }
    if !(lowest > error || highest < -error) {
        return Glance::Unsure;
    }
    let one_over = 1.0 / d_dot_n;
    let lambda = dot(to_p1, n) * one_over;
    let h = volumes.area() * (lambda.abs() * volumes.d_size + volumes.edges());
    Glance::Once(Around { t: lambda, off: LAMBDA_ERROR * h * one_over.abs() })
}

/// α and β of the point where the line of the ray passes through the triangle, which it must do. Each is
/// off by less than 2⁻³⁰ before it is rounded to R, which is enough for a color or a normal there; `None`
/// where plain `f64` is not good enough for that.
///
/// They are v / d · n and w / d · n. The volumes and d · n are off by the error above, and neither is larger
/// than d · n where the line passes through: the quotient is then off by twice that error over d · n.
#[inline(always)]
pub fn alpha_beta<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<(R, R)> {
    const ENOUGH: f64 = 1.0 / (1u64 << 31) as f64;
    let volumes = Volumes::of(ray, triangle);
    let Volumes { d_dot_n, uvw: [_, v, w], error, .. } = volumes;
    // NaN fails the test
    if !(volumes.are_in_range() && error <= ENOUGH * d_dot_n.abs()) {
        return None;
    }
    Some((R::round_from(v / d_dot_n), R::round_from(w / d_dot_n)))
}

#[cfg(all(test, feature = "stage"))]
mod tests;

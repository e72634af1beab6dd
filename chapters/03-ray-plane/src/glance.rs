//! At a glance: the page's quotient in plain `f64`, with what it may be off by.
//!
//! With p − o the numerator N = n · (p − o) is off by at most 5u Σ |n_i (p − o)_i|: a difference, a product, and up to
//! three sums of which every part takes part. D = n · d is off by 4u Σ |n_i d_i|. So their quotient t is off by at most
//! (E_N + |t| E_D) / (|D| − E_D) and its own rounding, which with |D| ≥ 2 E_D is less than twice that over |D|.

use math::{Around, Glance, Ray3, Real, Vector};

use crate::Plane;

/// u, the relative error of one operation.
const UNIT: f64 = f64::EPSILON / 2.0;
/// Between these, neither the products nor their errors overflow or vanish.
const SAFE: std::ops::RangeInclusive<f64> = 1e-140..=1e140;

/// Whether the line of the ray meets the plane, and roughly where: [`Glance::Once`], be it ahead or behind.
///
/// [`Glance::Unsure`] where the line is parallel or nearly so, and for a degenerate ray or plane.
#[inline(always)]
pub fn glance<R: Real>(ray: &Ray3<R>, plane: &Plane<R>) -> Glance {
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let [p, n] = [plane.point, plane.normal].map(Vector::in_f64::<3>);
    let to_p: [f64; 3] = std::array::from_fn(|axis| p[axis] - o[axis]);
    let (above, above_size) = dot_and_size(n, to_p);
    let (rise, rise_size) = dot_and_size(n, d);
    // NaN fails the test
    if !(SAFE.contains(&above_size) && SAFE.contains(&rise_size)) || rise.abs() <= 8.0 * UNIT * rise_size {
        return Glance::Unsure;
    }
    let one_over = 1.0 / rise;
    let t = above * one_over;
    let error = 8.0 * UNIT * (above_size + t.abs() * rise_size);
    Glance::Once(Around { t, off: 2.0 * error * one_over.abs() })
}

/// a · b, and the same of the magnitudes.
#[inline(always)]
fn dot_and_size(a: [f64; 3], b: [f64; 3]) -> (f64, f64) {
    let [x, y, z] = [a[0] * b[0], a[1] * b[1], a[2] * b[2]];
    (x + y + z, x.abs() + y.abs() + z.abs())
}

#[cfg(all(test, feature = "stage"))]
mod tests;

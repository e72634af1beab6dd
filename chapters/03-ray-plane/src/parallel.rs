//! "How would you test for this in a computer program?" Exactly.
//!
//! n · u_r is a sum of three products; computed, it may be off by a few last digits of the largest. If
//! it comes out farther from zero than that, the ray is not parallel. Only where it does not is there
//! a question, and then integers as long as it takes answer it ([`math::exact`]). A tolerance, such as
//! |n · u_r| < 1e−6, would instead lose every ray that meets the plane at a shallow angle.

use math::{Exact, Parallel, Ray3, Real, Vector};

use crate::Plane;

/// Three products and two sums are off by less than 2^−50 of the sum of their magnitudes,
const ERROR: f64 = 1.0 / (1u64 << 50) as f64;
/// as long as none of them that matters is so small that it vanishes.
const SMALLEST_SAFE: f64 = 1e-280;

/// How the ray runs along the plane; `None` where n · u_r ≠ 0. Decided on the numbers as given, which
/// must be finite.
#[inline(always)]
pub fn parallel<R: Real>(ray: &Ray3<R>, plane: &Plane<R>) -> Option<Parallel> {
    let [n, u]: [[f64; 3]; 2] = [plane.normal, ray.direction].map(|v| v.in_f64());
    let products: [f64; 3] = std::array::from_fn(|axis| n[axis] * u[axis]);
    let sum = products[0] + products[1] + products[2];
    let size = products[0].abs() + products[1].abs() + products[2].abs();
    if sum.abs() > ERROR * size && sum.abs() > SMALLEST_SAFE {
        return None;
    }
    let [p_r, p_0]: [[f64; 3]; 2] = [ray.origin, plane.point].map(|v| v.in_f64());
    exactly(n, u, p_r, p_0)
}

/// The same by exact sums.
#[cold]
#[inline(never)]
fn exactly(n: [f64; 3], u: [f64; 3], p_r: [f64; 3], p_0: [f64; 3]) -> Option<Parallel> {
    let [n, u] = [n, u].map(|v| v.map(Exact::new));
    if !Exact::dot(&n, &u).is_zero() {
        return None;
    }
    let from_plane: [Exact; 3] = std::array::from_fn(|axis| Exact::new(p_r[axis]) - Exact::new(p_0[axis]));
    let on_plane = Exact::dot(&n, &from_plane).is_zero();
    Some(if on_plane { Parallel::Within } else { Parallel::Apart })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn along(origin: [f64; 3], direction: [f64; 3], normal: [f64; 3]) -> Option<Parallel> {
        let ray = Ray3::<f64>::new(origin.into(), direction.into());
        parallel(&ray, &Plane { point: DVec3::ZERO, normal: normal.into() })
    }

    #[test]
    fn zero_means_zero() {
        assert_eq!(along([0.0, 1.0, 0.0], [1.0, 0.0, -1.0], [0.0, 1.0, 0.0]), Some(Parallel::Apart));
        assert_eq!(along([5.0, 0.0, 2.0], [1.0, 0.0, -1.0], [0.0, 1.0, 0.0]), Some(Parallel::Within));
        assert_eq!(along([0.0, 1.0, 0.0], [1.0, -1e-300, -1.0], [0.0, 1.0, 0.0]), None);
        // a product of 1e−400 vanishes in floating point, and is not zero
        assert_eq!(along([0.0, 1.0, 0.0], [0.0, -1e-200, 0.0], [0.0, 1e-200, 0.0]), None);
        // 0.1 · −0.2 − 0.1 · 0.1 + 0.1 · 0.3 is 0 when rounded, and 0.1, 0.2, 0.3 are not what they say
        assert_eq!(along([0.0; 3], [0.1, -0.1, -0.1], [-0.2, 0.1, -0.300_000_000_000_000_04]), None);
    }

    /// n · u_r = 0 by two products of three, whichever they are.
    #[test]
    fn two_products_cancel() {
        for u in [[1.0, -1.0, 0.0], [1.0, 0.0, -1.0], [0.0, 1.0, -1.0]] {
            assert_eq!(along([0.0, 1.0, 0.0], u, [1.0; 3]), Some(Parallel::Apart), "{u:?}");
        }
    }

    #[test]
    fn a_sum_that_comes_out_of_rounding_is_none() {
        // by hand, with ε = 2^−52: (1 + ε)² − (1 + 2ε) − ε² = 0, and the square loses its ε²
        let e = f64::EPSILON;
        let n = [1.0 + e, 1.0 + 2.0 * e, e];
        assert_eq!(along([0.0; 3], [1.0 + e, -1.0, -e], n), Some(Parallel::Within));
        // by hand, with the smallest number m: ¾ m − ½ m − ¼ m = 0, and is m when each is rounded
        let m = f64::from_bits(1);
        assert_eq!(along([0.0; 3], [0.75, -0.5, -0.25], [m; 3]), Some(Parallel::Within));
    }

    #[test]
    fn within_a_plane_that_does_not_hold_the_worlds_origin() {
        let plane = Plane { point: DVec3::new(1.0, 2.0, 3.0), normal: DVec3::ONE };
        let from = |x: f64| parallel(&Ray3::<f64>::new(DVec3::X * x, DVec3::new(1.0, -2.0, 1.0)), &plane);
        assert_eq!([from(6.0), from(-6.0)], [Some(Parallel::Within), Some(Parallel::Apart)]);
    }
}

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
/// must be finite. A direction or a normal that is zero counts as parallel.
#[inline(always)]
pub fn parallel<R: Real>(ray: &Ray3<R>, plane: &Plane<R>) -> Option<Parallel> {
    let [n, u]: [[f64; 3]; 2] = [plane.normal, ray.direction].map(|v| v.in_f64());
    let products: [f64; 3] = std::array::from_fn(|axis| n[axis] * u[axis]);
    let sum = products[0] + products[1] + products[2];
    let size = products[0].abs() + products[1].abs() + products[2].abs();
    if surely_crosses(sum, size) {
        return None;
    }
    let [p_r, p_0]: [[f64; 3]; 2] = [ray.origin, plane.point].map(|v| v.in_f64());
    exactly(n, u, p_r, p_0)
}

/// Whether a sum is certainly not zero, as it was computed, next to the sum of the magnitudes.
#[inline(always)]
fn surely_crosses(sum: f64, size: f64) -> bool {
    sum.abs() > ERROR * size && sum.abs() > SMALLEST_SAFE
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

    /// By hand, in units of 2^−50: a sum of 2 with products of size 3 is off by less than 3 of them.
    #[test]
    fn certain_is_what_no_rounding_can_make() {
        let unit = 2.0_f64.powi(-50);
        assert!(!surely_crosses(2.0 * unit, 3.0) && !surely_crosses(-3.0 * unit, 3.0));
        assert!(surely_crosses(4.0 * unit, 3.0) && surely_crosses(-4.0 * unit, 3.0));
        assert!(!surely_crosses(1e-281, 0.0) && surely_crosses(1e-279, 0.0));
    }

    /// n and u_r = n × v at right angles, in whole numbers of which the products have more digits than `f64`.
    #[test]
    fn whole_numbers_at_right_angles() {
        let mut bits = 1_u64;
        let mut number = || {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from((bits >> 39) as u32) - 2.0_f64.powi(24)
        };
        let mut rounded = 0;
        for _ in 0..1000 {
            let [n, v] = [(); 2].map(|()| DVec3::new(number(), number(), number()));
            let u = n.cross(v);
            rounded += usize::from(n.dot(u) != 0.0);
            assert_eq!(along([0.0; 3], u.to_array(), n.to_array()), Some(Parallel::Within), "{n} {u}");
            let off = along([0.0; 3], (u + DVec3::X).to_array(), n.to_array());
            assert_eq!(off, (n.x == 0.0).then_some(Parallel::Within), "{n} {u}");
        }
        assert!(rounded > 400, "{rounded}");
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

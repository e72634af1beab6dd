//! What programs have: Möller and Trumbore's formulas, which are Cramer's rule once more.
//!
//! A triple product may be turned round, (x × y) · z = (y × z) · x = (z × x) · y, and then the four determinants of
//! [`mod@matrix`](mod@crate::matrix) share two cross products, P = d × e2 and Q = s × e1. Möller and Trumbore (1997) have
//! e1 = p̄2 − p̄1, e2 = p̄3 − p̄1 and s = ā − p̄1, where the page has −e1, −e2 and −s: three signs, so that each of
//! their determinants is the page's with the other sign, and the quotients are the same.
//!
//! It is no method of its own here: what it loses, [`mod@matrix`](mod@crate::matrix) loses.

use math::{Ray3, Real, Vector};

use crate::Triangle;

/// Every number of Möller and Trumbore's way to the four determinants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MollerTrumbore<R: Real> {
    /// e1 = p̄2 − p̄1
    pub e1: R::Vec3,
    /// e2 = p̄3 − p̄1
    pub e2: R::Vec3,
    /// s = ā − p̄1
    pub s: R::Vec3,
    /// P = d × e2
    pub p: R::Vec3,
    /// Q = s × e1
    pub q: R::Vec3,
    /// P · e1 = −det
    pub det: R,
    /// P · s = −det_alpha
    pub det_alpha: R,
    /// Q · d = −det_beta
    pub det_beta: R,
    /// Q · e2 = −det_lambda
    pub det_lambda: R,
}

/// Works out the four determinants with two cross products.
#[inline]
pub fn moller_trumbore<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> MollerTrumbore<R> {
    let Triangle { p1, p2, p3 } = *triangle;
    let (e1, e2, s) = (p2 - p1, p3 - p1, ray.origin - p1);
    let p = R::cross(ray.direction, e2);
    let q = R::cross(s, e1);
    let (det, det_alpha) = (p.dot(e1), p.dot(s));
    let (det_beta, det_lambda) = (q.dot(ray.direction), q.dot(e2));
    MollerTrumbore { e1, e2, s, p, q, det, det_alpha, det_beta, det_lambda }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::matrix;
    use glam::DVec3;

    /// In whole numbers nothing is rounded: the determinants are the page's with the other sign.
    #[test]
    fn the_same_four_determinants() {
        let mut state = 1_u64;
        let mut whole = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % 201) as f64 - 100.0
        };
        for _ in 0..1000 {
            let mut v = || DVec3::new(whole(), whole(), whole());
            let (ray, triangle) = (Ray3::<f64>::new(v(), v()), Triangle { p1: v(), p2: v(), p3: v() });
            let (page, mt) = (matrix(&ray, &triangle), moller_trumbore(&ray, &triangle));
            assert_eq!(
                [mt.det, mt.det_alpha, mt.det_beta, mt.det_lambda],
                [-page.det, -page.det_alpha, -page.det_beta, -page.det_lambda],
            );
            assert_eq!(page.det, ray.direction.dot(triangle.normal()));
        }
    }
}

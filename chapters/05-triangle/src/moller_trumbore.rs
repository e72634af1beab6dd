//! What programs have: Möller and Trumbore's formulas, which are Cramer's rule once more.
//!
//! A triple product may be turned round, (x × y) · z = (y × z) · x = (z × x) · y, and then the four determinants of
//! [`mod@matrix`](mod@crate::matrix) share two cross products, P = d × e2 and Q = s × e1. Möller and Trumbore (1997) have
//! e1 = p̄2 − p̄1, e2 = p̄3 − p̄1 and s = ā − p̄1, where the page has −e1, −e2 and −s: three signs, so that each of
//! their determinants is the page's with the other sign, and the quotients are the same.
//!
//! It is not among the chapter's methods: what it loses, [`mod@matrix`](mod@crate::matrix) loses.

use math::{Degenerate, Hit, Ray3, Real, Span, Vector};

use crate::parallel::try_parallel;
use crate::{Hit3, Triangle};

/// Every number of Möller and Trumbore's way to the four determinants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MollerTrumbore<R: Real> {
    /// The ray ā + λ d.
    pub ray: Ray3<R>,
    /// The triangle.
    pub triangle: Triangle<R>,
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

/// Works out the four determinants with two cross products, for a direction of any length but zero.
///
/// A degenerate ray or triangle, and a ray along the plane, give values that mean nothing;
/// [`MollerTrumbore::hit`] sorts them out.
#[inline]
pub fn moller_trumbore<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> MollerTrumbore<R> {
    let Triangle { p1, p2, p3 } = *triangle;

    // exercise determinants: Which sides and cross products does it take, and which four dot products with those?
    let (e1, e2, s) = (p2 - p1, p3 - p1, ray.origin - p1);
    let p = R::cross(ray.direction, e2);
    let q = R::cross(s, e1);
    let (det, det_alpha) = (p.dot(e1), p.dot(s));
    let (det_beta, det_lambda) = (q.dot(ray.direction), q.dot(e2));
    MollerTrumbore { ray: *ray, triangle: *triangle, e1, e2, s, p, q, det, det_alpha, det_beta, det_lambda }
    // end determinants
}

impl<R: Real> MollerTrumbore<R> {
    /// α, β and λ, the last in lengths of d. Infinite or NaN where det is zero.
    #[inline]
    pub fn solution(&self) -> [R; 3] {
        // exercise solution: What are α, β and λ, now that the determinants are there?
        [self.det_alpha, self.det_beta, self.det_lambda].map(|of_unknown| of_unknown / self.det)
        // end solution
    }

    /// The hit in `span`, from either side of the triangle, as [`Matrix::hit`](crate::Matrix::hit) has it.
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        if try_parallel(&self.ray, &self.triangle)?.is_some() {
            return Ok(None);
        }
        // exercise hit: Which α, β and λ make a hit, and what are its t, its point and its unit normal?
        let [alpha, beta, lambda] = self.solution();
        let is_inside = alpha >= R::from(0.0) && beta >= R::from(0.0) && alpha + beta <= R::from(1.0);
        if !(is_inside && span.contains(lambda)) {
            return Ok(None);
        }
        let t = lambda + R::from(0.0); // minus zero is zero
        Ok(Some(Hit { t, point: self.ray.at(t), normal: R::cross(self.e1, self.e2).normalized() }))
        // end hit
    }
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
            assert_eq!(mt.hit(Span::ahead()), page.hit(Span::ahead()));
        }
    }

    /// By hand: from a corner s = 0, so that λ = 0/det, and of one of the two directions det is below zero.
    #[test]
    fn a_ray_that_starts_at_a_corner_starts_at_zero() {
        let triangle = Triangle::<f64> { p1: DVec3::ZERO, p2: DVec3::X, p3: DVec3::Y };
        let works = [1.0, -1.0].map(|d| moller_trumbore(&Ray3::new(DVec3::ZERO, DVec3::Z * d), &triangle));
        assert_eq!(works.map(|work| work.det), [-1.0, 1.0]);
        for work in works {
            assert_eq!(work.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0.0_f64.to_bits());
        }
    }
}

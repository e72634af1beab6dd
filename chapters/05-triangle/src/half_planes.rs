//! CSC418 11.3.1, the first way: the plane, then the half-planes.

use math::{Degenerate, Hit, Parallel, Ray3, Real, Span, Vector};

use crate::parallel::{parallel, try_parallel};
use crate::{Hit3, Triangle};

/// Every number of the first way.
///
/// The page's ā is the origin of the ray and its p̄1, p̄2, p̄3 are the corners of [`Triangle`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlanes<R: Real> {
    /// The ray ā + λ d.
    pub ray: Ray3<R>,
    /// The triangle.
    pub triangle: Triangle<R>,
    /// n = (p̄2 − p̄1) × (p̄3 − p̄1), not normalized.
    pub n: R::Vec3,
    /// (p̄1 − ā) · n
    pub to_p1_dot_n: R,
    /// d · n
    pub d_dot_n: R,
    /// λ* = (p̄1 − ā) · n / d · n, in lengths of d. Infinite or NaN where d · n = 0.
    pub lambda: R,
    /// r̄(λ*), where the line of the ray meets the plane.
    pub x: R::Vec3,
    /// ((p̄2 − p̄1) × (x − p̄1)) · n, the same for p̄2 and p̄3, and for p̄3 and p̄1. None is negative in the triangle; zero
    /// is on the edge.
    pub sides: [R; 3],
    /// n · n, which is what the three sides sum to.
    pub n_dot_n: R,
}

/// Works out the first way of CSC418 11.3.1, for a direction of any length but zero.
///
/// A degenerate ray or triangle, and a ray along the plane, give values that mean nothing;
/// [`HalfPlanes::hit`] sorts them out.
#[inline]
pub fn half_planes<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> HalfPlanes<R> {
    let Triangle { p1, p2, p3 } = *triangle;

    // (ā + λ d − p̄1) · n = 0, solved for λ
    let n = triangle.normal();
    let to_p1_dot_n = (p1 - ray.origin).dot(n);
    let d_dot_n = ray.direction.dot(n);
    let lambda = to_p1_dot_n / d_dot_n;
    let x = ray.at(lambda);

    // The half-plane of an edge: on the left of it, seen from where n points.
    let side = |from: R::Vec3, to: R::Vec3| {
        // exercise side: Which number, of the edge, the way from its start to x, and n, is positive for x on its left?
        // ((p̄2 − p̄1) × (x − p̄1)) · n
        R::cross(to - from, x - from).dot(n)
        // end side
    };
    let sides = [side(p1, p2), side(p2, p3), side(p3, p1)];
    let n_dot_n = n.dot(n);

    HalfPlanes { ray: *ray, triangle: *triangle, n, to_p1_dot_n, d_dot_n, lambda, x, sides, n_dot_n }
}

impl<R: Real> HalfPlanes<R> {
    /// What d · n = 0 means, decided exactly: see [`parallel`]. Means nothing for what [`Triangle::check`]
    /// refuses.
    pub fn parallel(&self) -> Option<Parallel> {
        parallel(&self.ray, &self.triangle)
    }

    /// α and β of the point. They need no further work: the side of an edge, as a share of n · n, is the share of the
    /// corner across it. `None` where there is no such point, or one of its numbers overflows.
    #[inline]
    pub fn alpha_beta(&self) -> Option<(R, R)> {
        // exercise shares: The three sides sum to n · n: which of them is the share of p̄2, and which that of p̄3?
        let (alpha, beta): (R, R) = (self.sides[2] / self.n_dot_n, self.sides[0] / self.n_dot_n);
        // end shares
        (alpha.is_finite() && beta.is_finite()).then_some((alpha, beta))
    }

    /// Whether x is in all three half-planes. They say nothing of λ*.
    #[inline]
    pub fn is_inside(&self) -> bool {
        // exercise inside: What do the three sides tell of a point of the triangle, its edges and corners included?
        self.sides.iter().all(|&side| side >= R::from(0.0))
        // end inside
    }

    /// The hit, where its t = λ* lies in `span` and the point in all three half-planes. The normal is
    /// n / ‖n‖, not turned toward the ray.
    ///
    /// `None` for a miss, which a ray along the plane is, too; [`Degenerate`] for a question without an
    /// answer, see [`Triangle::check`].
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        if try_parallel(&self.ray, &self.triangle)?.is_some() {
            return Ok(None);
        }
        if !(self.is_inside() && span.contains(self.lambda)) {
            return Ok(None);
        }
        let t = self.lambda + R::from(0.0); // minus zero is zero
        Ok(Some(Hit { t, point: self.x, normal: self.n.normalized() }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// In the plane z = 2, with legs of 4 and 2.
    const TRIANGLE: Triangle<f64> = Triangle {
        p1: DVec3::new(1.0, 1.0, 2.0),
        p2: DVec3::new(5.0, 1.0, 2.0),
        p3: DVec3::new(1.0, 3.0, 2.0),
    };

    fn work(x: f64, y: f64, z: f64) -> HalfPlanes<f64> {
        half_planes(&Ray3::new(DVec3::ZERO, DVec3::new(x, y, z)), &TRIANGLE)
    }

    #[test]
    fn a_ray_through_the_inside() {
        // by hand: n = (4,0,0) × (0,2,0) = (0,0,8); λ* = 16/8; x = (2, 1.5, 2) = p̄1 + ¼ (4,0,0) + ¼ (0,2,0)
        let work = work(1.0, 0.75, 1.0);
        assert_eq!((work.n, work.to_p1_dot_n, work.d_dot_n), (DVec3::new(0.0, 0.0, 8.0), 16.0, 8.0));
        assert_eq!((work.lambda, work.x), (2.0, DVec3::new(2.0, 1.5, 2.0)));
        // by hand: (4,0,0) × (1,½,0) = 2, (−4,2,0) × (−3,½,0) = 4, (0,−2,0) × (1,−1½,0) = 2, each times 8
        assert_eq!((work.sides, work.n_dot_n), ([16.0, 32.0, 16.0], 64.0));
        assert_eq!(work.alpha_beta(), Some((0.25, 0.25)));
        let hit = work.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point, hit.normal), (2.0, work.x, DVec3::Z));
        assert_eq!(work.parallel(), None);
    }

    #[test]
    fn each_half_plane_cuts_something_off() {
        for (x, y, outside) in [(2.0, 0.5, 0), (4.0, 2.0, 1), (0.5, 1.5, 2)] {
            let work = work(x / 2.0, y / 2.0, 1.0);
            let negative: Vec<_> = (0..3).filter(|&k| work.sides[k] < 0.0).collect();
            assert_eq!(negative, [outside], "({x}, {y})");
            assert_eq!(work.hit(Span::ahead()), Ok(None));
        }
    }

    #[test]
    fn edges_and_corners_belong_to_it() {
        for (x, y) in [(1.0, 1.0), (5.0, 1.0), (1.0, 3.0), (3.0, 1.0), (3.0, 2.0), (1.0, 2.0)] {
            let hit = work(x / 2.0, y / 2.0, 1.0).hit(Span::ahead()).unwrap();
            assert_eq!(hit.map(|hit| hit.t), Some(2.0), "({x}, {y})");
        }
    }

    #[test]
    fn what_is_behind_is_no_hit() {
        assert_eq!(work(-1.0, -0.75, -1.0).lambda, -2.0);
        assert_eq!(work(-1.0, -0.75, -1.0).hit(Span::ahead()), Ok(None));
        let touching = half_planes(&Ray3::new(TRIANGLE.p1, DVec3::Z), &TRIANGLE);
        assert_eq!(touching.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0.0_f64.to_bits());
    }

    #[test]
    fn a_ray_along_the_plane_is_a_miss_with_a_reason() {
        assert_eq!(work(1.0, 0.0, 0.0).parallel(), Some(Parallel::Apart));
        assert_eq!(work(1.0, 0.0, 0.0).hit(Span::ahead()), Ok(None));
        let within = half_planes(&Ray3::new(DVec3::new(0.0, 1.5, 2.0), DVec3::X), &TRIANGLE);
        assert_eq!(within.parallel(), Some(Parallel::Within));
        assert_eq!((within.hit(Span::ahead()), within.alpha_beta()), (Ok(None), None));
    }

    #[test]
    fn questions_without_an_answer_are_refused() {
        let still = half_planes(&Ray3::new(DVec3::ZERO, DVec3::ZERO), &TRIANGLE);
        assert_eq!(still.hit(Span::ahead()), Err(Degenerate::ZeroDirection));
        let line = Triangle { p3: DVec3::new(3.0, 1.0, 2.0), ..TRIANGLE };
        let flat = half_planes(&Ray3::new(DVec3::ZERO, DVec3::Z), &line);
        assert_eq!(flat.hit(Span::ahead()), Err(Degenerate::NoArea));
        let nowhere = Triangle { p3: DVec3::NAN, ..TRIANGLE };
        let lost = half_planes(&Ray3::new(DVec3::ZERO, DVec3::Z), &nowhere);
        assert_eq!(lost.hit(Span::ahead()), Err(Degenerate::NotFinite));
    }

    /// By hand: d · n = −8, and so λ* = 0/−8, which is −0.
    #[test]
    fn a_ray_that_leaves_the_corner_downward_starts_at_zero() {
        let touching = half_planes(&Ray3::new(TRIANGLE.p1, -DVec3::Z), &TRIANGLE);
        assert_eq!(touching.lambda.to_bits(), (-0.0_f64).to_bits());
        assert_eq!(touching.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0.0_f64.to_bits());
    }

    /// By hand: above (1½, 2^1022) the side of the first edge is 8 · 4 · 2^1022, which overflows, and that of the
    /// third is 8: α = 8/64.
    #[test]
    fn there_are_two_shares_or_none() {
        let far = half_planes(&Ray3::new(DVec3::new(1.5, 2.0_f64.powi(1022), 0.0), DVec3::Z), &TRIANGLE);
        assert_eq!((far.sides[2], far.sides[0]), (8.0, f64::INFINITY));
        assert_eq!(far.alpha_beta(), None);
    }
}

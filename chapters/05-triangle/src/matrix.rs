//! CSC418 11.3.1, the second way: three equations for α, β and λ.

use math::{Degenerate, Hit, Parallel, Ray3, Real, Span, Vector};

use crate::parallel::{parallel, try_parallel};
use crate::{Hit3, Triangle};

/// Every number of the second way.
///
/// ā + λ d = p̄1 + α (p̄2 − p̄1) + β (p̄3 − p̄1) is M (α, β, λ)ᵀ = p̄1 − ā. The page says "invert the matrix";
/// here it is done by Cramer's rule, so that every determinant is a number one can look at. An unknown is the
/// determinant of M with the unknown's column replaced by p̄1 − ā, over that of M.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix<R: Real> {
    /// The ray ā + λ d.
    pub ray: Ray3<R>,
    /// The triangle.
    pub triangle: Triangle<R>,
    /// The columns of M: −(p̄2 − p̄1), −(p̄3 − p̄1), d.
    pub m: [R::Vec3; 3],
    /// p̄1 − ā, the right-hand side.
    pub to_p1: R::Vec3,
    /// det M, which is d · n.
    pub det: R,
    /// With p̄1 − ā as the first column.
    pub det_alpha: R,
    /// With p̄1 − ā as the second column.
    pub det_beta: R,
    /// With p̄1 − ā as the third column; it is (p̄1 − ā) · n.
    pub det_lambda: R,
    /// α = det_alpha / det
    pub alpha: R,
    /// β = det_beta / det
    pub beta: R,
    /// λ = det_lambda / det, in lengths of d. Like α and β infinite or NaN where det is zero.
    pub lambda: R,
}

/// Works out the second way of CSC418 11.3.1, for a direction of any length but zero.
///
/// A degenerate ray or triangle, and a ray along the plane, give values that mean nothing; [`Matrix::hit`] sorts
/// them out.
#[inline]
pub fn matrix<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Matrix<R> {
    let Triangle { p1, p2, p3 } = *triangle;

    // ā + λ d = p̄1 + α (p̄2 − p̄1) + β (p̄3 − p̄1)
    // exercise system: With all unknowns on the left, and p̄1 − ā on the right, which columns do α, β and λ have?
    // M (α, β, λ)ᵀ = p̄1 − ā
    let m: [R::Vec3; 3] = [-(p2 - p1), -(p3 - p1), ray.direction];
    // end system
    let to_p1 = p1 - ray.origin;

    // Cramer's rule
    let det = determinant::<R>(m[0], m[1], m[2]);
    // exercise cramer: Which column of M does the right-hand side take the place of, for each unknown?
    let det_alpha = determinant::<R>(to_p1, m[1], m[2]);
    let det_beta = determinant::<R>(m[0], to_p1, m[2]);
    let det_lambda = determinant::<R>(m[0], m[1], to_p1);
    // end cramer

    // exercise solve: What is each unknown, now that the four determinants are there?
    let [alpha, beta, lambda] = [det_alpha, det_beta, det_lambda].map(|of_unknown| of_unknown / det);
    // end solve

    let (ray, triangle) = (*ray, *triangle);
    Matrix { ray, triangle, m, to_p1, det, det_alpha, det_beta, det_lambda, alpha, beta, lambda }
}

/// The determinant of three columns: the triple product (x × y) · z.
#[inline(always)]
fn determinant<R: Real>(x: R::Vec3, y: R::Vec3, z: R::Vec3) -> R {
    R::cross(x, y).dot(z)
}

impl<R: Real> Matrix<R> {
    /// What d · n = 0, the singular matrix, means; decided exactly: see [`parallel`]. Means nothing for what
    /// [`Triangle::check`] refuses.
    pub fn parallel(&self) -> Option<Parallel> {
        parallel(&self.ray, &self.triangle)
    }

    /// α and β; `None` where there is no single solution, or one of its numbers overflows.
    #[inline]
    pub fn alpha_beta(&self) -> Option<(R, R)> {
        (self.alpha.is_finite() && self.beta.is_finite()).then_some((self.alpha, self.beta))
    }

    /// α ≥ 0, β ≥ 0 and α + β ≤ 1: the page's conditions. They say nothing of λ.
    #[inline]
    pub fn is_inside(&self) -> bool {
        // exercise inside: Which α and β do the points of the triangle have?
        self.alpha >= R::from(0.0) && self.beta >= R::from(0.0) && self.alpha + self.beta <= R::from(1.0)
        // end inside
    }

    /// The hit, where the page's conditions hold and t = λ lies in `span`. The normal is n / ‖n‖, not turned
    /// toward the ray.
    ///
    /// `None` for a miss, which a ray along the plane is, too; [`Degenerate`] for a question without an
    /// answer, see [`Triangle::check`].
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        if try_parallel(&self.ray, &self.triangle)?.is_some() {
            return Ok(None);
        }
        // exercise counts: The point is in the triangle: what else makes it a hit?
        let counts: bool = self.is_inside() && span.contains(self.lambda);
        // end counts
        if !counts {
            return Ok(None);
        }
        let t = self.lambda + R::from(0.0); // minus zero is zero
        Ok(Some(Hit { t, point: self.ray.at(t), normal: self.triangle.normal().normalized() }))
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

    fn work(x: f64, y: f64, z: f64) -> Matrix<f64> {
        matrix(&Ray3::new(DVec3::ZERO, DVec3::new(x, y, z)), &TRIANGLE)
    }

    #[test]
    fn a_ray_through_the_inside() {
        // by hand, with the columns (−4,0,0), (0,−2,0), (1,¾,1) and the right-hand side (1,1,2):
        // det = 8, det_α = −2 (1 − 2) = 2, det_β = −4 (1 − 1½) = 2, det_λ = 8 · 2 = 16
        let work = work(1.0, 0.75, 1.0);
        assert_eq!([work.det, work.det_alpha, work.det_beta, work.det_lambda], [8.0, 2.0, 2.0, 16.0]);
        assert_eq!([work.alpha, work.beta, work.lambda], [0.25, 0.25, 2.0]);
        // put back into the equation: M (α, β, λ)ᵀ = p̄1 − ā
        let [m1, m2, m3] = work.m;
        assert_eq!(m1 * work.alpha + m2 * work.beta + m3 * work.lambda, work.to_p1);
        let hit = work.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point, hit.normal), (2.0, DVec3::new(2.0, 1.5, 2.0), DVec3::Z));
        assert_eq!((work.parallel(), work.alpha_beta()), (None, Some((0.25, 0.25))));
    }

    /// The page's conditions lack λ ≥ 0 (slip 23).
    #[test]
    fn as_printed_a_triangle_behind_the_eye_is_hit() {
        let behind = work(-1.0, -0.75, -1.0);
        assert!(behind.is_inside(), "as printed");
        assert_eq!((behind.lambda, behind.hit(Span::ahead())), (-2.0, Ok(None)));
        let touching = matrix(&Ray3::new(TRIANGLE.p1, DVec3::Z), &TRIANGLE);
        assert_eq!(touching.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0.0_f64.to_bits());
    }

    #[test]
    fn each_condition_cuts_something_off() {
        // by hand: α = (x − 1)/4 and β = (y − 1)/2
        for (x, y, alpha, beta) in [(2.0, 0.5, 0.25, -0.25), (4.0, 2.0, 0.75, 0.5), (0.5, 1.5, -0.125, 0.25)]
        {
            let work = work(x / 2.0, y / 2.0, 1.0);
            assert_eq!(work.alpha_beta(), Some((alpha, beta)));
            assert_eq!(work.hit(Span::ahead()), Ok(None));
        }
    }

    #[test]
    fn a_ray_along_the_plane_is_a_miss_with_a_reason() {
        let apart = work(1.0, 0.0, 0.0);
        assert_eq!((apart.det, apart.parallel()), (0.0, Some(Parallel::Apart)));
        assert_eq!((apart.hit(Span::ahead()), apart.alpha_beta()), (Ok(None), None));
        let within = matrix(&Ray3::new(DVec3::new(0.0, 1.5, 2.0), DVec3::X), &TRIANGLE);
        assert_eq!((within.parallel(), within.hit(Span::ahead())), (Some(Parallel::Within), Ok(None)));
    }

    #[test]
    fn questions_without_an_answer_are_refused() {
        let still = matrix(&Ray3::new(DVec3::ZERO, DVec3::ZERO), &TRIANGLE);
        assert_eq!(still.hit(Span::ahead()), Err(Degenerate::ZeroDirection));
        let line = Triangle { p3: DVec3::new(3.0, 1.0, 2.0), ..TRIANGLE };
        let flat = matrix(&Ray3::new(DVec3::ZERO, DVec3::Z), &line);
        assert_eq!(flat.hit(Span::ahead()), Err(Degenerate::NoArea));
    }

    /// By hand: det = −8, and so λ = 0/−8, which is −0.
    #[test]
    fn a_ray_that_leaves_the_corner_downward_starts_at_zero() {
        let touching = matrix(&Ray3::new(TRIANGLE.p1, -DVec3::Z), &TRIANGLE);
        assert_eq!(touching.lambda.to_bits(), (-0.0_f64).to_bits());
        assert_eq!(touching.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0.0_f64.to_bits());
    }

    /// By hand, above (1½, 2^1022): det_α = −2 (1 − 1½) = 1 of 8, and det_β = −4 (1 − 2^1022) overflows.
    #[test]
    fn there_are_two_shares_or_none() {
        let far = matrix(&Ray3::new(DVec3::new(1.5, 2.0_f64.powi(1022), 0.0), DVec3::Z), &TRIANGLE);
        assert_eq!((far.alpha, far.beta), (0.125, f64::INFINITY));
        assert_eq!(far.alpha_beta(), None);
    }
}

//! Why the others leak, and what to do about it.
//!
//! Two triangles of a mesh share an edge, and a ray that passes it must meet one of them. Each decides for itself. In
//! [`mod@half_planes`](mod@crate::half_planes) the point x is rounded, and beside the plane of either triangle; in
//! [`mod@matrix`](mod@crate::matrix) the one has α + β ≤ 1 where the other has β ≥ 0, which are the same question put in
//! different numbers. Where both are wrong the ray slips between them: the mesh leaks. A tolerance closes the crack and opens
//! another: then rays are hit that pass outside of the last triangle, and some are hit twice.
//!
//! The cure is to be right. The side on which the line of the ray passes an edge is the sign of a volume,
//! d · (B × C) for corners B and C seen from ā, and no division is needed for it. If no volume is negative, or none
//! positive, the line passes through the triangle. A triangle is closed, so what passes through a shared edge meets
//! both neighbors, and what passes beside it meets the one on that side: with every sign exact, nothing slips through. The
//! triangles need not know of each other.
//!
//! Three ways of taking the signs follow, each slower and surer than the one before; a ray takes the first whose error
//! bound says that what is left over can matter neither to the verdict nor to λ.
//!
//! 1. **At once** (`at_once.rs`): the determinants of the page's matrix in plain `f64`, with a bound on their error. The
//!    quotient λ is good enough for an `f32`. For an `f64` it is put back into the equations, and what they leave
//!    corrects it (`correction.rs`).
//! 2. **With twice the digits** ([`math::two_part`]): rays aimed at an edge, slivers, and rays that graze.
//! 3. **Exactly**, in integers as long as it takes ([`math::exact`]): rays exactly through an edge, origins next to the plane,
//!    and products that overflow or vanish.
//!
//! What this promises for every finite ray and triangle: hit or miss is exact, and λ is within one unit of the last digit of the
//! number nearest to it, in `f32` and in `f64`. What it costs is told by `trade`.

mod at_once;
mod carefully;
mod correction;

use math::plain::dot;
use math::{Certainty, Degenerate, Hit, Parallel, Ray3, Real, Span, Vector};

use crate::parallel::parallel;
use crate::{Hit3, Triangle};

/// Every number of the robust method. What is worked out with more digits is rounded for the reader.
///
/// A degenerate ray or triangle gives values that mean nothing; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray ā + λ d.
    pub ray: Ray3<R>,
    /// The triangle.
    pub triangle: Triangle<R>,
    /// With A, B and C the corners seen from ā, p̄1 − ā and so on: d · (B × C), d · (C × A), d · (A × B). Each belongs to an
    /// edge and tells on which side of it the ray passes; and each is the weight of the corner across. Where none is
    /// negative, or none positive, the line of the ray passes through the triangle.
    pub volumes: [f64; 3],
    /// d · n, which is what the three volumes sum to.
    pub d_dot_n: f64,
    /// λ = (p̄1 − ā) · n / d · n in lengths of d, which may be negative, where the line of the ray passes
    /// through the triangle; else `None`.
    pub lambda: Option<R>,
    /// How the verdict was reached, and λ.
    pub certainty: Certainty,
    passage: Passage,
    /// λ with the digits of `f64`, for the point.
    fine_lambda: f64,
    /// n, where plain `f64` is enough for it.
    n: Option<[f64; 3]>,
}

/// How the line of the ray passes the triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Passage {
    /// Through it: its inside, an edge or a corner.
    Through,
    /// Past it.
    Past,
    /// Along its plane: all three volumes are zero.
    Along,
    /// The ray or the triangle is degenerate.
    Degenerate,
}

/// Works out the robust method, for a direction of any length but zero.
#[inline(always)]
pub fn robust<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Robust<R> {
    at_once::robust(ray, triangle).unwrap_or_else(|| carefully::robust(*ray, *triangle))
}

impl<R: Real> Robust<R> {
    /// What d · n = 0 means, decided exactly: see [`parallel`]. Means nothing for what [`Triangle::check`]
    /// refuses.
    pub fn parallel(&self) -> Option<Parallel> {
        parallel(&self.ray, &self.triangle)
    }

    /// α and β, off by less than a unit of the last digit: the second and third volume as shares of d · n. `None` where
    /// there is no such point.
    pub fn alpha_beta(&self) -> Option<(R, R)> {
        carefully::alpha_beta(&self.ray, &self.triangle)
    }

    /// The hit, where the line of the ray passes through the triangle and its t = λ lies in `span`. The
    /// normal is n / ‖n‖, not turned toward the ray.
    ///
    /// `None` for a miss, which a ray along the plane is, too; [`Degenerate`] for a question without an
    /// answer, see [`Triangle::check`].
    #[inline(always)]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        if self.passage == Passage::Degenerate {
            return self.triangle.check(&self.ray).map(|()| None);
        }
        let Some(t) = self.lambda.filter(|&lambda| span.contains(lambda)) else { return Ok(None) };
        Ok(Some(Hit { t, point: self.point(), normal: self.unit_normal() }))
    }

    /// x = ā + λ d
    #[inline(always)]
    fn point(&self) -> R::Vec3 {
        let [o, d] = [self.ray.origin, self.ray.direction].map(Vector::in_f64::<3>);
        let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| o[axis] + self.fine_lambda * d[axis]);
        if !are_ordinary(self.fine_lambda, [x, y, z]) {
            return carefully::point(self.ray, self.triangle);
        }
        R::vec3(R::round_from(x), R::round_from(y), R::round_from(z))
    }

    /// n / ‖n‖
    #[inline(always)]
    fn unit_normal(&self) -> R::Vec3 {
        let Some(n) = self.n else { return carefully::unit_normal(self.triangle) };
        let one_over = 1.0 / dot(n, n).sqrt();
        let [x, y, z] = n.map(|component| R::round_from(component * one_over));
        R::vec3(x, y, z)
    }
}

/// Whether plain `f64` is enough for a point: λ may be infinite or vanish, and λ d may overflow, though x does not.
#[inline(always)]
fn are_ordinary(lambda: f64, [x, y, z]: [f64; 3]) -> bool {
    (x + y + z).is_finite() && lambda.abs() >= f64::MIN_POSITIVE
}

#[cfg(test)]
mod tests;

//! Chapter 05's `matrix` for eight triangles: the same function, called in a loop that the compiler turns
//! into wide instructions.
//!
//! So every lane has the bits of one triangle alone. Möller and Trumbore's two cross products would save a
//! fifth of the operations, but then t had other last digits than the method that it stands for.

use math::{Ray3, Real, Span};
use triangle::Triangle;
use triangle::parallel::try_parallel;

use super::block::{Block, LaneSet};
use super::mesh::Lanes;
use super::node::{Column, LANES};

/// By `matrix`.
pub(crate) struct ByMatrix;

impl<R: Real> Lanes<R> for ByMatrix {
    #[inline(always)]
    fn candidates(&self, block: &Block<R>, ray: &Ray3<R>, span: Span<R>) -> (Column<R>, LaneSet) {
        let (zero, one, none) = (R::from(0.0), R::from(1.0), R::from(-1.0));
        let mut t = [none; LANES];
        for (lane, t) in t.iter_mut().enumerate() {
            let work = triangle::matrix(ray, &block.triangle(lane));
            let (alpha, beta, lambda) = (work.alpha, work.beta, work.lambda);
            // `Matrix::is_inside` and `Span::contains`, without a branch
            let is_inside = (alpha >= zero) & (beta >= zero) & (alpha + beta <= one);
            let is_hit = is_inside & (span.min <= lambda) & (lambda <= span.max);
            *t = if is_hit { lambda + zero } else { none };
        }
        (t, LaneSet::not_negative(&t))
    }

    /// What is left to ask is whether there was one λ.
    #[inline(always)]
    fn hit(&self, ray: &Ray3<R>, triangle: &Triangle<R>, _span: Span<R>, t: R) -> Option<R> {
        (try_parallel(ray, triangle) == Ok(None)).then_some(t)
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Uncounted, WideMesh};
    use glam::DVec3;
    use triangle::Method;

    /// From the triangle's plane, up or down: one of the two is −0 as computed, and none as it is answered.
    #[test]
    fn a_hit_at_the_origin_is_not_at_minus_zero() {
        let corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let triangle = Triangle { p1: corners[0], p2: corners[1], p3: corners[2] };
        let mesh = WideMesh::of_triangles(&[triangle]);
        for direction in [DVec3::Z, -DVec3::Z] {
            let ray = Ray3::<f64>::new(DVec3::new(1.0, 1.0, 0.0), direction);
            let hit = mesh.closest(Method::Matrix, &ray, Span::ahead(), &mut Uncounted);
            assert_eq!(hit.map(|(face, t)| (face, t.to_bits())), Some((0, 0)), "{direction}");
        }
    }
}

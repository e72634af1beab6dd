//! A mesh: triangles, eight at a time.

use math::{Ray3, Real, Span};
use triangle::mesh::Mesh;
use triangle::{Method, Triangle};

use super::binary;
use super::block::{Block, LaneSet};
use super::collapse::{Prices, collapse};
use super::dispatch::{Instructions, Version};
use super::matrix::ByMatrix;
use super::node::{Child, Column, Node};
use super::robust::ByRobust;
use super::search::{Leaves, Search, Stack};
use crate::{Box3, Nearest, Tally};

/// A tree over triangles, eight wide, that holds their corners.
#[derive(Clone, Debug)]
pub struct WideMesh<R> {
    nodes: Vec<Node>,
    /// One a leaf.
    blocks: Vec<Block<R>>,
    stack: Stack,
    version: Version,
}

impl<R: Real> WideMesh<R> {
    /// A tree over the faces of a mesh, of which there are fewer than 2²⁷; with more it panics.
    pub fn of_mesh(mesh: &Mesh<R>) -> WideMesh<R> {
        WideMesh::build(mesh.faces().len(), |face| mesh.triangle(face))
    }

    /// A tree over triangles with finite corners, as many as for a mesh. One without an area is never hit.
    pub fn of_triangles(triangles: &[Triangle<R>]) -> WideMesh<R> {
        WideMesh::build(triangles.len(), |face| triangles[face])
    }

    fn build(count: usize, triangle: impl Fn(usize) -> Triangle<R>) -> WideMesh<R> {
        let boxes: Vec<Box3> = (0..count).map(|face| Box3::around::<R>(triangle(face).corners())).collect();
        let tree = binary(&boxes, 4..=4);
        let mut nodes = collapse(&tree, Prices::BLOCKS);
        let mut blocks = Vec::new();
        for node in &mut nodes {
            for child in node.children.iter_mut().filter(|child| child.is_leaf() && child.len() > 0) {
                let faces = &tree.order[child.first()..][..child.len()];
                *child = Child::leaf(blocks.len(), faces.len());
                blocks.push(Block::of(faces, &triangle));
            }
        }
        WideMesh { stack: Stack::of(&nodes), nodes, blocks, version: Version::of(Instructions::Best) }
    }

    /// There is no triangle.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// The same tree, searched with these instructions. The answers are the same.
    pub fn with(self, instructions: Instructions) -> WideMesh<R> {
        WideMesh { version: Version::of(instructions), ..self }
    }

    /// The nearest face that `method` hits in `span`, by its place in the mesh, and its t; at the same t the
    /// earlier face. `None` for a miss. What else there is to say of the hit, the method says for that face.
    /// The ray must be a ray.
    ///
    /// With `robust`, exactly what [`Mesh::hit`] says. The other two may be wrong about a ray beside the
    /// triangle, or about t by more than [`Reach::ULPS`](crate::Reach::ULPS) where it grazes: such a hit is
    /// then missed if its box is.
    #[inline]
    pub fn closest(
        &self,
        method: Method,
        ray: &Ray3<R>,
        span: Span<R>,
        counts: &mut impl Tally,
    ) -> Option<(usize, R)> {
        self.search::<false>(method, ray, span, counts)
    }

    /// Whether `method` hits any face in `span`: the search ends with the first.
    #[inline]
    pub fn any(&self, method: Method, ray: &Ray3<R>, span: Span<R>, counts: &mut impl Tally) -> bool {
        self.search::<true>(method, ray, span, counts).is_some()
    }

    #[inline(always)]
    fn search<const ANY: bool>(
        &self,
        method: Method,
        ray: &Ray3<R>,
        span: Span<R>,
        counts: &mut impl Tally,
    ) -> Option<(usize, R)> {
        match method {
            Method::Matrix => self.search_by::<_, ANY>(ByMatrix, ray, span, counts),
            Method::Robust => self.search_by::<_, ANY>(ByRobust, ray, span, counts),
            Method::HalfPlanes => self.search_by::<_, ANY>(ByHalfPlanes, ray, span, counts),
        }
    }

    #[inline(always)]
    fn search_by<L: Lanes<R>, const ANY: bool>(
        &self,
        lanes: L,
        ray: &Ray3<R>,
        span: Span<R>,
        counts: &mut impl Tally,
    ) -> Option<(usize, R)> {
        let leaves = Blocks { blocks: &self.blocks, ray, lanes };
        let (nodes, stack) = (&self.nodes, self.stack);
        self.version.run(Search::<R, _, _, ANY> { nodes, stack, ray, span, counts, leaves })
    }
}

/// A method for eight triangles.
pub(crate) trait Lanes<R: Real> {
    /// Which of them may be hit, and a number for each.
    fn candidates(&self, block: &Block<R>, ray: &Ray3<R>, span: Span<R>) -> (Column<R>, LaneSet);
    /// The t of a candidate, with the number that came with it.
    fn hit(&self, ray: &Ray3<R>, triangle: &Triangle<R>, span: Span<R>, number: R) -> Option<R>;
}

/// By `half-planes`, one after the other.
struct ByHalfPlanes;

impl<R: Real> Lanes<R> for ByHalfPlanes {
    fn candidates(&self, _block: &Block<R>, _ray: &Ray3<R>, _span: Span<R>) -> (Column<R>, LaneSet) {
        ([R::from(0.0); super::node::LANES], LaneSet::first(super::node::LANES))
    }

    fn hit(&self, ray: &Ray3<R>, triangle: &Triangle<R>, span: Span<R>, _number: R) -> Option<R> {
        triangle::half_planes(ray, triangle).hit(span).ok()?.map(|hit| hit.t)
    }
}

/// Leaves that are blocks.
struct Blocks<'a, R: Real, L> {
    blocks: &'a [Block<R>],
    ray: &'a Ray3<R>,
    lanes: L,
}

impl<R: Real, C: Tally, L: Lanes<R>> Leaves<R, C> for Blocks<'_, R, L> {
    #[inline(always)]
    fn visit(&mut self, leaf: Child, nearest: &mut Nearest<R>, counts: &mut C) {
        let block = &self.blocks[leaf.first()];
        counts.tests(leaf.len());
        let (numbers, candidates) = self.lanes.candidates(block, self.ray, nearest.span);
        let mut candidates = candidates.and(LaneSet::first(leaf.len()));
        while !candidates.is_empty() {
            let lane = candidates.take(true);
            let t = self.lanes.hit(self.ray, &block.triangle(lane), nearest.span, numbers[lane]);
            if let Some(t) = t.filter(|&t| nearest.span.contains(t)) {
                counts.hit();
                nearest.put(block.faces[lane] as usize, t);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Wide;

    #[test]
    fn a_tree_is_searched_with_what_was_asked_for() {
        for instructions in [Instructions::Baseline, Instructions::Best] {
            let version = Version::of(instructions);
            assert_eq!(Wide::build(&[]).with(instructions).version, version);
            assert_eq!(WideMesh::<f64>::of_triangles(&[]).with(instructions).version, version);
        }
    }
}

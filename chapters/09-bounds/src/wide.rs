//! The fast corner: a tree eight wide. No other chapter needs to understand it.
//!
//! [`Tree`] asks of two boxes at a time. An AVX register holds eight numbers of `f32`, so eight
//! boxes cost little more than one, if they stand side by side in memory. That changes everything a little:
//!
//! 1. **Nodes of eight** (`node.rs`), with a column for each face. They are collapsed from a binary tree
//!    (`collapse.rs`), so that as few as possible are opened.
//! 2. **The search** (`search.rs`) gets t for eight boxes and a bit for each that the ray enters. Those wait
//!    with their t, the nearest on top, and what has come to lie behind a hit is dropped when its turn comes.
//! 3. **Triangles in blocks of eight** ([`WideMesh`]), which are tested at once: by chapter 05's `matrix`,
//!    eight times the same formula, or by a test in plain numbers that only says who is surely missed, before
//!    chapter 05's `robust`.
//! 4. **Instructions chosen at run time** (`dispatch.rs`), as in chapter 04: the loops are written plainly,
//!    one lane after the other, and compiled twice.
//!
//! Every lane is rounded as a number by itself would be, and nothing is fused. So neither an answer nor a
//! count depends on the instructions, and an answer is the one of going through all objects in turn.

mod block;
mod collapse;
mod dispatch;
mod matrix;
mod mesh;
mod node;
mod robust;
mod search;
mod spheres;

use std::ops::RangeInclusive;

use math::{Ray3, Real, Span};

use crate::tree::build;
use crate::{Box3, Nearest, Tally, Tree};
use collapse::{Prices, collapse};
pub(crate) use dispatch::{Version, Work};
use node::{Child, Node};
use search::{Leaves, Search, Stack};
pub(crate) use spheres::{Passages, Spheres};

pub use dispatch::Instructions;
pub use mesh::WideMesh;

/// A tree over boxes, eight wide, with the searches of [`Tree`].
#[derive(Clone, Debug)]
pub struct Wide {
    nodes: Vec<Node>,
    order: Vec<u32>,
    stack: Stack,
    version: Version,
}

impl Wide {
    /// A tree over boxes, of which there are fewer than 2²⁷; with more it panics.
    pub fn build(boxes: &[Box3]) -> Wide {
        let tree = binary(boxes, 1..=2);
        let nodes = collapse(&tree, Prices::ONE_BY_ONE);
        Wide { stack: Stack::of(&nodes), nodes, order: tree.order, version: Version::of(Instructions::Best) }
    }

    /// The same tree, searched with these instructions. The answers are the same.
    pub fn with(self, instructions: Instructions) -> Wide {
        Wide { version: Version::of(instructions), ..self }
    }

    /// The same tree, in which each object goes by the name of its place in `names`, which must ascend: of
    /// two at the same t the earlier one still wins. A search then has nothing to look up.
    pub(crate) fn naming(mut self, names: &[usize]) -> Wide {
        for name in &mut self.order {
            *name = names[*name as usize] as u32;
        }
        self
    }

    /// The object with the smallest t in `span`, and that t: see [`Tree::closest`].
    #[inline]
    pub fn closest<R: Real>(
        &self,
        ray: &Ray3<R>,
        span: Span<R>,
        counts: &mut impl Tally,
        test: impl FnMut(usize, Span<R>) -> Option<R>,
    ) -> Option<(usize, R)> {
        self.search::<R, false>(ray, span, counts, test)
    }

    /// Whether any object is hit in `span`: see [`Tree::any`].
    #[inline]
    pub fn any<R: Real>(
        &self,
        ray: &Ray3<R>,
        span: Span<R>,
        counts: &mut impl Tally,
        mut test: impl FnMut(usize, Span<R>) -> bool,
    ) -> bool {
        let somewhere = |index, span: Span<R>| test(index, span).then_some(span.max);
        self.first_found(ray, span, counts, somewhere).is_some()
    }

    /// The first object that is found to be hit in `span`, and its t; which one that is depends on the tree.
    /// `test(index, span)` as for [`Wide::closest`].
    #[inline]
    pub fn first_found<R: Real>(
        &self,
        ray: &Ray3<R>,
        span: Span<R>,
        counts: &mut impl Tally,
        test: impl FnMut(usize, Span<R>) -> Option<R>,
    ) -> Option<(usize, R)> {
        self.search::<R, true>(ray, span, counts, test)
    }

    #[inline(always)]
    fn search<R: Real, const ANY: bool>(
        &self,
        ray: &Ray3<R>,
        span: Span<R>,
        counts: &mut impl Tally,
        test: impl FnMut(usize, Span<R>) -> Option<R>,
    ) -> Option<(usize, R)> {
        let leaves = OneByOne { order: &self.order, test };
        let (nodes, stack) = (&self.nodes, self.stack);
        self.version.run(Search::<R, _, _, ANY> { nodes, stack, ray, span, counts, leaves })
    }
}

/// The binary tree that is then collapsed.
fn binary(boxes: &[Box3], leaves: RangeInclusive<usize>) -> Tree {
    struct Build<'a>(&'a [Box3], RangeInclusive<usize>);
    impl Work for Build<'_> {
        type Answer = Tree;
        #[inline(always)]
        fn run(self) -> Tree {
            build::tree(self.0, self.1)
        }
    }
    assert!(boxes.len() < Child::MOST, "{} boxes are too many", boxes.len());
    Version::of(Instructions::Best).run(Build(boxes, leaves))
}

/// Leaves whose objects only the caller knows.
struct OneByOne<'a, F> {
    order: &'a [u32],
    test: F,
}

impl<R: Real, C: Tally, F: FnMut(usize, Span<R>) -> Option<R>> Leaves<R, C> for OneByOne<'_, F> {
    #[inline(always)]
    fn visit(&mut self, leaf: Child, nearest: &mut Nearest<R>, counts: &mut C) {
        counts.tests(leaf.len());
        for &index in &self.order[leaf.first()..][..leaf.len()] {
            if let Some(t) = (self.test)(index as usize, nearest.span) {
                counts.hit();
                nearest.put(index as usize, t);
            }
        }
    }
}

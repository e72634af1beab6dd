//! A bounding volume hierarchy: boxes in boxes.
//!
//! CSC418 11.5 bounds an object, so that a ray that misses the bound need not be tried on the object. Bound
//! the bounds in the same way, two and two together, and a ray that misses one large box is done with all
//! that is in it: with half of the scene, then half of the rest. A million objects are twenty such halves.
//!
//! It is built in `tree/build.rs` and searched here, with a list of what is still to do in place of
//! recursion. The nearer one of two boxes is looked into first. What is found there often lies before the
//! other one, which then is never opened.

pub(crate) mod build;

use math::{Ray3, Real, Span};

use crate::{Box3, Nearest, Slabs, Tally};
use build::MAX_DEPTH;

/// A box, and what is in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Node {
    /// Around all that is in it.
    pub(crate) bounds: Box3,
    /// Of a leaf, its first place in the order; of another node, its first child. The second child follows
    /// it.
    pub(crate) first: u32,
    /// How many objects a leaf has; 0 for another node.
    pub(crate) count: u32,
}

/// A tree over boxes. It knows no objects: who searches it brings the test of one object, by its place among
/// the boxes.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The root first. None for no boxes at all.
    pub(crate) nodes: Vec<Node>,
    /// The places of the boxes, leaf after leaf.
    pub(crate) order: Vec<u32>,
}

impl Tree {
    /// A tree over boxes, of which there are fewer than 2³².
    pub fn build(boxes: &[Box3]) -> Tree {
        build::tree(boxes, 1..=4)
    }

    /// The object with the smallest t in `span`, and that t; `None` if none is hit. At the same t the earlier
    /// object wins.
    ///
    /// `test(index, span)` is the t of one object if it is hit in that span, which shrinks as hits are found.
    /// The answer is exactly that of trying all objects in turn, if each test's t is within
    /// [`Reach::ULPS`](crate::Reach::ULPS) of a point in the object's box. The ray must be a ray. A span that
    /// begins below zero is taken to begin at zero.
    pub fn closest<R: Real>(
        &self,
        ray: &Ray3<R>,
        span: Span<R>,
        counts: &mut impl Tally,
        test: impl FnMut(usize, Span<R>) -> Option<R>,
    ) -> Option<(usize, R)> {
        self.search::<R, false>(ray, span, counts, test)
    }

    /// Whether any object is hit in `span`: the search ends with the first. `test(index, span)` says so of
    /// one.
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
    /// `test(index, span)` as for [`Tree::closest`].
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

    /// Tests what is in the boxes that the ray enters before the nearest hit so far; `ANY`: until something
    /// is hit.
    #[inline(always)]
    fn search<R: Real, const ANY: bool>(
        &self,
        ray: &Ray3<R>,
        span: Span<R>,
        counts: &mut impl Tally,
        mut test: impl FnMut(usize, Span<R>) -> Option<R>,
    ) -> Option<(usize, R)> {
        let slabs = Slabs::new(ray);
        let mut nearest = Nearest::new(span);
        let mut at = self.nodes.first()?;
        counts.boxes(1);
        slabs.enter(&at.bounds, nearest.reach)?;

        // what is still to do, with the t where the ray enters it: one sibling on each level, and one more
        let mut waiting = [(0.0, at); MAX_DEPTH + 1];
        let mut count = 0;
        loop {
            if at.count > 0 {
                counts.tests(at.count as usize);
                for &index in &self.order[at.first as usize..][..at.count as usize] {
                    if let Some(t) = test(index as usize, nearest.span) {
                        counts.hit();
                        nearest.put(index as usize, t);
                        if ANY {
                            return nearest.hit();
                        }
                    }
                }
            } else {
                counts.boxes(2);
                let below = count;
                for child in &self.nodes[at.first as usize..][..2] {
                    if let Some(t) = slabs.enter(&child.bounds, nearest.reach) {
                        waiting[count] = (t, child);
                        count += 1;
                    }
                }
                // the nearer one on top; of two at the same t, which do not matter, the second
                if count == below + 2 && waiting[below].0 < waiting[below + 1].0 {
                    waiting.swap(below, below + 1);
                }
            }
            // the latest that waits, if the ray does not hit before it
            loop {
                let Some(top) = count.checked_sub(1) else { return nearest.hit() };
                count = top;
                at = waiting[top].1;
                if waiting[top].0 <= nearest.reach.max {
                    break;
                }
            }
        }
    }
}

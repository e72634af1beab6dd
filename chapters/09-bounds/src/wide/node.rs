//! Eight boxes side by side, as columns.

use super::block::LaneSet;
use crate::extent::Extent;
use crate::slab::{larger, smaller};
use crate::{Box3, Reach, Slabs};

/// How many children a node has at most: one AVX2 register of `f32`.
pub(crate) const LANES: usize = 8;

/// One number of every lane.
pub(crate) type Column<R> = [R; LANES];

/// The boxes of up to eight children, and what is in them.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Node {
    /// By axis, then low and high: [`Slabs::first`] picks one.
    faces: [[Column<f32>; 2]; 3],
    /// An empty leaf in every lane that is not taken.
    pub(crate) children: Column<Child>,
    /// How many lanes are taken.
    pub(crate) count: u32,
    /// Along which axis the lanes are in order.
    pub(crate) axis: u32,
}

/// Another node, or a leaf: the first of its objects and how many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Child(pub(crate) u32);

impl Child {
    const LEAF: u32 = 1 << 31;
    const COUNT: u32 = 4;
    pub(crate) const EMPTY: Child = Child(Child::LEAF);
    /// How many objects there may be.
    pub(crate) const MOST: usize = 1 << (31 - Child::COUNT);

    pub(crate) fn node(index: usize) -> Child {
        Child(index as u32)
    }

    pub(crate) fn leaf(first: usize, count: usize) -> Child {
        Child(Child::LEAF | (first as u32) << Child::COUNT | count as u32)
    }

    #[inline(always)]
    pub(crate) fn is_leaf(self) -> bool {
        self.0 & Child::LEAF != 0
    }

    #[inline(always)]
    pub(crate) fn first(self) -> usize {
        ((self.0 & !Child::LEAF) >> Child::COUNT) as usize
    }

    #[inline(always)]
    pub(crate) fn len(self) -> usize {
        (self.0 & ((1 << Child::COUNT) - 1)) as usize
    }
}

impl Node {
    /// No lane is taken.
    pub(crate) fn empty() -> Node {
        let [low, high] = [f32::INFINITY, f32::NEG_INFINITY].map(|face| [face; LANES]);
        Node { faces: [[low, high]; 3], children: [Child::EMPTY; LANES], count: 0, axis: 0 }
    }

    /// A node with these children, not more than eight: in the order of their middles, along the axis where
    /// those reach farthest.
    pub(crate) fn of(children: &mut [(Box3, Child)]) -> Node {
        let middles = children.iter().map(|(bounds, _)| Extent::of(bounds).twice_middles());
        let [x, y, z] = middles.fold(Extent::EMPTY, |all, one| all.union(&one)).size();
        let axis = if x >= y && x >= z { 0 } else { 1 + usize::from(z > y) };
        let middle = |bounds: &Box3| Extent::of(bounds).twice_middle(axis);
        children.sort_unstable_by(|(a, _), (b, _)| middle(a).total_cmp(&middle(b)));
        let mut node = Node { axis: axis as u32, count: children.len() as u32, ..Node::empty() };
        for (lane, (bounds, child)) in children.iter().enumerate() {
            for axis in 0..3 {
                node.faces[axis][0][lane] = bounds.low[axis];
                node.faces[axis][1][lane] = bounds.high[axis];
            }
            node.children[lane] = *child;
        }
        node
    }

    /// [`Slabs::enter`] for every lane: t, and which boxes the ray enters.
    #[inline(always)]
    pub(crate) fn enter(&self, slabs: &Slabs, reach: Reach) -> (Column<f32>, LaneSet) {
        let [x, y, z] = &self.faces;
        let [i, j, k] = slabs.first;
        let (first_x, first_y, first_z) = (&x[i & 1], &y[j & 1], &z[k & 1]);
        let (last_x, last_y, last_z) = (&x[1 - (i & 1)], &y[1 - (j & 1)], &z[1 - (k & 1)]);
        let ([enter_x, enter_y, enter_z], [leave_x, leave_y, leave_z]) = (slabs.enter, slabs.leave);
        let mut near = [0.0; LANES];
        for lane in 0..LANES {
            let t = larger(enter_x.t(first_x[lane]), reach.min);
            let t = larger(enter_y.t(first_y[lane]), t);
            let t = larger(enter_z.t(first_z[lane]), t);
            let end = smaller(leave_x.t(last_x[lane]), reach.max);
            let end = smaller(leave_y.t(last_y[lane]), end);
            let end = smaller(leave_z.t(last_z[lane]), end);
            near[lane] = if t <= end { t } else { -1.0 };
        }
        (near, LaneSet::not_negative(&near))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: two points that are so far apart along x, y and z.
    #[test]
    fn children_are_in_order_along_the_longest_axis_and_the_first_of_several() {
        for (apart, axis) in [
            ([4.0, 4.0, 4.0], 0),
            ([4.0, 1.0, 4.0], 0),
            ([1.0, 4.0, 4.0], 1),
            ([1.0, 4.0, 2.0], 1),
            ([1.0, 2.0, 4.0], 2),
            ([4.0, 2.0, 5.0], 2),
        ] {
            let [far, near] = [apart, [0.0; 3]].map(|point| Box3 { low: point, high: point });
            let node = Node::of(&mut [(far, Child::leaf(0, 1)), (near, Child::leaf(1, 2))]);
            assert_eq!((node.axis, node.count), (axis, 2), "{apart:?}");
            assert_eq!(node.children[..3], [Child::leaf(1, 2), Child::leaf(0, 1), Child::EMPTY]);
        }
    }
}

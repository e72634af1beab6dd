//! Where to divide: the surface-area heuristic.
//!
//! A random ray that meets a box meets another one inside it with the probability of their areas' ratio. So a
//! division into a left and a right box costs (A_left n_left + A_right n_right) / A tests of objects, and to
//! open the node one more. The cheapest division is taken, of those between 16 bins an axis, which the
//! middles of the boxes are sorted into; or none, for a leaf, if testing all is cheaper. (MacDonald and Booth
//! 1990; the bins are Wald's, 2007.)
//!
//! A division by cost may take off a single box, level after level. [`MAX_DEPTH`] bounds that: a node is
//! halved instead as soon as its boxes need all the levels that are left. n boxes are single after ⌈log₂ n⌉
//! halvings, and n ≤ 2^levels holds at every node: at the root, as n < 2³²; at a half, which has at most
//! ⌈n/2⌉ ≤ 2^(levels − 1) boxes; and elsewhere, as a node is divided by cost only if n ≤ 2^(levels − 1)
//! itself.

use std::ops::RangeInclusive;

use super::{Node, Tree};
use crate::Box3;
use crate::extent::Extent;

/// No leaf is deeper. The tree of 2³² boxes could be 32 deep with no choice left, so there is some.
pub(crate) const MAX_DEPTH: usize = 48;
const BINS: usize = 16;

/// A box on its way to a leaf, and its place among the boxes.
type Item = (Extent, u32);

/// What is on one side of a division, or in one bin.
#[derive(Clone, Copy)]
struct Side {
    bounds: Extent,
    count: usize,
}

impl Side {
    const EMPTY: Side = Side { bounds: Extent::EMPTY, count: 0 };

    fn with(&self, other: &Side) -> Side {
        Side { bounds: self.bounds.union(&other.bounds), count: self.count + other.count }
    }

    fn of(items: &[Item]) -> Side {
        let bounds = items.iter().fold(Extent::EMPTY, |all, (bounds, _)| all.union(bounds));
        Side { bounds, count: items.len() }
    }

    fn leaf(&self, first: usize) -> Node {
        Node { bounds: self.bounds.to_box(), first: first as u32, count: self.count as u32 }
    }
}

/// A division: its cost, its axis, the last bin of its left side, and what is on either side.
type Division = (f64, usize, usize, [Side; 2]);

/// The tree. Up to so many boxes as `leaves` begins with are a leaf unasked (one at least); up to as many as
/// it ends with, if it is cheaper. (Inlined, to be compiled for wider instructions too.)
#[inline(always)]
pub(crate) fn tree(boxes: &[Box3], leaves: RangeInclusive<usize>) -> Tree {
    let mut items: Vec<Item> = boxes.iter().map(Extent::of).zip(0..).collect();
    let root = Side::of(&items);
    let mut nodes = vec![root.leaf(0)];
    // which node, its first item, what is in it, and how many levels there may be below
    let mut todo = vec![(0, 0, root, MAX_DEPTH)];
    while let Some((at, start, all, levels)) = todo.pop() {
        let here = &mut items[start..][..all.count];
        let Some([left, right]) = divide(here, &all, levels, &leaves) else { continue };
        let (first, middle) = (nodes.len(), start + left.count);
        (nodes[at].first, nodes[at].count) = (first as u32, 0);
        nodes.extend([left.leaf(start), right.leaf(middle)]);
        todo.push((first + 1, middle, right, levels - 1));
        todo.push((first, start, left, levels - 1));
    }
    nodes.truncate(2 * items.len()); // no box, no root
    Tree { nodes, order: items.iter().map(|(_, index)| *index).collect() }
}

/// Moves the items of the left side before those of the right one, and says what is on either; `None` for a
/// leaf.
#[inline(always)]
fn divide(
    items: &mut [Item],
    all: &Side,
    levels: usize,
    leaves: &RangeInclusive<usize>,
) -> Option<[Side; 2]> {
    if items.len() <= *leaves.start() {
        return None;
    }
    // bins from the smallest to the largest middle; a NaN, for middles that are all one, is in the first like
    // all others
    let middles = items.iter().fold(Extent::EMPTY, |all, (bounds, _)| all.union(&bounds.twice_middles()));
    let (bins, start, size) = (BINS.min(items.len()), middles.lows(), middles.size());
    let scale = size.map(|size| bins as f32 / size);
    let bin = |bounds: &Extent, axis: usize| {
        (((bounds.twice_middle(axis) - start[axis]) * scale[axis]) as i32 as usize).min(bins - 1)
    };
    let cheapest = cheapest(items, bins, bin);
    let area = all.bounds.half_area();
    let as_leaf = area * items.len() as f64;
    if items.len() <= *leaves.end() && cheapest.is_none_or(|(cost, ..)| as_leaf <= area + cost) {
        return None;
    }
    let may_choose = items.len() <= 1 << (levels - 1);
    let Some((_, axis, last, sides)) = cheapest.filter(|_| may_choose) else {
        let (middle, at) = (items.len() / 2, |item: &Item| item.0.twice_middle(0));
        items.select_nth_unstable_by(middle, |a, b| at(a).total_cmp(&at(b)));
        return Some([Side::of(&items[..middle]), Side::of(&items[middle..])]);
    };
    let mut left = 0;
    for place in 0..items.len() {
        if bin(&items[place].0, axis) <= last {
            items.swap(place, left);
            left += 1;
        }
    }
    Some(sides)
}

/// The cheapest division of all; `None` where all middles are one.
#[inline(always)]
fn cheapest(items: &[Item], bins: usize, bin: impl Fn(&Extent, usize) -> usize) -> Option<Division> {
    let mut filled = [[Side::EMPTY; BINS]; 3];
    for (bounds, _) in items {
        for (axis, filled) in filled.iter_mut().enumerate() {
            let side = &mut filled[bin(bounds, axis)];
            *side = side.with(&Side { bounds: *bounds, count: 1 });
        }
    }
    let mut best: Option<Division> = None;
    for (axis, filled) in filled.iter().enumerate() {
        // all right sides first, then each left one with its right one
        let mut rights = [Side::EMPTY; BINS + 1];
        for bin in (1..bins).rev() {
            rights[bin] = rights[bin + 1].with(&filled[bin]);
        }
        let mut left = Side::EMPTY;
        for last in 0..bins - 1 {
            left = left.with(&filled[last]);
            let sides = [left, rights[last + 1]];
            let [cost_left, cost_right] = sides.map(|side| side.bounds.half_area() * side.count as f64);
            let (cost, divides) = (cost_left + cost_right, sides.iter().all(|side| side.count > 0));
            if divides && best.is_none_or(|(least, ..)| cost < least) {
                best = Some((cost, axis, last, sides));
            }
        }
    }
    best
}

//! Where to divide: the surface-area heuristic.
//!
//! A random ray that meets a box meets another one inside it with the probability of their areas' ratio. So a division into
//! a left and a right box costs (A_left n_left + A_right n_right) / A tests of objects, and the cheapest one is taken:
//! of those between [`BINS`] bins an axis, which the middles of the boxes are sorted into. (MacDonald and Booth 1990; Wald 2007.)
//!
//! A division by cost may leave a single box on one side, level after level. [`MAX_DEPTH`] bounds that: a node is
//! halved instead, as soon as its boxes would need all the levels that are left. n boxes halved ⌈log₂ n⌉ times are single, so
//! if n ≤ 2^left holds at a node, it does at both children: of a halved one they have at most ⌈n/2⌉ ≤ 2^(left − 1) boxes, and a node
//! is divided by cost only if n ≤ 2^(left − 1) itself. At the root left = MAX_DEPTH and n < 2³².

use super::{Node, Tree};
use crate::Box3;
use crate::extent::Extent;

/// No leaf is deeper. The tree of 2³² boxes could be 32 deep with no choice left, so there is some.
pub(crate) const MAX_DEPTH: usize = 48;
/// Of 8, 16 and 32 the best in build and search together.
const BINS: usize = 16;

/// What a search pays, in tests of one object.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Costs {
    /// To open a node.
    pub(crate) node: f64,
    /// The largest leaf.
    pub(crate) leaf: usize,
    /// So few make a leaf unasked; one at least.
    pub(crate) surely_leaf: usize,
}

impl Costs {
    /// For a leaf whose objects are tested one after the other.
    pub(crate) const ONE_BY_ONE: Costs = Costs { node: 1.0, leaf: 4, surely_leaf: 1 };
    /// The same, for a tree that is collapsed: what is best together is decided then.
    pub(crate) const EIGHT_WIDE: Costs = Costs { node: 1.0, leaf: 2, surely_leaf: 1 };
    /// For leaves that are tested at once, up to eight.
    pub(crate) const BLOCKS: Costs = Costs { node: 1.0, leaf: 4, surely_leaf: 4 };
}

/// A box on its way to a leaf.
#[derive(Clone, Copy)]
struct Item {
    bounds: Extent,
    index: u32,
}

/// The items on one side of a division, or in one bin.
#[derive(Clone, Copy)]
struct Side {
    bounds: Extent,
    count: usize,
}

impl Side {
    const EMPTY: Side = Side { bounds: Extent::EMPTY, count: 0 };

    #[inline(always)]
    fn with(&self, other: &Side) -> Side {
        Side { bounds: self.bounds.union(&other.bounds), count: self.count + other.count }
    }

    #[inline(always)]
    fn of(items: &[Item]) -> Side {
        let bounds = items.iter().fold(Extent::EMPTY, |all, item| all.union(&item.bounds));
        Side { bounds, count: items.len() }
    }

    #[inline(always)]
    fn cost(&self) -> f64 {
        self.bounds.half_area() * self.count as f64
    }
}

/// A node to be made.
struct Task {
    at: usize,
    start: usize,
    all: Side,
    /// How many levels there may be below.
    levels: usize,
}

/// A division between two bins.
#[derive(Clone, Copy)]
struct Division {
    cost: f64,
    axis: usize,
    /// The last bin of the left side.
    last: usize,
    sides: [Side; 2],
}

/// Bins from the smallest to the largest middle on each axis.
struct Bins {
    count: usize,
    start: [f32; 3],
    scale: [f32; 3],
}

impl Bins {
    #[inline(always)]
    fn new(items: &[Item]) -> Bins {
        let middles = items.iter().fold(Extent::EMPTY, |all, item| all.union(&item.bounds.twice_middles()));
        let (count, size) = (BINS.min(items.len()), middles.size());
        let scale = [0, 1, 2].map(|axis| count as f32 / size[axis]);
        Bins { count, start: [0, 1, 2].map(|axis| middles.low(axis)), scale }
    }

    /// In which bin an item is. A NaN, for middles that are all one, is in bin 0, like all the others.
    #[inline(always)]
    fn of(&self, item: &Item, axis: usize) -> usize {
        let place = (item.bounds.twice_middle(axis) - self.start[axis]) * self.scale[axis];
        (place as i32 as usize).min(self.count - 1)
    }
}

/// The tree.
#[inline(always)]
pub(crate) fn tree(boxes: &[Box3], costs: Costs) -> Tree {
    let mut nodes = Vec::with_capacity(boxes.len());
    let mut items = Vec::with_capacity(boxes.len());
    for (index, bounds) in boxes.iter().enumerate() {
        items.push(Item { bounds: Extent::of(bounds), index: index as u32 });
    }
    let mut todo = Vec::new();
    if !items.is_empty() {
        nodes.push(Node { bounds: Box3::EMPTY, first: 0, count: 0 });
        todo.push(Task { at: 0, start: 0, all: Side::of(&items), levels: MAX_DEPTH });
    }
    while let Some(Task { at, start, all, levels }) = todo.pop() {
        let first = nodes.len();
        nodes[at] = Node { bounds: all.bounds.to_box(), first: first as u32, count: 0 };
        let here = &mut items[start..start + all.count];
        let Some([left, right]) = divide(here, &all, levels, costs) else {
            (nodes[at].first, nodes[at].count) = (start as u32, all.count as u32);
            continue;
        };
        nodes.extend([nodes[at]; 2]);
        let middle = start + left.count;
        todo.push(Task { at: first + 1, start: middle, all: right, levels: levels - 1 });
        todo.push(Task { at: first, start, all: left, levels: levels - 1 });
    }
    Tree { nodes, order: items.iter().map(|item| item.index).collect() }
}

/// Moves the items of the left side before those of the right one, and says what is on either; `None` for a leaf.
#[inline(always)]
fn divide(items: &mut [Item], all: &Side, levels: usize, costs: Costs) -> Option<[Side; 2]> {
    if items.len() <= costs.surely_leaf {
        return None;
    }
    let bins = Bins::new(items);
    let best = cheapest(items, &bins);
    if items.len() <= costs.leaf {
        let area = all.bounds.half_area();
        let divided = best.map_or(f64::INFINITY, |best| costs.node * area + best.cost);
        if area * items.len() as f64 <= divided {
            return None;
        }
    }
    let must_halve = items.len() > 1 << (levels - 1);
    let Some(best) = best.filter(|_| !must_halve) else {
        let middle = items.len() / 2;
        let at = |item: &Item| item.bounds.twice_middle(0);
        items.select_nth_unstable_by(middle, |a, b| at(a).total_cmp(&at(b)));
        let (left, right) = items.split_at(middle);
        return Some([left, right].map(Side::of));
    };
    let mut left = 0;
    for place in 0..items.len() {
        if bins.of(&items[place], best.axis) <= best.last {
            items.swap(place, left);
            left += 1;
        }
    }
    Some(best.sides)
}

/// The cheapest division of all; `None` where all middles are one.
#[inline(always)]
fn cheapest(items: &[Item], bins: &Bins) -> Option<Division> {
    let mut filled = [[Side::EMPTY; BINS]; 3];
    for item in items {
        for (axis, filled) in filled.iter_mut().enumerate() {
            let bin = &mut filled[bins.of(item, axis) & (BINS - 1)];
            *bin = bin.with(&Side { bounds: item.bounds, count: 1 });
        }
    }
    let mut best: Option<Division> = None;
    for (axis, filled) in filled.iter().enumerate() {
        // the right sides, then the left ones against them
        let mut rights = [Side::EMPTY; BINS];
        let mut right = Side::EMPTY;
        for bin in (1..bins.count).rev() {
            right = right.with(&filled[bin]);
            rights[bin] = right;
        }
        let mut left = Side::EMPTY;
        for last in 0..bins.count - 1 {
            left = left.with(&filled[last]);
            let right = rights[last + 1];
            let cost = left.cost() + right.cost();
            let is_division = left.count > 0 && right.count > 0;
            if is_division && best.is_none_or(|best| cost < best.cost) {
                best = Some(Division { cost, axis, last, sides: [left, right] });
            }
        }
    }
    best
}

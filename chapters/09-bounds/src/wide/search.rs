//! The search: nearest box first.

use math::{Ray3, Real, Span};

use super::collapse::most_waiting;
use super::dispatch::Work;
use super::node::{Child, LANES, Node};
use crate::{Nearest, Slabs, Tally};

/// What to do with a leaf. (Not a closure, for those cannot be told to be inlined.)
pub(crate) trait Leaves<R, C> {
    /// Tests what is in it.
    fn visit(&mut self, leaf: Child, nearest: &mut Nearest<R>, counts: &mut C);
}

/// How many children may have to wait.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stack {
    /// Not more than [`FEW`].
    Few,
    /// Not more than [`MANY`].
    Many,
}

/// Enough for a million triangles; and set to zero for every ray in no time.
const FEW: usize = 64;
/// Enough for any tree: seven of eight wait on each of [`MAX_DEPTH`](crate::tree::build::MAX_DEPTH) levels,
/// and the eighth.
const MANY: usize = (LANES - 1) * crate::tree::build::MAX_DEPTH + 1;

impl Stack {
    /// The one that is needed.
    pub(crate) fn of(nodes: &[Node]) -> Stack {
        if most_waiting(nodes) <= FEW { Stack::Few } else { Stack::Many }
    }
}

/// A search for the nearest hit in `span`, or for `ANY`.
pub(crate) struct Search<'a, R: Real, C, L, const ANY: bool> {
    pub(crate) nodes: &'a [Node],
    pub(crate) stack: Stack,
    pub(crate) ray: &'a Ray3<R>,
    pub(crate) span: Span<R>,
    pub(crate) counts: &'a mut C,
    pub(crate) leaves: L,
}

impl<R: Real, C: Tally, L: Leaves<R, C>, const ANY: bool> Work for Search<'_, R, C, L, ANY> {
    type Answer = Option<(usize, R)>;

    #[inline(always)]
    fn run(self) -> Option<(usize, R)> {
        match self.stack {
            Stack::Few => self.search::<FEW>(),
            Stack::Many => self.search::<MANY>(),
        }
    }
}

/// A child that waits: its t above, itself below, so that these numbers are in the order of t. (The bits of
/// floating-point numbers that are not negative are in their order.)
type Waiting = u64;

#[inline(always)]
fn waiting(near: f32, child: Child) -> Waiting {
    u64::from(near.to_bits()) << 32 | u64::from(child.0)
}

impl<R: Real, C: Tally, L: Leaves<R, C>, const ANY: bool> Search<'_, R, C, L, ANY> {
    #[inline(always)]
    fn search<const STACK: usize>(mut self) -> Option<(usize, R)> {
        let mut nearest = Nearest::new(self.span);
        if self.nodes.is_empty() {
            return None;
        }
        let slabs = Slabs::new(self.ray);
        let mut stack: [Waiting; STACK] = [0; STACK];
        let mut top = 0;
        let mut at = Child::node(0);
        loop {
            if at.is_leaf() {
                self.leaves.visit(at, &mut nearest, self.counts);
                if ANY && nearest.index.is_some() {
                    return nearest.hit();
                }
            } else {
                let node = &self.nodes[at.0 as usize];
                self.counts.boxes(node.count as usize);
                let (near, mut entered) = node.enter(&slabs, nearest.reach);
                // the farther ones first, by the order of the lanes: most are then in their place
                let is_backward = slabs.first[node.axis as usize % 3] == 1;
                let below = top;
                while entered != 0 {
                    let (lowest, highest) = (entered.trailing_zeros(), 31 - entered.leading_zeros());
                    let lane = if is_backward { lowest } else { highest } as usize % LANES;
                    entered &= !(1 << lane);
                    let one = waiting(near[lane], node.children[lane]);
                    let mut place = top;
                    // by t, the nearest on top; not worth it where any hit will do
                    while !ANY && place > below && stack[place - 1] < one {
                        stack[place] = stack[place - 1];
                        place -= 1;
                    }
                    stack[place] = one;
                    top += 1;
                }
            }
            // the next one, if the ray does not hit before it
            loop {
                if top == 0 {
                    return nearest.hit();
                }
                top -= 1;
                let one = stack[top];
                if f32::from_bits((one >> 32) as u32) <= nearest.reach.max {
                    at = Child(one as u32);
                    break;
                }
            }
        }
    }
}

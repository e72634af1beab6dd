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
        let slabs = Slabs::new(self.ray);
        let mut nearest = Nearest::new(self.span);
        let mut node = self.nodes.first()?;
        self.counts.boxes(node.count as usize);
        let (mut near, mut entered) = node.enter(&slabs, nearest.reach);
        if entered.is_empty() {
            return None; // before there is a stack, which takes time
        }
        let mut stack: [Waiting; STACK] = [0; STACK];
        let mut top = 0;
        loop {
            // the farther ones first, by the order of the lanes: most are then in their place
            let is_backward = slabs.first[node.axis as usize % 3] == 1;
            let below = top;
            while !entered.is_empty() {
                let lane = entered.take(is_backward);
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
            // leaves on top are looked into, up to a node
            node = loop {
                if top == 0 {
                    return nearest.hit();
                }
                top -= 1;
                let (t, child) = (f32::from_bits((stack[top] >> 32) as u32), Child(stack[top] as u32));
                if t > nearest.reach.max {
                    continue; // the ray hits before it
                }
                if !child.is_leaf() {
                    break &self.nodes[child.0 as usize];
                }
                self.leaves.visit(child, &mut nearest, self.counts);
                if ANY && nearest.index.is_some() {
                    return nearest.hit();
                }
            };
            self.counts.boxes(node.count as usize);
            (near, entered) = node.enter(&slabs, nearest.reach);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wide::Wide;
    use crate::{Box3, Uncounted};
    use glam::Vec3;

    /// 64 points in a row: where any will do the search begins with those near the origin, whichever end that is at.
    #[test]
    fn any_hit_is_looked_for_from_the_origin_on() {
        for axis in 0..3 {
            let along = |x: f32| std::array::from_fn(|it| if it == axis { x } else { 0.0 });
            let points: Vec<Box3> = (0..64)
                .map(|place| along(place as f32))
                .map(|point| Box3 { low: point, high: point })
                .collect();
            let wide = Wide::build(&points);
            for (origin, direction, near) in [(-1.0, 1.0, 0..8), (64.0, -1.0, 56..64)] {
                let ray = Ray3::<f32>::new(Vec3::from(along(origin)), Vec3::from(along(direction)));
                let found = wide.first_found(&ray, Span::ahead(), &mut Uncounted, |_, _| Some(1.0));
                assert!(
                    found.is_some_and(|(place, _)| near.contains(&place)),
                    "{axis} {direction}: {found:?}"
                );
            }
        }
    }
}

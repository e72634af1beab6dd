//! Which sides does a ray in the plane cross? Counted so that a corner is never counted twice.
//!
//! s(t) = x + t (1, 0), t > 0, starts at the point x in question and runs along the first of the two axes. A side
//! from p̄ to q̄ crosses it if p̄ and q̄ are on different sides of the line of s, and the crossing is ahead of x.
//! Both questions have a tie, and both ties are where the counting of most programs goes wrong:
//!
//! - **s runs through a corner.** Counted with "on or above" and "on or below", both sides that meet there are
//!   crossed, and where the polygon goes straight on upward, one crossing becomes two. So a side's lower end
//!   belongs to it and its upper end does not (p_v ≤ x_v < q_v). A corner where the polygon passes through is
//!   then counted once, one that only touches s from above twice or from below not at all; and a side along s,
//!   which has no upper end, never.
//! - **x is on the side.** Then there is nothing to count: the boundary belongs to the polygon.
//!
//! On which side of p̄q̄ the point is, is the sign of (q̄ − p̄) × (x − p̄); [`math::Sure`] tells it exactly.

use std::cmp::Ordering;

use math::{Bounded, Exact, Real, Sure, TwoPart};

/// A side that s(t) crosses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<R> {
    /// Which side, from 0: that from corner `side` to the next one.
    pub side: usize,
    /// Where: the t of s(t), about, for a reader, in units of the scene. That it is > 0 was decided without
    /// it.
    pub t: R,
    /// Which way the side goes there.
    pub way: Way,
}

/// Which way a side crosses s(t), which goes to the right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// From below it to above it: counterclockwise around x.
    Up,
    /// From above it to below it: clockwise.
    Down,
}

/// Where a point is with respect to a side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// s(t) does not cross it.
    Apart,
    /// s(t) crosses it.
    Crosses(Way),
    /// The point is on it, or one of its ends.
    OnSide,
}

/// Where the point `x` is with respect to the side from `p` to `q`, exactly, each of them [u, v]. All must be finite, and
/// `p` is not `q`.
pub fn relation<R: Real>(p: [R; 2], q: [R; 2], x: [R; 2]) -> Relation {
    let [p, q, x] = [p, q, x].map(|point| point.map(Into::<f64>::into));
    let is_beyond = |axis: usize| x[axis] < p[axis].min(q[axis]) || x[axis] > p[axis].max(q[axis]);
    if is_beyond(1) {
        return Relation::Apart;
    }
    // at the height of the side or of its upper end, there may be no crossing and the point on it all the same
    let turn = turn(p, q, x);
    if turn == Ordering::Equal && !is_beyond(0) {
        return Relation::OnSide;
    }
    // exercise ends: Of a side, let the lower end count and the upper one not: which heights x_v does it reach?
    let goes_up: bool = p[1] <= x[1] && x[1] < q[1];
    let goes_down: bool = q[1] <= x[1] && x[1] < p[1];
    // end ends
    // exercise ahead: Seen along the side, on which hand is a point whose s(t) crosses it for t > 0?
    match turn {
        Ordering::Greater if goes_up => Relation::Crosses(Way::Up),
        Ordering::Less if goes_down => Relation::Crosses(Way::Down),
        _ => Relation::Apart,
    }
    // end ahead
}

/// Whether x is to the left of the line from p to q (greater), on it, or to the right, exactly.
fn turn(p: [f64; 2], q: [f64; 2], x: [f64; 2]) -> Ordering {
    let sign = left_of::<Bounded<f64>>(p, q, x).sign();
    let sign = sign.or_else(|| left_of::<Bounded<TwoPart>>(p, q, x).sign());
    sign.or_else(|| left_of::<Exact>(p, q, x).sign()).unwrap_or(Ordering::Equal)
}

/// (q̄ − p̄) × (x − p̄), twice the area of the triangle p̄ q̄ x.
fn left_of<N: Sure>(p: [f64; 2], q: [f64; 2], x: [f64; 2]) -> N {
    let [side_u, side_v] = [N::difference(q[0], p[0]), N::difference(q[1], p[1])];
    let [x_u, x_v] = [N::difference(x[0], p[0]), N::difference(x[1], p[1])];
    side_u * x_v - side_v * x_u
}

/// What s(t) meets on its way out.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Met<R> {
    /// The first side that holds the point.
    pub on_side: Option<usize>,
    /// The sides that it crosses, in their order around the polygon.
    pub crossings: Vec<Crossing<R>>,
}

/// The sides of a closed outline that s(t) from `x` crosses.
pub(super) fn crossings<R: Real>(outline: &[[R; 2]], x: [R; 2]) -> Met<R> {
    let mut met = Met { on_side: None, crossings: Vec::new() };
    for (side, [p, q]) in sides(outline).enumerate() {
        match relation(p, q, x) {
            Relation::Apart => {}
            Relation::OnSide => met.on_side = met.on_side.or(Some(side)),
            Relation::Crosses(way) => met.crossings.push(Crossing { side, t: t_of(p, q, x), way }),
        }
    }
    met
}

/// From each corner to the next, and from the last to the first.
pub(super) fn sides<R: Real>(outline: &[[R; 2]]) -> impl Iterator<Item = [[R; 2]; 2]> {
    outline.iter().zip(outline.iter().cycle().skip(1)).map(|(&p, &q)| [p, q])
}

/// The t at which s(t) meets the line through p and q.
pub(super) fn t_of<R: Real>(p: [R; 2], q: [R; 2], x: [R; 2]) -> R {
    let share = (x[1] - p[1]) / (q[1] - p[1]);
    (p[0] - x[0]) + share * (q[0] - p[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lower_end_belongs_to_a_side_and_the_upper_one_does_not() {
        let (low, high) = ([2.0, 0.0], [2.0, 1.0]);
        for (height, up) in [(-0.5, false), (0.0, true), (0.5, true), (1.0, false), (1.5, false)] {
            let of = |way| if up { Relation::Crosses(way) } else { Relation::Apart };
            assert_eq!(relation(low, high, [0.0, height]), of(Way::Up), "{height}");
            assert_eq!(relation(high, low, [0.0, height]), of(Way::Down), "{height}");
        }
    }

    #[test]
    fn a_side_along_the_ray_is_not_crossed_but_may_hold_the_point() {
        let (p, q) = ([1.0, 0.0], [3.0, 0.0]);
        for (u, relation_there) in [
            (0.0, Relation::Apart),
            (1.0, Relation::OnSide),
            (2.0, Relation::OnSide),
            (3.0, Relation::OnSide),
            (4.0, Relation::Apart),
        ] {
            assert_eq!(relation(p, q, [u, 0.0]), relation_there);
            assert_eq!(relation(q, p, [u, 0.0]), relation_there);
        }
    }

    #[test]
    fn on_a_side_is_exact() {
        // by hand: (1, 1/3) is on the line from (0, 0) to (3, 1), and the float beside 1/3 is not
        let (p, q) = ([0.0, 0.0], [3.0, 1.0]);
        assert_eq!(relation(p, q, [0.75, 0.25]), Relation::OnSide);
        assert_eq!(relation(p, q, [0.75_f64.next_down(), 0.25]), Relation::Crosses(Way::Up));
        assert_eq!(relation(p, q, [0.75_f64.next_up(), 0.25]), Relation::Apart);
        // 0.1 · 3 is 0.30000000000000004 when rounded; 0.1 as read is a bit more than a tenth, 0.3 a bit less
        assert_eq!(relation(p, [0.3, 0.1], [0.15, 0.05]), Relation::OnSide, "halves are exact");
        assert_ne!(relation(p, [0.6, 0.2], [0.3, 0.1]), Relation::Apart);
        assert_eq!(relation([-1e300, -1e300], [1e300, 1e300], [1e-300, 1e-300]), Relation::OnSide);
        let below = [f64::from_bits(1), 0.0];
        assert_eq!(
            relation([-1e300, -1e300], [1e300, 1e300], below),
            Relation::Apart,
            "to the right by 5e−324"
        );
    }

    /// By hand: the side from (3, 2) to (11, 10) is at (9, 8) at the height of (1, 8), which is ¾ of the way.
    #[test]
    fn where_the_side_is_crossed() {
        let (p, q, x) = ([3.0, 2.0], [11.0, 10.0], [1.0, 8.0]);
        assert_eq!([t_of(p, q, x), t_of(q, p, x)], [8.0; 2]);
    }
}

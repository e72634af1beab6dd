//! How often does the polygon go around the point?
//!
//! Walk around the polygon once, from corner to corner, and look at the point: the turns that you make, counted
//! counterclockwise, are its winding number. No angle is needed. Each turn crosses s(t) once more upward than
//! downward, so the number is that of the sides going up less that of those going down. Where a polygon does not
//! overlap itself it is 1 or −1 inside and 0 outside, and the rules agree. In the middle of a pentagram it is 2:
//! even, but not 0.

use math::Real;

use super::crossing::{Crossing, Way, crossings};

/// Every number of the winding rule.
#[derive(Clone, Debug, PartialEq)]
pub struct Winding<R> {
    /// The point in question, on the axes of [`Polygon::axes`](super::Polygon::axes).
    pub point: [R; 2],
    /// The side that the point is on, from 0, if it is on one.
    pub on_side: Option<usize>,
    /// The sides that s(t) crosses for t > 0.
    pub crossings: Vec<Crossing<R>>,
    /// How many of them go up, less how many go down: above zero where the outline goes around the point
    /// counterclockwise. Means nothing on the boundary.
    pub number: i64,
}

/// Works out the winding number of an outline, from corner to corner and back to the first, around a point.
/// All must be finite.
pub fn winding<R: Real>(outline: &[[R; 2]], point: [R; 2]) -> Winding<R> {
    let met = crossings(outline, point);
    let turn = |crossing: &Crossing<R>| match crossing.way {
        Way::Up => 1,
        Way::Down => -1,
    };
    let number = met.crossings.iter().map(turn).sum();
    Winding { point, on_side: met.on_side, crossings: met.crossings, number }
}

impl<R> Winding<R> {
    /// Any number but 0 is inside, and so is the boundary.
    pub fn is_inside(&self) -> bool {
        self.on_side.is_some() || self.number != 0
    }
}

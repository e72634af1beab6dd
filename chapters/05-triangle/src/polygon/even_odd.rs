//! CSC418 11.3.2: even or odd?
//!
//! "If there is an even number of intersections, the intersection is inside. If the number of intersections is
//! odd, it is outside." It is the other way round (slip 20): far away nothing is crossed, 0 is even, and far away
//! is outside; each side crossed on the way back changes that.

use math::Real;

use super::crossing::{Crossing, crossings, sides, t_of};

/// Every number of the even-odd rule.
#[derive(Clone, Debug, PartialEq)]
pub struct EvenOdd<R> {
    /// The point in question, on the axes of [`Polygon::axes`](super::Polygon::axes).
    pub point: [R; 2],
    /// The side that the point is on, from 0, if it is on one.
    pub on_side: Option<usize>,
    /// The sides that s(t) crosses for t > 0.
    pub crossings: Vec<Crossing<R>>,
}

/// Works out the even-odd rule (CSC418 11.3.2, put right) for an outline, from corner to corner and back to
/// the first, and a point. All must be finite.
pub fn even_odd<R: Real>(outline: &[[R; 2]], point: [R; 2]) -> EvenOdd<R> {
    let met = crossings(outline, point);
    EvenOdd { point, on_side: met.on_side, crossings: met.crossings }
}

impl<R> EvenOdd<R> {
    /// Whether the point belongs to the polygon, as its boundary does.
    pub fn is_inside(&self) -> bool {
        // exercise inside: How many crossings has a point inside, and what of a point that is on a side?
        self.on_side.is_some() || self.crossings.len() % 2 == 1
        // end inside
    }
}

/// The page's rule as it is printed: even is inside. For the test and the transcript that show it fail.
pub fn is_inside_as_printed<R>(work: &EvenOdd<R>) -> bool {
    work.crossings.len().is_multiple_of(2)
}

/// How many sides s(t) crosses for t > 0, counted as one does at first: a side is crossed where its ends are on
/// or above the line of s and on or below it. Where s runs through a corner, that counts both sides that meet
/// there; a side along s, which has no single crossing, is left out.
pub fn count_naively<R: Real>(outline: &[[R; 2]], point: [R; 2]) -> usize {
    let crosses = |[p, q]: &[[R; 2]; 2]| {
        let reaches = p[1] <= point[1] && point[1] <= q[1] || q[1] <= point[1] && point[1] <= p[1];
        reaches && p[1] != q[1] && t_of(*p, *q, point) > R::from(0.0)
    };
    sides(outline).filter(crosses).count()
}

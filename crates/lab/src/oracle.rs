//! Exact truth: what is hit, and where, without a rounding on the way.
//!
//! Every finite float is an integer times a power of two, and so is every sum and product of such
//! numbers: a [`Dyadic`]. The discriminant of a sphere, n · d of a plane, the distance to a wall are
//! dyadic, so whether a ray hits is the sign of an integer; no tolerance, no error bound. The root
//! itself is a quotient or irrational. It is not needed to answer a question about it: an
//! [`ExactRoot`] is compared with a number by putting the number into its equation, and that again is
//! the sign of an integer.
//!
//! A solid of several surfaces is convex: what the line has inside the wall and between the caps is one
//! stretch each, and the ends of what they have in common are found by such questions alone. An affine object
//! is a unit object seen by a ray that the adjugate has taken back, and a division by det A is a change of scale.
//!
//! Only what is written down is rounded, and the rounding is decided too. Integer division and integer
//! square root give the leading 126 bits of the root and an interval that holds it. If the interval
//! lies on one side of the midpoint of two neighboring floats, that is the decision; if not, the root
//! is compared with the midpoint.
//!
//! # Nothing here is shared with what it judges
//!
//! The methods named `robust` fall back on [`math::Exact`], so a slip in it would be repeated by an
//! oracle that is built on it. The oracle has another crate's integers (dashu-int), and gets to its
//! answer another way: robust takes twice the digits, bounds their error and rounds at the end; the
//! oracle has no digits that could be wrong. Of [`math`] it uses the words of the reasons, the names of
//! the grids, and [`Wide`] to hand over its result. Its tests put the answers back into the geometry,
//! ‖o + t d − c‖ = r, and do not ask the formulas that they came from.
//!
//! [`Wide`]: math::Wide

mod affine;
mod cone;
mod digits;
mod dyadic;
mod flat;
mod grid;
mod open_cone;
mod plane;
mod quadratic;
mod quadric;
mod root;
mod round;
mod rounding;
#[cfg(test)]
mod seen;
mod sphere;
mod stretch;
#[cfg(test)]
mod testing;
mod triangle;
mod unit;
mod vector;
mod verdict;
mod wall;

pub use affine::{affine, exact_affine};
pub use dyadic::Dyadic;
pub use grid::pixel;
pub use open_cone::{exact_open_cone, open_cone};
pub use plane::{exact_plane, plane};
pub use quadric::{exact_quadric, quadric};
pub use root::ExactRoot;
pub use sphere::{exact_sphere, sphere};
pub use triangle::{exact_triangle, triangle};
pub use unit::UnitObject;
pub use verdict::Verdict;
pub use wall::{exact_wall, wall};

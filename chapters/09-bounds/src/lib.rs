//! Not testing what cannot be hit.
//!
//! "Intersection tests are expensive when there are large numbers of objects" (CSC418 11.5). The page bounds an object
//! by a sphere or a box, and tests it only where the bound is met; or it projects the object's extent onto the image
//! plane. What follows from it is to bound the bounds: a tree. [`Bounded`] is a scene with one of them ([`Method`]), and
//! whichever it is, each ray sees the same object at the same λ, to the last bit. That is what the two halves of this
//! chapter are about:
//!
//! - The objects are met by the robust methods, whose verdict is exact, so that what is outside a bound cannot be hit
//!   ([`mod@parts`]).
//! - A bound leaves nothing out: boxes are rounded outward ([`mod@box3`]), spheres too ([`mod@around`]), and the test
//!   of a box never says a wrong no ([`mod@slab`]).
//!
//! [`mod@tree`] is the tree that one writes down, [`mod@wide`] the fast one, which nobody needs to understand who
//! only wants to know what it answers.

mod all;
pub mod around;
pub mod bounded;
pub mod box3;
pub mod counts;
#[cfg(feature = "stage")]
mod explain;
mod extent;
#[cfg(feature = "stage")]
mod measure;
pub mod method;
pub mod nearest;
pub mod parts;
#[cfg(feature = "stage")]
mod picture;
pub mod projected;
pub mod query;
#[cfg(feature = "stage")]
mod report;
pub mod slab;
#[cfg(feature = "stage")]
pub mod stage;
pub mod tree;
pub mod trial;
pub mod wide;

pub use around::sphere_around;
pub use bounded::Bounded;
pub use box3::Box3;
pub use counts::{Counts, Tally, Uncounted};
pub use method::Method;
pub use nearest::Nearest;
pub use parts::Parts;
pub use query::{FirstPart, Found, Leaves, Query};
pub use slab::{Reach, Slabs};
pub use tree::Tree;
pub use wide::{Wide, WideMesh};

#[cfg(test)]
mod tests;

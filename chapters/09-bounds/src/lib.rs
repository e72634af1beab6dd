//! Not testing what cannot be hit.
//!
//! "Intersection tests are expensive when there are large numbers of objects" (CSC418 11.5). The page bounds
//! an object by a sphere or a box, and tests it only where the bound is met; or it projects the object's
//! extent onto the image plane ([`mod@projected`]). What follows from it is to bound the bounds: a tree.
//! [`Bounded`] is a scene with one of them ([`Method`]), and whichever it is, each ray sees the same object
//! at the same λ, to the last bit. That is what the two halves of this chapter are about:
//!
//! - The objects are met by the robust methods, whose verdict is exact, so that what is outside a bound cannot be hit
//!   ([`mod@parts`]).
//! - A bound leaves nothing out: boxes are rounded outward ([`mod@box3`]), spheres too ([`mod@around`]), and the test
//!   of a box never says a wrong no ([`mod@slab`]).
//!
//! [`mod@tree`] is the tree that one writes down, [`mod@wide`] the fast one, which nobody needs to understand
//! who only wants to know what it answers. [`Query`] is what is asked of a scene, [`mod@trial`] says how a
//! ray is tried on one part, and [`Counts`] what an answer took.
//!
//! A row of a hundred spheres, of which a ray up meets one. How many are tried to find out?
//!
//! ```
//! use bounds::{Bounded, Counts, Method};
//! use glam::DVec3;
//! use math::{Camera, Grid, Handedness, Ray3, Span, Window};
//! use ray_sphere::Sphere;
//! use signature::{Object, Scene, Shape};
//!
//! let window = Window { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 };
//! let camera = Camera::looking(DVec3::ZERO, DVec3::Z, DVec3::Y, Handedness::Right, 1.0, window)?;
//! let ball = |k| Sphere::<f64> { center: DVec3::new(3.0 * f64::from(k), 5.0, 0.0), radius: 1.0 };
//! let objects = (0..100).map(|k| Object { id: None, shape: Shape::Sphere(ball(k)) }).collect();
//! let scene = Scene { camera, grid: Grid::Centers, size: (64, 48), objects };
//!
//! let up = Ray3::new(DVec3::new(150.0, 0.0, 0.0), DVec3::Y);
//! for (method, most) in [(Method::None, 100), (Method::Tree, 8)] {
//!     let mut counts = Counts::default();
//!     let first = Bounded::new(&scene, method).first_hit(&up, Span::ahead(), &mut counts);
//!     assert_eq!(first.map(|first| (first.object, first.lambda)), Some((50, 4.0)));
//!     assert!(counts.tests <= most);
//! }
//! # Ok::<(), math::Degenerate>(())
//! ```

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

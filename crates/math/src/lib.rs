//! The tiny math core: what a ray is, how far along it one looks, where a pixel lies.
//!
//! Start with [`Ray2`], [`Ray3`] and its equation x(t) = p_r + t u_r, then [`Span`], the range of t that every
//! intersector takes, and [`Hit`], what it returns: `None` for a miss, [`Degenerate`] for a question
//! without an answer. [`Camera`] and [`Grid`] say which ray belongs to a pixel. Everything is generic over
//! [`Real`], which is `f32` or `f64`: one readable formula serves both precisions, and a chapter can show
//! what the smaller one loses. [`portable`] has the functions whose last bit would differ between machines.
//!
//! [`two_part`], [`wide`] and [`exact`] are for the methods named `robust`: numbers with twice the
//! digits, numbers that cannot overflow, and numbers that are not rounded at all. [`Sure`] is what they have in
//! common: a formula written once, worked out in plain `f64`, with twice the digits, or exactly. [`glance`]
//! is what can be said before any of that, and [`plain`] the vectors that it is said with.
//!
//! There is no input or output here, and nothing that teaches ray tracing.
//!
//! A point of a ray, whose direction may have any length:
//!
//! ```
//! use glam::DVec3;
//! use math::Ray3;
//!
//! let ray = Ray3::<f64>::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, -2.0, 4.0));
//! assert_eq!(ray.at(0.5), DVec3::new(1.0, 1.0, 5.0));
//! ```

mod bounded;
mod camera;
pub mod exact;
pub mod glance;
pub mod grid;
mod hit;
mod no_grid;
pub mod plain;
pub mod portable;
mod ray;
mod real;
mod roots;
mod span;
mod sure;
pub mod two_part;
pub mod wide;

pub use bounded::Bounded;
pub use camera::{Camera, Handedness, Window};
pub use exact::Exact;
pub use glance::{Around, Glance};
pub use grid::Grid;
pub use hit::{Degenerate, Hit, Parallel};
pub use no_grid::NoGrid;
pub use ray::{Ray2, Ray3};
pub use real::{Real, Vector};
pub use roots::Roots;
pub use span::Span;
pub use sure::{Certainty, Quadratic, Sure};
pub use two_part::TwoPart;
pub use wide::Wide;

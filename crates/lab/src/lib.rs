//! Speed for accuracy, measured.
//!
//! A chapter hands over its methods, its kinds of case and what is true of a case: a [`Subject`]. The lab draws
//! the cases of each [`Regime`] from a seed, judges every method at every precision against the exact
//! [`Truth`], and times them side by side. It knows no chapter and none of their formulas.
//!
//! Truth comes from [`oracle`], which is not floating point: hit or miss is the sign of an integer.
//! No method is ever judged by another.

mod draw;
pub mod oracle;
pub mod plot;
mod regime;
mod subject;
mod truth;

pub use draw::{Draw, Vec2, Vec3};
pub use regime::{Notes, Regime};
pub use subject::{Answer, Outcome, Pass, Runner, Subject};
pub use truth::{Root, Truth};

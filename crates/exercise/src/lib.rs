//! What a hand-out prints, is shown and is judged by.
//!
//! An exercise has [`Case`]s, each a row of numbers that belongs to a property of the answer ("from inside",
//! "any length of D"), and a probe, which writes down what the code makes of a case as [`Steps`]: symbol,
//! formula, value, in the order of the page. The same probe runs on the student's code, on the chapter's, and
//! on every known mistake; whoever judges compares steps and finds the [first that is wrong](first_wrong).
//!
//! This crate goes along with every hand-out, so it needs nothing but Rust. [`main`] is what `cargo run`
//! there does, and [`test()`] what `cargo test` does.

mod case;
mod compare;
mod program;
mod sheet;
mod steps;
mod told;
mod value;

pub use case::Case;
pub use compare::{Wrong, first_wrong, first_wrong_step};
pub use program::{Probe, Work, lines, main, run, test};
pub use sheet::{Answer, Broken, Property, Row, Sheet};
pub use steps::{Step, Steps};
pub use told::{asks, ended, got, next, told};
pub use value::{Value, ulps};

//! The umbrella command: run every stage there is, and show what each left behind.
//!
//! [`stages::ALL`] lists the stages, in the order of the book; the commands and the tests read that
//! one list. [`run`](run::run) asks each stage for its worked example, writes the pictures and the
//! [gallery], and prints the transcripts; [`list`](list::list) says what each stage teaches. Both
//! write what they print to an output that they are given, so a test can read it. The verbs for a course,
//! `exercise`, `check` and `grade`, are those of the crate `homework`; [`command()`] has them all, and
//! [`serve`] does what one of them asks.

mod command;
mod drawings;
pub mod gallery;
pub mod list;
pub mod run;
pub mod stages;

pub use command::{command, main, main_from, serve};

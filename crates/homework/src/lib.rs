//! Hand out an exercise, check an attempt, grade a class.
//!
//! What an exercise is stands in `chapters/*/exercises`, see [`cutter`]. Its reference solution is the
//! chapter's own code, and each known mistake is the same code with some lines changed; both are modules of
//! this crate, made when it is built. An attempt is judged by what it makes of the cases ([`judge`]): never
//! by its text.
//!
//! [`list`](list()) says what exercises there are, [`start`](start()) hands one out. [`check`](check())
//! builds and runs an attempt where it is, on its author's machine. [`grade`](grade()) trusts nobody: each
//! submission is built and run in a sandbox, upon a hand-out that was built once, and only its own files of
//! `src` count. All of them read the [`Catalog`], which is that of the checkout that this was built from.

mod attempt;
mod bench;
mod cargo;
mod catalog;
mod check;
mod folder;
mod grade;
mod instructor;
pub mod judge;
mod limits;
mod list;
mod placed;
mod process;
mod report;
mod sandbox;
mod sheets;
mod start;
mod state;
mod submission;

// What is cut from a chapter is that chapter's own code, linted there; cut out, parts of it stand without use
// or words.
#[allow(
    dead_code,
    missing_docs,
    unexpected_cfgs,
    unreachable_pub,
    unused_assignments,
    unused_imports,
    unused_mut,
    unused_variables,
    clippy::all
)]
mod solutions {
    include!(concat!(env!("OUT_DIR"), "/solutions.rs"));
}

pub use catalog::{Catalog, Exercise, Known};
pub use check::{CheckAsk, check};
pub use grade::{GradeAsk, GradeFormat, grade};
pub use list::{ListFormat, list};
pub use sheets::{answers, sheet};
pub use start::{hand_out, start};

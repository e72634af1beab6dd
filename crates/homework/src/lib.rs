//! Hand out an exercise, check an attempt, grade a class.
//!
//! What an exercise is stands in `chapters/*/exercises`, see [`cutter`]. Its reference solution is the chapter's own
//! code, and each known mistake is the same code with some lines changed; both are modules of this crate, made when it is
//! built. An attempt is judged by what it makes of the cases ([`judge`]): never by its text.

mod catalog;
mod check;
mod folder;
pub mod judge;
mod list;
mod sheets;
mod start;

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
pub use check::check;
pub use list::list;
pub use sheets::{answers, sheet};
pub use start::{hand_out, start};

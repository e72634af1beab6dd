//! The tests of the whole: every stage, as a reader runs it.
//!
//! [`STAGES`] is the one list of stages. A stage that stands in it is covered by all tests under
//! `tests/all`: its transcripts, help texts and error messages against snapshots, its pictures
//! pixel by pixel, its answers against exact ones. The snapshots of a new stage are accepted with
//! `INSTA_UPDATE=always cargo test -p tests`, its picture with `UPDATE_PICTURES=1`; then read and
//! look at what was accepted.

mod bars;
mod folder;
pub mod fuzzed;
mod judge;
mod picture;
mod record;
mod rows;
mod run;
mod verdict;

pub use bars::{BARS, Bars};
pub use folder::Folder;
pub use judge::{Judge, is_within};
pub use picture::compare;
pub use record::{Record, case_of, number, records};
pub use rows::{header, plain_row, row_with};
pub use run::{Run, command_in};
pub use verdict::exact_verdict;

use stage::Stage;

/// Every stage, in the order of the book: those that the workbench runs.
pub static STAGES: &[&dyn Stage] = workbench::stages::ALL;

/// Those of them that answer case files.
pub fn with_cases() -> impl Iterator<Item = &'static dyn Stage> {
    STAGES.iter().copied().filter(|stage| !stage.about().inputs.is_empty())
}

/// The stage of that name; `None` where there is none.
pub fn stage_named(name: &str) -> Option<&'static dyn Stage> {
    STAGES.iter().copied().find(|stage| stage.about().name == name)
}

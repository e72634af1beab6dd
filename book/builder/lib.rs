//! Builds the book: mdBook's pages, filled from what the project itself runs.
//!
//! A page is Markdown with lines of its own in double braces, each of which fetches something that is kept elsewhere:
//!
//! ```text
//! {{code chapters/04-ray-sphere/src/closest_approach.rs along}}      items of a source file
//! {{show ray-sphere --pixel 170,300 | Both roots}}                   a command, and what it prints, or a section of it
//! {{text book/src/same-bits.txt}}                                   a file as it stands; of a snapshot what was shown
//! {{picture ray-sphere}}                                             the picture of a stage, drawn
//! {{figure ray-sphere}}                                              the interactive figure of a chapter
//! {{trade ray-sphere grazing | method t_ulp_max}}                   rows and columns of what `trade` measured
//! {{exercises ray-sphere}}                                           the exercises of a chapter
//! ```
//!
//! and with mathematics between dollar signs. Nothing is typed twice: [`build`] fails, with the page and the line, where
//! an item is missing, where a stage prints something else than its accepted snapshot, where a block of code comes from
//! nowhere, where a test is named that there is not, where a row of the coverage of the notes names no place or no test, and where a link leads nowhere.

#![forbid(unsafe_code)]

mod build;
mod code;
mod exercises;
mod fault;
mod figures;
mod links;
mod math;
mod page;
mod pictures;
mod shown;
mod trade;

pub use build::build;
pub use fault::Fault;

//! What a stage binary is made of: its verbs, the list of steps, pictures, case files, exit status.
//!
//! A chapter implements [`Chapter`] in its `stage.rs`, makes it a [`Stage`] there, and calls [`main`] in its `main.rs`:
//!
//! ```ignore
//! fn main() -> std::process::ExitCode {
//!     stage::main(ray_wall::stage::STAGE)
//! }
//! ```
//!
//! The key type is [`Transcript`]: the steps of one ray, each with its symbol, its formula as the
//! page writes it, and its value, taken from the struct that the chapter's method returned. It is
//! made once; the terminal, `--format json`, the snapshots and the gallery all show that same list,
//! so they cannot disagree. This crate knows no chapter and no formula.
//!
//! Beside it a stage has a picture ([`Canvas`]), answers the rows of a case file ([`Case`], [`Row`]) and is
//! measured ([`TradeAsk`], [`Traded`]). [`Sketch`] is what the inspector and the book's [`figure`]s draw
//! with, [`tiled`] works on a picture with several threads, and [`write_whole`] writes a file or leaves none.
//!
//! A section of it, by hand:
//!
//! ```
//! use stage::Section;
//!
//! let mut section = Section::new("a wall four ahead", "House 4.2");
//! section.number("t", "(front − p_x) / u_x", 2.0).note("in lengths of the direction");
//! assert_eq!(section.steps[0].value.to_text(), "2");
//! ```

mod ask;
mod canvas;
mod case;
mod color;
mod command;
mod error;
mod eval;
pub mod figure;
mod flags;
mod font;
mod ids;
mod inspect;
mod interrupt;
mod json;
mod large_file;
mod pixels;
#[cfg_attr(target_family = "wasm", path = "progress/nowhere.rs")]
mod progress;
mod sketch;
mod text;
mod tiles;
mod trade;
mod transcript;
mod value;
mod view;
mod whole_file;

pub use ask::{About, Ask, Chapter, Chosen, Precision, Shown, Stage, Words};
pub use canvas::{Anchor, Canvas, Pen};
pub use case::{Case, Row};
pub use color::Color;
pub use command::{asked, finish, main, main_from, refuse, report};
pub use error::Error;
pub use eval::answer_cases;
pub use flags::{Flag, command as command_line};
pub use ids::Ids;
pub use inspect::{Inspect, Inspector, Look, Packed};
pub use interrupt::{Scratch, clean_up_when_interrupted};
pub use large_file::large_files_are_errors;
pub use pixels::each_pixel;
pub use progress::Progress;
pub use sketch::{Ink, SKETCH, Sketch, escaped};
pub use tiles::{Tile, Workers, tiled};
pub use trade::{Drawing, Field, Record, Sheet, TradeAsk, Traded};
pub use transcript::{Section, Step, Table, Transcript};
pub use value::Value;
pub use view::View;
pub use whole_file::{try_beside, write_picture, write_whole};

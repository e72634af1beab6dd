//! Cuts an exercise from the very code that the stage runs, so that there is no second copy of a chapter.
//!
//! In a chapter's file two comments mark a region:
//!
//! ```text
//! // exercise t_close: How far along the ray is the point nearest to the center?
//! let t_close = u_r.dot(c - p_r);
//! // end t_close
//! ```
//!
//! [`cut`](mod@cut) takes regions out and puts a question, or another solution, in their place.
//! [`slice`](mod@slice) takes from the rest of the chapter what the region needs and nothing else; [`docs`]
//! says in other words what would give the answer away. A [`Manifest`], a TOML file in the chapter's folder
//! `exercises`, says which regions and which rest, and knows the mistakes that are often made. [`hand_out()`]
//! writes a project for a student; [`modules`] writes the reference solution, the mistakes and other
//! solutions as modules of one crate.
//!
//! What earlier chapters taught, and earlier exercises of the chapter, comes along solved ([`given`]); what
//! later exercises of the chapter ask is hidden. No comment of a hand-out has a formula that is asked for:
//! [`formulas`] finds them. Everything is read from a checkout, a [`Source`]. Where something is wrong with
//! what is read the error is a text for whoever wrote the exercise: which file, and what is wrong there.
//!
//! [`named`] is apart from this: it looks in the sources for the tests and functions that a table names.
//!
//! A region, and what a student sees of it:
//!
//! ```
//! use std::collections::BTreeMap;
//!
//! use cutter::cut::{Filling, cut};
//!
//! let text = "\
//! // exercise twice: What is x and x again?
//! let y: f64 = x + x;
//! // end twice
//! ";
//! let fillings = BTreeMap::from([("twice".to_string(), Filling::Question)]);
//! assert_eq!(cut(text, &fillings)?, "let y: f64 = todo!(\"What is x and x again?\");\n");
//! # Ok::<(), String>(())
//! ```

pub mod cut;
pub mod docs;
pub mod formulas;
pub mod given;
pub mod hand_out;
pub mod manifest;
pub mod modules;
pub mod named;
mod operations;
pub mod slice;
pub mod source;

pub use cut::{Filling, cut, statements};
pub use hand_out::hand_out;
pub use manifest::{Manifest, Mistake};
pub use source::Source;

//! Attempts at every exercise, as modules of one crate: the untouched hand-out, right solutions in other
//! algebra, and each known mistake written twice more, independently of the model that it is recognized by.
//! `tests/` judges them all.

// Cut out of a chapter, parts of its code stand without use or words, and what comes after a hole is never
// reached.
#[allow(
    dead_code,
    missing_docs,
    unexpected_cfgs,
    unreachable_code,
    unreachable_pub,
    unused_assignments,
    unused_imports,
    unused_mut,
    unused_variables,
    clippy::all,
    reason = "it is a chapter's own code, and linted there"
)]
mod attempts {
    include!(concat!(env!("OUT_DIR"), "/attempts.rs"));
}

/// What an attempt is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// The hand-out as it was handed out.
    Untouched,
    /// Right, in other algebra: the so-many-th.
    Right(usize),
    /// Wrong, by this mistake, written for the so-many-th time.
    Wrong(&'static str, usize),
}

/// An attempt: the exercise's name, what it is, and what it does.
pub type Attempt = (&'static str, Kind, exercise::Probe);

/// Every attempt, by exercise.
pub fn all() -> &'static [Attempt] {
    attempts::ALL
}

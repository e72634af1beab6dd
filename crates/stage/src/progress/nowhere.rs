//! A bar where there is no terminal: in the figures of the book.

use std::borrow::Cow;

/// Nothing that is seen.
pub struct Progress;

impl Progress {
    /// See the other one.
    pub fn new(_: u64) -> Progress {
        Progress
    }

    /// See the other one.
    pub fn patient(_: u64, _: impl Into<Cow<'static, str>>) -> Progress {
        Progress
    }

    /// See the other one.
    pub fn starts(&self, _: impl Into<Cow<'static, str>>) {}

    /// See the other one.
    pub fn done(&self) {}
}

//! Where a value stands in its file.

use std::ops::Range;

/// A value and its place, so that whoever finds it wrong can point at it.
#[derive(Clone, Debug, PartialEq)]
pub struct At<T> {
    /// The value.
    pub value: T,
    /// Where the file says so.
    pub place: Place,
}

/// A stretch of the bytes of a scene's text, counted from 0. (The text begins after a byte order mark.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The first byte.
    pub start: usize,
    /// The byte after the last one.
    pub end: usize,
}

impl Place {
    /// The bytes of the file.
    pub fn range(self) -> Range<usize> {
        self.start..self.end
    }
}

impl From<Range<usize>> for Place {
    fn from(bytes: Range<usize>) -> Place {
        Place { start: bytes.start, end: bytes.end }
    }
}

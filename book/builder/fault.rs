//! What is wrong with a page, and where.

use std::fmt;
use std::path::PathBuf;

/// One thing that keeps the book from being built.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The file, as seen from the project's root.
    pub file: PathBuf,
    /// The line, from 1; 0 where it is the file as a whole.
    pub line: usize,
    /// What is wrong, and what would be right.
    pub what: String,
}

impl Fault {
    /// A fault in a line of a file; line 0 is the whole of it.
    pub fn new(file: impl Into<PathBuf>, line: usize, what: impl Into<String>) -> Fault {
        Fault { file: file.into(), line, what: what.into() }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            0 => write!(f, "{}: {}", self.file.display(), self.what),
            line => write!(f, "{}:{line}: {}", self.file.display(), self.what),
        }
    }
}

//! What can go wrong, and the exit status it means.

use std::fmt;
use std::io;

/// Why a command ended without doing what it was asked.
#[derive(Debug)]
pub enum Error {
    /// The request was wrong (usage, a bad case file): exit status 2. The text names the place and
    /// says what would be right.
    Request(String),
    /// It could not be done (a file not writable, a disk full): exit status 1.
    Failed(String),
    /// What was looked at is not right yet, and that has been said: nothing to add, exit status 1.
    NotYet,
    /// The reader of the output went away, as `head` does: nothing to say, exit status 0.
    PipeClosed,
}

impl Error {
    /// The exit status of the contract.
    pub fn status(&self) -> u8 {
        match self {
            Error::Request(_) => 2,
            Error::Failed(_) | Error::NotYet => 1,
            Error::PipeClosed => 0,
        }
    }

    /// What a failed write to standard output means.
    pub fn from_output(error: io::Error) -> Error {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Error::PipeClosed,
            _ => Error::Failed(format!("cannot write to standard output: {error}")),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Request(text) | Error::Failed(text) => f.write_str(text),
            Error::NotYet => f.write_str("it is not right yet"),
            Error::PipeClosed => f.write_str("the reader of the output went away"),
        }
    }
}

impl std::error::Error for Error {}

/// A stage's own scene is never degenerate; if it were, the stage could not be shown.
impl From<math::Degenerate> for Error {
    fn from(degenerate: math::Degenerate) -> Error {
        Error::Failed(degenerate.to_string())
    }
}

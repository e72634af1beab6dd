//! Why there is no grid.

use std::fmt;

/// A grid that cannot be laid: `edges` with a single column or row divides by zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoGrid;

impl fmt::Display for NoGrid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the grid `edges` needs at least two columns and two rows: it runs from edge to edge")
    }
}

impl std::error::Error for NoGrid {}

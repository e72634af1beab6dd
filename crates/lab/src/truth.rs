//! What is true of a case, as the oracle found it.

use math::Wide;

/// The exact answer to a case, by the root rule of the contract: the smallest root ≥ 0, touching
/// counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Truth {
    /// A question without an answer, with the reason that a result row gives.
    Invalid(&'static str),
    /// A miss, with the reason that a result row gives; mostly empty.
    Miss(&'static str),
    /// A hit.
    Hit {
        /// The smallest root ≥ 0.
        t: Root,
        /// Where the line leaves the body; `None` for a surface without an inside.
        out: Option<Root>,
    },
}

/// An exact value of t, as far as it can be written down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// The value of the precision that is nearest to it, ties to even, the rounding decided exactly; an
    /// infinity beyond the largest one. Never minus zero.
    pub nearest: f64,
    /// The same to 100 bits and more, whatever its size.
    pub fine: Wide,
}

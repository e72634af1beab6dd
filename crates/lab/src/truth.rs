//! What is true of a case, as the oracle found it.

use math::{Around, Wide};

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
        /// Where the line leaves a wall or a sphere; `None` for everything else, which has no t_out.
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

impl Root {
    /// Whether it is where a glance says: not farther from its t than that may be off. The numbers of
    /// `around` must be finite.
    pub fn is_within(&self, around: Around) -> bool {
        let away = self.fine - Wide::from(around.t);
        let away = if away.is_negative() { -away } else { away };
        !(Wide::from(around.off) - away).is_negative()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 3 is within 1/2 of 2.5 and of 3.5, and not of one digit less or more.
    #[test]
    fn the_ends_are_within() {
        let root = Root { nearest: 3.0, fine: Wide::from(3.0) };
        for (t, is_within) in
            [(2.5, true), (3.5, true), (2.5_f64.next_down(), false), (3.5_f64.next_up(), false)]
        {
            assert_eq!(root.is_within(Around { t, off: 0.5 }), is_within, "{t}");
        }
    }
}

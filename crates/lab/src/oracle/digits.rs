//! The leading digits of a root, and an interval that holds it.

use math::{TwoPart, Wide};

use super::Dyadic;

/// A number to about 125 bits: its size is at least leading · 2^exponent, and less than
/// (leading + [`Digits::SLACK`]) · 2^exponent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Digits {
    pub(super) negative: bool,
    /// 126 or 127 bits; 0 for zero.
    pub(super) leading: u128,
    pub(super) exponent: i32,
}

impl Digits {
    /// How many of its units the interval is long: one for what the division drops, and one for what
    /// is missing from the numbers divided.
    pub(super) const SLACK: u128 = 2;

    /// The digits of n / d, for d > 0.
    ///
    /// They are right also for a quotient whose n is larger in size, or whose d is smaller, by less than
    /// 2^−128 of it: that adds less than a unit.
    pub(super) fn of_quotient(n: &Dyadic, d: &Dyadic) -> Digits {
        let (Some(n_top), Some(d_top)) = (n.top(), d.top()) else {
            return Digits { negative: false, leading: 0, exponent: 0 };
        };
        // d in its own units, n in such that the quotient has 126 or 127 bits.
        let exponent = n_top - d_top - 126;
        let d_unit = d.unit();
        let quotient = n.whole(d_unit + exponent) / d.whole(d_unit);
        let leading = quotient.try_into().expect("a number below 2^127 fits 128 bits");
        Digits { negative: n.sign().is_lt(), leading, exponent }
    }

    /// The number to 106 bits, as far as two parts reach.
    pub(super) fn to_wide(self) -> Wide {
        // Seven bits fewer: hi, rounded up, is still far below the largest i128.
        let leading = self.leading >> 7;
        let hi = leading as f64;
        let lo = (leading as i128 - hi as i128) as f64;
        let value = TwoPart { hi, lo };
        Wide::new(if self.negative { -value } else { value }, self.exponent + 7)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_third_and_its_digits() {
        // by hand: 2^127 / 3 is 1010…10 in binary, 126 bits
        let [three, minus_one] = [3.0, -1.0].map(Dyadic::of);
        let third = Digits::of_quotient(&minus_one, &three);
        assert_eq!((third.negative, third.leading, third.exponent), (true, (1 << 127) / 3, -127));
        // −1/3 + 1/3 in two parts, and what they leave
        let rest = third.to_wide() * Wide::from(3.0) + Wide::from(1.0);
        assert!(rest.to_f64().abs() <= f64::EPSILON.powi(2), "{rest:?}");
    }

    #[test]
    fn the_longest_digits_fit() {
        // by hand: (2^53 − 1) / 1 has only ones at its front, 1 / (2^53 − 1) only noughts behind its one
        let [ones, one] = [f64::MAX, 1.0].map(Dyadic::of);
        for (n, d) in [(&ones, &one), (&one, &ones), (&ones.square(), &one), (&one, &ones.square())] {
            let digits = Digits::of_quotient(n, d);
            assert!((126..=127).contains(&(128 - digits.leading.leading_zeros())), "{digits:?}");
        }
        let zero = Digits::of_quotient(&Dyadic::of(-0.0), &ones);
        assert!(zero.leading == 0 && !zero.negative && zero.to_wide().is_zero());
    }
}

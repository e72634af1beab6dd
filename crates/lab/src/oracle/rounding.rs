//! The nearest float, decided exactly.

use std::cmp::Ordering;

use stage::Precision;

use super::Dyadic;
use super::digits::Digits;

/// A binary format of IEEE 754.
struct Format {
    /// Of the significand.
    digits: i32,
    /// The exponent of the last digit of the smallest numbers.
    lowest: i32,
    /// The same of the largest.
    highest: i32,
    /// Makes a number of its bits.
    of_bits: fn(u64) -> f64,
}

const BINARY32: Format =
    Format { digits: 24, lowest: -149, highest: 104, of_bits: |bits| f64::from(f32::from_bits(bits as u32)) };
const BINARY64: Format = Format { digits: 53, lowest: -1074, highest: 971, of_bits: f64::from_bits };

/// The value of the precision nearest to a number of which these are the leading digits, ties to even;
/// an infinity where that would be beyond the largest one, zero and never minus zero where it is zero.
///
/// `compared_with` says how the number compares with another. It is asked where the digits
/// leave open on which side of a midpoint the number lies.
pub(super) fn nearest(
    digits: &Digits,
    precision: Precision,
    compared_with: impl Fn(&Dyadic) -> Ordering,
) -> f64 {
    let format = match precision {
        Precision::F32 => BINARY32,
        Precision::F64 => BINARY64,
    };
    let size = format.nearest_size(digits, |midpoint| {
        if digits.negative { compared_with(&-&midpoint).reverse() } else { compared_with(&midpoint) }
    });
    if digits.negative && size != 0.0 { -size } else { size }
}

impl Format {
    /// The number nearest to the size of what has these digits.
    fn nearest_size(&self, digits: &Digits, size_compared_with: impl Fn(Dyadic) -> Ordering) -> f64 {
        if digits.leading == 0 {
            return 0.0;
        }
        // Numbers of this size are multiples of 2^grid.
        let length = 128 - digits.leading.leading_zeros() as i32;
        let grid = (digits.exponent + length - self.digits).max(self.lowest);
        if grid > self.highest {
            return f64::INFINITY;
        }
        // The interval reaches to 2^127 + 1 units at the most: less than half of a grid of 2^129.
        let dropped = grid - digits.exponent;
        if dropped > 128 {
            return 0.0;
        }
        let half = 1 << (dropped - 1);
        let below = digits.leading.checked_shr(dropped as u32).unwrap_or(0) as u64;
        let rest = digits.leading & (half | (half - 1));
        let up = if rest > half {
            true
        } else if rest + Digits::SLACK <= half {
            false
        } else {
            let midpoint = Dyadic::scaled(2 * below + 1, grid - 1);
            match size_compared_with(midpoint) {
                Ordering::Greater => true,
                Ordering::Less => false,
                Ordering::Equal => below % 2 == 1,
            }
        };
        self.at(below + u64::from(up), grid)
    }

    /// place · 2^grid. Bits of floats count up: from the last number of one power of two to the first of
    /// the next, from the subnormal ones to the normal, from the largest to infinity.
    fn at(&self, place: u64, grid: i32) -> f64 {
        let powers = (grid - self.lowest) as u64;
        (self.of_bits)((powers << (self.digits - 1)) + place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::ExactRoot;
    use crate::oracle::quadratic::Quadratic;

    /// m − a little, m and m + a little, with m = twice_m / 2. Little is far behind the digits that are
    /// worked out, once rational and once not.
    fn around(twice_m: &Dyadic, precision: Precision) -> [f64; 3] {
        let m = twice_m * &Dyadic::scaled(1, -1);
        let little = Dyadic::scaled(1, -4000);
        let quotient = |n: &Dyadic| ExactRoot::quotient(n.clone(), Dyadic::of(1.0));
        let [below, at, above] =
            [&m - &little, m.clone(), &m + &little].map(|n| quotient(&n).written(precision).nearest);
        // (t − m)² = 2 little², so t = m ± √2 little
        let c = &m.square() - &(&Dyadic::of(2.0) * &little.square());
        let equation = Quadratic::new(Dyadic::of(1.0), m, c).expect("two roots");
        let [smaller, larger] = ExactRoot::roots(equation).map(|root| root.written(precision).nearest);
        assert_eq!([smaller, larger], [below, above], "{twice_m:?}");
        [below, at, above]
    }

    #[test]
    fn a_midpoint_is_told_from_its_neighborhood() {
        for precision in Precision::ALL {
            let (smallest, largest, epsilon, power) = match precision {
                Precision::F32 => (f32::from_bits(1).into(), f32::MAX.into(), f32::EPSILON.into(), 128),
                Precision::F64 => (f64::from_bits(1), f64::MAX, f64::EPSILON, 1024),
            };
            // by hand: two neighbors, of which the second is even or odd
            let one_and = |steps: f64| 1.0 + steps * epsilon;
            let cases = [
                (1.0, one_and(1.0), false),
                (one_and(1.0), one_and(2.0), true),
                (1.0 - epsilon / 2.0, 1.0, true),
                (0.0, smallest, false),
                (smallest, 2.0 * smallest, true),
                (largest, f64::INFINITY, true),
            ];
            for (low, high, even) in cases {
                let exact_high = if high.is_finite() { Dyadic::of(high) } else { Dyadic::scaled(1, power) };
                let twice_m = &Dyadic::of(low) + &exact_high;
                let tie = if even { high } else { low };
                assert_eq!(around(&twice_m, precision), [low, tie, high], "{low:e} {high:e}");
                assert_eq!(around(&-&twice_m, precision), [-high, -tie, -low], "−{low:e} −{high:e}");
            }
        }
    }

    #[test]
    fn zero_is_never_negative() {
        for n in [Dyadic::scaled(-1, -1075), Dyadic::scaled(-1, -9000), Dyadic::of(-0.0)] {
            let root = ExactRoot::quotient(n, Dyadic::of(1.0)).written(Precision::F64);
            assert_eq!(root.nearest.to_bits(), 0);
        }
        let infinite = ExactRoot::quotient(Dyadic::scaled(-1, 9000), Dyadic::of(1.0));
        assert_eq!(infinite.written(Precision::F32).nearest, f64::NEG_INFINITY);
    }
}

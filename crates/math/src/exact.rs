//! Numbers that are never rounded.
//!
//! Every finite float is an integer times a power of two, and so is every sum and product of such
//! numbers. Written with integers as long as it takes, the sign of a discriminant is simply true.
//! It is slow (about a microsecond an operation): the last resort of the `robust` methods, for the
//! few rays whose verdict two-part arithmetic leaves in doubt.

use std::ops::{Add, Mul, Neg, Sub};

use crate::{TwoPart, Wide};

/// ± magnitude · 2^exponent, exactly.
#[derive(Clone, Debug)]
pub struct Exact {
    negative: bool,
    /// Digits to the base 2^64, the least significant first; no zero at the end; empty for zero.
    magnitude: Vec<u64>,
    exponent: i32,
}

impl Exact {
    /// The number `x` itself. It must be finite.
    pub fn new(x: f64) -> Exact {
        let bits = x.to_bits();
        let biased = ((bits >> 52) & 0x7ff) as i32;
        let fraction = bits & ((1 << 52) - 1);
        let (integer, exponent) =
            if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
        Exact::normal(x < 0.0, vec![integer], exponent)
    }

    /// a · b for vectors of as many components, exactly: the sum of the products of these.
    pub fn dot(a: &[Exact], b: &[Exact]) -> Exact {
        a.iter().zip(b).fold(Exact::new(0.0), |sum, (a, b)| sum + a.clone() * b.clone())
    }

    /// Equal to zero.
    pub fn is_zero(&self) -> bool {
        self.magnitude.is_empty()
    }

    /// Less than zero.
    pub fn is_negative(&self) -> bool {
        self.negative
    }

    /// The number to 106 bits and more, as far as two parts reach.
    pub fn to_wide(&self) -> Wide {
        let Some(&top) = self.magnitude.last() else {
            return Wide::ZERO;
        };
        // The leading 120 bits as one integer, then as a float and what the float leaves.
        let bits = 64 * self.magnitude.len() as i32 - top.leading_zeros() as i32;
        let dropped = (bits - 120).max(0);
        let leading = shifted_right(&self.magnitude, dropped as u32);
        let hi = leading as f64;
        let lo = (leading as i128 - hi as i128) as f64;
        let value = TwoPart { hi, lo };
        Wide::new(if self.negative { -value } else { value }, self.exponent + dropped)
    }

    fn normal(negative: bool, mut magnitude: Vec<u64>, exponent: i32) -> Exact {
        while magnitude.last() == Some(&0) {
            magnitude.pop();
        }
        Exact { negative: negative && !magnitude.is_empty(), magnitude, exponent }
    }

    /// The magnitude with respect to a smaller exponent.
    fn aligned(&self, exponent: i32) -> Vec<u64> {
        let shift = (self.exponent - exponent) as u32;
        let mut digits = vec![0; (shift / 64) as usize];
        let mut carry = 0;
        for &digit in &self.magnitude {
            let moved = (u128::from(digit)) << (shift % 64);
            digits.push(moved as u64 | carry);
            carry = (moved >> 64) as u64;
        }
        digits.push(carry);
        digits
    }
}

/// The integer divided by 2^shift, rounded down; it must fit 128 bits.
fn shifted_right(digits: &[u64], shift: u32) -> u128 {
    let digit = |i: usize| u128::from(digits.get(i).copied().unwrap_or(0));
    let (skip, within) = ((shift / 64) as usize, shift % 64);
    let low = digit(skip) | digit(skip + 1) << 64;
    if within == 0 { low } else { low >> within | digit(skip + 2) << (128 - within) }
}

/// a − b of magnitudes as long as each other, and whether it came out negative.
fn difference(a: &[u64], b: &[u64]) -> (Vec<u64>, bool) {
    let negative = a.iter().rev().lt(b.iter().rev());
    let (large, small) = if negative { (b, a) } else { (a, b) };
    let mut borrow = false;
    let digits = large.iter().zip(small).map(|(&l, &s)| {
        let (digit, under) = l.overflowing_sub(s);
        let (digit, under_again) = digit.overflowing_sub(u64::from(borrow));
        borrow = under || under_again;
        digit
    });
    (digits.collect(), negative)
}

/// a + b of magnitudes as long as each other.
fn sum(a: &[u64], b: &[u64]) -> Vec<u64> {
    let mut carry = 0;
    let mut digits: Vec<u64> = Vec::with_capacity(a.len() + 1);
    for (&a, &b) in a.iter().zip(b) {
        let total = u128::from(a) + u128::from(b) + carry;
        digits.push(total as u64);
        carry = total >> 64;
    }
    digits.push(carry as u64);
    digits
}

impl Add for Exact {
    type Output = Exact;
    fn add(self, other: Exact) -> Exact {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other } else { self };
        }
        let exponent = self.exponent.min(other.exponent);
        let (mut a, mut b) = (self.aligned(exponent), other.aligned(exponent));
        let length = a.len().max(b.len());
        a.resize(length, 0);
        b.resize(length, 0);
        if self.negative == other.negative {
            return Exact::normal(self.negative, sum(&a, &b), exponent);
        }
        let (magnitude, flipped) = difference(&a, &b);
        Exact::normal(self.negative != flipped, magnitude, exponent)
    }
}

impl Neg for Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact::normal(!self.negative, self.magnitude, self.exponent)
    }
}

impl Sub for Exact {
    type Output = Exact;
    fn sub(self, other: Exact) -> Exact {
        self + -other
    }
}

impl Mul for Exact {
    type Output = Exact;
    fn mul(self, other: Exact) -> Exact {
        let mut digits = vec![0; self.magnitude.len() + other.magnitude.len()];
        for (i, &a) in self.magnitude.iter().enumerate() {
            let mut carry = 0;
            for (j, &b) in other.magnitude.iter().enumerate() {
                let total = u128::from(a) * u128::from(b) + u128::from(digits[i + j]) + carry;
                digits[i + j] = total as u64;
                carry = total >> 64;
            }
            digits[i + other.magnitude.len()] = carry as u64;
        }
        Exact::normal(self.negative != other.negative, digits, self.exponent + other.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NUMBERS: [f64; 10] =
        [0.0, 1.0, -1.0, 0.1, -3e200, 1e-200, 5e-324, f64::MAX, -f64::MIN_POSITIVE, 12345.678];

    #[test]
    fn a_number_comes_back_as_it_went_in() {
        for x in NUMBERS {
            assert_eq!(Exact::new(x).to_wide().to_f64(), x);
        }
    }

    #[test]
    fn binomial_formulas_leave_nothing() {
        for a in NUMBERS {
            for b in NUMBERS {
                let [a, b] = [a, b].map(Exact::new);
                let square = (a.clone() + b.clone()) * (a.clone() + b.clone());
                let rest = square.clone()
                    - a.clone() * a.clone()
                    - Exact::new(2.0) * a.clone() * b.clone()
                    - b.clone() * b.clone();
                assert!(rest.is_zero(), "(a + b)² − a² − 2ab − b² = {rest:?}");
                let thirds =
                    (a.clone() - b.clone()) * (a.clone() + b.clone()) - a.clone() * a + b.clone() * b;
                assert!(thirds.is_zero(), "(a − b)(a + b) − a² + b² = {thirds:?}");
            }
        }
    }

    #[test]
    fn the_smallest_difference_has_its_sign() {
        let difference = Exact::new(f64::MAX) * Exact::new(f64::MAX)
            - (Exact::new(f64::MAX) * Exact::new(f64::MAX) + Exact::new(5e-324));
        assert!(difference.is_negative() && !difference.is_zero());
        assert_eq!(difference.to_wide().to_f64(), -5e-324);
    }

    #[test]
    fn two_parts_survive() {
        let third = Exact::new(1.0 / 3.0);
        let square = third.clone() * third; // 106 bits
        let two_part = crate::two_part::two_product(1.0 / 3.0, 1.0 / 3.0);
        let rest = square.to_wide() - Wide::from(two_part);
        assert!(rest.is_zero(), "{rest:?}");
    }
}

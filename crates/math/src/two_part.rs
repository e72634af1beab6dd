//! Numbers in two parts: twice the digits of `f64`, from `f64` operations alone.
//!
//! The rounding error of one addition or one multiplication is itself a floating-point number, and
//! can be computed ([`two_sum`], [`two_product`]: Knuth 1969, Dekker 1971). Kept beside the result it
//! gives a number hi + lo of about 106 bits.
//!
//! Nothing here guards against overflow or underflow: keep magnitudes between about 2^−400 and
//! 2^400, or use [`Wide`](crate::Wide).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum hi + lo, with |lo| at most half the last digit of hi.
///
/// One operation errs by at most 2^−102 of its result (2^−102 of |a| + |b| for a sum of unlike signs):
/// with u = 2^−53, Joldes, Muller and Popescu (2017) prove 3u² for sums of this kind, 5u² for products
/// and 15u² for quotients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoPart {
    /// The nearest `f64`.
    pub hi: f64,
    /// What is left.
    pub lo: f64,
}

/// a + b exactly: the rounded sum and its rounding error (Knuth's TwoSum).
pub fn two_sum(a: f64, b: f64) -> TwoPart {
    let hi = a + b;
    let b_rounded = hi - a;
    let a_rounded = hi - b_rounded;
    TwoPart { hi, lo: (a - a_rounded) + (b - b_rounded) }
}

/// a + b exactly, where |a| ≥ |b| or a = 0 (Dekker's FastTwoSum).
pub fn fast_two_sum(a: f64, b: f64) -> TwoPart {
    let hi = a + b;
    TwoPart { hi, lo: b - (hi - a) }
}

/// a · b exactly: the rounded product and its rounding error.
///
/// Dekker splits each factor into halves of 26 bits, whose products are exact. Where there is a fused multiply-add the
/// error is one instruction, and the same number for factors in the range named above. Outside it is another, so it is
/// not taken: what is worked out must not depend on the processor.
pub fn two_product(a: f64, b: f64) -> TwoPart {
    let hi = a * b;
    let (a_hi, a_lo) = halves(a);
    let (b_hi, b_lo) = halves(b);
    TwoPart { hi, lo: ((a_hi * b_hi - hi) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo }
}

/// `a` as a sum of two numbers of at most 26 significant bits (Veltkamp).
fn halves(a: f64) -> (f64, f64) {
    let shifted = 134_217_729.0 * a; // 2^27 + 1
    let hi = shifted - (shifted - a);
    (hi, a - hi)
}

/// The sum of many numbers as if it were computed with three times the digits and then rounded: off by less
/// than u of itself and (2Nu)³ of the sum of their magnitudes, u = 2^−53 (Ogita, Rump and Oishi 2005, SumK
/// with K = 3).
pub fn threefold_sum<const N: usize>(terms: [f64; N]) -> f64 {
    distilled(terms).into_iter().sum()
}

/// Other numbers with the same sum, the last of them nearly all of it: twice, each sum passes its rounding
/// error to the number before it, and nothing is lost.
pub fn distilled<const N: usize>(mut terms: [f64; N]) -> [f64; N] {
    for _ in 0..2 {
        for i in 1..N {
            let sum = two_sum(terms[i], terms[i - 1]);
            (terms[i], terms[i - 1]) = (sum.hi, sum.lo);
        }
    }
    terms
}

/// a · b for vectors, in two parts: products and sums with twice the digits.
pub fn dot<B: Copy>(a: [TwoPart; 3], b: [B; 3]) -> TwoPart
where
    TwoPart: Mul<B, Output = TwoPart>,
{
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl TwoPart {
    /// The square root; zero for zero, and for a negative number, which has none.
    pub fn sqrt(self) -> TwoPart {
        if self.hi <= 0.0 {
            return TwoPart::from(0.0);
        }
        // One Newton step from the rounded root: s + (x − s²) / 2s.
        let s = self.hi.sqrt();
        let rest = self - two_product(s, s);
        fast_two_sum(s, rest.hi / (2.0 * s))
    }
}

impl From<f64> for TwoPart {
    fn from(x: f64) -> TwoPart {
        TwoPart { hi: x, lo: 0.0 }
    }
}

impl Neg for TwoPart {
    type Output = TwoPart;
    fn neg(self) -> TwoPart {
        TwoPart { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for TwoPart {
    type Output = TwoPart;
    fn add(self, other: TwoPart) -> TwoPart {
        let high = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let sum = fast_two_sum(high.hi, high.lo + low.hi);
        fast_two_sum(sum.hi, sum.lo + low.lo)
    }
}

impl Sub for TwoPart {
    type Output = TwoPart;
    fn sub(self, other: TwoPart) -> TwoPart {
        self + -other
    }
}

impl Mul for TwoPart {
    type Output = TwoPart;
    fn mul(self, other: TwoPart) -> TwoPart {
        let high = two_product(self.hi, other.hi);
        fast_two_sum(high.hi, high.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Mul<f64> for TwoPart {
    type Output = TwoPart;
    fn mul(self, factor: f64) -> TwoPart {
        let high = two_product(self.hi, factor);
        fast_two_sum(high.hi, high.lo + self.lo * factor)
    }
}

impl Div for TwoPart {
    type Output = TwoPart;
    /// The divisor must not be zero.
    fn div(self, other: TwoPart) -> TwoPart {
        // Long division with two digits, each a f64.
        let first = self.hi / other.hi;
        let rest = self - other * first;
        fast_two_sum(first, rest.hi / other.hi)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const THIRD: f64 = 1.0 / 3.0;

    #[test]
    fn a_sum_keeps_what_rounding_drops() {
        let sum = two_sum(1e16, 1.0); // 1e16 + 1 is not a f64: the neighbors are 2 apart
        assert_eq!((sum.hi, sum.lo), (1e16, 1.0));
    }

    #[test]
    fn a_product_keeps_what_rounding_drops() {
        // (2^27 + 1)² = 2^54 + 2^28 + 1 needs 55 bits
        let x = 134_217_729.0;
        let product = two_product(x, x);
        assert_eq!((product.hi, product.lo), (18_014_398_777_917_440.0, 1.0));
    }

    #[test]
    fn a_sum_survives_what_cancels() {
        // by hand: 2^100 and 2^50 leave, and 2^−20 is what remains
        let power = |exponent: i32| 2.0_f64.powi(exponent);
        let terms = [power(100), 1.0, power(50), -power(100), power(-20), -power(50), -1.0];
        assert_eq!(threefold_sum(terms), power(-20));
        assert_eq!(terms.iter().sum::<f64>(), -1.0, "a plain sum");
    }

    #[test]
    fn a_third_three_times_is_one() {
        let third = TwoPart::from(1.0) / TwoPart::from(3.0);
        assert_eq!(third.hi, THIRD);
        let rest = third + third + third - TwoPart::from(1.0);
        assert!(rest.hi.abs() < 2.0_f64.powi(-102), "{rest:?}");
    }

    #[test]
    fn a_root_squared_is_the_number() {
        for x in [2.0, 3.0, 1e-10, 12345.678] {
            let root = TwoPart::from(x).sqrt();
            let rest = root * root - TwoPart::from(x);
            assert!(rest.hi.abs() <= x * 2.0_f64.powi(-100), "{x}: {rest:?}");
        }
    }
}

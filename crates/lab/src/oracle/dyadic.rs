//! Numbers that are not rounded: integers times powers of two.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::ops::BitTest;
use dashu_int::{IBig, UBig};

/// mantissa · 2^exponent: every finite float, and every sum and product of such numbers.
///
/// One value has many forms (1 · 2¹ is 2 · 2⁰), so it is not compared by its fields: take a
/// difference and its [`sign`](Dyadic::sign).
#[derive(Clone, Debug)]
pub struct Dyadic {
    mantissa: IBig,
    exponent: i32,
}

impl Dyadic {
    /// The number `x` itself. Panics where it is not finite.
    pub fn of(x: f64) -> Dyadic {
        assert!(x.is_finite(), "{x} is no number");
        let bits = x.to_bits();
        let (biased, fraction) = (((bits >> 52) & 0x7ff) as i32, bits & ((1 << 52) - 1));
        let (magnitude, exponent) =
            if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
        if magnitude == 0 {
            return Dyadic::scaled(0, 0);
        }
        // Without the zeros at its end: whole numbers and axis-aligned rays are short, and fast.
        let zeros = magnitude.trailing_zeros();
        let odd = (magnitude >> zeros) as i64;
        Dyadic::scaled(if x < 0.0 { -odd } else { odd }, exponent + zeros as i32)
    }

    /// mantissa · 2^exponent
    pub fn scaled(mantissa: impl Into<IBig>, exponent: i32) -> Dyadic {
        Dyadic { mantissa: mantissa.into(), exponent }
    }

    /// How it compares with zero.
    pub fn sign(&self) -> Ordering {
        self.mantissa.cmp(&IBig::ZERO)
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// Its product with itself.
    pub fn square(&self) -> Dyadic {
        self * self
    }

    /// ⌊log₂ |x|⌋, the place of its first digit; `None` for zero, which has none.
    pub fn top(&self) -> Option<i32> {
        (!self.is_zero()).then(|| self.mantissa.bit_len() as i32 - 1 + self.exponent)
    }

    /// The exponent of a unit of which it is a whole number.
    pub fn unit(&self) -> i32 {
        self.exponent
    }

    /// |x| in units of 2^exponent, rounded down.
    pub fn whole(&self, exponent: i32) -> UBig {
        let (_, magnitude) = self.mantissa.clone().into_parts();
        let shift = self.exponent - exponent;
        let distance = shift.unsigned_abs() as usize;
        if shift < 0 { magnitude >> distance } else { magnitude << distance }
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: &Dyadic) -> Dyadic {
        // Zero has no digits to align.
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other.clone() } else { self.clone() };
        }
        let (high, low) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let aligned = &high.mantissa << (high.exponent - low.exponent) as usize;
        Dyadic { mantissa: aligned + &low.mantissa, exponent: low.exponent }
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic { mantissa: -&self.mantissa, exponent: self.exponent }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: &Dyadic) -> Dyadic {
        self + &-other
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: &Dyadic) -> Dyadic {
        Dyadic { mantissa: &self.mantissa * &other.mantissa, exponent: self.exponent + other.exponent }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NUMBERS: [f64; 10] =
        [0.0, -0.0, 1.0, -1.0, 0.1, -3e200, 1e-200, 5e-324, f64::MAX, -f64::MIN_POSITIVE];

    #[test]
    fn binomial_formulas_leave_nothing() {
        for a in NUMBERS {
            for b in NUMBERS {
                let [x, y] = [a, b].map(Dyadic::of);
                let product = &(&x + &y) * &(&x - &y);
                let rest = &product - &(&x.square() - &y.square());
                assert!(rest.is_zero(), "(a + b)(a − b) − (a² − b²) = {rest:?} for {a} {b}");
                assert_eq!((&x - &y).sign(), a.partial_cmp(&b).unwrap(), "{a} {b}");
            }
        }
    }

    #[test]
    fn differences_of_far_exponents_are_exact() {
        // by hand: (2 + 2^−1074)² − 4 − 2^−1072 = 2^−2148
        let (two, small) = (Dyadic::of(2.0), Dyadic::of(5e-324));
        let rest = &(&(&two + &small).square() - &Dyadic::of(4.0)) - &Dyadic::scaled(1, -1072);
        assert!((&rest - &small.square()).is_zero());
        assert_eq!((rest.sign(), rest.top()), (Ordering::Greater, Some(-2148)));
        let sum = &Dyadic::of(f64::MAX) + &small;
        assert_eq!((&sum - &Dyadic::of(f64::MAX)).sign(), Ordering::Greater);
    }

    #[test]
    fn digits_are_counted_and_cut() {
        // by hand: 6.5 = 110.1 in binary
        for x in [6.5, -6.5].map(Dyadic::of) {
            assert_eq!(x.top(), Some(2));
            assert_eq!(
                [-3, -1, 0, 2, 3].map(|exponent| x.whole(exponent)),
                [52u8, 13, 6, 1, 0].map(UBig::from)
            );
        }
        assert_eq!((Dyadic::of(0.0).top(), Dyadic::of(5e-324).top()), (None, Some(-1074)));
    }
}

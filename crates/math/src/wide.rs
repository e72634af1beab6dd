//! Numbers that neither overflow nor vanish.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Real, TwoPart, Vector};

/// significand · 2^exponent: a number in two parts whose exponent is kept apart, so that the square
/// of 1e300 and the square of 1e−300 are ordinary numbers.
///
/// One operation errs by at most 2^−102 of its result (2^−102 of |a| + |b| for a sum). Slower than a
/// [`TwoPart`]: for the last steps of a method, not for its first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide {
    /// 1 ≤ |hi| < 2, or zero.
    significand: TwoPart,
    /// Zero for zero.
    exponent: i32,
}

/// Beyond this difference of exponents the smaller of two summands no longer matters.
const NEGLIGIBLE: i32 = 220;

impl Wide {
    /// The number zero.
    pub const ZERO: Wide = Wide { significand: TwoPart { hi: 0.0, lo: 0.0 }, exponent: 0 };

    /// value · 2^exponent. The value must be finite.
    pub fn new(value: TwoPart, exponent: i32) -> Wide {
        if value.hi == 0.0 {
            return Wide::ZERO;
        }
        let shift = exponent_of(value.hi);
        // In two steps: 2^1074, for the smallest subnormal, is not a f64.
        let scale = |x: f64| x * power_of_two(-shift / 2) * power_of_two(-shift - -shift / 2);
        let significand = TwoPart { hi: scale(value.hi), lo: scale(value.lo) };
        Wide { significand, exponent: exponent + shift }
    }

    /// The nearest `f64`, or one beside it where it is subnormal: infinite above the largest, zero below
    /// the smallest. Zero is never negative.
    pub fn to_f64(self) -> f64 {
        scaled(self.significand.hi + self.significand.lo, self.exponent) + 0.0
    }

    /// The number `x` itself. It must be finite.
    pub fn of<R: Real>(x: R) -> Wide {
        Wide::from(x.into())
    }

    /// The components of a vector, which must be finite. N is their number.
    pub fn vector<R: Real, const N: usize>(v: impl Vector<R>) -> [Wide; N] {
        std::array::from_fn(|axis| Wide::of(v.components()[axis]))
    }

    /// A root t in the precision R, to a rounding (two for `f32`, by way of `f64`), except that no
    /// negative one becomes zero: what lies behind the origin of a ray stays behind it.
    pub fn rounded<R: Real>(self) -> R {
        let nearest = R::round_from(self.to_f64());
        if self.is_negative() && nearest == R::from(0.0) { -R::SMALLEST } else { nearest }
    }

    /// Less than zero.
    pub fn is_negative(self) -> bool {
        self.significand.hi < 0.0
    }

    /// Equal to zero.
    pub fn is_zero(self) -> bool {
        self.significand.hi == 0.0
    }

    /// The square root; zero for zero, and for a negative number, which has none.
    pub fn sqrt(self) -> Wide {
        let odd = self.exponent.rem_euclid(2);
        let even = TwoPart::from(power_of_two(odd)) * self.significand;
        Wide::new(even.sqrt(), (self.exponent - odd) / 2)
    }
}

/// floor(log2 |x|) of a finite x; for zero, that of the smallest number, −1074.
pub fn exponent_of(x: f64) -> i32 {
    if x == 0.0 {
        return -1074;
    }
    let biased = ((x.to_bits() >> 52) & 0x7ff) as i32;
    if biased == 0 { exponent_of(x * power_of_two(64)) - 64 } else { biased - 1023 }
}

/// 2^exponent for −1022 ≤ exponent ≤ 1023, exactly.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

/// x · 2^exponent, infinite above the largest number: for any exponent where 1 ≤ |x| < 2 or x is zero, for
/// other numbers from −2022 to 2023. Exact, but for a result that is subnormal: that is rounded, once if |x|
/// is at least 2^−22.
pub fn scaled(x: f64, exponent: i32) -> f64 {
    match exponent {
        1023.. => x * power_of_two(1000) * power_of_two((exponent - 1000).min(1023)),
        -1022..1023 => x * power_of_two(exponent),
        // 2^−1000 first: the second step alone rounds.
        _ => x * power_of_two(-1000) * power_of_two((exponent + 1000).max(-1022)),
    }
}

impl From<f64> for Wide {
    fn from(x: f64) -> Wide {
        Wide::new(TwoPart::from(x), 0)
    }
}

impl From<TwoPart> for Wide {
    fn from(x: TwoPart) -> Wide {
        Wide::new(x, 0)
    }
}

impl Neg for Wide {
    type Output = Wide;
    fn neg(self) -> Wide {
        Wide { significand: -self.significand, ..self }
    }
}

impl Add for Wide {
    type Output = Wide;
    fn add(self, other: Wide) -> Wide {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other } else { self };
        }
        let (large, small) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let apart = large.exponent - small.exponent;
        if apart > NEGLIGIBLE {
            return large;
        }
        let aligned = TwoPart::from(power_of_two(-apart)) * small.significand;
        Wide::new(large.significand + aligned, large.exponent)
    }
}

impl Sub for Wide {
    type Output = Wide;
    fn sub(self, other: Wide) -> Wide {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Wide;
    fn mul(self, other: Wide) -> Wide {
        Wide::new(self.significand * other.significand, self.exponent + other.exponent)
    }
}

impl Div for Wide {
    type Output = Wide;
    /// The divisor must not be zero.
    fn div(self, other: Wide) -> Wide {
        Wide::new(self.significand / other.significand, self.exponent - other.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [f64; 9] =
        [1.0, -1.5, 1e300, -1e300, 1e-300, f64::MAX, f64::MIN_POSITIVE, 5e-324, 3.3e-310];

    #[test]
    fn a_number_comes_back_as_it_went_in() {
        for x in CORNERS {
            assert_eq!(Wide::from(x).to_f64(), x);
        }
    }

    #[test]
    fn a_square_of_anything_has_its_root() {
        for x in CORNERS {
            let wide = Wide::from(x);
            assert_eq!((wide * wide).sqrt().to_f64(), x.abs(), "√({x:e}²)");
        }
    }

    #[test]
    fn only_the_last_step_overflows_or_vanishes() {
        let (big, small) = (Wide::from(1e300), Wide::from(1e-300));
        assert_eq!((big * big).to_f64(), f64::INFINITY);
        assert_eq!((-(big * big)).to_f64(), f64::NEG_INFINITY);
        assert_eq!((small * small).to_f64(), 0.0);
        assert_eq!((big * big / big).to_f64(), 1e300);
        assert_eq!((small * small / small).to_f64(), 1e-300);
    }

    #[test]
    fn sums_align_their_exponents() {
        let sum = Wide::from(1e300) + Wide::from(1e-300) - Wide::from(1e300);
        assert_eq!(sum.to_f64(), 0.0, "1e−300 is 2000 digits below 1e300");
        let sum = Wide::from(1e16) + Wide::from(1e-3) - Wide::from(1e16);
        assert_eq!(sum.to_f64(), 1e-3);
    }
}

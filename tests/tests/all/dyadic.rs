//! Numbers that are not rounded, on another crate's long integers: nothing of `math::Exact` is used
//! to judge it.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::IBig;

/// mantissa · 2^exponent: every finite float, and every sum and product of such numbers.
#[derive(Clone, Debug)]
pub(crate) struct Dyadic {
    mantissa: IBig,
    exponent: i32,
}

impl Dyadic {
    /// The number `x` itself. It must be finite.
    pub(crate) fn of(x: f64) -> Dyadic {
        assert!(x.is_finite(), "{x} is no number");
        let bits = x.to_bits();
        let (biased, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
        let (magnitude, exponent) =
            if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased as i32 - 1075) };
        let magnitude = IBig::from(magnitude);
        Dyadic { mantissa: if x < 0.0 { -magnitude } else { magnitude }, exponent }
    }

    /// How it compares with zero.
    pub(crate) fn sign(&self) -> Ordering {
        self.mantissa.cmp(&IBig::ZERO)
    }

    /// Whether it is zero.
    pub(crate) fn is_zero(&self) -> bool {
        self.sign().is_eq()
    }

    /// Its own product.
    pub(crate) fn square(&self) -> Dyadic {
        self * self
    }

    /// The mantissa that goes with a smaller or equal exponent.
    fn mantissa_at(&self, exponent: i32) -> IBig {
        &self.mantissa << (self.exponent - exponent) as usize
    }
}

/// a · b
pub(crate) fn dot(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> Dyadic {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// a − b
pub(crate) fn difference(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> [Dyadic; 3] {
    std::array::from_fn(|axis| &a[axis] - &b[axis])
}

impl Add for &Dyadic {
    type Output = Dyadic;

    fn add(self, other: &Dyadic) -> Dyadic {
        let exponent = self.exponent.min(other.exponent);
        Dyadic { mantissa: self.mantissa_at(exponent) + other.mantissa_at(exponent), exponent }
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
        let exponent = self.exponent + other.exponent;
        Dyadic { mantissa: &self.mantissa * &other.mantissa, exponent }
    }
}

#[test]
fn differences_of_far_exponents_are_exact() {
    let [large, small] = [f64::MAX, f64::from_bits(1)].map(Dyadic::of);
    let sum = &large + &small;
    assert_eq!((&(&sum - &large) - &small).sign(), Ordering::Equal);
    assert_eq!((&(&sum - &large) - &Dyadic::of(0.0)).sign(), Ordering::Greater);
    // by hand: (2 + 2^−1074)² − 4 − 2^−1072 = 2^−2148
    let two = Dyadic::of(2.0);
    let rest = &(&(&two + &small).square() - &two.square()) - &(&Dyadic::of(4.0) * &small);
    assert_eq!((&rest - &small.square()).sign(), Ordering::Equal);
}

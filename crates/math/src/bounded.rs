//! A number and a bound on its error: what [`Sure`] tries before anything is exact.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::two_part::{two_product, two_sum};
use crate::{Quadratic, Real, Sure, TwoPart};

/// A number that is off by `error` at most: T is `f64`, or [`TwoPart`] with twice the digits.
///
/// Every sum and product adds its own rounding error to those of its parts. The bound itself is computed in
/// floating point; `SLACK` makes up for its roundings in formulas of up to a million operations. What overflows
/// has an infinite error or a NaN, and no sign; what is so small that digits vanish has `VANISHED` in its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded<T> {
    /// The number.
    pub value: T,
    /// By how much the number may be off: not below zero; infinite or NaN where nothing is known of it.
    pub error: f64,
}

/// 2^−52, twice the rounding error of one operation of `f64`: the other half is for what is rounded on the way to it.
const ROUNDING: f64 = f64::EPSILON;
/// 2^−101: one operation of [`TwoPart`] errs by 2^−102 at most.
const ROUNDING_OF_TWO_PARTS: f64 = f64::EPSILON * f64::EPSILON * 8.0;
/// A product below this may have lost digits below the smallest number, where no bound relative to the product holds.
const SMALLEST_SAFE: f64 = 1e-290;
/// What such a product is off by at most: rounding errors of products below 1e−290 are subnormal.
const VANISHED: f64 = 1e-300;
/// The errors add up in floating point, each step rounded by 2^−53.
const SLACK: f64 = 1.0 + 1.0 / (1u64 << 30) as f64;

impl<T> Bounded<T> {
    /// A number without an error.
    #[inline(always)]
    pub fn exactly(value: T) -> Bounded<T> {
        Bounded { value, error: 0.0 }
    }

    /// Zero and nothing else, where `hi` is all but the last digits of the value. (A product of two errors may vanish,
    /// so that it is no sign of it.)
    #[inline(always)]
    fn is_zero(&self, hi: f64) -> bool {
        hi == 0.0 && self.error == 0.0
    }

    /// How `hi`, all but the last digits of the value, compares with zero.
    #[inline(always)]
    fn sign_of(hi: f64, error: f64) -> Option<Ordering> {
        let error = error * SLACK;
        match () {
            _ if hi > error => Some(Ordering::Greater),
            _ if hi < -error => Some(Ordering::Less),
            _ if hi == 0.0 && error == 0.0 => Some(Ordering::Equal),
            _ => None,
        }
    }

    /// t rounded to R, where what it is off by is less than a quarter of R's last digit before it is rounded.
    #[inline(always)]
    fn rounded<R: Real>(t: f64, error: f64) -> Option<R> {
        // A unit of the last digit of t is at least 2^(1 − DIGITS) · |t| / 2.
        let quarter =
            if R::DIGITS == f64::MANTISSA_DIGITS { ROUNDING / 8.0 } else { f64::from(f32::EPSILON) / 8.0 };
        // What is subnormal has fewer digits; what is exactly zero is certain.
        let is_sure = error * SLACK <= quarter * t.abs() && (SMALLEST_SAFE..f64::INFINITY).contains(&t.abs());
        (is_sure || t == 0.0 && error == 0.0).then(|| R::root_from(t + 0.0)) // minus zero is zero
    }
}

/// What a product of these sizes may have lost beyond its relative error.
#[inline(always)]
fn vanished(product: f64, is_zero: bool) -> f64 {
    if product.abs() > SMALLEST_SAFE || is_zero { 0.0 } else { VANISHED }
}

impl Add for Bounded<f64> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        Bounded { value, error: self.error + other.error + ROUNDING * value.abs() }
    }
}

impl Mul for Bounded<f64> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let error = self.value.abs() * other.error + (other.value.abs() + other.error) * self.error;
        let is_zero = self.is_zero(self.value) || other.is_zero(other.value);
        Bounded { value, error: error + ROUNDING * value.abs() + vanished(value, is_zero) }
    }
}

impl Neg for Bounded<f64> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Bounded { value: -self.value, ..self }
    }
}

impl Div for Bounded<f64> {
    type Output = Self;
    /// An infinite error where the divisor may be zero.
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let error = quotient_error(value, self.error, other.value, other.error);
        let lost = vanished(value, self.is_zero(self.value));
        Bounded { value, error: error + ROUNDING * value.abs() + lost }
    }
}

/// What n / d is off by, apart from its rounding, if n is off by `n_error` and d by `d_error`.
#[inline(always)]
fn quotient_error(quotient: f64, n_error: f64, d: f64, d_error: f64) -> f64 {
    let smallest = d.abs() - d_error * SLACK;
    if smallest > 0.0 { (n_error + quotient.abs() * d_error) / smallest } else { f64::INFINITY }
}

/// What √x is off by, apart from its rounding, if x ≥ 0 is off by `error`: √x by √error at the most, however
/// small x is.
#[inline(always)]
fn root_error(root: f64, error: f64) -> f64 {
    if root * root > error { error / root } else { (2.0 * error).sqrt() }
}

impl Sure for Bounded<f64> {
    #[inline(always)]
    fn of(x: f64) -> Self {
        Bounded::exactly(x)
    }

    #[inline(always)]
    fn difference(a: f64, b: f64) -> Self {
        // Rounded, it has no error where it is a float; that is worth knowing when b is 0.
        let value = a - b;
        Bounded { value, error: if b == 0.0 { 0.0 } else { ROUNDING * value.abs() } }
    }

    #[inline(always)]
    fn product(a: f64, b: f64) -> Self {
        Bounded::exactly(a) * Bounded::exactly(b)
    }

    #[inline(always)]
    fn sign(&self) -> Option<Ordering> {
        Self::sign_of(self.value, self.error)
    }

    fn about(&self) -> f64 {
        self.value
    }

    #[inline(always)]
    fn quotient<R: Real>(n: &Self, d: &Self) -> Option<R> {
        let t = *n / *d;
        Self::rounded(t.value, t.error)
    }

    #[inline(always)]
    fn root<R: Real>(quadratic: &Quadratic<Self>, s: f64) -> Option<R> {
        let Quadratic { a, b, c, d } = *quadratic;
        let root = d.sqrt();
        let s_root = Bounded { value: s * root.value, ..root };
        let adds = b.value * s >= 0.0;
        let t = if adds { (b + s_root) / a } else { c / (b - s_root) };
        Self::rounded(t.value, t.error)
    }
}

impl Bounded<f64> {
    /// √x, of a number that is not below zero or is so by its error alone.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let root = self.value.max(0.0).sqrt();
        Bounded { value: root, error: root_error(root, self.error) + ROUNDING * root }
    }

    /// t + x to the precision of R, for a small correction x of a t as it is: off by less than a unit of its last digit,
    /// like [`Sure::quotient`]. `None` where the error of x is too large for that.
    #[inline(always)]
    pub fn added_to<R: Real>(self, t: f64) -> Option<R> {
        Self::rounded(t + self.value, self.error)
    }
}

impl Add for Bounded<TwoPart> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        let size = self.value.hi.abs() + other.value.hi.abs();
        Bounded { value, error: self.error + other.error + ROUNDING_OF_TWO_PARTS * size }
    }
}

impl Mul for Bounded<TwoPart> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let error = self.value.hi.abs() * other.error + (other.value.hi.abs() + other.error) * self.error;
        let is_zero = self.is_zero(self.value.hi) || other.is_zero(other.value.hi);
        let rounding = ROUNDING_OF_TWO_PARTS * value.hi.abs();
        // The lower part vanishes long before the upper one.
        let lost = vanished(value.hi * LOWER_PART, is_zero);
        Bounded { value, error: error * (1.0 + ROUNDING) + rounding + lost }
    }
}

/// The lower part of a product reaches 2^−106 of it, and with a digit to spare, 2^−110.
const LOWER_PART: f64 = 1.0 / (1u128 << 110) as f64;

impl Neg for Bounded<TwoPart> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Bounded { value: -self.value, ..self }
    }
}

impl Div for Bounded<TwoPart> {
    type Output = Self;
    /// An infinite error where the divisor may be zero.
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let error = quotient_error(value.hi, self.error, other.value.hi, other.error);
        let lost = vanished(self.value.hi * LOWER_PART, self.error == 0.0 && self.value.hi == 0.0);
        let rounding = ROUNDING_OF_TWO_PARTS * value.hi.abs() + lost / other.value.hi.abs();
        // The quotient itself may be too small for a number.
        let rounding = rounding + vanished(value.hi * LOWER_PART, self.is_zero(self.value.hi));
        Bounded { value, error: error * (1.0 + ROUNDING) + rounding }
    }
}

impl Sure for Bounded<TwoPart> {
    #[inline(always)]
    fn of(x: f64) -> Self {
        Bounded::exactly(TwoPart::from(x))
    }

    /// Without an error: two parts hold the difference of any two numbers.
    #[inline(always)]
    fn difference(a: f64, b: f64) -> Self {
        Bounded::exactly(two_sum(a, -b))
    }

    /// Without an error, but for what vanishes: two parts hold the product of any two numbers.
    #[inline(always)]
    fn product(a: f64, b: f64) -> Self {
        let value = two_product(a, b);
        Bounded { value, error: vanished(value.hi * LOWER_PART, a == 0.0 || b == 0.0) }
    }

    #[inline(always)]
    fn sign(&self) -> Option<Ordering> {
        Self::sign_of(self.value.hi, self.error)
    }

    fn about(&self) -> f64 {
        self.value.hi
    }

    #[inline(always)]
    fn quotient<R: Real>(n: &Self, d: &Self) -> Option<R> {
        let t = *n / *d;
        Self::rounded(t.value.hi, t.error)
    }

    #[inline(always)]
    fn root<R: Real>(quadratic: &Quadratic<Self>, s: f64) -> Option<R> {
        let Quadratic { a, b, c, d } = *quadratic;
        let root = d.value.sqrt();
        let lost = vanished(d.value.hi * LOWER_PART, d.error == 0.0 && d.value.hi == 0.0);
        let error = root_error(root.hi, d.error + lost) + ROUNDING_OF_TWO_PARTS * root.hi;
        let s_root = Bounded { value: if s < 0.0 { -root } else { root }, error };
        let adds = b.value.hi * s >= 0.0;
        let t = if adds { (b + s_root) / a } else { c / (b - s_root) };
        Self::rounded(t.value.hi, t.error)
    }
}

macro_rules! subtract {
    ($kind:ty) => {
        impl Sub for $kind {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                self + -other
            }
        }
    };
}
subtract!(Bounded<f64>);
subtract!(Bounded<TwoPart>);

#[cfg(test)]
mod tests;

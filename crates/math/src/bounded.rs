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
    /// Not below zero.
    pub error: f64,
}

/// 2^−52, twice the rounding error of one operation of `f64`: the other half is for what is rounded on the way to it.
const ROUNDING: f64 = f64::EPSILON;
/// 2^−101: one operation of [`TwoPart`] errs by 2^−102 at most.
const ROUNDING_OF_TWO_PARTS: f64 = f64::EPSILON * f64::EPSILON * 8.0;
/// A product below this may have lost digits below the smallest number, where no relative bound holds,
const SMALLEST_SAFE: f64 = 1e-290;
/// but none above this: rounding errors of products below 1e−290 are subnormal.
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
mod tests {
    use super::*;
    use crate::Exact;

    /// Numbers of many sizes, whole ones and some with few digits, the same on every run.
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let (bits, kind) = (self.0 >> 11, self.0 >> 60);
            let unit = bits as f64 / (1u64 << 52) as f64 - 1.0;
            match kind {
                0..6 => unit,
                6..10 => (unit * 4.0).round(),
                10..12 => unit * 2.0_f64.powi(bits as i32 % 40),
                12..14 => 1.0 + (unit * 8.0).round() * f64::EPSILON,
                14 => unit * 2.0_f64.powi(bits as i32 % 500),
                _ => unit * 2.0_f64.powi(bits as i32 % 1000 - 20),
            }
        }
    }

    /// A formula with differences, products and sums, among them some that cancel.
    fn formula<N: Sure>(x: [f64; 9]) -> [N; 3] {
        let [a, b]: [[N; 3]; 2] =
            [0, 3].map(|at| std::array::from_fn(|axis| N::difference(x[at + axis], x[6 + axis])));
        let cross = N::cross(&a, &b);
        let [dot, size] = [N::dot(&a, &b), N::dot(&cross, &cross)];
        // Lagrange: ‖a × b‖² + (a · b)² = ‖a‖² ‖b‖², so the last is 0
        let rest = size.clone() + dot.clone() * dot.clone() - N::dot(&a, &a) * N::dot(&b, &b);
        [N::product(x[0], x[1]) - dot, size, rest]
    }

    /// |value − exact| ≤ error, exactly.
    fn assert_bounds(parts: [f64; 2], error: f64, exact: &Exact) {
        if !parts.iter().chain([&error]).all(|x| x.is_finite()) {
            return;
        }
        let off = Exact::new(parts[0]) + Exact::new(parts[1]) - exact.clone();
        let off = if off.is_negative() { -off } else { off };
        let within = !(Exact::new(error * SLACK) - off.clone()).is_negative();
        assert!(within, "{parts:?} is off by {:e}, not by {error:e}", off.about());
    }

    #[test]
    fn no_error_is_beyond_its_bound_and_no_sign_is_wrong() {
        let (mut numbers, mut told) = (Numbers(1), [0, 0]);
        for _ in 0..20_000 {
            let x: [f64; 9] = std::array::from_fn(|_| numbers.next());
            let exact = formula::<Exact>(x);
            let (once, twice) = (formula::<Bounded<f64>>(x), formula::<Bounded<TwoPart>>(x));
            for ((exact, once), twice) in exact.iter().zip(once).zip(twice) {
                assert_bounds([once.value, 0.0], once.error, exact);
                assert_bounds([twice.value.hi, twice.value.lo], twice.error, exact);
                for (count, sign) in told.iter_mut().zip([once.sign(), twice.sign()]) {
                    assert!(sign.is_none() || sign == exact.sign(), "{x:?}");
                    *count += usize::from(sign.is_some());
                }
            }
        }
        // A bound that never tells would be no use. The third number is 0, which only whole numbers show.
        assert!(told[0] > 25_000 && told[1] > 35_000, "{told:?} of 60000");
    }

    /// The roots through (u, v): A = u² + 1, and D = B² − A C is taken the plain way.
    fn roots<N: Sure, R: Real>(u: f64, v: f64, w: f64) -> [Option<R>; 2] {
        let a = N::product(u, u) + N::of(1.0);
        let (b, c) = (N::product(u, v), N::product(v, v) - N::product(w, w));
        let d = b.clone() * b.clone() - a.clone() * c.clone();
        if d.sign().is_none_or(Ordering::is_lt) {
            return [None; 2];
        }
        let quadratic = Quadratic { a, b, c, d };
        [N::root(&quadratic, -1.0), N::root(&quadratic, 1.0)]
    }

    #[test]
    fn roots_and_quotients_are_those_of_exact_numbers_to_the_last_digit() {
        let (mut numbers, mut found) = (Numbers(2), [0; 3]);
        for _ in 0..20_000 {
            let [u, v, w] = std::array::from_fn(|_| numbers.next());
            let exact: [Option<f64>; 2] = roots::<Exact, f64>(u, v, w);
            let twice: [Option<f64>; 2] = roots::<Bounded<TwoPart>, f64>(u, v, w);
            let halves: [Option<f32>; 2] = roots::<Bounded<f64>, f32>(u, v, w);
            let exact_halves: [Option<f32>; 2] = roots::<Exact, f32>(u, v, w);
            for i in 0..2 {
                if let Some(t) = twice[i] {
                    let want = exact[i].unwrap();
                    assert!((t - want).abs() <= (want.next_up() - want).abs(), "{t:e}, not {want:e}");
                    found[0] += 1;
                }
                if let Some(t) = halves[i] {
                    let want = exact_halves[i].unwrap();
                    assert!(t == want || (want.next_down()..=want.next_up()).contains(&t), "{t:e}, {want:e}");
                    found[1] += 1;
                }
            }
            let [n, d] = [v, w].map(<Bounded<TwoPart>>::of);
            if let Some(t) = Sure::quotient::<f64>(&n, &d) {
                assert_eq!(t, v / w, "a division is rounded correctly");
                found[2] += 1;
            }
        }
        assert!(found.iter().all(|&count| count > 15_000), "{found:?}");
    }

    #[test]
    fn one_rounding_of_f64_is_too_many_for_f64_and_none_for_f32() {
        let [n, d] = [1.0, 3.0].map(<Bounded<f64>>::of);
        assert_eq!(Sure::quotient::<f64>(&n, &d), None);
        assert_eq!(Sure::quotient::<f32>(&n, &d), Some(1.0 / 3.0));
        let off = Bounded { value: TwoPart::from(1.0), error: f64::EPSILON };
        assert_eq!(
            Sure::quotient::<f64>(&off, &<Bounded<TwoPart>>::of(1.0)),
            None,
            "a digit off is too much"
        );
    }

    /// 1/3 + 1/3 · 2^−60, which no f64 holds: the correction counts where it is larger than half of the last digit.
    #[test]
    fn a_correction_is_rounded_once() {
        let third = 1.0 / 3.0;
        let correction = |value: f64, error: f64| Bounded { value, error }.added_to::<f64>(third);
        assert_eq!(correction(third * 2.0_f64.powi(-60), 1e-30), Some(third));
        assert_eq!(correction(third * 2.0_f64.powi(-52), 1e-30), Some(third.next_up()));
        assert_eq!(correction(third * 2.0_f64.powi(-60), 1e-16), None, "an error as large as the last digit");
        let root = Bounded { value: 2.0, error: 1e-9 }.sqrt();
        assert!(root.value == 2.0_f64.sqrt() && root.error >= 1e-9 / 8.0_f64.sqrt());
        let none_left = Bounded { value: -1e-20, error: 1e-18 }.sqrt();
        assert!(none_left.value == 0.0 && none_left.error >= 1e-9, "√ of what it may be");
    }

    #[test]
    fn zero_is_certain_where_nothing_was_rounded() {
        let zero = <Bounded<f64> as Sure>::product(0.0, 1e-300);
        assert_eq!(zero.sign(), Some(Ordering::Equal));
        let vanished = <Bounded<f64> as Sure>::product(1e-200, 1e-200);
        assert_eq!((vanished.value, vanished.sign()), (0.0, None));
        // nor is it zero times a number so small that the error vanishes as well
        let again = vanished * <Bounded<f64> as Sure>::of(1e-200);
        assert_eq!((again.value, again.sign()), (0.0, None));
        let vanished = <Bounded<TwoPart> as Sure>::product(1e-200, 1e-200);
        assert_eq!((vanished * <Bounded<TwoPart> as Sure>::of(1e-200)).sign(), None);
        // nor is a quotient zero that is only too small
        let [n, d] = [1e-200, -1e200].map(<Bounded<f64>>::of);
        assert_eq!((Sure::quotient::<f64>(&n, &d), Sure::quotient::<f32>(&n, &d)), (None, None));
        let [n, d] = [1e-200, -1e200].map(<Bounded<TwoPart>>::of);
        assert_eq!(Sure::quotient::<f64>(&n, &d), None);
        let zero = <Bounded<TwoPart>>::of(0.0);
        assert_eq!(Sure::quotient::<f64>(&zero, &d), Some(0.0), "a zero is");
        let overflown = <Bounded<TwoPart> as Sure>::product(1e200, -1e200);
        let small = overflown * Bounded::exactly(TwoPart::from(1e-200));
        assert_eq!((small + Bounded::exactly(TwoPart::from(1e250))).sign(), None, "1e250 − 1e200");
    }
}

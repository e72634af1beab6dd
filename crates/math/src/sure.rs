//! Numbers whose sign is never wrong, so that a formula is written once and worked out as carefully as its
//! numbers need.
//!
//! A verdict is a sign: of a discriminant, of a volume, of a distance. Computed in floating point it may be the
//! wrong one, so each number here carries a bound on its own error through every sum and product
//! (a running error bound: Wilkinson 1963; Higham, *Accuracy and Stability*, 3.3), and a sign that the error
//! could turn over is not told. A formula generic over [`Sure`] is tried in plain `f64` first
//! ([`Bounded<f64>`]), then with twice the digits ([`Bounded<TwoPart>`]), and last in integers as long as it takes
//! ([`Exact`]), which is never in doubt:
//!
//! ```
//! use math::{Bounded, Exact, Sure, TwoPart};
//! use std::cmp::Ordering;
//!
//! /// On which side of the line through a and b is c? The sign of twice the area of the triangle.
//! fn side<N: Sure>(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<Ordering> {
//!     let [ux, uy] = [N::difference(b[0], a[0]), N::difference(b[1], a[1])];
//!     let [vx, vy] = [N::difference(c[0], a[0]), N::difference(c[1], a[1])];
//!     (ux * vy - uy * vx).sign()
//! }
//!
//! let (a, b, c) = ([0.0, 0.0], [1.0, 1.0], [0.5, 0.5]);
//! assert_eq!(side::<Bounded<f64>>(a, b, [0.5, 0.6]), Some(Ordering::Greater));
//! assert_eq!(side::<Bounded<f64>>([0.1, 0.1], [0.2, 0.2], [0.7, 0.7]), None, "in doubt");
//! assert_eq!(side::<Exact>(a, b, c), Some(Ordering::Equal), "on the line");
//! ```

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use crate::{Exact, Real, Wide};

/// A number with a sign that is never wrong. It comes from finite numbers: what is infinite or NaN is to be
/// refused before.
pub trait Sure:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// The number `x` itself. It must be finite.
    fn of(x: f64) -> Self;

    /// a − b of two numbers as given, with all the digits that this kind of number has for it.
    fn difference(a: f64, b: f64) -> Self;

    /// a · b of two numbers as given, with all the digits that this kind of number has for it.
    fn product(a: f64, b: f64) -> Self;

    /// How the number compares with zero; `None` where its error leaves that open.
    fn sign(&self) -> Option<Ordering>;

    /// The number to the digits that it has, for a reader.
    fn about(&self) -> f64;

    /// n / d to the precision of R, off by less than a unit of its last digit; no negative quotient becomes
    /// zero, and one beyond the largest number is infinite. `None` where the error is larger, or d may be 0.
    fn quotient<R: Real>(n: &Self, d: &Self) -> Option<R>;

    /// A root of A t² − 2 B t + C = 0 to the precision of R, as [`Sure::quotient`] is: the one at
    /// (B + s √D) / A, with s = 1 or −1 and D = B² − A C, which must not be negative. Where B and s √D
    /// cancel it is taken as C / (B − s √D), which has no subtraction. A must not be zero.
    ///
    /// D is handed over because there may be a better way to it than B² − A C, which cancels.
    fn root<R: Real>(quadratic: &Quadratic<Self>, s: f64) -> Option<R>;

    /// a · b for vectors.
    #[inline(always)]
    fn dot(a: &[Self; 3], b: &[Self; 3]) -> Self {
        let [[a1, a2, a3], [b1, b2, b3]] = [a, b].map(Clone::clone);
        a1 * b1 + a2 * b2 + a3 * b3
    }

    /// a × b
    #[inline(always)]
    fn cross(a: &[Self; 3], b: &[Self; 3]) -> [Self; 3] {
        let minor = |i: usize, j: usize| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone();
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }
}

/// A t² − 2 B t + C = 0 with its discriminant.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadratic<N> {
    /// A
    pub a: N,
    /// B
    pub b: N,
    /// C
    pub c: N,
    /// D = B² − A C
    pub d: N,
}

/// With what kind of number an answer was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// In plain `f64`: by more than its rounding could make up for.
    AtOnce,
    /// With twice the digits.
    TwoPart,
    /// In integers as long as it takes.
    Exact,
}

impl Certainty {
    /// What it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Certainty::AtOnce => "certain at once",
            Certainty::TwoPart => "certain with twice the digits",
            Certainty::Exact => "too close to call: worked out exactly",
        }
    }
}

impl Sure for Exact {
    fn of(x: f64) -> Exact {
        Exact::new(x)
    }

    fn difference(a: f64, b: f64) -> Exact {
        Exact::new(a) - Exact::new(b)
    }

    fn product(a: f64, b: f64) -> Exact {
        Exact::new(a) * Exact::new(b)
    }

    fn sign(&self) -> Option<Ordering> {
        Some(match () {
            _ if self.is_zero() => Ordering::Equal,
            _ if self.is_negative() => Ordering::Less,
            _ => Ordering::Greater,
        })
    }

    fn about(&self) -> f64 {
        self.to_wide().to_f64()
    }

    fn quotient<R: Real>(n: &Exact, d: &Exact) -> Option<R> {
        (!d.is_zero()).then(|| (n.to_wide() / d.to_wide()).rounded())
    }

    fn root<R: Real>(quadratic: &Quadratic<Exact>, s: f64) -> Option<R> {
        // Only now is anything rounded, to twice the digits of f64.
        let Quadratic { a, b, c, d } = quadratic;
        let [a, b, c, d] = [a, b, c, d].map(Exact::to_wide);
        let s_root = if s < 0.0 { -d.sqrt() } else { d.sqrt() };
        if a.is_zero() || d.is_negative() {
            return None;
        }
        let adds = b.is_zero() || s_root.is_zero() || b.is_negative() == s_root.is_negative();
        let t: Wide = if adds { (b + s_root) / a } else { c / (b - s_root) };
        Some(t.rounded())
    }
}

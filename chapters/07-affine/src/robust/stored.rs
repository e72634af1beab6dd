//! What depends on the object alone: adj A and det A, with the sign of det A taken out.

use math::{Bounded, Exact, Real, TwoPart, Vector};

use crate::Affine;
use crate::exact_sign::adjugate_and_determinant;

/// adj A sgn det A and |det A| in one kind of number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scaled<N> {
    /// By rows.
    pub(crate) adjugate: [[N; 3]; 3],
    /// |det A|
    pub(crate) s: N,
}

/// The same in the two kinds of number that are kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stored {
    /// det A < 0.
    pub(crate) mirrors: bool,
    /// With twice the digits.
    pub(crate) fine: Scaled<Bounded<TwoPart>>,
    /// The leading digits of that: no rounding of a difference is left in them.
    pub(crate) near: Scaled<Bounded<f64>>,
}

impl Stored {
    /// adj A and det A, turned where det A < 0.
    pub(crate) fn new(adjugate: [[Bounded<TwoPart>; 3]; 3], s: Bounded<TwoPart>, mirrors: bool) -> Stored {
        let near = Scaled { adjugate: adjugate.map(|row| row.map(leading)), s: leading(s) };
        Stored { mirrors, fine: Scaled { adjugate, s }, near }
    }
}

/// The first part, with the second in its error.
#[inline(always)]
pub(super) fn leading(x: Bounded<TwoPart>) -> Bounded<f64> {
    Bounded { value: x.value.hi, error: x.value.lo.abs() + x.error }
}

/// The same in integers as long as it takes. The matrix must not be singular.
pub(super) fn exactly<R: Real>(affine: &Affine<R>) -> Scaled<Exact> {
    let (adjugate, determinant) =
        adjugate_and_determinant::<Exact>(affine.a.columns.map(Vector::in_f64::<3>));
    if determinant.is_negative() {
        return Scaled { adjugate: adjugate.map(|row| row.map(|x| -x)), s: -determinant };
    }
    Scaled { adjugate, s: determinant }
}

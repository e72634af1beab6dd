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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Matrix3, Object};
    use glam::DVec3;

    /// The leading digits of adj A and det A are off by what they say, and by no more than a rounding; mirrored or not.
    #[test]
    fn what_is_kept_has_no_error_beyond_its_bound() {
        for sign in [1.0, -1.0] {
            let rows = [[0.1 * sign, 0.2, 0.3], [0.7 * sign, 0.1, 0.9], [0.3 * sign, 0.2, 1.1]];
            let affine = Affine { a: Matrix3::<f64>::from_rows(rows), t: DVec3::ZERO };
            let near = crate::Deformed::new(Object::Sphere, affine).unwrap().stored.near;
            let exact = exactly(&affine);
            let pairs = near.adjugate.iter().flatten().zip(exact.adjugate.iter().flatten());
            for (near, exact) in pairs.chain([(&near.s, &exact.s)]) {
                let off = (Exact::new(near.value) - exact.clone()).to_wide().to_f64().abs();
                assert!(off <= near.error && near.error <= f64::EPSILON * near.value.abs(), "{near:?}");
            }
            assert!(near.s.value > 0.0);
        }
    }
}

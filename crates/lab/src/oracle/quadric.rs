//! Quadrics: the unit cylinder and the unit cone.

use math::Degenerate;
use stage::Precision;

use super::unit::ScaledRay;
use super::vector::{is_zero, vectors};
use super::{Dyadic, UnitObject, Verdict};
use crate::Truth;

/// What is true of a ray and a unit object, from the columns `ox,oy,oz,dx,dy,dz`.
///
/// t is the smallest t ≥ 0 at which the ray is on the boundary of the solid: 0 if it starts there, also where
/// it then runs inside a cap or along the wall; else where it enters, and where it leaves if it starts inside.
/// Touching counts: a tangent, the rim, the apex. There is no t_out. For the plane and the triangle, a ray with
/// dz = 0 is a miss, `in-plane` or `parallel`. Invalid, whichever comes first: a number that is not finite, a
/// zero direction.
pub fn quadric(shape: UnitObject, case: [f64; 6], precision: Precision) -> Truth {
    exact_quadric(shape, case).written(precision)
}

/// The same before anything is rounded.
pub fn exact_quadric(shape: UnitObject, case: [f64; 6]) -> Verdict {
    if !case.iter().all(|x| x.is_finite()) {
        return Verdict::Invalid(Degenerate::NotFinite.reason());
    }
    let [origin, direction] = vectors(&case);
    if is_zero(&direction) {
        return Verdict::Invalid(Degenerate::ZeroDirection.reason());
    }
    shape.verdict(&ScaledRay { origin, direction, scale: Dyadic::of(1.0) })
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use super::*;
    use crate::oracle::seen::{Solid, seen_from};
    use crate::oracle::testing::{assert_rounded, for_drawn};

    #[test]
    fn the_first_reason_counts() {
        for shape in UnitObject::ALL {
            let reason = |x, d| quadric(shape, [x, 0.0, 0.0, d, -0.0, 0.0], Precision::F64);
            assert_eq!(reason(f64::NAN, 0.0), Truth::Invalid("not-finite"));
            assert_eq!(reason(0.0, f64::INFINITY), Truth::Invalid("not-finite"));
            assert_eq!(reason(0.0, 0.0), Truth::Invalid("zero-direction"));
        }
    }

    #[test]
    fn put_back_into_the_ray_every_root_is_on_the_boundary() {
        for shape in [UnitObject::Sphere, UnitObject::Cylinder, UnitObject::Cone] {
            let (mut entered, mut left, mut missed) = (0, 0, 0);
            for_drawn(shape.name(), |mut case: [f64; 6], precision| {
                // Half of them aim at the solid.
                if case[0] < 0.0 {
                    (3..6).for_each(|i| case[i] = case[i] / 8.0 - case[i - 3]);
                }
                let ray = vectors(&case);
                let seen = |t: &Dyadic| seen_from(t, shape, &ray);
                let is_here = |t: &Dyadic| matches!(seen(t), Solid::Here { .. });
                // How a number compares with an end of the solid. `beside` is too little to step over
                // anything but that end.
                let place = |t: &Dyadic, beside: Dyadic| match seen(t) {
                    Solid::Ahead => Ordering::Less,
                    Solid::Behind => Ordering::Greater,
                    Solid::Here { strictly: false } if !is_here(&(t + &beside)) => Ordering::Equal,
                    Solid::Here { .. } => beside.sign().reverse(),
                    Solid::Nowhere => panic!("nowhere: {case:?}"),
                };
                let zero = Dyadic::of(0.0);
                match (quadric(shape, case, precision), seen(&zero)) {
                    (Truth::Invalid(_), _) => {}
                    (Truth::Hit { t, out: None }, Solid::Ahead) => {
                        entered += 1;
                        assert_rounded(&t, precision, |t| place(t, Dyadic::scaled(-1, -20_000)));
                    }
                    (Truth::Hit { t, out: None }, Solid::Here { strictly: true }) => {
                        left += 1;
                        assert_rounded(&t, precision, |t| place(t, Dyadic::scaled(1, -20_000)));
                    }
                    (Truth::Hit { t, out: None }, Solid::Here { strictly: false }) => {
                        assert!(t.nearest.to_bits() == 0 && t.fine.is_zero(), "{case:?}");
                    }
                    (Truth::Miss(""), Solid::Behind | Solid::Nowhere) => missed += 1,
                    (Truth::Miss(""), Solid::Ahead) => {
                        missed += 1;
                        assert_not_found(seen, &case);
                    }
                    (truth, seen) => panic!("{truth:?}, but {seen:?}: {case:?}"),
                }
            });
            assert!(entered > 1000 && left > 1000 && missed > 1000, "{entered} {left} {missed}");
        }
    }

    /// Looks for the solid between zero and the largest number, to the last bit.
    fn assert_not_found(seen: impl Fn(&Dyadic) -> Solid, case: &[f64; 6]) {
        let (mut low, mut high) = (0, f64::INFINITY.to_bits());
        while high - low > 1 {
            let middle = u64::midpoint(low, high);
            match seen(&Dyadic::of(f64::from_bits(middle))) {
                Solid::Ahead => low = middle,
                Solid::Behind => high = middle,
                Solid::Nowhere => return,
                Solid::Here { .. } => panic!("there it is: {case:?}"),
            }
        }
    }
}

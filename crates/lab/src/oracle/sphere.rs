//! The sphere: ‖p_r + t d − c‖² = r² is A t² − 2 B t + C = 0.

use math::Degenerate;
use stage::Precision;

use super::quadratic::Quadratic;
use super::vector::{difference, dot, is_zero, vectors};
use super::{Dyadic, ExactRoot, Verdict};
use crate::Truth;

/// What is true of a ray and a sphere, from the columns `ox,oy,oz,dx,dy,dz,cx,cy,cz,r`.
///
/// t_out is the larger root, also for a ray that starts inside. A tangent hits, at two equal roots. Invalid,
/// whichever comes first: a number that is not finite, a zero direction, r ≤ 0.
pub fn sphere(case: [f64; 10], precision: Precision) -> Truth {
    exact_sphere(case).written(precision)
}

/// The same before anything is rounded.
pub fn exact_sphere(case: [f64; 10]) -> Verdict {
    if !case.iter().all(|x| x.is_finite()) {
        return Verdict::Invalid(Degenerate::NotFinite.reason());
    }
    let ([p_r, d, center], r) = (vectors(&case), case[9]);
    if is_zero(&d) {
        return Verdict::Invalid(Degenerate::ZeroDirection.reason());
    }
    if r <= 0.0 {
        return Verdict::Invalid(Degenerate::RadiusNotPositive.reason());
    }
    // A = d · d, B = L · d, C = L · L − r², with L = c − p_r.
    let l = difference(&center, &p_r);
    let (a, b) = (dot(&d, &d), dot(&l, &d));
    let c = &dot(&l, &l) - &Dyadic::of(r).square();
    match Quadratic::new(a, b, c) {
        Some(equation) => Verdict::through(ExactRoot::roots(equation)),
        None => Verdict::Miss(""),
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use super::*;
    use crate::oracle::testing::{assert_rounded, floats, for_drawn};
    use crate::oracle::vector::cross;

    /// A ray up the z axis, at (x, 0, 0), and a sphere around (0, 0, z).
    fn truth(x: f64, z: f64, r: f64) -> Truth {
        sphere([x, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, z, r], Precision::F64)
    }

    #[test]
    fn closed_forms() {
        // by hand: t = z ± √(r² − x²)
        let t = |x, z, r| floats(&truth(x, z, r));
        assert_eq!(t(3.0, 13.0, 5.0), [9.0, 17.0]);
        assert_eq!(t(3.0, 0.0, 5.0), [4.0, 4.0], "from inside");
        assert_eq!(t(3.0, 4.0, 5.0), [0.0, 8.0], "on it, going in");
        assert_eq!(t(3.0, -4.0, 5.0), [0.0, 0.0], "on it, going out");
        assert_eq!(t(3.0, -5.0, 5.0), [0.0; 0], "behind");
        assert_eq!(t(5.0, 13.0, 5.0), [13.0, 13.0], "a tangent");
        assert_eq!(t(5.0, 0.0, 5.0), [0.0, 0.0], "a tangent at the origin");
        assert_eq!(t(5.0_f64.next_up(), 13.0, 5.0), [0.0; 0], "a digit beside it");
    }

    #[test]
    fn nothing_cancels_and_nothing_overflows() {
        // by hand: t = z ± r, of which one is a tie or many digits smaller
        let t = |z, r| floats(&truth(0.0, z, r));
        let tiny = f64::EPSILON / 2.0;
        assert_eq!(t(1.0, tiny), [1.0 - tiny, 1.0]);
        assert_eq!(t(1.0 + 2.0 * tiny, tiny), [1.0, 1.0 + 4.0 * tiny]);
        assert_eq!(t(1e300_f64.next_up(), 1e300), [1e300_f64.next_up() - 1e300, 2e300]);
        assert_eq!(t(1e300, 5e-324), [1e300, 1e300]);
        assert_eq!(t(1e308, 1e308), [0.0, f64::INFINITY]);
        assert_eq!(t(1e-320, 5e-324), [1e-320_f64.next_down(), 1e-320_f64.next_up()]);
    }

    #[test]
    fn the_first_reason_counts() {
        let reason = |x, d, r| sphere([x, 0.0, 0.0, d, -0.0, 0.0, 0.0, 0.0, 0.0, r], Precision::F64);
        assert_eq!(reason(1.0, 0.0, f64::NAN), Truth::Invalid("not-finite"));
        assert_eq!(reason(1.0, 0.0, 0.0), Truth::Invalid("zero-direction"));
        for r in [0.0, -0.0, -1.0] {
            assert_eq!(reason(1.0, 1.0, r), Truth::Invalid("radius-not-positive"));
        }
    }

    #[test]
    fn put_back_into_the_ray_every_root_is_on_the_sphere() {
        let (mut hits, mut misses) = (0, 0);
        for_drawn("sphere", |mut case: [f64; 10], precision| {
            case[9] = case[9].abs();
            let ([p_r, d, center], r) = (vectors(&case), Dyadic::of(case[9]));
            // ‖x − c‖² − r² at x = p_r + t d, and whether the ray moves away from the center there.
            let outside_and_away = |t: &Dyadic| {
                let x: [Dyadic; 3] = std::array::from_fn(|axis| &p_r[axis] + &(t * &d[axis]));
                let p = difference(&x, &center);
                ((&dot(&p, &p) - &r.square()).sign(), dot(&p, &d).sign())
            };
            let zero = Dyadic::of(0.0);
            match sphere(case, precision) {
                Truth::Invalid(_) => {}
                Truth::Miss(reason) => {
                    misses += 1;
                    let behind = outside_and_away(&zero) == (Ordering::Greater, Ordering::Greater);
                    assert!(reason.is_empty() && (behind || is_beside(&p_r, &d, &center, &r)), "{case:?}");
                }
                Truth::Hit { t, out } => {
                    hits += 1;
                    assert!(!is_beside(&p_r, &d, &center, &r), "{case:?}");
                    let near = |t: &Dyadic| match outside_and_away(t) {
                        (_, Ordering::Greater) => Ordering::Greater,
                        (outside, _) => outside.reverse(),
                    };
                    let far = |t: &Dyadic| match outside_and_away(t) {
                        (_, Ordering::Less) => Ordering::Less,
                        (outside, _) => outside,
                    };
                    match near(&zero).is_le() {
                        true => assert_rounded(&t, precision, near),
                        false => assert_rounded(&t, precision, far),
                    }
                    assert_rounded(&out.expect("a sphere has an inside"), precision, far);
                }
            }
        });
        assert!(hits > 1000 && misses > 1000, "{hits} hits, {misses} misses");
    }

    /// The line passes the center at more than r: ‖L × d‖ > r ‖d‖.
    fn is_beside(p_r: &[Dyadic; 3], d: &[Dyadic; 3], center: &[Dyadic; 3], r: &Dyadic) -> bool {
        let area = cross(&difference(center, p_r), d);
        (&dot(&area, &area) - &(&r.square() * &dot(d, d))).sign().is_gt()
    }
}

//! The plane: n · (p_0 − p_r) / n · u_r.

use math::Degenerate;
use stage::Precision;

use super::vector::{difference, dot, is_zero, vectors};
use super::{ExactRoot, Verdict};
use crate::Truth;

/// What is true of a ray and a plane, from the columns `ox,oy,oz,dx,dy,dz,px,py,pz,nx,ny,nz`; the normal may
/// have any length. There is no t_out.
///
/// A ray with n · d = 0 is a miss: `in-plane` where it runs in the plane, else `parallel`. Invalid,
/// whichever comes first: a number that is not finite, a zero direction, a zero normal.
pub fn plane(case: [f64; 12], precision: Precision) -> Truth {
    exact_plane(case).written(precision)
}

/// The same before anything is rounded.
pub fn exact_plane(case: [f64; 12]) -> Verdict {
    if !case.iter().all(|x| x.is_finite()) {
        return Verdict::Invalid(Degenerate::NotFinite.reason());
    }
    let [p_r, u_r, p_0, n] = vectors(&case);
    if is_zero(&u_r) {
        return Verdict::Invalid(Degenerate::ZeroDirection.reason());
    }
    if is_zero(&n) {
        return Verdict::Invalid(Degenerate::ZeroNormal.reason());
    }
    // How far the plane is above the origin, and how fast the ray rises, along n.
    let (above, rise) = (dot(&n, &difference(&p_0, &p_r)), dot(&n, &u_r));
    if rise.is_zero() {
        return Verdict::along(above.is_zero());
    }
    Verdict::at(ExactRoot::quotient(above, rise))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::Dyadic;
    use crate::oracle::testing::{assert_rounded, floats, for_drawn};

    /// The plane through `point`, with the normal (1, 1, 1), from `origin`.
    fn truth(origin: [f64; 3], direction: [f64; 3], point: [f64; 3]) -> Truth {
        let case = [origin, direction, point, [1.0; 3]].concat();
        plane(std::array::from_fn(|i| case[i]), Precision::F64)
    }

    #[test]
    fn closed_forms() {
        // by hand: x + y + z = 6, along the ray 1 + 5t = 6, 11 − 5t = 6, 6 + 5t = 6, 7 + 5t = 6
        let t = |x, direction| floats(&truth([x, 0.0, 0.0], direction, [1.0, 2.0, 3.0]));
        assert_eq!(t(1.0, [1.0, 1.0, 3.0]), [1.0]);
        assert_eq!(t(11.0, [-1.0, -1.0, -3.0]), [1.0], "from the other side");
        assert_eq!(t(6.0, [1.0, 1.0, 3.0]), [0.0], "on the plane");
        assert_eq!(t(7.0, [1.0, 1.0, 3.0]), [0.0; 0], "behind");
        // by hand: 5 / 2^−1074 is beyond the largest number
        assert_eq!(t(1.0, [5e-324, 0.0, 0.0]), [f64::INFINITY]);
    }

    #[test]
    fn parallel_is_exact() {
        // by hand: n · d = 1e200 + 1 − 1e200 is not zero, though a float says so
        let direction = [1e200, 1.0, -1e200];
        assert_eq!(floats(&truth([0.0; 3], direction, [0.0, 0.0, 7.0])), [7.0]);
        let direction = [1e200, 0.0, -1e200];
        assert_eq!(truth([0.0; 3], direction, [0.0, 0.0, 5e-324]), Truth::Miss("parallel"));
        assert_eq!(truth([0.0; 3], direction, [1e200, -0.0, -1e200]), Truth::Miss("in-plane"));
    }

    #[test]
    fn the_first_reason_counts() {
        let reason = |x, d, n| {
            let case = [x, 0.0, 0.0, d, 0.0, -0.0, 0.0, 0.0, 0.0, n, -0.0, 0.0];
            plane(case, Precision::F64)
        };
        assert_eq!(reason(f64::INFINITY, 0.0, 0.0), Truth::Invalid("not-finite"));
        assert_eq!(reason(1.0, 0.0, 0.0), Truth::Invalid("zero-direction"));
        assert_eq!(reason(1.0, 5e-324, 0.0), Truth::Invalid("zero-normal"));
    }

    #[test]
    fn put_back_into_the_ray_every_root_is_on_the_plane() {
        let mut hits = 0;
        for_drawn("plane", |case: [f64; 12], precision| {
            let Truth::Hit { t, out: None } = plane(case, precision) else { return };
            hits += 1;
            let [p_r, u_r, p_0, n] = vectors(&case);
            // How far above the plane x(t) is, and whether the ray goes up.
            let above = |t: &Dyadic| {
                let x: [Dyadic; 3] = std::array::from_fn(|axis| &p_r[axis] + &(t * &u_r[axis]));
                dot(&n, &difference(&x, &p_0)).sign()
            };
            let upward = above(&Dyadic::scaled(1, 9000)).is_gt();
            assert_rounded(&t, precision, |t| if upward { above(t) } else { above(t).reverse() });
        });
        assert!(hits > 4000, "{hits} hits");
    }
}

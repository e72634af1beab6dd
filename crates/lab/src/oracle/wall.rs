//! The wall: (x − p_x) / u_x for both faces.

use math::Degenerate;
use stage::Precision;

use super::{Dyadic, ExactRoot, Verdict};
use crate::Truth;

/// What is true of a ray and a wall, from the columns `ox,oy,dx,dy,front,back`. t_out is where the ray leaves
/// by the other face.
///
/// A ray with dx = 0 is a miss: `in-plane` where it runs in a face, else `parallel`, inside the wall
/// too. Invalid, whichever comes first: a number that is not finite, a zero direction, front > back.
pub fn wall(case: [f64; 6], precision: Precision) -> Truth {
    exact_wall(case).written(precision)
}

/// The same before anything is rounded.
pub fn exact_wall(case: [f64; 6]) -> Verdict {
    if let Some(degenerate) = degenerate(case) {
        return Verdict::Invalid(degenerate.reason());
    }
    let [ox, _, dx, _, front, back] = case;
    if dx == 0.0 {
        return Verdict::along(ox == front || ox == back);
    }
    let [p_x, u_x, front, back] = [ox, dx, front, back].map(Dyadic::of);
    let [t_front, t_back] = [front, back].map(|x| ExactRoot::quotient(&x - &p_x, u_x.clone()));
    Verdict::through(if dx > 0.0 { [t_front, t_back] } else { [t_back, t_front] })
}

/// Why the question has no answer; `None` where it has one.
fn degenerate(case: [f64; 6]) -> Option<Degenerate> {
    let [_, _, dx, dy, front, back] = case;
    if !case.iter().all(|x| x.is_finite()) {
        return Some(Degenerate::NotFinite);
    }
    if dx == 0.0 && dy == 0.0 {
        return Some(Degenerate::ZeroDirection);
    }
    (front > back).then_some(Degenerate::FrontBeyondBack)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::testing::{assert_rounded, floats, for_drawn};

    /// t and t_out of a ray along x; empty for a miss.
    fn t(ox: f64, dx: f64, front: f64, back: f64) -> Vec<f64> {
        floats(&wall([ox, 1.0, dx, 1.0, front, back], Precision::F64))
    }

    #[test]
    fn faces_are_hit_in_order() {
        // by hand: (x − p_x) / u_x
        assert_eq!(t(1.0, 2.0, 4.0, 5.0), [1.5, 2.0]);
        assert_eq!(t(8.0, -2.0, 4.0, 5.0), [1.5, 2.0], "from behind");
        assert_eq!(t(4.5, 2.0, 4.0, 5.0), [0.25, 0.25], "from inside");
        assert_eq!(t(5.0, 1.0, 4.0, 5.0), [0.0, 0.0], "leaving at the origin");
        assert_eq!(t(4.0, -1.0, 4.0, 5.0), [0.0, 0.0], "never inside, and it touches");
        assert_eq!(t(4.0, 1.0, 4.0, 4.0), [0.0, 0.0], "a wall without thickness");
        assert_eq!(t(5.0_f64.next_up(), 1.0, 4.0, 5.0), [0.0; 0], "behind");
    }

    #[test]
    fn parameters_are_rounded_once() {
        // by hand: the difference is 1 + 2^−1074
        assert_eq!(t(-5e-324, 1.0, 1.0, 2.0), [1.0, 2.0]);
        // by hand: 3e308 / 1e300, whose difference is no f64
        assert_eq!(t(-1.5e308, 1e300, 1.5e308, 1.5e308), [3e8, 3e8]);
        assert_eq!(t(0.0, 5e-324, 1e10, 2e10), [f64::INFINITY; 2]);
        assert_eq!(t(5e-324, 1e10, -1.0, 0.0), [0.0; 0], "behind by less than the smallest number");
    }

    #[test]
    fn a_ray_along_the_wall_misses() {
        let miss = |ox| wall([ox, 0.0, -0.0, 1.0, 4.0, 5.0], Precision::F64);
        for ox in [4.0, 5.0] {
            assert_eq!(miss(ox), Truth::Miss("in-plane"));
        }
        for ox in [4.5, 3.0, 4.0_f64.next_up()] {
            assert_eq!(miss(ox), Truth::Miss("parallel"));
        }
    }

    #[test]
    fn the_first_reason_counts() {
        let reason = |case| wall(case, Precision::F64);
        assert_eq!(reason([0.0, f64::NAN, 0.0, 0.0, 5.0, 4.0]), Truth::Invalid("not-finite"));
        assert_eq!(reason([0.0, 0.0, 0.0, -0.0, 5.0, 4.0]), Truth::Invalid("zero-direction"));
        assert_eq!(reason([0.0, 0.0, 0.0, 1.0, 5.0, 4.0]), Truth::Invalid("front-beyond-back"));
    }

    #[test]
    fn put_back_into_x_of_t_every_root_is_at_its_face() {
        let mut hits = 0;
        for_drawn("wall", |case: [f64; 6], precision| {
            let [ox, _, dx, _, front, back] = case;
            let Truth::Hit { t, out: Some(out) } = wall(case, precision) else { return };
            hits += 1;
            let [origin, direction] = [ox, dx].map(Dyadic::of);
            // Along the ray, how far a number is from the root at a face.
            let place = |face: f64| {
                let [origin, direction, face] = [&origin, &direction, &Dyadic::of(face)].map(Clone::clone);
                move |t: &Dyadic| {
                    let ahead = (&(&origin + &(t * &direction)) - &face).sign();
                    if direction.sign().is_lt() { ahead.reverse() } else { ahead }
                }
            };
            let (near, far) = if dx > 0.0 { (front, back) } else { (back, front) };
            let zero = Dyadic::of(0.0);
            let first = if place(near)(&zero).is_le() { near } else { far };
            assert_rounded(&t, precision, place(first));
            assert_rounded(&out, precision, place(far));
        });
        assert!(hits > 4000, "{hits} hits");
    }
}

//! The triangle: n · (a − o) / n · d, where the line passes its three edges on the same side.

use math::Degenerate;
use stage::Precision;

use super::vector::{cross, difference, dot, is_zero, vectors};
use super::{ExactRoot, Verdict};
use crate::Truth;

/// What is true of a ray and a triangle, from the columns `ox,oy,oz,dx,dy,dz,ax,ay,az,bx,by,bz,cx,cy,cz`.
///
/// Its edges and corners belong to it, and it is met from either side. There is no t_out. A ray with
/// n · d = 0, for n = (b − a) × (c − a), is a miss: `in-plane` where it runs in the triangle's plane, else
/// `parallel`. Invalid, whichever comes first: a number that is not finite, a zero direction, no area
/// (n = 0).
pub fn triangle(case: [f64; 15], precision: Precision) -> Truth {
    exact_triangle(case).written(precision)
}

/// The same before anything is rounded.
pub fn exact_triangle(case: [f64; 15]) -> Verdict {
    if !case.iter().all(|x| x.is_finite()) {
        return Verdict::Invalid(Degenerate::NotFinite.reason());
    }
    let [o, d, a, b, c] = vectors(&case);
    if is_zero(&d) {
        return Verdict::Invalid(Degenerate::ZeroDirection.reason());
    }
    let n = cross(&difference(&b, &a), &difference(&c, &a));
    if is_zero(&n) {
        return Verdict::Invalid(Degenerate::NoArea.reason());
    }
    let [to_a, to_b, to_c] = [a, b, c].map(|corner| difference(&corner, &o));
    // How far the plane is above the origin, and how fast the ray rises, along n.
    let (above, rise) = (dot(&n, &to_a), dot(&n, &d));
    if rise.is_zero() {
        return Verdict::along(above.is_zero());
    }
    // On which side of the line each edge passes: volumes, which add up to n · d.
    let sides =
        [(&to_a, &to_b), (&to_b, &to_c), (&to_c, &to_a)].map(|(from, to)| dot(&d, &cross(from, to)).sign());
    if sides.contains(&rise.sign().reverse()) {
        return Verdict::Miss("");
    }
    Verdict::at(ExactRoot::quotient(above, rise))
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use super::*;
    use crate::oracle::Dyadic;
    use crate::oracle::testing::{assert_rounded, floats, for_drawn};

    const CORNERS: [[f64; 3]; 3] = [[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0]];

    fn truth(origin: [f64; 3], direction: [f64; 3], [a, b, c]: [[f64; 3]; 3]) -> Truth {
        let case = [origin, direction, a, b, c].concat();
        triangle(std::array::from_fn(|i| case[i]), Precision::F64)
    }

    /// t up the z axis, at (x, y, 0), in both orders of the corners.
    fn t(x: f64, y: f64) -> Vec<f64> {
        let [a, b, c] = CORNERS;
        let up = |corners| floats(&truth([x, y, 0.0], [0.0, 0.0, 1.0], corners));
        assert_eq!(up([a, b, c]), up([c, b, a]));
        up([b, c, a])
    }

    #[test]
    fn closed_forms() {
        // by hand: x ≥ 0, y ≥ 0, x + y ≤ 4 in the plane z = 2
        assert_eq!(t(1.0, 1.0), [2.0]);
        for (x, y) in [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (2.0, 0.0), (0.0, 1.0), (2.0, 2.0), (1.0, 3.0)] {
            assert_eq!(t(x, y), [2.0], "a corner or an edge: {x} {y}");
        }
        for (x, y) in [(2.0, -5e-324), (-5e-324, 2.0), (2.0, 2.0_f64.next_up()), (4.0_f64.next_up(), 0.0)] {
            assert_eq!(t(x, y), [0.0; 0], "a digit beside it: {x} {y}");
        }
        let along_z = |z, direction| floats(&truth([1.0, 1.0, z], [0.0, 0.0, direction], CORNERS));
        assert_eq!(along_z(3.0, -3.0), [1.0 / 3.0], "from the other side");
        assert_eq!(along_z(2.0, -3.0), [0.0], "on it");
        assert_eq!(along_z(3.0, 1.0), [0.0; 0], "behind");
        // by hand: 2 / 2^−1074 is beyond the largest number
        assert_eq!(along_z(0.0, 5e-324), [f64::INFINITY]);
    }

    #[test]
    fn the_smallest_volume_decides() {
        // by hand: at t = 1e−200 the ray is at x = 1e200, or 2^−1074 · 1e−200 beside it
        let [a, b] = [[1e200, -1.0, 1.0], [1e200, 1.0, 1.0]];
        let beside = |x, direction| truth([x, 0.0, 0.0], [direction, 0.0, 1e200], [a, b, [2e200, 0.0, 1.0]]);
        assert_eq!(floats(&beside(1e200, 0.0)), [1e-200], "on the edge");
        assert_eq!(floats(&beside(1e200, 5e-324)), [1e-200], "inside");
        assert_eq!(floats(&beside(1e200, -5e-324)), [0.0; 0], "outside");
    }

    #[test]
    fn parallel_is_exact() {
        let slanted = [[0.0, 0.0, 0.0], [1e200, 0.0, -1e200], [0.0, 1.0, 0.0]];
        // by hand: n is along (1, 0, 1), and n · d = 0 or the smallest number
        let along = |x, z| truth([x, 0.0, 0.0], [1.0, 0.0, z], slanted);
        assert_eq!(along(0.0, -1.0), Truth::Miss("in-plane"));
        assert_eq!(along(9.0, -1.0), Truth::Miss("parallel"));
        assert_eq!(along(5e-324, -1.0), Truth::Miss("parallel"));
        let direction = [1.0, 0.0, -1.0_f64.next_down()];
        assert_eq!(floats(&truth([1.0, 0.0, -1.0], direction, slanted)), [0.0], "not parallel");
    }

    #[test]
    fn the_first_reason_counts() {
        let flat = |x, d, y| truth([x, 0.0, 0.0], [d, 0.0, -0.0], [[1.0; 3], [2.0; 3], [3.0, y, 3.0]]);
        assert_eq!(flat(f64::INFINITY, 0.0, 3.0), Truth::Invalid("not-finite"));
        assert_eq!(flat(1.0, 0.0, 3.0), Truth::Invalid("zero-direction"));
        assert_eq!(flat(1.0, 5e-324, 3.0), Truth::Invalid("no-area"));
        assert_eq!(floats(&flat(0.0, 1.0, 3.0_f64.next_up())), [0.0; 0], "it has an area");
    }

    #[test]
    fn put_back_into_the_ray_every_root_is_in_the_triangle() {
        let (mut hits, mut beside) = (0, 0);
        for_drawn("triangle", |case: [f64; 15], precision| {
            let verdict = exact_triangle(case);
            if matches!(verdict, Verdict::Invalid(_) | Verdict::Miss("parallel" | "in-plane")) {
                return;
            }
            let [o, d, a, b, c] = vectors(&case);
            let [ab, ac] = [&b, &c].map(|corner| difference(corner, &a));
            let n = cross(&ab, &ac);
            // The point of the plane, times rise: o rise + d above; and its α and β, times n · n rise.
            let (above, rise) = (dot(&n, &difference(&a, &o)), dot(&n, &d));
            let to_p: [Dyadic; 3] = std::array::from_fn(|i| &(&(&o[i] - &a[i]) * &rise) + &(&d[i] * &above));
            assert!(dot(&n, &to_p).is_zero());
            let (alpha, beta) = (dot(&n, &cross(&to_p, &ac)), dot(&n, &cross(&ab, &to_p)));
            let rest = &(&(&dot(&n, &n) * &rise) - &alpha) - &beta;
            let outside = [&alpha, &beta, &rest].iter().any(|share| share.sign() == rise.sign().reverse());
            let ahead = above.is_zero() || above.sign() == rise.sign();
            match verdict.written(precision) {
                Truth::Hit { t, out: None } => {
                    hits += 1;
                    assert!(ahead && !outside, "{case:?}");
                    // How a number compares with above / rise.
                    let place = |t: &Dyadic| (&(t * &rise) - &above).sign();
                    let upward = rise.sign() == Ordering::Greater;
                    assert_rounded(&t, precision, |t| if upward { place(t) } else { place(t).reverse() });
                }
                _ => {
                    beside += usize::from(ahead);
                    assert!(outside || !ahead, "{case:?}");
                }
            }
        });
        assert!(hits > 500 && beside > 500, "{hits} hits, {beside} beside");
    }
}

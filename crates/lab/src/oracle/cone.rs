//! The unit cone: 4 (x² + y²) ≤ (s − z)² above its base, and below its apex.
//!
//! The inequality alone is true in two nappes, which meet in the apex. The one below it, s − z ≥ 0, is
//! convex. It is the coefficient A that says how a line meets them:
//!
//! * A > 0, flatter than the wall: what the line has inside is one stretch, in one nappe. s − z ≥ 0 keeps it or
//!   drops it.
//! * A = 0, parallel to the wall: the same, but the stretch has only one end, C / 2B; or none on the wall itself.
//! * A < 0, steeper: the line comes out of one nappe at the smaller root and goes into the other at the larger.

use std::cmp::Ordering;

use super::quadratic::Quadratic;
use super::round::across;
use super::stretch::Stretch;
use super::unit::ScaledRay;
use super::{Dyadic, ExactRoot, Verdict};

/// 4 (x² + y²) ≤ (s − z)² and 0 ≤ z ≤ s
pub(super) fn cone(ray: &ScaledRay) -> Verdict {
    let ScaledRay { origin: p, direction: d, scale } = ray;
    let four = Dyadic::of(4.0);
    // How far the origin is below the apex.
    let below = scale - &p[2];
    // 4 (x² + y²) − (s − z)² along the ray is A t² − 2 B t + C.
    let a = &(&four * &across(d, d)) - &d[2].square();
    let b = -&(&(&four * &across(p, d)) + &(&below * &d[2]));
    let c = &(&four * &across(p, p)) - &below.square();
    let starts_strictly_inside = c.sign().is_lt() && below.sign().is_gt() && p[2].sign().is_gt();
    let stretch = Stretch::common([
        inside_the_wall(a, b, c, d[2].sign()),
        Stretch::above(&below, &-&d[2]),
        Stretch::above(&p[2], &d[2]),
    ]);
    Verdict::boundary(stretch, starts_strictly_inside)
}

/// Where A t² − 2 B t + C ≤ 0; in the lower nappe only, if the line is in both. `rise` is the sign of d_z.
fn inside_the_wall(a: Dyadic, b: Dyadic, c: Dyadic, rise: Ordering) -> Option<Stretch> {
    if a.sign().is_ge() {
        return Stretch::within(a, b, c);
    }
    // Where z = s the polynomial is 4 (x² + y²) ≥ 0: a steep line has its roots.
    let [smaller, larger] = ExactRoot::roots(Quadratic::new(a, b, c)?);
    Some(if rise.is_gt() { Stretch::up_to(smaller) } else { Stretch::from(larger) })
}

#[cfg(test)]
mod tests {
    use stage::Precision;

    use crate::oracle::UnitObject::Cone;
    use crate::oracle::quadric;
    use crate::oracle::testing::floats;

    /// t of a ray in the plane y = 0; empty for a miss.
    fn t([x, z]: [f64; 2], [d_x, d_z]: [f64; 2]) -> Vec<f64> {
        floats(&quadric(Cone, [x, 0.0, z, d_x, 0.0, d_z], Precision::F64))
    }

    #[test]
    fn flatter_than_the_wall() {
        // by hand: at z = ½ the radius is ¼; half an ellipsoid, the page's slip, would have √3/4
        assert_eq!(t([-1.0, 0.5], [1.0, 0.0]), [0.75]);
        assert_eq!(t([0.0, 0.5], [1.0, 0.0]), [0.25], "from inside");
        assert_eq!(t([0.25, 0.5], [1.0, 0.0]), [0.0], "on the wall, going out");
        assert_eq!(t([0.25, 0.5], [-1.0, 0.0]), [0.0], "on the wall, going in");
        assert_eq!(t([-3.0, 1.5], [1.0, 0.0]), [0.0; 0], "only the upper nappe is in its way");
        assert_eq!(t([-3.0, -0.25], [1.0, 0.0]), [0.0; 0], "below the base");
        // by hand: at (¼, y, ½) the wall's tangent runs along y
        let along_y = |x, z| floats(&quadric(Cone, [x, -3.0, z, 0.0, 1.0, 0.0], Precision::F64));
        assert_eq!(along_y(0.25, 0.5), [3.0], "a tangent");
        assert_eq!(along_y(0.25_f64.next_up(), 0.5), [0.0; 0], "a digit beside it");
        assert_eq!(along_y(0.5, 0.0), [3.0], "a tangent of the rim");
        assert_eq!(along_y(0.0, 1.0), [3.0], "the apex");
        assert_eq!([along_y(0.0, 1.0_f64.next_up()), along_y(5e-324, 1.0)], [[], [0.0; 0]]);
    }

    #[test]
    fn along_the_slope() {
        // by hand: 2 |x| = 1 − z
        assert_eq!(t([-1.0, 3.0], [1.0, -2.0]), [1.0], "on the wall, from the apex down");
        assert_eq!(t([1.0, -1.0], [-1.0, 2.0]), [0.5], "on the wall, from the rim up");
        assert_eq!(t([0.25, 0.5], [1.0, -2.0]), [0.0], "within the wall");
        assert_eq!(t([-1.0, 3.0_f64.next_up()], [1.0, -2.0]), [0.0; 0], "a digit outside the wall");
        assert_eq!(t([0.0, 0.5], [1.0, -2.0]), [0.25], "from inside, by the base");
        assert_eq!(t([0.0, 0.5], [1.0, 2.0]), [0.125], "from inside, by the wall");
        assert_eq!(t([1.0, 2.5], [-1.0, -2.0]), [0.875], "through the wall");
        assert_eq!(t([-1.0, -1.5], [1.0, 2.0]), [0.75], "through the base");
        assert_eq!(t([-2.0, -2.5], [1.0, 2.0]), [0.0; 0], "only the upper nappe is in its way");
        assert_eq!(t([2.0, 5.5], [-1.0, -2.0]), [0.0; 0], "and the other way");
        // by hand: at y = 1 the ray along the slope is nowhere inside
        assert_eq!(floats(&quadric(Cone, [0.0, 1.0, 0.5, 1.0, 0.0, 2.0], Precision::F64)), [0.0; 0]);
    }

    #[test]
    fn steeper_than_the_wall() {
        // by hand: 2 / 8 = 1 − z at z = ¾, and the upper nappe begins at z = 1¼
        assert_eq!(t([0.125, -1.0], [0.0, 1.0]), [1.0], "through the base");
        assert_eq!(t([0.125, 0.5], [0.0, 1.0]), [0.25], "from inside, by the wall");
        assert_eq!(t([0.125, 0.5], [0.0, -1.0]), [0.5], "from inside, by the base");
        assert_eq!(t([0.125, 0.8], [0.0, 1.0]), [0.0; 0], "the upper nappe does not count");
        for z in [1.0, 1.25, 2.0] {
            assert_eq!(t([0.125, z], [0.0, -1.0]), [z - 0.75], "from between the nappes, or the upper one");
            assert_eq!(t([0.125, z], [0.0, 1.0]), [0.0; 0]);
        }
        assert_eq!([t([0.5, -1.0], [0.0, 1.0]), t([0.5, 1.0], [0.0, -1.0])], [[1.0], [1.0]], "the rim");
        assert_eq!(t([0.5_f64.next_up(), -1.0], [0.0, 1.0]), [0.0; 0], "a digit outside the rim");
        // by hand: 4 (x² + 1/16) = (1 − z)² at x = t, z = 4 t − ¾ is 12 t² − 14 t + 45/16 = 0
        let skew = |x, z| floats(&quadric(Cone, [x, 0.25, z, 1.0, 0.0, 4.0], Precision::F64));
        assert_eq!(skew(0.0, -0.75), [0.1875], "the base comes before");
        let by_hand = (14.0 - 61.0_f64.sqrt()) / 24.0 - 0.1875;
        assert!((skew(0.1875, 5e-324)[0] - by_hand).abs() < 1e-15, "from inside, by the wall");
    }

    #[test]
    fn along_the_axis_and_through_the_apex() {
        assert_eq!(t([0.0, -1.0], [0.0, 1.0]), [1.0], "from below");
        assert_eq!(t([0.0, 3.0], [0.0, -1.0]), [2.0], "from above, the apex");
        assert_eq!(t([0.0, 0.25], [0.0, 1.0]), [0.75], "from inside, the apex");
        assert_eq!(t([0.0, 3.0], [0.0, 1.0]), [0.0; 0], "behind");
        assert_eq!(t([-3.0, 1.0], [1.0, 0.0]), [3.0], "touching the apex, flat");
        assert_eq!(t([-1.0, 5.0], [1.0, -4.0]), [1.0], "the apex, steep, going in");
        for d in [[0.0, 1.0], [0.0, -1.0], [1.0, 0.0], [1.0, 2.0], [1.0, -2.0], [1.0, 4.0], [4.0, -1.0]] {
            assert_eq!(t([0.0, 1.0], d), [0.0], "from the apex: {d:?}");
        }
    }

    #[test]
    fn in_the_base() {
        assert_eq!(t([-1.0, 0.0], [1.0, 0.0]), [0.5], "along the base");
        for x in [0.0, 0.25, -0.5, 0.5] {
            for d in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 2.0]] {
                assert_eq!(t([x, 0.0], d), [0.0], "within it: {x} {d:?}");
            }
        }
        assert_eq!(t([-1.0, -5e-324], [1.0, 0.0]), [0.0; 0], "a digit below it");
        assert_eq!(
            t([1.0, -1.0], [-1.0, 2.0_f64.next_down()]),
            [1.0 / 2.0_f64.next_down()],
            "inside the rim"
        );
        assert_eq!(t([1.0, -1.0], [-1.0, 2.0_f64.next_up()]), [0.0; 0], "outside the rim");
    }
}

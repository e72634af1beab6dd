//! The unit sphere and the unit cylinder: x² + y² + z² ≤ s², and x² + y² ≤ s² between two caps.

use super::stretch::Stretch;
use super::unit::ScaledRay;
use super::vector::dot;
use super::{Dyadic, Verdict};

/// x² + y² + z² ≤ s²
pub(super) fn sphere(ray: &ScaledRay) -> Verdict {
    let ScaledRay { origin: p, direction: d, scale } = ray;
    let c = &dot(p, p) - &scale.square();
    let starts_strictly_inside = c.sign().is_lt();
    Verdict::boundary(Stretch::within(dot(d, d), -&dot(p, d), c), starts_strictly_inside)
}

/// x² + y² ≤ s² and −s ≤ z ≤ s
pub(super) fn cylinder(ray: &ScaledRay) -> Verdict {
    let ScaledRay { origin: p, direction: d, scale } = ray;
    let c = &across(p, p) - &scale.square();
    // How far the origin is below the upper cap, and above the lower one.
    let (below, above) = (scale - &p[2], scale + &p[2]);
    let starts_strictly_inside = c.sign().is_lt() && below.sign().is_gt() && above.sign().is_gt();
    let stretch = Stretch::common([
        Stretch::within(across(d, d), -&across(p, d), c),
        Stretch::above(&below, &-&d[2]),
        Stretch::above(&above, &d[2]),
    ]);
    Verdict::boundary(stretch, starts_strictly_inside)
}

/// x x' + y y': a · b across the axis.
pub(super) fn across(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> Dyadic {
    &(&a[0] * &b[0]) + &(&a[1] * &b[1])
}

#[cfg(test)]
mod tests {
    use stage::Precision;

    use crate::oracle::UnitObject::{Cylinder, Sphere};
    use crate::oracle::quadric;
    use crate::oracle::testing::floats;

    /// t of a ray and the cylinder; empty for a miss.
    fn t(origin: [f64; 3], direction: [f64; 3]) -> Vec<f64> {
        let [[x, y, z], [d_x, d_y, d_z]] = [origin, direction];
        floats(&quadric(Cylinder, [x, y, z, d_x, d_y, d_z], Precision::F64))
    }

    #[test]
    fn the_sphere_by_hand() {
        // by hand: z ± √(1 − x²)
        let t = |x, z| floats(&quadric(Sphere, [x, 0.0, z, 0.0, 0.0, 1.0], Precision::F64));
        assert_eq!(t(0.5, 0.0), [0.75_f64.sqrt()]);
        assert_eq!([t(0.0, -3.0), t(0.0, 0.5), t(0.0, 1.0)], [[2.0], [0.5], [0.0]]);
        assert_eq!([t(0.0, -1.0), t(1.0, -3.0)], [[0.0], [3.0]], "on it, going in, and a tangent");
        assert_eq!([t(0.0, 1.5), t(1.0_f64.next_up(), -3.0)], [[], [0.0; 0]]);
    }

    #[test]
    fn through_the_wall_and_the_caps() {
        assert_eq!(t([-3.0, 0.0, 0.0], [2.0, 0.0, 0.0]), [1.0], "the wall");
        assert_eq!(t([0.0, 0.0, 2.0], [0.0, 0.0, -3.0]), [1.0 / 3.0], "along the axis");
        assert_eq!(t([0.0, 0.0, -2.0], [0.0, 0.0, 3.0]), [1.0 / 3.0], "and up");
        assert_eq!(t([0.0, 0.0, 2.0], [0.0, 0.0, 1.0]), [0.0; 0], "behind");
        // by hand: at z = 1 the ray is at x = −0.5, at x = −1 at z = 1.5
        assert_eq!(t([-2.0, 0.0, 2.5], [1.0, 0.0, -1.0]), [1.5], "a cap, after the wall's first root");
        assert_eq!(t([-2.5, 0.0, 2.0], [1.0, 0.0, -1.0]), [1.5], "the wall, after the cap's plane");
        assert_eq!(t([-3.0, 0.0, 0.0], [1.0, 0.0, 1.0]), [0.0; 0], "above it");
        assert_eq!(t([3.0, 3.0, 0.0], [0.0, 0.0, 1.0]), [0.0; 0], "beside it");
        // by hand: √(1 − ¼) is irrational
        assert_eq!(t([0.5, 0.0, 0.0], [0.0, 1.0, 0.0]), [0.75_f64.sqrt()], "from inside, by the wall");
        assert_eq!(t([0.5, 0.0, 0.5], [0.0, 0.25, 0.25]), [2.0], "from inside, by a cap");
    }

    #[test]
    fn touching_is_a_hit() {
        let (above, below) = (1.0_f64.next_up(), 1.0_f64.next_down());
        assert_eq!(t([1.0, -3.0, 0.0], [0.0, 1.0, 0.0]), [3.0], "a tangent");
        assert_eq!(t([above, -3.0, 0.0], [0.0, 1.0, 0.0]), [0.0; 0], "a digit beside it");
        assert_eq!(t([1.0, -3.0, 1.0], [0.0, 1.0, 0.0]), [3.0], "a tangent of the rim");
        assert_eq!(t([1.0, -3.0, above], [0.0, 1.0, 0.0]), [0.0; 0], "a digit above it");
        assert_eq!(t([2.0, 0.0, 0.0], [-1.0, 0.0, 1.0]), [1.0], "the rim");
        assert_eq!(t([2.0_f64.next_up(), 0.0, 0.0], [-1.0, 0.0, 1.0]), [0.0; 0], "a digit outside it");
        assert_eq!(t([-3.0, 0.0, -above], [1.0, 0.0, 0.0]), [0.0; 0], "a digit below the lower cap");
        assert_eq!(t([2.0, 0.0, -2.0], [-1.0, 0.0, 1.0]), [1.0], "the lower rim");
        assert_eq!(t([2.0, 0.0, 0.0], [-1.0, 0.0, below]).len(), 1, "a digit below the rim");
        assert_eq!(t([2.0, 0.0, 0.0], [-1.0, 0.0, above]), [0.0; 0], "a digit above the rim");
    }

    #[test]
    fn inside_a_surface_it_hits_where_it_first_touches() {
        let above = 1.0_f64.next_up();
        assert_eq!(t([-3.0, 0.0, 1.0], [1.0, 0.0, 0.0]), [2.0], "along a cap");
        assert_eq!(t([0.5, 0.0, 1.0], [1.0, 0.0, 0.0]), [0.0], "within a cap");
        assert_eq!(t([1.0, 0.0, -3.0], [0.0, 0.0, 2.0]), [1.0], "along the wall");
        assert_eq!(t([1.0, 0.0, -0.5], [0.0, 0.0, 2.0]), [0.0], "within the wall");
        assert_eq!(t([above, 0.0, -3.0], [0.0, 0.0, 2.0]), [0.0; 0], "a digit outside the wall");
        assert_eq!(t([0.0, 0.0, above], [1.0, 0.0, 0.0]), [0.0; 0], "a digit above a cap");
    }

    #[test]
    fn a_ray_from_the_boundary_hits_at_zero() {
        for origin in [[1.0, 0.0, 0.5], [0.5, 0.0, 1.0], [0.5, 0.0, -1.0], [1.0, 0.0, 1.0], [0.0, 1.0, -1.0]]
        {
            for direction in [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]] {
                assert_eq!(t(origin, direction), [0.0], "{origin:?} {direction:?}");
            }
        }
        // by hand: a digit inside the wall, it leaves after the rest, 2^−53
        assert_eq!(t([1.0_f64.next_down(), 0.0, 0.0], [1.0, 0.0, 0.0]), [f64::EPSILON / 2.0]);
    }
}

//! The unit plane and the unit triangle: t = −z / d_z.

use super::unit::ScaledRay;
use super::{Dyadic, ExactRoot, Verdict};

/// z = 0
pub(super) fn plane(ray: &ScaledRay) -> Verdict {
    let ([_, _, z], [_, _, d_z]) = (&ray.origin, &ray.direction);
    if d_z.is_zero() {
        return Verdict::along(z.is_zero());
    }
    Verdict::at(ExactRoot::quotient(-z, d_z.clone()))
}

/// z = 0, x ≥ 0, y ≥ 0 and x + y ≤ s
pub(super) fn triangle(ray: &ScaledRay) -> Verdict {
    let ([x, y, z], [d_x, d_y, d_z]) = (&ray.origin, &ray.direction);
    // The point of the plane is (α, β) / d_z; what is left of s is s − α / d_z − β / d_z.
    let share = |from: &Dyadic, d: &Dyadic| &(from * d_z) - &(z * d);
    let (alpha, beta) = (share(x, d_x), share(y, d_y));
    let rest = &(&(&ray.scale * d_z) - &alpha) - &beta;
    let is_beside = [alpha, beta, rest].iter().any(|share| share.sign() == d_z.sign().reverse());
    if is_beside && !d_z.is_zero() { Verdict::Miss("") } else { plane(ray) }
}

#[cfg(test)]
mod tests {
    use stage::Precision;

    use crate::Truth;
    use crate::oracle::UnitObject::{Plane, Triangle};
    use crate::oracle::quadric;
    use crate::oracle::testing::floats;

    #[test]
    fn closed_forms() {
        // by hand: −z / d_z, at (x, y, 0)
        let t = |shape, case| floats(&quadric(shape, case, Precision::F64));
        for shape in [Plane, Triangle] {
            assert_eq!(t(shape, [0.25, 0.25, -2.0, 0.0, 0.0, 3.0]), [2.0 / 3.0]);
            assert_eq!(t(shape, [0.25, 0.25, 2.0, 0.0, 0.0, -3.0]), [2.0 / 3.0], "from the other side");
            assert_eq!(t(shape, [0.25, 0.25, 0.0, 0.0, 0.0, -3.0]), [0.0], "on it");
            assert_eq!(t(shape, [0.25, 0.25, 2.0, 0.0, 0.0, 3.0]), [0.0; 0], "behind");
            assert_eq!(t(shape, [1.25, -0.75, 2.0, -1.0, 1.0, -2.0]), [1.0], "slanted");
        }
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5), (0.5, 0.0), (0.0, 0.5)] {
            for d_z in [2.0, -2.0] {
                assert_eq!(t(Triangle, [x, y, -d_z, 0.0, 0.0, d_z]), [1.0], "a corner or an edge: {x} {y}");
            }
        }
        for (x, y) in [(-5e-324, 0.0), (0.0, -5e-324), (1.0_f64.next_up(), 0.0), (0.5, 0.5_f64.next_up())] {
            for d_z in [2.0, -2.0] {
                assert_eq!(t(Triangle, [x, y, -d_z, 0.0, 0.0, d_z]), [0.0; 0], "beside it: {x} {y}");
                assert_eq!(t(Plane, [x, y, -d_z, 0.0, 0.0, d_z]), [1.0]);
            }
        }
    }

    #[test]
    fn a_ray_along_the_plane_misses() {
        for shape in [Plane, Triangle] {
            let miss = |z| quadric(shape, [-9.0, 0.25, z, 1.0, 0.0, -0.0], Precision::F64);
            assert_eq!(miss(-0.0), Truth::Miss("in-plane"));
            assert_eq!(miss(5e-324), Truth::Miss("parallel"));
            assert_eq!(miss(-5e-324), Truth::Miss("parallel"));
        }
    }
}

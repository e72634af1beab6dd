//! The cone as CSC418 11.3.5 prints it: x² + y² − ¼(1 − z²) = 0 for 0 ≤ z ≤ 1. It is half an ellipsoid.
//!
//! At a height z the printed radius is ½√(1 − z²), a quarter of an ellipse; a cone's is ½(1 − z), a straight line. The
//! two agree at the base and at the apex, and nowhere between. This is here for the picture and for the test of the
//! slip; no method of the chapter uses it.

use math::{Degenerate, Hit, Ray3, Real, Span, Vector};

use crate::Hit3;

/// The radius at a height 0 ≤ z ≤ 1 by the printed formula, ½√(1 − z²); NaN above 1.
pub fn printed_radius<R: Real>(z: R) -> R {
    let one = R::from(1.0);
    R::from(0.5) * (one - z * z).sqrt()
}

/// The radius of the cone at a height 0 ≤ z ≤ 1: ½(1 − z).
pub fn radius<R: Real>(z: R) -> R {
    R::from(0.5) * (R::from(1.0) - z)
}

/// The nearest hit in `span` of the printed surface with the base under it, found as the notes find theirs,
/// with the outward normal; `None` for a miss, [`Degenerate`] for a ray that asks nothing.
pub fn hit<R: Real>(ray: &Ray3<R>, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
    ray.check()?;
    let ([a_x, a_y, a_z], [d_x, d_y, d_z]) = (R::xyz(ray.origin), R::xyz(ray.direction));
    let (zero, one, quarter) = (R::from(0.0), R::from(1.0), R::from(0.25));

    // x² + y² − ¼(1 − z²) = 0: the sign of z² is that of x² and y², which makes it an ellipsoid.
    let a = d_x * d_x + d_y * d_y + quarter * d_z * d_z;
    let b = a_x * d_x + a_y * d_y + quarter * a_z * d_z;
    let c = a_x * a_x + a_y * a_y - quarter * (one - a_z * a_z);
    let d = b * b - a * c;

    let mut nearest: Option<Hit3<R>> = None;
    let mut consider = |t: R, point: R::Vec3, normal: R::Vec3| {
        if span.contains(t) && nearest.is_none_or(|hit| t < hit.t) {
            nearest = Some(Hit { t: t + zero, point, normal });
        }
    };
    if d >= zero {
        for lambda in [-b / a + d.sqrt() / a, -b / a - d.sqrt() / a] {
            let point = ray.at(lambda);
            let [x, y, z] = R::xyz(point);
            if zero <= z && z <= one {
                consider(lambda, point, R::vec3(x, y, quarter * z).normalized());
            }
        }
    }
    if d_z != zero {
        let lambda = -a_z / d_z;
        let [x, y, _] = R::xyz(ray.at(lambda));
        if x * x + y * y <= quarter {
            consider(lambda, R::vec3(x, y, zero), R::vec3(zero, zero, -one));
        }
    }
    Ok(nearest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Shape, notes};
    use glam::DVec3;

    /// Slip 13.
    #[test]
    fn as_printed_the_cone_is_half_an_ellipsoid() {
        // by hand: across the axis at z = 3/5 the cone is at x = −½ · 2/5, half an ellipsoid at x = −½ · 4/5
        let ray = Ray3::<f64>::new(DVec3::new(-1.0, 0.0, 0.6), DVec3::X);
        let cone = notes(&ray, Shape::Cone).hit(Span::ahead()).unwrap().unwrap();
        let printed = hit(&ray, Span::ahead()).unwrap().unwrap();
        assert!((cone.point.x + 0.2).abs() < 1e-15 && (printed.point.x + 0.4).abs() < 1e-15);
        assert!((radius(0.6) - 0.2_f64).abs() < 1e-15 && (printed_radius(0.6) - 0.4_f64).abs() < 1e-15);
        // A straight side has its middle halfway between its ends; the printed one does not.
        let middle = |radius: fn(f64) -> f64| radius(0.5) - (radius(0.0) + radius(1.0)) / 2.0;
        assert_eq!(middle(radius), 0.0);
        assert!(middle(printed_radius) > 0.18);
    }

    #[test]
    fn the_base_closes_the_printed_surface() {
        // by hand: straight up from 2 below, and from 2 above the half without its base
        let along_z = |x: f64, z: f64, d_z: f64| {
            let ray = Ray3::<f64>::new(DVec3::new(x, 0.0, z), DVec3::Z * d_z);
            hit(&ray, Span::ahead()).unwrap().map(|hit| (hit.t, hit.point.z, hit.normal))
        };
        assert_eq!(along_z(0.25, -2.0, 4.0), Some((0.5, 0.0, -DVec3::Z)));
        assert_eq!(along_z(0.75, -2.0, 4.0), None);
        assert_eq!(along_z(0.0, 2.0, -0.5), Some((2.0, 1.0, DVec3::Z)));
        assert_eq!(along_z(0.25, -2.0, -4.0), None);
        // and as far beside the base along y
        let beside = Ray3::<f64>::new(DVec3::new(0.25, 0.75, -2.0), DVec3::Z);
        assert_eq!(hit(&beside, Span::ahead()), Ok(None));
        let beside = Ray3::<f64>::new(DVec3::new(0.25, -0.75, -2.0), DVec3::Z);
        assert_eq!(hit(&beside, Span::ahead()), Ok(None));
    }

    #[test]
    fn from_inside_the_printed_surface_is_left() {
        // by hand: at z = 3/5 it is left at x = 2/5, three tenths from 1/10
        let ray = Ray3::<f64>::new(DVec3::new(0.1, 0.0, 0.6), DVec3::X);
        let seen = hit(&ray, Span::ahead()).unwrap().unwrap();
        // 0.1 and 0.6 are rounded, then a dozen numbers below 1: each by half a unit of the last digit of 1 at most
        let few = 8.0 * f64::EPSILON;
        assert!((seen.t - 0.3).abs() <= few && (seen.point.x - 0.4).abs() <= few, "{seen:?}");
    }

    #[test]
    fn slanted_rays_meet_the_printed_equation() {
        for origin in [[2.0, -1.0, 1.5], [-1.0, 3.0, 0.75], [-2.0, -1.0, 2.0], [0.5, -2.0, -0.5]] {
            let origin = DVec3::from(origin);
            let ray = Ray3::<f64>::new(origin, DVec3::new(0.1, 0.05, 0.5) - origin);
            let seen = hit(&ray, Span::ahead()).unwrap().unwrap();
            let DVec3 { x, y, z } = seen.point;
            // a ray from about 3 away: a dozen roundings of squares below 10
            let residual = x * x + y * y - (1.0 - z * z) / 4.0;
            assert!(z == 0.0 || residual.abs() < 64.0 * f64::EPSILON, "{seen:?}: {residual:e}");
            assert!(seen.point.distance(ray.at(seen.t)) == 0.0 && seen.normal.dot(ray.direction) < 0.0);
        }
    }

    /// By hand: up along x = ½ the ellipsoid is touched at z = 0, where A λ² + 2 B λ + C is λ² − 2 λ + 1, and the base
    /// is as near. At the rim the ellipsoid is upright.
    #[test]
    fn a_tie_at_the_rim_is_the_walls() {
        let ray = Ray3::<f64>::new(DVec3::new(0.5, 0.0, -2.0), DVec3::Z * 2.0);
        let seen = hit(&ray, Span::ahead()).unwrap().unwrap();
        assert_eq!((seen.t, seen.point, seen.normal), (1.0, DVec3::X * 0.5, DVec3::X));
    }

    /// By hand: from x = ¼ by 2 λ it is left at x = ½, λ = ⅛.
    #[test]
    fn the_direction_need_not_be_of_length_one() {
        let ray = Ray3::<f64>::new(DVec3::X * 0.25, DVec3::X * 2.0);
        let seen = hit(&ray, Span::ahead()).unwrap().unwrap();
        assert_eq!((seen.t, seen.point, seen.normal), (0.125, DVec3::X * 0.5, DVec3::X));
    }

    /// By hand: at (−2/5, 0, 3/5) half the gradient is (x, y, ¼ z) = (−8, 0, 3) / 20.
    #[test]
    fn the_normal_of_the_printed_surface_is_its_gradient() {
        let ray = Ray3::<f64>::new(DVec3::new(-1.0, 0.0, 0.6), DVec3::X);
        let normal = hit(&ray, Span::ahead()).unwrap().unwrap().normal;
        // x is off by 8 units of the last digit of 1 at most, as above, and ¼ z by half a one; that is 20 of a length
        // of 0.43. Then a dozen numbers of at most 1 are rounded, each by half a unit.
        let few = 26.0 * f64::EPSILON;
        assert!(normal.distance(DVec3::new(-8.0, 0.0, 3.0) / 73.0_f64.sqrt()) <= few, "{normal}");
    }

    /// From on the base up, λ is −0 / 1.
    #[test]
    fn minus_zero_is_zero() {
        let seen = hit(&Ray3::<f64>::new(DVec3::ZERO, DVec3::Z), Span::ahead()).unwrap().unwrap();
        assert_eq!((seen.t.to_bits(), seen.normal), (0, -DVec3::Z));
    }
}

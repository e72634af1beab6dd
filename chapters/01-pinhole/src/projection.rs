//! House 4.1: perspective projection by similar triangles, and the same by casting a ray.

use math::{Ray2, Real, Vector};

/// The side view of a projection: z is the distance from the eye, y the height above it, both in units of
/// the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection<R> {
    /// The object's height.
    pub y_0: R,
    /// The object's distance.
    pub z_0: R,
    /// The view plane's distance.
    pub z_p: R,
    /// The height of its picture on the view plane: y_0 z_p / z_0.
    pub y_p: R,
    /// The height of its picture on a film as far behind the pinhole: −y_p, upside down.
    pub y_film: R,
}

/// Projects an object point to a view plane at the distance `z_p` above zero: y_p / z_p = y_0 / z_0 (House
/// 4.1).
///
/// `None` for z_0 = 0, a point beside the eye, which has no picture. (For z_0 < 0 the point is behind the
/// eye and not seen; what is returned is where the line through it and the eye meets the plane.)
pub fn project<R: Real>(y_0: R, z_0: R, z_p: R) -> Option<Projection<R>> {
    if z_0 == R::from(0.0) {
        return None;
    }
    let y_p = y_0 * z_p / z_0;
    let y_film = y_0 * -z_p / z_0;
    Some(Projection { y_0, z_0, z_p, y_p, y_film })
}

/// The ray from the eye through the projected point, followed to the object: the projection read
/// backwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CastThrough<R: Real> {
    /// From the eye (0, 0) through (y_p, z_p); components are (y, z), as in the page's triangles. Its
    /// direction is not normalized: t = 1 on the view plane.
    pub ray: Ray2<R>,
    /// z_0 / z_p: where the ray is at the object's distance, in lengths of its direction.
    pub t: R,
    /// The point there; on paper it is (y_0, z_0).
    pub point: R::Vec2,
    /// How far that is from the object, in units of the scene.
    pub residual: R,
}

/// Casts the ray of a projection, whose z_p must not be 0.
pub fn cast_through<R: Real>(projection: &Projection<R>) -> CastThrough<R> {
    let Projection { y_0, z_0, z_p, y_p, .. } = *projection;
    let zero = R::from(0.0);
    let ray = Ray2::new(R::vec2(zero, zero), R::vec2(y_p, z_p));
    let t = z_0 / z_p;
    let point = ray.at(t);
    CastThrough { ray, t, point, residual: (point - R::vec2(y_0, z_0)).length() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn similar_triangles() {
        // by hand: a point 2 up and 4 away, a view plane at 3
        let seen = project(2.0, 4.0, 3.0).unwrap();
        assert_eq!((seen.y_p, seen.y_film), (1.5, -1.5));
        assert_eq!(project(2.0, 0.0, 1.0), None);
    }

    #[test]
    fn projecting_and_casting_agree() {
        for (y_0, z_0, z_p) in [(2.0, 4.0, 1.0), (-0.3, 7.1, 0.9), (123.4, 0.7, 3.0), (1e-3, 1e5, 1e-2)] {
            let cast = cast_through(&project(y_0, z_0, z_p).unwrap());
            // three roundings, each at most half a last digit: 2^−52 of the distance covers them
            let bound = f64::EPSILON * f64::hypot(y_0, z_0);
            assert!(cast.residual <= bound, "({y_0}, {z_0}) at {z_p}: {}", cast.residual);
        }
    }
}

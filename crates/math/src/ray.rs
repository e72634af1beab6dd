//! The ray equation.

use crate::{Real, Vector};

/// A ray x(t) = p_r + t u_r: an origin and a direction, in the plane or in space.
///
/// The direction need not have length 1; t is counted in lengths of the direction as given. House
/// writes (p_r, u_r) with a unit u_r, Gambetta (O, D) with any D, CSC418 (a, d) with any d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<V> {
    /// Where the ray starts: p_r, O or a.
    pub origin: V,
    /// Where it goes: u_r, D or d. A zero direction is degenerate.
    pub direction: V,
}

/// A ray in the plane.
pub type Ray2<R> = Ray<<R as Real>::Vec2>;
/// A ray in space.
pub type Ray3<R> = Ray<<R as Real>::Vec3>;

impl<V> Ray<V> {
    /// A ray from `origin` along `direction`, both taken as they are.
    pub fn new(origin: V, direction: V) -> Self {
        Ray { origin, direction }
    }

    /// The point x(t) = p_r + t u_r (House, Eq. 4.1).
    ///
    /// `t` may be infinite, for a hit beyond the largest number: then a component that does not move
    /// stays where it is, and the others are infinite.
    pub fn at<R: Real>(&self, t: R) -> V
    where
        V: Vector<R>,
    {
        let zero = R::from(0.0);
        // (0 · ∞ would be NaN)
        self.origin.zip(self.direction, |p, u| if u == zero { p } else { p + t * u })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_point_is_t_directions_away() {
        let ray = Ray::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, -2.0, 4.0));
        assert_eq!(ray.at(0.5), DVec3::new(1.0, 1.0, 5.0));
        assert_eq!(ray.at(0.0), ray.origin);
    }

    #[test]
    fn an_infinite_t_moves_only_what_moves() {
        let ray = Ray::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, -2.0, 4.0));
        let far = ray.at(f64::INFINITY);
        assert_eq!(far, DVec3::new(1.0, f64::NEG_INFINITY, f64::INFINITY));
    }
}

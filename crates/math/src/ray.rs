//! The ray equation.

use crate::{Degenerate, Real, Vector};

/// A ray x(t) = p_r + t u_r in space: an origin and a direction.
///
/// The direction need not have length 1; t is counted in lengths of the direction as given. House
/// writes (p_r, u_r) with a unit u_r, Gambetta (O, D) with any D, CSC418 (a, d) with any d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray3<R: Real> {
    /// Where the ray starts: p_r, O or a.
    pub origin: R::Vec3,
    /// Where it goes: u_r, D or d. A zero direction is degenerate.
    pub direction: R::Vec3,
}

/// A ray x(t) = p_r + t u_r in the plane, like [`Ray3`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray2<R: Real> {
    /// Where the ray starts.
    pub origin: R::Vec2,
    /// Where it goes, a vector of any length but zero.
    pub direction: R::Vec2,
}

impl<R: Real> Ray3<R> {
    /// A ray from `origin` along `direction`, both taken as they are.
    pub fn new(origin: R::Vec3, direction: R::Vec3) -> Self {
        Ray3 { origin, direction }
    }

    /// Refuses a ray that asks nothing: [`Degenerate::NotFinite`], [`Degenerate::ZeroDirection`], whichever
    /// comes first.
    ///
    /// Where numbers of the object can be refused too, the object's own `check` has the order of the reasons.
    #[inline(always)]
    pub fn check(&self) -> Result<(), Degenerate> {
        if !(self.origin.is_finite() && self.direction.is_finite()) {
            return Err(Degenerate::NotFinite);
        }
        if self.direction.is_zero() {
            return Err(Degenerate::ZeroDirection);
        }
        Ok(())
    }

    /// The point x(t) = p_r + t u_r (House, Eq. 4.1); for an infinite t, see [`Ray2::at`].
    pub fn at(&self, t: R) -> R::Vec3 {
        self.origin.zip(self.direction, |p, u| point(p, t, u))
    }
}

impl<R: Real> Ray2<R> {
    /// A ray from `origin` along `direction`, both taken as they are.
    pub fn new(origin: R::Vec2, direction: R::Vec2) -> Self {
        Ray2 { origin, direction }
    }

    /// The point x(t) = p_r + t u_r (House, Eq. 4.1).
    ///
    /// `t` may be infinite, for a hit beyond the largest number: then a component that does not move
    /// stays where it is, and the others are infinite.
    pub fn at(&self, t: R) -> R::Vec2 {
        self.origin.zip(self.direction, |p, u| point(p, t, u))
    }
}

/// One component of Eq. 4.1. (0 · ∞ would be NaN.)
fn point<R: Real>(p: R, t: R, u: R) -> R {
    if u == R::from(0.0) { p } else { p + t * u }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_point_is_t_directions_away() {
        let ray = Ray3::<f64>::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, -2.0, 4.0));
        assert_eq!(ray.at(0.5), DVec3::new(1.0, 1.0, 5.0));
        assert_eq!(ray.at(0.0), ray.origin);
    }

    #[test]
    fn a_ray_that_asks_nothing_is_refused() {
        let check = |origin, direction| Ray3::<f64>::new(origin, direction).check();
        assert_eq!(check(DVec3::ZERO, DVec3::new(0.0, 5e-324, 0.0)), Ok(()));
        assert_eq!(check(DVec3::ZERO, DVec3::new(0.0, -0.0, 0.0)), Err(Degenerate::ZeroDirection));
        assert_eq!(check(DVec3::NAN, DVec3::ZERO), Err(Degenerate::NotFinite));
        assert_eq!(check(DVec3::ZERO, DVec3::INFINITY), Err(Degenerate::NotFinite));
    }

    #[test]
    fn an_infinite_t_moves_only_what_moves() {
        let ray = Ray3::<f64>::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, -2.0, 4.0));
        let far = ray.at(f64::INFINITY);
        assert_eq!(far, DVec3::new(1.0, f64::NEG_INFINITY, f64::INFINITY));
    }
}

//! House 4.3: how far is a point from a plane?

use math::{Real, Vector};

use crate::Plane;

/// The numbers of House's distance of a point from a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignedDistance<R: Real> {
    /// x − p_0, from the plane's point to x.
    pub from_plane: R::Vec3,
    /// d = n · (x − p_0) with n / ‖n‖ for n, in units of the scene. (House's n has length 1.)
    pub d: R,
}

/// On which side of the plane a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// d > 0: where the normal points.
    Above,
    /// d = 0
    On,
    /// d < 0: by |d|.
    Below,
}

/// Works out House's distance (4.3) of the point `x` from a plane whose normal is not zero; else d is NaN.
pub fn signed_distance<R: Real>(x: R::Vec3, plane: &Plane<R>) -> SignedDistance<R> {
    // exercise d: Which vector leads from the plane's point to x, and how much of it goes along the normal?
    let from_plane = x - plane.point;
    let d = plane.unit_normal().dot(from_plane);
    // end d
    SignedDistance { from_plane, d }
}

impl<R: Real> SignedDistance<R> {
    /// The meaning of the sign. d must not be NaN, which would pass for [`Side::On`].
    pub fn side(&self) -> Side {
        let zero = R::from(0.0);
        // exercise side: What does the sign of d say?
        match () {
            _ if self.d > zero => Side::Above,
            _ if self.d < zero => Side::Below,
            _ => Side::On,
        }
        // end side
    }
}

impl Side {
    /// The word for it: `above`, `on the plane` or `below`.
    pub fn name(self) -> &'static str {
        match self {
            Side::Above => "above",
            Side::On => "on the plane",
            Side::Below => "below",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn three_signs() {
        // by hand: 2x + y + 2z = 9 with ‖(2, 1, 2)‖ = 3; the origin lies 3 below, (3, 3, 6) lies 4 above
        let plane = Plane::<f64> { point: DVec3::new(4.0, 1.0, 0.0), normal: DVec3::new(2.0, 1.0, 2.0) };
        for (x, d, side) in [
            (DVec3::new(3.0, 3.0, 6.0), 4.0, Side::Above),
            (DVec3::new(0.0, 9.0, 0.0), 0.0, Side::On),
            (DVec3::ZERO, -3.0, Side::Below),
        ] {
            let distance = signed_distance(x, &plane);
            assert!((distance.d - d).abs() < 1e-15, "{distance:?}");
            assert_eq!(distance.side(), side);
        }
    }

    #[test]
    fn the_length_of_the_normal_does_not_matter() {
        for length in [1e300, 7.0, 1e-300, 5e-324] {
            let plane = Plane::<f64> { point: DVec3::ZERO, normal: DVec3::Y * length };
            assert_eq!(signed_distance(DVec3::new(1.0, -3.0, 2.0), &plane).d, -3.0, "‖n‖ = {length:e}");
        }
    }

    #[test]
    fn each_side_has_its_word() {
        let words = [Side::Above, Side::On, Side::Below].map(Side::name);
        assert_eq!(words, ["above", "on the plane", "below"]);
    }
}

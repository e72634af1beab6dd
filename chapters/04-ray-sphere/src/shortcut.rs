//! House's distance without House's point: the scalar shortcut that most tracers take.
//!
//! x_close is only needed for its distance d from the center, and by Pythagoras that is a difference of
//! squares: d² = L · L − t_close², with L = c − p_r. Then a² = r² − d². Three multiplications instead of
//! a vector and a root; every graphics library has it, and House does not.
//!
//! On paper it is [`mod@crate::closest_approach`]. In floating point it is the quadratic in disguise:
//! from afar L · L and t_close² are both the distance squared, and d², which decides, is what is left
//! when they cancel. House's ‖x_close − c‖ measures next to the sphere and loses nothing there.

use math::{Degenerate, Ray3, Real, Roots, Span, Vector};

use crate::{Hit3, Sphere};

/// Every number of the scalar shortcut. t is a distance, as with House.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shortcut<R: Real> {
    /// The ray as given.
    pub ray: Ray3<R>,
    /// The sphere.
    pub sphere: Sphere<R>,
    /// ‖D‖, the length of the direction as given.
    pub length: R,
    /// The unit direction.
    pub u_r: R::Vec3,
    /// L = c − p_r, from the origin to the center.
    pub l: R::Vec3,
    /// Where along the ray the center is nearest, as a distance.
    pub t_close: R,
    /// d² = L · L − t_close², the square of the distance there. Rounding can make it negative.
    pub d_squared: R,
    /// a² = r² − d², the square of half the chord; negative for a miss.
    pub a_squared: R,
    /// Half the chord. `None` where a² < 0, a miss.
    pub a: Option<R>,
}

/// Works out the scalar shortcut, for a direction of any length but zero.
///
/// A degenerate ray or sphere gives values that mean nothing; [`Shortcut::hit`] refuses them.
#[inline]
pub fn shortcut<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Shortcut<R> {
    // exercise shortcut: How close does the ray pass the center, by Pythagoras, and how long is half the chord?
    let r = sphere.radius;
    let length = ray.direction.length();
    let u_r = ray.direction / length;

    // The same t_close; then Pythagoras over the way to the center, before the one inside the sphere.
    let l = sphere.center - ray.origin;
    let t_close = u_r.dot(l);
    let d_squared = l.dot(l) - t_close * t_close;
    let a_squared = r * r - d_squared;
    let a = if a_squared < R::from(0.0) { None } else { Some(a_squared.sqrt()) };

    Shortcut { ray: *ray, sphere: *sphere, length, u_r, l, t_close, d_squared, a_squared, a }
    // end shortcut
}

impl<R: Real> Shortcut<R> {
    /// t_close ± a in lengths of the direction as given; `None` for a miss.
    #[inline]
    pub fn roots(&self) -> Option<Roots<R>> {
        // exercise roots: Where does the ray enter and leave, in lengths of the direction as given?
        let a = self.a?;
        Some(Roots { near: (self.t_close - a) / self.length, far: (self.t_close + a) / self.length })
        // end roots
    }

    /// The nearest hit in `span`.
    ///
    /// `None` for a miss, [`Degenerate`] for a question without an answer, see [`Sphere::check`].
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.sphere.first_hit(&self.ray, self.roots(), span)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec3, Vec3};

    #[test]
    fn up_close_it_is_the_same() {
        // by hand: 3-4-5: the center 3 beside the ray, radius 5, t_close 12: 12 ± 4
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::new(0.0, 0.0, 2.0));
        let sphere = Sphere { center: DVec3::new(3.0, 0.0, 12.0), radius: 5.0 };
        let work = shortcut(&ray, &sphere);
        assert_eq!((work.t_close, work.d_squared, work.a), (12.0, 9.0, Some(4.0)));
        assert_eq!(work.roots(), Some(Roots { near: 4.0, far: 8.0 }), "in lengths of (0, 0, 2)");
    }

    /// By hand: the center 5 beside the ray, and 12 ahead: d² = 13² − 12² is r², and nothing of the chord is left.
    #[test]
    fn a_tangent_is_a_hit() {
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
        let work = shortcut(&ray, &Sphere { center: DVec3::new(5.0, 0.0, 12.0), radius: 5.0 });
        assert_eq!((work.a_squared, work.a), (0.0, Some(0.0)));
        assert_eq!(work.roots(), Some(Roots { near: 12.0, far: 12.0 }));
    }

    /// A ray down the z axis past a sphere of radius 1, half a radius outside it: a miss, by a mile.
    #[test]
    fn from_afar_it_sees_spheres_that_are_not_there() {
        let past = |distance: f32| {
            let ray = Ray3::<f32>::new(Vec3::ZERO, Vec3::Z);
            let sphere = Sphere { center: Vec3::new(1.5, 0.0, distance), radius: 1.0 };
            (shortcut(&ray, &sphere), crate::closest_approach(&ray, &sphere))
        };
        // by hand: d² = 2.25, while L · L has a last digit of 8 at a distance of 10 000
        let (shortcut, house) = past(10_000.0);
        assert_eq!((shortcut.d_squared, shortcut.a), (0.0, Some(1.0)), "a hit through the center");
        assert_eq!((house.d, house.a), (1.5, None), "House: a miss");
        assert_eq!(past(10.0).0.a, None, "up close both are right");
    }
}

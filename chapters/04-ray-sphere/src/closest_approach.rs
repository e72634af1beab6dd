//! House 4.4: walk to the point of closest approach, then back by Pythagoras.

use math::{Degenerate, Ray3, Real, Roots, Span, Vector};

use crate::{Hit3, Sphere};

/// Every number of House's method.
///
/// His rays have unit directions, so t is a distance. A direction of any length is made one first;
/// t then comes back in lengths of the direction as given: t = t_House / ‖D‖.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestApproach<R: Real> {
    /// The ray as given.
    pub ray: Ray3<R>,
    /// The sphere.
    pub sphere: Sphere<R>,
    /// ‖D‖, the length of the direction as given; 1 by [`closest_approach_of_unit`].
    pub length: R,
    /// The unit direction.
    pub u_r: R::Vec3,
    /// Where along the ray the center is nearest, as a distance.
    pub t_close: R,
    /// The point there. (The page writes p_r + t u_r; it means t_close.)
    pub x_close: R::Vec3,
    /// Its distance from the center.
    pub d: R,
    /// Half the chord: from x_close to the surface either way. `None` where d > r, a miss.
    pub a: Option<R>,
}

/// Works out House's method (4.4), for a direction of any length but zero.
///
/// A degenerate ray or sphere gives values that mean nothing; [`ClosestApproach::hit`] refuses them.
#[inline]
pub fn closest_approach<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> ClosestApproach<R> {
    let length = ray.direction.length();
    along(ray, sphere, length, ray.direction / length)
}

/// The same for a direction of length 1, as House's have, and no other: nothing is divided, nothing checked.
#[inline]
pub fn closest_approach_of_unit<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> ClosestApproach<R> {
    along(ray, sphere, R::from(1.0), ray.direction)
}

/// House's page, for a ray along u_r.
#[inline]
fn along<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>, length: R, u_r: R::Vec3) -> ClosestApproach<R> {
    let (p_r, c, r) = (ray.origin, sphere.center, sphere.radius);

    // exercise t_close: How long is the shadow that c − p_r casts on the ray?
    // The nearest point to the center is where c − p_r projects onto the ray.
    let t_close = u_r.dot(c - p_r);
    // end t_close
    let x_close = p_r + u_r * t_close;
    let d = (x_close - c).length();

    // exercise a: r, d and a are the sides of a right triangle: how long is a, and when is there none?
    // Pythagoras: a² + d² = r².
    let a = if d <= r { Some((r * r - d * d).sqrt()) } else { None };
    // end a

    ClosestApproach { ray: *ray, sphere: *sphere, length, u_r, t_close, x_close, d, a }
}

impl<R: Real> ClosestApproach<R> {
    /// t_close ± a, as distances along the ray; `None` for a miss.
    #[inline]
    pub fn distances(&self) -> Option<Roots<R>> {
        // exercise distances: Where does the ray enter, and where does it leave?
        self.a.map(|a| Roots { near: self.t_close - a, far: self.t_close + a })
        // end distances
    }

    /// The same in lengths of the direction as given.
    #[inline]
    pub fn roots(&self) -> Option<Roots<R>> {
        self.distances().map(|Roots { near, far }| Roots { near: near / self.length, far: far / self.length })
    }

    /// The nearest hit in `span`: x_hit = p_r + (t_close ∓ a) u_r. (The page takes t_close − a even where
    /// that is behind the origin.)
    ///
    /// `None` for a miss, [`Degenerate`] for a question without an answer, see [`Sphere::check`].
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.sphere.check(&self.ray)?;
        let (Some(distances), Some(roots)) = (self.distances(), self.roots()) else { return Ok(None) };
        let Some(t) = roots.first_within(span) else { return Ok(None) };
        let distance = if span.contains(roots.near) { distances.near } else { distances.far };
        let x_hit = Ray3::<R>::new(self.ray.origin, self.u_r).at(distance);
        Ok(Some(self.sphere.hit_at(t, x_hit)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn through_the_center_it_is_the_distance_less_the_radius() {
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::new(0.0, -1.0, 3.0));
        let sphere = Sphere { center: DVec3::new(0.0, -1.0, 3.0), radius: 1.0 };
        let work = closest_approach(&ray, &sphere);
        // closed form: the center lies at distance √10, on the ray
        assert!((work.t_close - 10.0_f64.sqrt()).abs() < 1e-15);
        assert!(work.d < 1e-15);
        assert_eq!(work.a, Some(1.0));
    }

    /// The page's three cases: d < r, d = r, d > r.
    #[test]
    fn touching_is_a_hit_at_x_close() {
        let sphere = Sphere { center: DVec3::new(0.0, 3.0, 4.0), radius: 3.0 };
        let ray = |height| Ray3::<f64>::new(DVec3::new(0.0, height, 0.0), DVec3::Z);
        let touching = closest_approach(&ray(0.0), &sphere);
        assert_eq!((touching.d, touching.a), (3.0, Some(0.0)));
        assert_eq!(touching.hit(Span::ahead()).unwrap().unwrap().point, touching.x_close);
        assert_eq!(closest_approach(&ray(-0.5), &sphere).distances(), None);
        assert!(closest_approach(&ray(0.5), &sphere).a > Some(0.0));
    }

    /// t comes back in lengths of the direction as given, and n has length 1.
    #[test]
    fn t_house_is_the_length_of_d_times_t() {
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::new(0.0, 0.0, 4.0));
        let sphere = Sphere { center: DVec3::new(0.0, 0.0, 10.0), radius: 2.0 };
        let work = closest_approach(&ray, &sphere);
        // by hand: the sphere reaches from z = 8 to z = 12
        assert_eq!(work.distances(), Some(Roots { near: 8.0, far: 12.0 }));
        assert_eq!(work.roots(), Some(Roots { near: 2.0, far: 3.0 }));
        let hit = work.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point.z, hit.normal), (2.0, 8.0, -DVec3::Z));
        assert_eq!(crate::quadratic(&ray, &sphere).hit(Span::ahead()).unwrap().unwrap().normal, -DVec3::Z);
        // λ = t − 1 for a ray that starts one direction further on
        let from_plane = Ray3::<f64>::new(ray.at(1.0), ray.direction);
        assert_eq!(crate::half_quadratic(&from_plane, &sphere).lambda_2, Some(1.0));
    }

    /// House takes t_close − a whatever its sign (slip 5).
    #[test]
    fn as_printed_a_ray_from_inside_hits_behind_itself() {
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
        let sphere = Sphere { center: DVec3::new(0.0, 0.0, 1.0), radius: 2.0 };
        let work = closest_approach(&ray, &sphere);
        // by hand: the sphere reaches from z = −1 to z = 3
        assert_eq!(work.distances(), Some(Roots { near: -1.0, far: 3.0 }), "as printed: t = −1");
        assert_eq!(work.hit(Span::ahead()).unwrap().unwrap().t, 3.0, "what it hits is the way out");
    }

    /// "x_close = p_r + t u_r" (slip 2): with the t of the hit it is another point.
    #[test]
    fn x_close_stands_at_t_close() {
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
        let sphere = Sphere::<f64> { center: DVec3::new(0.0, 0.5, 4.0), radius: 1.0 };
        let work = closest_approach(&ray, &sphere);
        // the residual: x_close − c is at right angles to the ray
        assert_eq!((work.x_close - sphere.center).dot(ray.direction), 0.0);
        let t = work.distances().unwrap().near;
        assert!((ray.at(t) - sphere.center).dot(ray.direction).abs() > 0.5, "as printed it is not");
    }

    /// Three ways to see a miss that agree on paper (slip 7): of a thousand rays within a few last digits
    /// of a tangent, they disagree about some.
    #[test]
    fn as_printed_three_tests_of_a_miss_disagree() {
        let sphere = Sphere { center: DVec3::new(0.0, 1.0, 3.0), radius: 1.0 };
        let disagree = (0..1000).filter(|&step| {
            let tilt = f64::from(step) * f64::EPSILON / 8.0;
            let ray = Ray3::<f64>::new(DVec3::new(0.1, 0.0, 0.2), DVec3::new(-0.1, tilt, 2.8));
            let work = closest_approach(&ray, &sphere);
            let (l, r) = (sphere.center - ray.origin, sphere.radius);
            let misses =
                [work.d > r, work.d * work.d > r * r, r * r - l.dot(l) + work.t_close * work.t_close < 0.0];
            misses.iter().any(|&miss| miss != misses[0])
        });
        assert!(disagree.count() > 0);
    }
}

//! Gambetta, "Ray Meets Sphere" and Listing 2-5: put the ray into the sphere's equation.

use math::{Degenerate, Ray3, Real, Roots, Span, Vector};

use crate::{Hit3, Sphere};

/// Every number of Gambetta's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic<R: Real> {
    /// The ray O + t D.
    pub ray: Ray3<R>,
    /// The sphere.
    pub sphere: Sphere<R>,
    /// CO = O − C, from the center to the origin of the ray.
    pub co: R::Vec3,
    /// a = ⟨D, D⟩
    pub a: R,
    /// b = 2⟨CO, D⟩
    pub b: R,
    /// c = ⟨CO, CO⟩ − r²
    pub c: R,
    /// b² − 4ac: its sign tells how many roots there are.
    pub discriminant: R,
    /// (−b + √discriminant) / 2a, the larger root, in lengths of D. `None` where the discriminant is negative
    /// (the listing returns inf, which its caller's [1, inf] contains).
    pub t1: Option<R>,
    /// (−b − √discriminant) / 2a, the smaller root, likewise.
    pub t2: Option<R>,
}

/// Works out Gambetta's method (Listing 2-5), for a direction of any length but zero.
///
/// A degenerate ray or sphere gives values that mean nothing; [`Quadratic::hit`] refuses them.
#[inline]
pub fn quadratic<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Quadratic<R> {
    let (two, four) = (R::from(2.0), R::from(4.0));
    let r = sphere.radius;
    let co = ray.origin - sphere.center;

    // exercise coefficients: With O + tD in the sphere's equation, what stands with t², with t, and alone?
    // ⟨CO + tD, CO + tD⟩ = r², sorted by powers of t: a t² + b t + c = 0.
    let a = ray.direction.dot(ray.direction);
    let b = two * co.dot(ray.direction);
    let c = co.dot(co) - r * r;
    // end coefficients

    // exercise discriminant: What stands under the root in the solution, and when is there no root?
    let discriminant = b * b - four * a * c;
    let root: Option<R> = if discriminant < R::from(0.0) { None } else { Some(discriminant.sqrt()) };
    // end discriminant
    // exercise solutions: What are the two solutions, t1 the larger and t2 the smaller?
    let t1 = root.map(|root| (-b + root) / (two * a));
    let t2 = root.map(|root| (-b - root) / (two * a));
    // end solutions

    Quadratic { ray: *ray, sphere: *sphere, co, a, b, c, discriminant, t1, t2 }
}

impl<R: Real> Quadratic<R> {
    /// t2 and t1, the smaller first; `None` for a miss.
    #[inline]
    pub fn roots(&self) -> Option<Roots<R>> {
        Some(Roots { near: self.t2?, far: self.t1? })
    }

    /// The nearest hit in `span` (Listing 2-4's t_min and t_max).
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
    use glam::DVec3;

    #[test]
    fn the_roots_solve_the_equation() {
        // by hand: z from 3 to 5 with D = (0, 0, 2), so t = 1.5 and 2.5
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::new(0.0, 0.0, 2.0));
        let sphere = Sphere { center: DVec3::new(0.0, 0.0, 4.0), radius: 1.0 };
        let work = quadratic(&ray, &sphere);
        assert_eq!((work.t2, work.t1), (Some(1.5), Some(2.5)));
    }

    /// Listing 2-5 with a zero direction divides 0 by 0 (slip 10).
    #[test]
    fn as_printed_a_zero_direction_gives_nan() {
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::ZERO);
        let sphere = Sphere { center: DVec3::new(0.0, 0.0, 4.0), radius: 1.0 };
        let work = quadratic(&ray, &sphere);
        assert!(work.t1.is_some_and(f64::is_nan), "as printed");
        assert_eq!(work.hit(Span::ahead()), Err(Degenerate::ZeroDirection));
    }

    /// Listing 2-5 reports a miss as inf, and inf lies in [1, inf] (slip 10).
    #[test]
    fn as_printed_a_miss_lies_in_the_span() {
        // Listing 2-4 with the strict `<` and with a careless `<=`
        let (t1, t_min, t_max, closest_t) = (f64::INFINITY, 1.0, f64::INFINITY, f64::INFINITY);
        let in_span = t_min <= t1 && t1 <= t_max;
        assert!(in_span && t1 <= closest_t, "as printed, a miss is in the span");
        assert!(!(in_span && t1 < closest_t), "saved by the strict comparison");
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::X);
        let sphere = Sphere { center: DVec3::new(0.0, 0.0, 4.0), radius: 1.0 };
        assert_eq!(quadratic(&ray, &sphere).hit(Span::from_view_plane()), Ok(None));
    }

    /// The text says t > 1, the listing admits t = 1 (slip 9).
    #[test]
    fn a_sphere_touching_the_view_plane_is_seen() {
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
        let sphere = Sphere { center: DVec3::new(0.0, 0.0, 2.0), radius: 1.0 };
        let span = Span::from_view_plane();
        assert_eq!(quadratic(&ray, &sphere).hit(span).unwrap().unwrap().t, 1.0, "the listing");
        assert!(!span.surrounds(1.0), "the text");
    }

    /// One of −b ± √… cancels when b² ≫ |4ac| (slip 10): a large sphere, and the eye close to it.
    #[test]
    fn the_root_near_a_large_sphere_cancels() {
        // the exact t of this ray, by integer arithmetic: row 14.2404… of the case file ray-sphere.csv
        let ray = Ray3::<f64>::new(
            DVec3::new(1.9952313207334456, 3.7661753132419973, -0.19725060181439602),
            DVec3::new(-0.5654075000796883, -0.2644705215195315, -0.8248117111520891),
        );
        let radius = 226272073.4487939;
        let sphere = Sphere { center: DVec3::new(0.0, -radius, 0.0), radius };
        let exact = 14.240436657507502;
        let t = quadratic(&ray, &sphere).t2.unwrap();
        assert!((t - exact).abs() / exact > 1e-9, "as printed: {t} for {exact}");
        let robust = crate::robust(&ray, &sphere).roots().unwrap().near;
        assert!((robust - exact).abs() <= 4.0 * f64::EPSILON * exact, "robust: {robust} for {exact}");
    }
}

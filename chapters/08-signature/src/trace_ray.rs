//! Gambetta's `TraceRay`, Listing 2-4, for any shape.

use math::{Ray3, Real, Span};

use crate::{First, Hit3, Method, Object};

/// `TraceRay(O, D, t_min, t_max)`: the object with the smallest t in [t_min, t_max], by the listing's
/// `t in [t_min, t_max] and t < closest_t`.
///
/// The listing looks at both roots of a sphere, and each shape's own chapter has done so when it gives its nearest t
/// in the range. With [`Span::ahead`] it is [`fn@crate::first_hit`] by another name; the page's main method asks for
/// [1, inf], and what stands between the eye and the view plane is not seen.
///
/// `None` where the ray hits nothing in the range. The ray must be a ray: [`Ray3::check`].
pub fn trace_ray<R: Real>(
    method: Method,
    ray: &Ray3<R>,
    objects: &[Object<R>],
    [t_min, t_max]: [R; 2],
) -> Option<First<R>> {
    let mut closest_t = R::INFINITY;
    let mut closest_object = None;
    for (object, it) in objects.iter().enumerate() {
        // exercise in_range: Which hit of this object counts, if any?
        let hit: Option<Hit3<R>> = it.shape.hit(method, ray, Span::new(t_min, t_max));
        // end in_range
        let Some(hit) = hit else { continue };
        // exercise closest: When is this hit the closest so far, and what has to be remembered then?
        // a t beyond the largest number is a hit too, and there is none before it
        if hit.t < closest_t || closest_object.is_none() {
            closest_t = hit.t;
            closest_object = Some(object);
        }
        // end closest
    }
    closest_object.map(|object| First { object, lambda: closest_t })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;
    use glam::DVec3;
    use ray_sphere::Sphere;

    /// Of two that are hit at the same t the listing keeps the first.
    #[test]
    fn of_two_at_the_same_t_the_first_is_kept() {
        let sphere =
            Object { id: None, shape: Shape::Sphere(Sphere { center: DVec3::Z * 3.0, radius: 1.0 }) };
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
        let first = trace_ray(Method::Robust, &ray, &[sphere.clone(), sphere], [0.0, f64::INFINITY]);
        assert_eq!(first, Some(First { object: 0, lambda: 2.0 }));
    }

    /// By hand, Figure 2-10: from the origin the ray (0, −1/3, 1) meets the red sphere, whose center is (0, −1, 3). One more
    /// sphere stands before the view plane, where t < 1.
    #[test]
    fn what_stands_before_the_view_plane_is_not_in_gambettas_range() {
        let sphere = |center, radius| Object { id: None, shape: Shape::Sphere(Sphere { center, radius }) };
        let objects = [
            sphere(DVec3::new(0.0, -1.0, 3.0), 1.0),
            sphere(DVec3::new(2.0, 0.0, 4.0), 1.0),
            sphere(DVec3::new(-2.0, 0.0, 4.0), 1.0),
            sphere(DVec3::new(0.0, -0.125, 0.375), 0.25),
        ];
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::new(0.0, -1.0 / 3.0, 1.0));
        for method in Method::ALL {
            let seen = |t_min| trace_ray(method, &ray, &objects, [t_min, f64::INFINITY]).map(|it| it.object);
            assert_eq!(seen(1.0), Some(0));
            assert_eq!(seen(0.0), Some(3));
            assert_eq!(trace_ray(method, &ray, &objects, [5.0, f64::INFINITY]), None);
        }
    }
}

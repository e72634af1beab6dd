//! CSC418 11.4: the first object that a ray hits.

use math::{Ray3, Real, Span};

use crate::{First, Method, Object, Scene};

/// The page's loop over all objects: the one with the smallest λ* in `span`, and of several with the same λ* the
/// earliest, by the page's strict λ* < λ_ij.
///
/// `None` where the ray hits nothing, which the page leaves unsaid. The ray must be a ray: [`Ray3::check`].
pub fn first_hit<R: Real>(
    method: Method,
    ray: &Ray3<R>,
    objects: &[Object<R>],
    span: Span<R>,
) -> Option<First<R>> {
    // λ_ij ← ∞
    let mut first: Option<First<R>> = None;
    for (object, it) in objects.iter().enumerate() {
        // find λ* for the closest intersection of the ray and the object
        let Some(hit) = it.shape.hit(method, ray, span) else { continue };
        let lambda = hit.t;
        // exercise nearer: When does this object take the place of the one before, and what is kept of it?
        // if λ* < λ_ij then λ_ij ← λ*, sig[i, j] ← objID_k
        if first.is_none_or(|first| lambda < first.lambda) {
            first = Some(First { object, lambda });
        }
        // end nearer
    }
    first
}

impl<R: Real> Scene<R> {
    /// The place of the object that a pixel sees first, from 0; `None` where it sees nothing.
    ///
    /// Hits count from the eye on, λ ≥ 0.
    pub fn seen(&self, method: Method, pixel: (u32, u32)) -> Option<usize> {
        // exercise seen: Which ray belongs to the pixel, and which of its hits can the eye see?
        Some(first_hit(method, &self.ray(pixel), &self.objects, Span::ahead())?.object)
        // end seen
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;
    use glam::DVec3;
    use ray_plane::Plane;
    use ray_sphere::Sphere;

    fn sphere(z: f64) -> Object<f64> {
        Object { id: None, shape: Shape::Sphere(Sphere { center: DVec3::new(0.0, 0.0, z), radius: 1.0 }) }
    }

    /// By hand: a unit sphere around (0, 0, z) begins at z − 1.
    #[test]
    fn the_smallest_lambda_wins_and_on_a_tie_the_earlier_object() {
        let wall = Object {
            id: None,
            shape: Shape::Plane(Plane { point: DVec3::new(0.0, 0.0, 4.0), normal: DVec3::Z }),
        };
        let ray = Ray3::new(DVec3::ZERO, DVec3::Z);
        for method in Method::ALL {
            let first = |objects: &[Object<f64>]| {
                first_hit(method, &ray, objects, Span::ahead()).map(|first| (first.object, first.lambda))
            };
            assert_eq!(first(&[sphere(9.0), sphere(5.0), wall.clone(), sphere(7.0)]), Some((1, 4.0)));
            assert_eq!(first(&[wall.clone(), sphere(5.0)]), Some((0, 4.0)));
            assert_eq!(first(&[sphere(-5.0)]), None, "behind the eye");
            assert_eq!(first(&[]), None);
            assert_eq!(first(&[sphere(0.0)]), Some((0, 1.0)), "the eye is in it: where the ray leaves");
            assert_eq!(first(&[sphere(1.0)]), Some((0, 0.0)), "the eye is on it");
        }
    }

    /// By hand: at (0, 0, 1e300) with a direction of 1e−300 λ* is 1e600.
    #[test]
    fn as_printed_a_hit_beyond_the_largest_number_is_lost() {
        let point = DVec3::new(0.0, 0.0, 1e300);
        let wall = Object::<f64> { id: None, shape: Shape::Plane(Plane { point, normal: DVec3::Z }) };
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::new(0.0, 0.0, 1e-300));
        let first = first_hit(Method::Robust, &ray, &[wall], Span::ahead()).unwrap();
        assert_eq!(first.lambda, f64::INFINITY);
        let as_printed = first.lambda < f64::INFINITY;
        assert!(!as_printed);
    }
}

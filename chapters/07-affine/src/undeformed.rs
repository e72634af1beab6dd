//! A ray against the unit objects, each by the notes' own formula.

use math::{Hit, Ray3, Real, Span};
use quadric::Shape;
use ray_sphere::{HalfQuadratic, Sphere, half_quadratic};

use crate::{Hit3, Object};

/// One object's own method, with its intermediate values, for the ray a′ + λ d′.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Undeformed<R: Real> {
    /// The sphere: 11.3.3.
    Sphere(HalfQuadratic<R>),
    /// The cylinder and the cone: 11.3.5.
    Solid(quadric::Notes<R>),
    /// The plane z = 0.
    Plane(Level<R>),
    /// The triangle in it.
    Triangle(Level<R>),
}

/// Where a ray meets the plane z = 0: (a′ + λ d′) · e_z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level<R: Real> {
    /// λ* = −a′_z / d′_z. Infinite or NaN where d′_z = 0.
    pub lambda: R,
    /// r′(λ*). In the triangle its x and y are α and β. Not finite where λ* is not.
    pub p: R::Vec3,
}

impl<R: Real> Level<R> {
    /// Works it out.
    #[inline]
    fn of(ray: &Ray3<R>) -> Level<R> {
        let ([_, _, a_z], [_, _, d_z]) = (R::xyz(ray.origin), R::xyz(ray.direction));
        let lambda = -a_z / d_z;
        Level { lambda, p: ray.at(lambda) }
    }

    /// α ≥ 0, β ≥ 0 and α + β ≤ 1 (11.3.1).
    #[inline]
    pub fn is_in_triangle(&self) -> bool {
        let ([alpha, beta, _], zero, one) = (R::xyz(self.p), R::from(0.0), R::from(1.0));
        alpha >= zero && beta >= zero && alpha + beta <= one
    }

    #[inline]
    fn hit(&self) -> Hit3<R> {
        let (zero, one) = (R::from(0.0), R::from(1.0));
        Hit { t: self.lambda, point: self.p, normal: R::vec3(zero, zero, one) }
    }
}

/// Works out the object's own method, for a ray in its space with a direction of any length but zero.
#[inline]
pub fn undeformed<R: Real>(object: Object, ray: &Ray3<R>) -> Undeformed<R> {
    match object {
        Object::Sphere => {
            let (zero, one) = (R::from(0.0), R::from(1.0));
            Undeformed::Sphere(half_quadratic(
                ray,
                &Sphere { center: R::vec3(zero, zero, zero), radius: one },
            ))
        }
        Object::Cylinder => Undeformed::Solid(quadric::notes(ray, Shape::Cylinder)),
        Object::Cone => Undeformed::Solid(quadric::notes(ray, Shape::Cone)),
        Object::Plane => Undeformed::Plane(Level::of(ray)),
        Object::Triangle => Undeformed::Triangle(Level::of(ray)),
    }
}

impl<R: Real> Undeformed<R> {
    /// The hit at the smallest λ in `span`, in the object's own space; `None` for a miss, and where a number is NaN.
    /// The normal of a flat object is (0, 0, 1), whichever side the ray comes from.
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Option<Hit3<R>> {
        match self {
            Undeformed::Sphere(work) => {
                let lambda = work.roots()?.first_within(span)?;
                let p = work.ray.at(lambda);
                Some(Hit { t: lambda, point: p, normal: p })
            }
            // What overflowed on the way here is no fault of the question: a miss.
            Undeformed::Solid(work) => work.hit(span).ok().flatten(),
            Undeformed::Plane(level) => span.contains(level.lambda).then(|| level.hit()),
            Undeformed::Triangle(level) => {
                (span.contains(level.lambda) && level.is_in_triangle()).then(|| level.hit())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn the_triangle_has_its_edges_and_corners() {
        for (x, y, hits) in [
            (0.25, 0.25, true),
            (0.0, 0.0, true),
            (1.0, 0.0, true),
            (0.0, 1.0, true),
            (0.5, 0.5, true),
            (0.5, 0.5625, false),
            (-0.125, 0.5, false),
            (0.5, -0.125, false),
        ] {
            let ray = Ray3::<f64>::new(DVec3::new(x, y, 2.0), DVec3::new(0.0, 0.0, -0.5));
            let hit = undeformed(Object::Triangle, &ray).hit(Span::ahead());
            assert_eq!(hit.map(|hit| hit.t), hits.then_some(4.0), "({x}, {y})");
        }
    }

    #[test]
    fn what_is_not_a_number_is_a_miss() {
        for object in Object::ALL {
            let ray = Ray3::<f64>::new(DVec3::splat(f64::INFINITY), DVec3::splat(f64::NAN));
            assert_eq!(undeformed(object, &ray).hit(Span::ahead()), None);
        }
    }
}

//! The shapes of a scene, each met by its own chapter.

use affine::Deformed;
use math::{Degenerate, Glance, Parallel, Ray3, Real, Span};
use quadric::open::OpenCone;
use ray_plane::{Meeting, Plane};
use ray_sphere::{Line, Sphere};
use triangle::Triangle;
use triangle::mesh::Mesh;
use triangle::polygon::{Polygon, Rule};

use crate::{Hit3, Method};

/// A shape where it stands in the world.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape<R: Real> {
    /// Chapter 03.
    Plane(Plane<R>),
    /// Chapter 04.
    Sphere(Sphere<R>),
    /// Chapter 05.
    Triangle(Triangle<R>),
    /// Chapter 05: its inside by the even-odd rule.
    Polygon(Polygon<R>),
    /// Chapter 05.
    Mesh(Mesh<R>),
    /// Chapter 06: the unit cylinder or cone, undeformed.
    Solid(quadric::Shape),
    /// Chapter 06: NFF's cone, without caps.
    OpenCone(OpenCone<R>),
    /// Chapter 07: a sphere, cylinder or cone by (A, t). It keeps much that depends on A alone: in a box of its own, so that a
    /// list of spheres stays short.
    Deformed(Box<Deformed<R>>),
}

impl<R: Real> Shape<R> {
    /// The nearest hit in `span`, by the method of the shape's own chapter; `None` for a miss, and for a
    /// shape that its chapter refuses. The ray must be a ray: [`Ray3::check`].
    pub fn hit(&self, method: Method, ray: &Ray3<R>, span: Span<R>) -> Option<Hit3<R>> {
        let hit = match method {
            Method::Robust => self.robust(ray, span),
            Method::Notes => self.notes(ray, span),
        };
        // Degenerate shapes are refused when the scene is made.
        hit.ok().flatten()
    }

    fn robust(&self, ray: &Ray3<R>, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        match self {
            Shape::Plane(plane) => ray_plane::robust(ray, plane).hit(span),
            Shape::Sphere(sphere) => ray_sphere::robust::hit(ray, sphere, span),
            Shape::Triangle(triangle) => triangle::robust(ray, triangle).hit(span),
            Shape::Polygon(polygon) => polygon.hit(ray, span),
            Shape::Mesh(mesh) => Ok(mesh.hit(triangle::Method::Robust, ray, span)?.map(|seen| seen.hit)),
            Shape::Solid(shape) => quadric::robust(ray, *shape).hit(span),
            Shape::OpenCone(cone) => quadric::open::robust(ray, cone).hit(span),
            Shape::Deformed(deformed) => affine::robust(ray, deformed).hit(span),
        }
    }

    fn notes(&self, ray: &Ray3<R>, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        match self {
            Shape::Plane(plane) => ray_plane::notes(ray, plane).hit(span),
            Shape::Sphere(sphere) => ray_sphere::half_quadratic(ray, sphere).hit(span),
            Shape::Triangle(triangle) => triangle::matrix(ray, triangle).hit(span),
            Shape::Polygon(polygon) => polygon.hit_by(ray_plane::Method::Notes, Rule::EvenOdd, ray, span),
            Shape::Mesh(mesh) => Ok(mesh.hit(triangle::Method::Matrix, ray, span)?.map(|seen| seen.hit)),
            Shape::Solid(shape) => quadric::notes(ray, *shape).hit(span),
            Shape::OpenCone(cone) => quadric::open::notes(ray, cone).hit(span),
            Shape::Deformed(deformed) => affine::notes(ray, deformed).hit(span),
        }
    }

    /// What plain `f64` says of the robust method's answer at a glance: [`Glance::Unsure`] for all that is of
    /// chapter 07, for the unit solids, and for a mesh, of which it is asked face by face. The ray must be a
    /// ray, and `line` its line.
    #[inline(always)]
    pub fn glance(&self, ray: &Ray3<R>, line: &Line) -> Glance {
        match self {
            Shape::Plane(plane) => ray_plane::glance(ray, plane),
            Shape::Sphere(sphere) => ray_sphere::glance(line, sphere),
            Shape::Triangle(triangle) => triangle::glance(ray, triangle),
            Shape::Polygon(polygon) => polygon.glance(ray),
            Shape::OpenCone(cone) => quadric::open::glance(ray, cone),
            Shape::Mesh(_) | Shape::Solid(_) | Shape::Deformed(_) => Glance::Unsure,
        }
    }

    /// How the ray runs along a flat shape, exactly; `None` where it meets its plane, for a solid or an open
    /// cone, and for a mesh, which has many planes. The ray must be a ray.
    pub fn parallel(&self, ray: &Ray3<R>) -> Option<Parallel> {
        match self {
            Shape::Plane(plane) => match ray_plane::robust(ray, plane).meeting() {
                Meeting::Never(how) => Some(how),
                Meeting::At(_) => None,
            },
            Shape::Triangle(triangle) => triangle::robust(ray, triangle).parallel(),
            Shape::Polygon(polygon) => polygon.parallel(ray),
            Shape::Deformed(deformed) => deformed.parallel(ray),
            Shape::Sphere(_) | Shape::Mesh(_) | Shape::Solid(_) | Shape::OpenCone(_) => None,
        }
    }

    /// What it is called.
    pub fn name(&self) -> &'static str {
        match self {
            Shape::Plane(_) => "plane",
            Shape::Sphere(_) => "sphere",
            Shape::Triangle(_) => "triangle",
            Shape::Polygon(_) => "polygon",
            Shape::Mesh(_) => "mesh",
            Shape::Solid(shape) => shape.name(),
            Shape::OpenCone(_) => "open cone",
            Shape::Deformed(deformed) => match deformed.object {
                affine::Object::Sphere => "sphere, deformed",
                affine::Object::Cylinder => "cylinder, deformed",
                affine::Object::Cone => "cone, deformed",
                affine::Object::Plane => "plane, deformed",
                affine::Object::Triangle => "triangle, deformed",
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// Of each flat shape in the plane z = 0, and of one that is round.
    #[test]
    fn a_ray_along_a_flat_shape_is_parallel() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let flat = affine::Affine { a: affine::Matrix3::identity(), t: DVec3::ZERO };
        let ray =
            |z: f64, slope: f64| Ray3::<f64>::new(DVec3::new(-1.0, 0.25, z), DVec3::new(1.0, 0.0, slope));
        for shape in [
            Shape::Plane(Plane { point: DVec3::ZERO, normal: DVec3::Z }),
            Shape::Triangle(Triangle { p1: corners[0], p2: corners[1], p3: corners[2] }),
            Shape::Polygon(Polygon::new(corners.to_vec()).unwrap()),
            Shape::Deformed(Box::new(Deformed::new(affine::Object::Plane, flat).unwrap())),
        ] {
            assert_eq!(shape.parallel(&ray(1.0, 0.0)), Some(Parallel::Apart), "{}", shape.name());
            assert_eq!(shape.parallel(&ray(0.0, 0.0)), Some(Parallel::Within), "{}", shape.name());
            assert_eq!(shape.parallel(&ray(1.0, -1.0)), None, "{}", shape.name());
        }
        let round = Shape::Sphere(Sphere { center: DVec3::ZERO, radius: 1.0 });
        assert_eq!(round.parallel(&ray(2.0, 0.0)), None);
    }
}

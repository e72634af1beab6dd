//! The objects of a scene file.

use std::fmt::Display;

use affine::Affine;
use math::{Degenerate, Ray3, Real, Vector};
use quadric::open::OpenCone;
use ray_plane::Plane;
use ray_sphere::Sphere;
use scene_file::{Error, Place};
use triangle::Triangle;
use triangle::mesh::Mesh;
use triangle::polygon::Polygon;

use super::{or_f64, vector};
use crate::{Object, Shape, Transform, deform};

/// An object where it stands in the world.
pub(super) fn object<R: Real>(file: &scene_file::Scene, it: &scene_file::Object) -> Result<Object<R>, Error> {
    let steps: Vec<Transform> = it.transform.iter().map(|step| transform(step.value)).collect();
    let by = deform::composed(&steps);
    let by = if steps.is_empty() { None } else { Some(&by) };
    let refuse = Refuse { file, it };
    if let Some(by) = by {
        by.check().map_err(|degenerate| refuse.degenerate::<R>(degenerate))?;
    }
    Ok(Object { id: it.id, shape: shape(&it.shape, by, &refuse)? })
}

/// A step of a file's transform, in the words of [`mod@crate::deform`].
pub fn transform(step: scene_file::Transform) -> Transform {
    match step {
        scene_file::Transform::Scale(factors) => Transform::Scale(factors),
        scene_file::Transform::Rotate { axis, degrees } => Transform::Rotate { axis, degrees },
        scene_file::Transform::Translate(by) => Transform::Translate(by),
        scene_file::Transform::Matrix(rows) => Transform::Matrix(rows),
    }
}

/// A shape, deformed where there is a deformation.
fn shape<R: Real>(
    it: &scene_file::Shape,
    by: Option<&Affine<f64>>,
    refuse: &Refuse<'_>,
) -> Result<Shape<R>, Error> {
    let degenerate = |what| refuse.degenerate::<R>(what);
    let moved = |point: [f64; 3]| match by {
        Some(by) => vector::<R>(by.apply(point.into()).in_f64()),
        None => vector::<R>(point),
    };
    let all_moved = |points: &[[f64; 3]]| {
        let moved: Vec<R::Vec3> = points.iter().copied().map(moved).collect();
        let held = moved.iter().all(|point| point.is_finite());
        if held { Ok(moved) } else { Err(degenerate(Degenerate::NotFinite)) }
    };
    match it {
        scene_file::Shape::Plane { point, normal } => {
            let plane = Plane { point: (*point).into(), normal: (*normal).into() };
            let plane = by.map_or(plane, |by| deform::plane(&plane, by));
            // the length of a normal means nothing, and in R it might overflow or vanish
            let normal = plane.normal.normalized();
            let plane =
                Plane { point: vector::<R>(plane.point.in_f64()), normal: vector::<R>(normal.in_f64()) };
            plane.check(&any_ray()).map_err(degenerate)?;
            Ok(Shape::Plane(plane))
        }
        scene_file::Shape::Sphere { center, radius } => match by {
            Some(by) => {
                deform::sphere(&Sphere { center: (*center).into(), radius: *radius }, by).map_err(degenerate)
            }
            None => {
                let sphere = Sphere { center: vector::<R>(*center), radius: R::round_from(*radius) };
                sphere.check(&any_ray()).map_err(degenerate)?;
                Ok(Shape::Sphere(sphere))
            }
        },
        scene_file::Shape::Triangle { vertices } => triangle(vertices.map(moved)).map_err(degenerate),
        // the same points, by a shorter way
        scene_file::Shape::Polygon { vertices } if vertices.len() == 3 => {
            triangle([0, 1, 2].map(|corner| moved(vertices[corner]))).map_err(degenerate)
        }
        scene_file::Shape::Polygon { vertices } => {
            let polygon = Polygon::new(all_moved(vertices)?);
            polygon.map(Shape::Polygon).map_err(|why| refuse.shape(&why))
        }
        scene_file::Shape::Cylinder => solid(quadric::Shape::Cylinder, by).map_err(degenerate),
        scene_file::Shape::Cone => solid(quadric::Shape::Cone, by).map_err(degenerate),
        scene_file::Shape::Mesh { mesh, smooth } => {
            let vertices = all_moved(&mesh.vertices)?;
            let faces = mesh.faces.iter().map(|face| face.map(|vertex| vertex as usize)).collect();
            let flat = Mesh::<R>::new(vertices, faces).map_err(|why| refuse.shape(&why))?;
            match (*smooth, mesh.normals.is_empty()) {
                (false, _) => Ok(Shape::Mesh(flat)),
                (true, true) => Ok(Shape::Mesh(flat.smooth())),
                (true, false) => {
                    let normals: Vec<_> = mesh
                        .normals
                        .iter()
                        .map(|corners| corners.map(|normal| normal.map(|normal| turned::<R>(normal, by))))
                        .collect();
                    flat.with_normals(&normals).map(Shape::Mesh).map_err(|why| refuse.shape(&why))
                }
            }
        }
        scene_file::Shape::OpenCone { base, base_radius, apex, apex_radius } => {
            let [base_radius, apex_radius] = [*base_radius, *apex_radius].map(R::round_from);
            let cone = OpenCone::new(vector::<R>(*base), base_radius, vector::<R>(*apex), apex_radius);
            cone.check(&any_ray()).map_err(degenerate)?;
            Ok(Shape::OpenCone(cone))
        }
        scene_file::Shape::Patch { vertices, normals } => {
            let fan: Vec<[usize; 3]> = (2..vertices.len()).map(|corner| [0, corner - 1, corner]).collect();
            let at_corners: Vec<[Option<R::Vec3>; 3]> =
                fan.iter().map(|face| face.map(|vertex| Some(turned::<R>(normals[vertex], by)))).collect();
            let vertices = all_moved(vertices)?;
            let mesh = Mesh::new(vertices, fan).and_then(|flat| flat.with_normals(&at_corners));
            mesh.map(Shape::Mesh).map_err(|why| refuse.shape(&why))
        }
    }
}

fn triangle<R: Real>([p1, p2, p3]: [R::Vec3; 3]) -> Result<Shape<R>, Degenerate> {
    let triangle = Triangle { p1, p2, p3 };
    triangle.check(&any_ray())?;
    Ok(Shape::Triangle(triangle))
}

fn solid<R: Real>(solid: quadric::Shape, by: Option<&Affine<f64>>) -> Result<Shape<R>, Degenerate> {
    match by {
        Some(by) => deform::solid(solid, by),
        None => Ok(Shape::Solid(solid)),
    }
}

/// A normal of a mesh, deformed; without a direction where it has none.
fn turned<R: Real>(normal: [f64; 3], by: Option<&Affine<f64>>) -> R::Vec3 {
    vector::<R>(by.map_or(normal, |by| deform::normal(normal.into(), &by.a).in_f64()))
}

/// A ray with nothing wrong about it, to ask a shape whether anything is wrong about the shape.
fn any_ray<R: Real>() -> Ray3<R> {
    Ray3::new(vector::<R>([0.0; 3]), vector::<R>([0.0, 0.0, 1.0]))
}

/// Says what is wrong about an object, at its place.
struct Refuse<'a> {
    file: &'a scene_file::Scene,
    it: &'a scene_file::Object,
}

impl Refuse<'_> {
    /// Where its transform stands, from the first step to the last; the object where it has none.
    fn place(&self) -> Place {
        match (self.it.transform.first(), self.it.transform.last()) {
            (Some(first), Some(last)) => Place { start: first.place.start, end: last.place.end },
            _ => self.it.place,
        }
    }

    fn degenerate<R: Real>(&self, why: Degenerate) -> Error {
        let (place, file) = (self.it.place, self.file);
        match why {
            Degenerate::NotFinite => file.fault(
                place,
                &format!("a number of this object is too large for {}", R::NAME),
                &or_f64::<R>("make it smaller"),
            ),
            Degenerate::Singular => file.fault(
                self.place(),
                &format!("the transform has no inverse in {}: it presses the object flat", R::NAME),
                &or_f64::<R>("write steps that leave it a volume"),
            ),
            Degenerate::NoArea => file.fault(
                place,
                &format!("the triangle has no area: its corners lie on one line in {}", R::NAME),
                &or_f64::<R>("move a corner off the line"),
            ),
            other => file.fault(
                place,
                &format!("{other} in {}", R::NAME),
                &or_f64::<R>("give the object an extent"),
            ),
        }
    }

    /// What a polygon or a mesh says of itself: `PROBLEM: REMEDY`.
    fn shape(&self, why: &dyn Display) -> Error {
        let why = why.to_string();
        let (problem, remedy) = why.rsplit_once(": ").unwrap_or((&why, "mend the shape"));
        self.file.fault(self.it.place, problem, remedy)
    }
}

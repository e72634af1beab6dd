//! What is tested: the objects of a scene, a mesh face by face, each with its box.

use std::ops::Range;

use math::{Glance, Ray3, Real, Span, Vector};
use ray_sphere::Line;
use signature::{Hit3, Method, Scene, Shape};

use crate::Box3;

/// The objects of a scene in parts: a mesh has a part for each of its faces, every other object is one.
///
/// Parts are in the order of the objects and of their faces, so that on a tie the earlier part is the one
/// that the signature's loop sees.
#[derive(Debug)]
pub struct Parts<'a, R: Real> {
    all: Vec<Part<'a, R>>,
    /// For each object its parts.
    of_object: Vec<Range<usize>>,
}

/// One of the things that a ray is tested against.
#[derive(Clone, Copy, Debug)]
struct Part<'a, R: Real> {
    /// Its object's shape, where a search needs nothing else.
    shape: &'a Shape<R>,
    /// Its object's place in the scene.
    object: u32,
    /// Its face's place in the mesh; 0 for an object that is none.
    face: u32,
}

impl<'a, R: Real> Parts<'a, R> {
    /// The parts of a scene.
    pub fn of(scene: &'a Scene<R>) -> Parts<'a, R> {
        let (mut all, mut of_object) = (Vec::new(), Vec::new());
        for (object, it) in scene.objects.iter().enumerate() {
            let first = all.len();
            let faces = if let Shape::Mesh(mesh) = &it.shape { mesh.faces().len() } else { 1 };
            all.extend((0..faces as u32).map(|face| Part { shape: &it.shape, object: object as u32, face }));
            of_object.push(first..all.len());
        }
        Parts { all, of_object }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// The parts of an object.
    pub fn of_object(&self, object: usize) -> Range<usize> {
        self.of_object[object].clone()
    }

    /// The place of a part's object in the scene.
    pub fn object(&self, part: usize) -> usize {
        self.all[part].object as usize
    }

    /// The shape of a part's object.
    #[inline(always)]
    pub fn shape(&self, part: usize) -> &'a Shape<R> {
        self.all[part].shape
    }

    /// The face that a part is, of a mesh: its place among the mesh's faces. `None` for an object that is no
    /// mesh.
    pub fn face(&self, part: usize) -> Option<usize> {
        let Part { shape, face, .. } = self.all[part];
        matches!(shape, Shape::Mesh(_)).then_some(face as usize)
    }

    /// The t of the nearest hit of a part in `span`, by the robust method of its chapter, whose verdict is
    /// exact: so what a bound leaves out would not have been hit. `None` for a miss. The ray must be a ray.
    #[inline]
    pub fn hit(&self, part: usize, ray: &Ray3<R>, span: Span<R>) -> Option<R> {
        self.whole_hit(Method::Robust, part, ray, span).map(|hit| hit.t)
    }

    /// What plain `f64` says of that at a glance, see [`Shape::glance`].
    #[inline(always)]
    pub fn glance(&self, part: usize, ray: &Ray3<R>, line: &Line) -> Glance {
        let Part { shape, face, .. } = self.all[part];
        match shape {
            Shape::Mesh(mesh) => triangle::glance(ray, &mesh.triangle(face as usize)),
            shape => shape.glance(ray, line),
        }
    }

    /// The nearest hit of a part in `span` with the point and the unit normal, by either method; of a mesh
    /// the normal of the face. `None` for a miss. The ray must be a ray.
    #[inline]
    pub fn whole_hit(&self, method: Method, part: usize, ray: &Ray3<R>, span: Span<R>) -> Option<Hit3<R>> {
        let Part { shape, face, .. } = self.all[part];
        match shape {
            Shape::Mesh(mesh) => {
                let triangle = mesh.triangle(face as usize);
                let hit = match method {
                    Method::Robust => triangle::robust(ray, &triangle).hit(span),
                    Method::Notes => triangle::matrix(ray, &triangle).hit(span),
                };
                // a face without area is never hit
                hit.ok().flatten()
            }
            shape => shape.hit(method, ray, span),
        }
    }

    /// A box around a part, in the world; `None` for a plane, which has none.
    pub fn bounds(&self, part: usize) -> Option<Box3> {
        let Part { shape, face, .. } = self.all[part];
        match shape {
            Shape::Mesh(mesh) => Some(Box3::around::<R>(mesh.triangle(face as usize).corners())),
            shape => box_of(shape),
        }
    }

    /// A box around an object; `None` for a plane.
    pub fn object_bounds(&self, object: usize) -> Option<Box3> {
        let mut parts = self.of_object(object).map(|part| self.bounds(part));
        parts.try_fold(Box3::EMPTY, |all, part| Some(all.union(&part?)))
    }
}

/// A box around a shape that is no mesh; `None` for a plane.
fn box_of<R: Real>(shape: &Shape<R>) -> Option<Box3> {
    match shape {
        Shape::Plane(_) => None,
        Shape::Sphere(sphere) => Some(Box3::around_sphere(sphere.center, sphere.radius)),
        Shape::Triangle(triangle) => Some(Box3::around::<R>(triangle.corners())),
        Shape::Polygon(polygon) => Some(around(polygon.bounds())),
        Shape::Mesh(mesh) => Some(Box3::around::<R>(mesh.vertices().iter().copied())),
        Shape::Solid(quadric::Shape::Cylinder) => Some(around([[-1.0; 3], [1.0; 3]])),
        Shape::Solid(quadric::Shape::Cone) => Some(around([[-0.5, -0.5, 0.0], [0.5, 0.5, 1.0]])),
        Shape::OpenCone(cone) => {
            let (low, high) = cone.bounds();
            Some(around([low, high]))
        }
        Shape::Deformed(deformed) => deformed_box(deformed),
    }
}

fn around(corners: [[f64; 3]; 2]) -> Box3 {
    Box3::around::<f64>(corners.map(Into::into))
}

/// The box around a deformed solid. Along an axis e the point A x̄ + t is at most t_e + max (Aᵀe) · x̄ away,
/// and over the unit sphere that is the length of A's row; over the cylinder the length of its first two
/// numbers and the size of the third; over the cone the greater of the apex, a_3, and the base, half the
/// length of the first two.
///
/// Each of these sums and roots is rounded a few times, by less than 8 units of the last digit of its largest
/// part.
fn deformed_box<R: Real>(deformed: &affine::Deformed<R>) -> Option<Box3> {
    let rows = deformed.affine.a.rows().map(|row| row.map(Into::<f64>::into));
    let t: [f64; 3] = deformed.affine.t.in_f64();
    let (mut low, mut high) = ([0.0; 3], [0.0; 3]);
    for axis in 0..3 {
        let [x, y, z] = rows[axis];
        let (below, above) = match deformed.object {
            affine::Object::Sphere => {
                let reach = length([x, y, z]);
                (reach, reach)
            }
            affine::Object::Cylinder => {
                let reach = length([x, y, 0.0]) + z.abs();
                (reach, reach)
            }
            affine::Object::Cone => {
                let base = length([x, y, 0.0]) / 2.0;
                (base.max(-z), base.max(z))
            }
            affine::Object::Plane => return None,
            affine::Object::Triangle => ((-x).max(-y).max(0.0), x.max(y).max(0.0)),
        };
        [low[axis], high[axis]] = widened(t[axis], below, above);
    }
    Some(around([low, high]))
}

/// From t − below to t + above, farther by what both may be off.
fn widened(t: f64, below: f64, above: f64) -> [f64; 2] {
    let off = 8.0 * f64::EPSILON * (t.abs() + below.abs() + above.abs()) + f64::MIN_POSITIVE;
    [t - below - off, t + above + off]
}

/// ‖v‖, divided by the largest component first, so that no square overflows or vanishes.
fn length(v: [f64; 3]) -> f64 {
    let largest = v.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    let [x, y, z] = v.map(|x| x / largest);
    largest * (x * x + y * y + z * z).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use affine::{Affine, Deformed, Matrix3};
    use glam::DVec3;
    use math::{Camera, Grid, Handedness, Window};
    use signature::Object;

    /// By hand, with 3-4-5, around (10, 20, 30): ‖(3, 4, 0)‖ = 5 of the sphere, 5 + 2 of the cylinder; of the cone
    /// half of it at the base, or the apex. The box is rounded outward, by no more than two of its digits.
    #[test]
    fn a_deformed_solid_has_the_box_of_its_rows() {
        let rows = [[3.0, 4.0, 2.0], [0.0, 2.0, 0.0], [0.0, 0.0, 4.0]];
        let triangle = [[-3.0, 4.0, 2.0], [0.0, 2.0, 0.0], [0.0, -1.0, 4.0]];
        let of_sphere = 29.0_f64.sqrt();
        for (object, rows, below, above) in [
            (affine::Object::Sphere, rows, [of_sphere, 2.0, 4.0], [of_sphere, 2.0, 4.0]),
            (affine::Object::Cylinder, rows, [7.0, 2.0, 4.0], [7.0, 2.0, 4.0]),
            (affine::Object::Cone, rows, [2.5, 1.0, 0.0], [2.5, 1.0, 4.0]),
            (affine::Object::Triangle, triangle, [3.0, 0.0, 1.0], [4.0, 2.0, 0.0]),
        ] {
            let t = [10.0, 20.0, 30.0];
            let affine = Affine { a: Matrix3::from_rows(rows), t: t.into() };
            let around = deformed_box::<f64>(&Deformed::new(object, affine).unwrap()).unwrap();
            for axis in 0..3 {
                let (low, high) = (t[axis] - below[axis], t[axis] + above[axis]);
                // a box has single precision, rounded outward
                let most = 2.0 * f64::from(f32::EPSILON) * (t[axis] + below[axis] + above[axis]);
                let [under, over] = [low - f64::from(around.low[axis]), f64::from(around.high[axis]) - high];
                assert!((0.0..=most).contains(&under), "{} {axis}: {under}", object.name());
                assert!((0.0..=most).contains(&over), "{} {axis}: {over}", object.name());
            }
        }
    }

    /// By hand: eight units of the last digit of the largest, and not of all three more than 24; where all are zero, a
    /// little.
    #[test]
    fn a_box_is_widened_by_what_is_rounded() {
        for [t, below, above] in
            [[1.0, 0.25, 0.0], [-1.0, 0.0, 0.5], [0.25, 1.0, 1.0], [0.25, 0.5, -1.0], [0.5, -1.0, 1.0]]
        {
            let [low, high] = widened(t, below, above);
            for off in [t - below - low, high - t - above] {
                // the sums that are subtracted here are exact but for one more digit
                assert!((7.0..=25.0).contains(&(off / f64::EPSILON)), "{t} {below} {above}: {off:e}");
            }
        }
        assert_eq!(widened(0.0, 0.0, 0.0), [-f64::MIN_POSITIVE, f64::MIN_POSITIVE]);
    }

    /// By hand: a ball of radius 1, a mesh of two faces, a cylinder and a cone of chapter 06.
    #[test]
    fn what_a_part_is_and_what_is_around_it() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[x, y]| DVec3::new(x, y, 7.0));
        let square = triangle::mesh::Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        let ball = ray_sphere::Sphere { center: DVec3::ZERO, radius: 1.0 };
        let shapes = [
            Shape::Sphere(ball),
            Shape::Mesh(square),
            Shape::Solid(quadric::Shape::Cylinder),
            Shape::Solid(quadric::Shape::Cone),
        ];
        let window = Window { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 };
        let camera = Camera::looking(DVec3::ZERO, DVec3::Z, DVec3::Y, Handedness::Left, 1.0, window).unwrap();
        let objects = shapes.map(|shape| Object { id: None, shape }).to_vec();
        let scene = Scene::<f64> { camera, grid: Grid::Centers, size: (5, 5), objects };
        let parts = Parts::of(&scene);
        let faces: Vec<Option<usize>> = (0..parts.count()).map(|part| parts.face(part)).collect();
        assert_eq!(faces, [None, Some(0), Some(1), None, None]);
        let objects: Vec<usize> = (0..parts.count()).map(|part| parts.object(part)).collect();
        assert_eq!(objects, [0, 1, 1, 2, 3]);
        let boxed = |low, high| Some(Box3 { low, high });
        assert_eq!(parts.bounds(1), boxed([0.0, 0.0, 7.0], [2.0, 2.0, 7.0]));
        assert_eq!(parts.bounds(3), boxed([-1.0; 3], [1.0; 3]));
        assert_eq!(parts.bounds(4), boxed([-0.5, -0.5, 0.0], [0.5, 0.5, 1.0]));
    }

    #[test]
    fn a_length_does_not_overflow_or_vanish() {
        for scale in [1e-300, 1.0, 1e300] {
            let off = length([2.0 * scale, -3.0 * scale, 6.0 * scale]) / scale - 7.0;
            assert!(off.abs() <= 14.0 * f64::EPSILON, "{scale}: {off}");
        }
        assert_eq!(length([0.0; 3]), 0.0);
    }
}

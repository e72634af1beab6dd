//! A ray aimed at a deformed object: what the regimes are drawn from.

use lab::{Draw, Vec3};
use math::{Ray3, Real};

use crate::{Affine, Matrix3, Object};

/// A ray, an object and its deformation.
#[derive(Clone, Copy)]
pub(super) struct Scene {
    pub(super) ray: Ray3<f64>,
    pub(super) object: Object,
    pub(super) affine: Affine<f64>,
}

impl Scene {
    /// The columns of a case file.
    pub(super) fn numbers(&self) -> [f64; 19] {
        let Scene { ray: Ray3 { origin: o, direction: d }, object, affine: Affine { a, t } } = self;
        let [[a11, a12, a13], [a21, a22, a23], [a31, a32, a33]] = a.rows();
        let shape = place(*object);
        [o.x, o.y, o.z, d.x, d.y, d.z, shape, a11, a12, a13, a21, a22, a23, a31, a32, a33, t.x, t.y, t.z]
    }

    /// Everything elsewhere.
    pub(super) fn moved(mut self, by: Vec3) -> Scene {
        self.ray.origin += by;
        self.affine.t += by;
        self
    }

    /// Every length times a factor, the direction as it is.
    pub(super) fn scaled(mut self, factor: f64) -> Scene {
        self.ray.origin *= factor;
        self.affine.t *= factor;
        self.affine.a.columns = self.affine.a.columns.map(|column| column * factor);
        self
    }

    /// The direction times a factor.
    pub(super) fn with_direction_times(mut self, factor: f64) -> Scene {
        self.ray.direction *= factor;
        self
    }
}

/// The place of an object's word among the words of a case file.
pub(super) fn place(object: Object) -> f64 {
    Object::ALL.iter().position(|&other| other == object).unwrap_or(0) as f64
}

/// Sphere, cylinder or cone, one as likely as the next.
pub(super) fn solid(draw: &mut Draw) -> Object {
    [Object::Sphere, Object::Cylinder, Object::Cone][draw.below(3) as usize]
}

/// How far the object is from the world's origin, if nothing else is said.
const SPREAD: f64 = 10.0;

/// A matrix that turns, stretches by these factors, and turns again, rounded to the precision.
pub(super) fn turned(draw: &mut Draw, scales: [f64; 3]) -> Matrix3<f64> {
    let ([u, v], zero) = ([frame(draw), frame(draw)], f64::vec3(0.0, 0.0, 0.0));
    // Σ scale u vᵀ
    let column = |axis: usize| (0..3).fold(zero, |sum, i| sum + u[i] * (scales[i] * v[i].to_array()[axis]));
    rounded(draw, Matrix3 { columns: [0, 1, 2].map(column) })
}

/// Three directions at right angles.
fn frame(draw: &mut Draw) -> [Vec3; 3] {
    let x = draw.direction();
    let y = draw.perpendicular(x);
    [x, y, x.cross(y)]
}

/// A matrix rounded to the precision: what follows from it then follows from what is in the case.
pub(super) fn rounded(draw: &Draw, a: Matrix3<f64>) -> Matrix3<f64> {
    Matrix3 { columns: a.columns.map(|column| draw.rounded_vector(column)) }
}

/// A matrix as pictures have it: sizes of 0.3 to 3, a condition of 10 at the most.
pub(super) fn ordinary_matrix(draw: &mut Draw) -> Matrix3<f64> {
    let size = draw.uniform(1.0, 3.0);
    let [second, third] = [0, 1].map(|_| draw.log_uniform(0.1, 1.0));
    turned(draw, [size, size * second, size * third])
}

/// A matrix of this condition: one axis as it is, one squashed so many times, the third in between. In `f32` a million
/// at the most: its rounding leaves no more of a matrix that turns.
pub(super) fn squashed_matrix(draw: &mut Draw, condition: f64) -> Matrix3<f64> {
    let condition = draw.by_precision(condition, condition.min(1e6));
    let between = if condition > 1.0 { draw.log_uniform(1.0, condition) } else { 1.0 };
    turned(draw, [1.0, 1.0 / between, 1.0 / condition])
}

/// A point of the object's own space to aim at: in it or near it, so that a ray through it mostly hits.
pub(super) fn target(draw: &mut Draw, object: Object) -> Vec3 {
    match object {
        Object::Sphere => draw.direction() * draw.uniform(0.0, 1.8),
        Object::Cylinder => draw.in_cube(1.5),
        Object::Cone => draw.in_cube(0.55) + f64::vec3(0.0, 0.0, 0.4),
        Object::Plane => draw.in_cube(2.0) * f64::vec3(1.0, 1.0, 0.0),
        Object::Triangle => f64::vec3(draw.uniform(-0.1, 0.8), draw.uniform(-0.1, 0.8), 0.0),
    }
}

/// A point strictly within a solid, not next to its surface.
pub(super) fn within(draw: &mut Draw, object: Object) -> Vec3 {
    match object {
        Object::Cone => draw.direction() * draw.uniform(0.0, 0.2) + f64::vec3(0.0, 0.0, 0.25),
        _ => draw.direction() * draw.uniform(0.0, 0.9),
    }
}

/// A point of a solid's surface, to a rounding.
pub(super) fn on_surface(draw: &mut Draw, object: Object) -> Vec3 {
    let side = draw.direction_in_plane();
    let (height, share) = (draw.uniform(0.0, 1.0), draw.uniform(0.0, 1.0));
    let across = |radius: f64, z: f64| f64::vec3(side.x * radius, side.y * radius, z);
    match (object, draw.coin()) {
        (Object::Cylinder, true) => across(1.0, 2.0 * height - 1.0),
        (Object::Cylinder, false) => across(share, draw.sign()),
        (Object::Cone, true) => across(0.5 * (1.0 - height), height),
        (Object::Cone, false) => across(0.5 * share, 0.0),
        _ => draw.direction(),
    }
}

/// A ray along `direction` that starts `distance` before the point A `target` + t.
///
/// Origin, direction and A are rounded first and t follows from them, so that the aim holds at either precision.
pub(super) fn aimed_along(
    draw: &mut Draw,
    object: Object,
    a: Matrix3<f64>,
    target: Vec3,
    direction: Vec3,
    distance: f64,
) -> Scene {
    let direction = draw.rounded_vector(direction);
    let about = draw.in_cube(SPREAD);
    let origin = draw.rounded_vector(about - direction * distance);
    let t = origin + direction * distance - a.times(target);
    Scene { ray: Ray3::<f64>::new(origin, direction), object, affine: Affine { a, t } }
}

/// The same in any direction, from a distance as pictures have it. A plane cannot be missed but by turning away: one
/// ray of three does.
pub(super) fn aimed(draw: &mut Draw, object: Object, a: Matrix3<f64>) -> Scene {
    let (target, direction) = (target(draw, object), draw.direction());
    let turns_away = object == Object::Plane && draw.below(3) == 0;
    let distance = draw.uniform(5.0, 40.0) * if turns_away { -1.0 } else { 1.0 };
    aimed_along(draw, object, a, target, direction, distance)
}

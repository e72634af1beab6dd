//! The point on the unit object, from the line's direction and moment: p × d = w.
//!
//! o″ + λ d″ would be the shorter way, and for an object squashed a million times it loses six digits: both are large
//! there and p is not. Here nothing large is subtracted, and only the square root needs the careful numbers.

use math::{Real, Vector};
use quadric::robust::Place;
use quadric::{Part, Shape};

use super::solve::shape_of;
use crate::Object;

/// A line in the object's own space, with d of any length: the points p with p × d = w.
#[derive(Clone, Copy)]
pub(super) struct Plucker {
    pub(super) d: [f64; 3],
    pub(super) w: [f64; 3],
    /// D / s² of the sphere or the wall, which is not below zero.
    pub(super) chord: f64,
}

impl Plucker {
    /// The point where the line enters the surface at this place, or leaves it. NaN where the line does not meet it.
    #[inline(always)]
    pub(super) fn point(&self, object: Object, place: Place, enters: bool) -> [f64; 3] {
        if let Some(height) = place.plane.and_then(Part::height) {
            return self.on_plane(height.into());
        }
        let root = self.chord.max(0.0).sqrt();
        let root = if enters { -root } else { root };
        match object {
            Object::Cylinder => self.on_cylinder(root),
            Object::Cone => self.on_cone(root),
            Object::Sphere | Object::Plane | Object::Triangle => self.on_sphere(root),
        }
    }

    /// The closest approach d × w / A, and √(A − w·w) d / A from there.
    #[inline(always)]
    fn on_sphere(&self, root: f64) -> [f64; 3] {
        let Plucker { d, w, .. } = self;
        let a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        let across = cross(d, w);
        [0, 1, 2].map(|axis| (across[axis] + root * d[axis]) / a)
    }

    /// The same for x and y; z follows from p × d = w.
    #[inline(always)]
    fn on_cylinder(&self, root: f64) -> [f64; 3] {
        let Plucker { d: [d_x, d_y, d_z], w: [w_x, w_y, w_z], .. } = *self;
        let a = d_x * d_x + d_y * d_y;
        let x = (d_y * w_z + root * d_x) / a;
        let y = (-d_x * w_z + root * d_y) / a;
        let z = ((w_y + x * d_z) * d_x + (y * d_z - w_x) * d_y) / a;
        [x, y, z]
    }

    /// x = (−w_y + z d_x) / d_z, y = (w_x + z d_y) / d_z
    #[inline(always)]
    fn on_plane(&self, z: f64) -> [f64; 3] {
        let Plucker { d: [d_x, d_y, d_z], w: [w_x, w_y, _], .. } = *self;
        [(-w_y + z * d_x) / d_z, (w_x + z * d_y) / d_z, z]
    }

    /// From the point q nearest to the apex, by the wall's quadratic along q + μ d.
    #[inline(always)]
    fn on_cone(&self, root: f64) -> [f64; 3] {
        let Plucker { d, w, .. } = *self;
        // the moment about the apex, w − e_z × d, and q from the apex
        let v = [w[0] + d[1], w[1] - d[0], w[2]];
        let length = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        let q = cross(&d, &v).map(|x| x / length);
        // the wall's form: x² + y² − ¼ z²
        let form = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] - 0.25 * u[2] * v[2];
        let (a, b) = (form(d, d), -form(q, d));
        let adds = b * root >= 0.0;
        let mu = if adds { (b + root) / a } else { form(q, q) / (b - root) };
        [q[0] + mu * d[0], q[1] + mu * d[1], (q[2] + mu * d[2]) + 1.0]
    }
}

#[inline(always)]
fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The outward unit normal of the unit object at a point of a part of it.
#[inline(always)]
pub(super) fn normal(object: Object, part: Part, p: [f64; 3]) -> [f64; 3] {
    match (object, shape_of(object)) {
        (Object::Sphere, _) => p,
        (_, Some(shape)) => f64::xyz(shape.normal::<f64>(part, f64::vec3(p[0], p[1], p[2]))),
        (_, None) => [0.0, 0.0, 1.0],
    }
}

/// The same in any length: not rounded by the one that makes it 1.
pub(super) fn outward(object: Object, part: Part, p: [f64; 3]) -> [f64; 3] {
    let gradient = |shape: Shape| shape.half_gradient::<f64>(f64::vec3(p[0], p[1], p[2]));
    match shape_of(object).map(gradient) {
        // that of the apex is zero
        Some(gradient) if part == Part::Wall && !gradient.is_zero() => f64::xyz(gradient),
        _ => normal(object, part, p),
    }
}

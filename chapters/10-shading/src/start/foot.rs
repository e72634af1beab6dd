//! p̄ put back on its surface, and how far it may still be off.
//!
//! p̄ = ā + λ d⃗ is off by what λ is off along the ray, and by its own rounding: the farther away the eye, the more. Put
//! back on the surface it is off by the roundings of that step alone, which depend on the numbers of the shape: on c⃗
//! and r of a sphere, on how large the coordinates are along n⃗. All of it is worked out in `f64`, for rays of `f32`
//! too, where then only the last rounding counts.
//!
//! In what follows u is half a unit of the last digit, the error of one operation. Each bound counts the roundings on the way
//! and takes the next power of two of them. The notes' formulas are in the precision of the ray, and what they can still
//! tell apart from zero is no less than as many u of that precision: for them u is that one.

use affine::{Deformed, Matrix3};
use math::{Real, Vector};
use quadric::open::OpenCone;
use signature::{Method, Shape};

use crate::Landing;

/// A point on a surface, in `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot<R: Real> {
    /// The point.
    pub point: [f64; 3],
    /// The unit normal of the face, outward for a solid.
    pub normal: [f64; 3],
    /// How far from the surface the point is at most, along the normal.
    pub error: f64,
    /// What it will cost to round it to R, in the same way: u (|n_x p_x| + |n_y p_y| + |n_z p_z|).
    pub rounding: f64,
    precision: std::marker::PhantomData<R>,
}

impl<R: Real> Foot<R> {
    /// How far along the normal a ray starts: twice the error and the rounding. Once is as far as the surface may be away;
    /// and again, as the new point is rounded as well.
    #[inline(always)]
    pub fn offset(&self) -> f64 {
        2.0 * (self.error + self.rounding)
    }

    /// The points to start from on the side of the normal, and on the other.
    #[inline(always)]
    pub fn origins(&self) -> [R::Vec3; 2] {
        let offset = self.offset();
        [offset, -offset].map(|offset| {
            let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| self.point[axis] + offset * self.normal[axis]);
            R::vec3(R::round_from(x), R::round_from(y), R::round_from(z))
        })
    }
}

/// u of a precision, half a unit of the last digit of 1.
const fn unit(digits: u32) -> f64 {
    1.0 / (1u64 << digits) as f64
}

/// The foot of a landing on a shape; `face` is the face of a mesh.
#[inline]
pub fn of<R: Real>(formulas: Method, shape: &Shape<R>, face: Option<usize>, landing: &Landing<R>) -> Foot<R> {
    let u = match formulas {
        Method::Robust => unit(f64::DIGITS),
        Method::Notes => unit(R::DIGITS),
    };
    let (p, n) = (landing.point.in_f64::<3>(), unit_length(landing.face_normal.in_f64()));
    let (point, error) = match shape {
        Shape::Sphere(sphere) => {
            // c⃗ + r n⃗. n⃗ is off length 1 by 4u at most, the product by u; the sum is in `rounding`
            let (c, r): ([f64; 3], f64) = (sphere.center.in_f64(), sphere.radius.into());
            (std::array::from_fn(|axis| c[axis] + r * n[axis]), 8.0 * u * r)
        }
        Shape::Plane(plane) => on_plane(u, p, plane.point.in_f64(), plane.normal.in_f64()),
        Shape::Polygon(polygon) => {
            let plane = polygon.plane();
            on_plane(u, p, plane.point.in_f64(), plane.normal.in_f64())
        }
        Shape::Triangle(triangle) => on_triangle::<R>(u, p, triangle),
        Shape::Mesh(mesh) => on_triangle::<R>(u, p, &mesh.triangle(face.unwrap_or(0))),
        Shape::Solid(solid) => (on_unit(*solid, n, p), 8.0 * u),
        Shape::OpenCone(cone) => on_open_cone(u, p, n, cone),
        Shape::Deformed(deformed) => on_deformed(u, p, n, deformed),
    };
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| (n[axis] * point[axis]).abs());
    let rounding = unit(R::DIGITS) * (x + y + z) + Into::<f64>::into(R::SMALLEST);
    Foot { point, normal: n, error, rounding, precision: std::marker::PhantomData }
}

/// p̄ − ((p̄ − p̄1)·n⃗ / n⃗·n⃗) n⃗. Each part of the product (p̄ − p̄1)·n⃗ is rounded five times.
#[inline(always)]
fn on_plane(u: f64, p: [f64; 3], p_1: [f64; 3], n: [f64; 3]) -> ([f64; 3], f64) {
    let squared = dot(n, n);
    let away: [f64; 3] = std::array::from_fn(|axis| p[axis] - p_1[axis]);
    let k = dot(away, n) / squared;
    let size: [f64; 3] = std::array::from_fn(|axis| (n[axis] * (p[axis].abs() + p_1[axis].abs())).abs());
    let error = 8.0 * u * (size[0] + size[1] + size[2]) / squared.sqrt();
    (std::array::from_fn(|axis| p[axis] - k * n[axis]), error)
}

/// The plane through p̄1 with n⃗ = (p̄2 − p̄1) × (p̄3 − p̄1), whose parts are rounded four times: by so much the plane itself is
/// tilted, about p̄1.
#[inline(always)]
fn on_triangle<R: Real>(u: f64, p: [f64; 3], triangle: &triangle::Triangle<R>) -> ([f64; 3], f64) {
    let [p_1, p_2, p_3] = triangle.corners().map(Vector::in_f64::<3>);
    let from_p_1 = |q: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| q[axis] - p_1[axis]) };
    let (a, b, away) = (from_p_1(p_2), from_p_1(p_3), from_p_1(p));
    let part = |i: usize, j: usize| (a[i] * b[j] - a[j] * b[i], (a[i] * b[j]).abs() + (a[j] * b[i]).abs());
    let [(x, x_size), (y, y_size), (z, z_size)] = [part(1, 2), part(2, 0), part(0, 1)];
    let n = [x, y, z];
    let (point, error) = on_plane(u, p, p_1, n);
    let tilt = away[0].abs() * x_size + away[1].abs() * y_size + away[2].abs() * z_size;
    (point, error + 8.0 * u * tilt / dot(n, n).sqrt())
}

/// On a cap its height is the cap's; on the wall its distance from the axis is the wall's there.
#[inline(always)]
fn on_unit(solid: quadric::Shape, n: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    let is_cap = n[0] == 0.0 && n[1] == 0.0;
    let (radius, cap) = match solid {
        quadric::Shape::Cylinder => (1.0, if n[2] > 0.0 { 1.0 } else { -1.0 }),
        quadric::Shape::Cone => ((1.0 - z) / 2.0, 0.0),
    };
    if is_cap {
        return [x, y, cap];
    }
    let from_axis = (x * x + y * y).sqrt();
    // at the apex there is no direction away from the axis
    let k = if from_axis > 0.0 { radius / from_axis } else { 1.0 };
    [x * k, y * k, z]
}

/// With w⃗ = p̄ − b̄, split along the axis and away from it: what is away from it is given the wall's radius there.
#[inline(always)]
fn on_open_cone<R: Real>(u: f64, p: [f64; 3], n: [f64; 3], cone: &OpenCone<R>) -> ([f64; 3], f64) {
    let [base, apex] = [cone.base, cone.apex].map(Vector::in_f64::<3>);
    let [r_b, r_a]: [f64; 2] = [cone.base_radius, cone.apex_radius].map(Into::into);
    let v: [f64; 3] = std::array::from_fn(|axis| apex[axis] - base[axis]);
    let w: [f64; 3] = std::array::from_fn(|axis| p[axis] - base[axis]);
    let s = dot(w, v) / dot(v, v);
    let away: [f64; 3] = std::array::from_fn(|axis| w[axis] - s * v[axis]);
    let (from_axis, radius) = (dot(away, away).sqrt(), r_b + s * (r_a - r_b));
    let k = if from_axis > 0.0 { radius / from_axis } else { 1.0 };
    let point = std::array::from_fn(|axis| base[axis] + s * v[axis] + k * away[axis]);
    let size: [f64; 3] = std::array::from_fn(|axis| (n[axis] * (base[axis].abs() + w[axis].abs())).abs());
    (point, 16.0 * u * (size[0] + size[1] + size[2] + r_b + r_a))
}

/// In the object's own space, and back: A x̄ + t. Where x̄ is off along the surface it is still on it.
#[inline(always)]
fn on_deformed<R: Real>(u: f64, p: [f64; 3], n: [f64; 3], deformed: &Deformed<R>) -> ([f64; 3], f64) {
    let a = Matrix3::<f64> { columns: deformed.affine.a.columns.map(|column| column.in_f64::<3>().into()) };
    let t: [f64; 3] = deformed.affine.t.in_f64();
    let from_t: [f64; 3] = std::array::from_fn(|axis| p[axis] - t[axis]);
    let x = f64::xyz(a.inverse().times(from_t.into()));
    // the normal goes back by Aᵀ
    let own_n = f64::xyz(a.transposed_times(n.into()));
    let x = match deformed.object {
        affine::Object::Sphere => unit_length(x),
        affine::Object::Cylinder => on_unit(quadric::Shape::Cylinder, cap_or_wall(own_n), x),
        affine::Object::Cone => on_unit(quadric::Shape::Cone, cap_or_wall(own_n), x),
        // those are moved once, and stay flat
        affine::Object::Plane | affine::Object::Triangle => x,
    };
    let rows = a.rows();
    let point = std::array::from_fn(|axis| dot(rows[axis], x) + t[axis]);
    let size: [f64; 3] = std::array::from_fn(|axis| {
        let [i, j, k] = rows[axis];
        let all = (i * x[0]).abs() + (j * x[1]).abs() + (k * x[2]).abs() + t[axis].abs();
        (n[axis] * all).abs()
    });
    (point, 8.0 * u * (size[0] + size[1] + size[2]))
}

/// Of a normal that was carried to and fro: what of it is left across the axis is rounding on a cap. A wall's normal has at
/// least as much across the axis as a cone's, 2 parts to 1 along it.
fn cap_or_wall([x, y, z]: [f64; 3]) -> [f64; 3] {
    if x.abs() + y.abs() < z.abs() { [0.0, 0.0, z] } else { [x, y, z] }
}

/// n⃗ / ‖n⃗‖ where that is a number, else n⃗ as it is.
#[inline(always)]
fn unit_length(n: [f64; 3]) -> [f64; 3] {
    let length = dot(n, n).sqrt();
    if length > 0.0 && length < f64::INFINITY { n.map(|component| component / length) } else { n }
}

#[inline(always)]
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

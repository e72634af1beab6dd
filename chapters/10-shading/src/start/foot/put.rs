//! Onto each shape.
//!
//! What is said of an error is without the last rounding of the point's coordinates, which is the same for
//! all shapes and added by [`super::of`].

use affine::{Deformed, Matrix3};
use math::plain::dot;
use math::{Real, Vector};
use quadric::open::OpenCone;
use signature::Shape;

/// A point put on a surface, in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Put {
    /// The point.
    pub point: [f64; 3],
    /// A unit normal of the surface there, on either side.
    pub normal: [f64; 3],
    /// How far from the surface the point is at most, before its coordinates were rounded.
    pub error: f64,
}

impl Put {
    /// p̄ with the unit normal n⃗ put on a shape; `face` is the face of a mesh. u is the error of an operation.
    /// What it cannot work out is not finite, see [`Put::is_finite`].
    #[inline]
    pub fn on<R: Real>(u: f64, p: [f64; 3], n: [f64; 3], shape: &Shape<R>, face: Option<usize>) -> Put {
        match shape {
            Shape::Sphere(sphere) => {
                // c⃗ + r n⃗. ‖n⃗‖ is off 1 by 4u at most, the product by u
                let (c, r): ([f64; 3], f64) = (sphere.center.in_f64(), sphere.radius.into());
                let point = std::array::from_fn(|axis| c[axis] + r * n[axis]);
                Put { point, normal: n, error: 8.0 * u * r }
            }
            Shape::Plane(plane) => on_plane(u, p, plane.point.in_f64(), plane.normal.in_f64()),
            Shape::Polygon(polygon) => {
                let plane = polygon.plane();
                on_plane(u, p, plane.point.in_f64(), plane.normal.in_f64())
            }
            Shape::Triangle(triangle) => on_triangle(u, p, triangle.corners().map(Vector::in_f64::<3>)),
            Shape::Mesh(mesh) => {
                on_triangle(u, p, mesh.triangle(face.unwrap_or(0)).corners().map(Vector::in_f64::<3>))
            }
            Shape::Solid(solid) => {
                let (point, gradient) = on_unit(*solid, n, p);
                Put { point, normal: unit_length(gradient), error: 8.0 * u }
            }
            Shape::OpenCone(cone) => on_open_cone(u, p, n, cone),
            Shape::Deformed(deformed) => on_deformed(u, p, n, deformed),
        }
    }

    /// p̄ where it is.
    pub fn at(p: [f64; 3], n: [f64; 3]) -> Put {
        Put { point: p, normal: n, error: 0.0 }
    }

    /// No square on the way has overflowed or vanished.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        let Put { point, normal, error } = self;
        let length = dot(*normal, *normal);
        error.is_finite() && point.iter().all(|x| x.is_finite()) && (0.5..2.0).contains(&length)
    }
}

/// p̄ − ((p̄ − p̄1)·n⃗) n⃗ with n⃗ at unit length.
///
/// A part of the product (p̄ − p̄1)·n⃗ is rounded four times, and a component of n⃗ twice: when the largest
/// is made 1, and then the length, which is off 1 by 4u. That, twice, and three more roundings are in the
/// step of k along n⃗.
#[inline(always)]
fn on_plane(u: f64, p: [f64; 3], p_1: [f64; 3], n: [f64; 3]) -> Put {
    let largest = n.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let normal = unit_length(n.map(|x| x / largest));
    let away: [f64; 3] = std::array::from_fn(|axis| p[axis] - p_1[axis]);
    let k = dot(away, normal);
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| (normal[axis] * away[axis]).abs());
    let point = std::array::from_fn(|axis| p[axis] - k * normal[axis]);
    Put { point, normal, error: u * (8.0 * (x + y + z) + 16.0 * k.abs()) }
}

/// The plane through p̄1 with n⃗ = (p̄2 − p̄1) × (p̄3 − p̄1), whose parts are rounded four times: by so much
/// the plane itself is tilted, about p̄1. Twice that is taken, for n⃗ may have come out shorter than it is.
///
/// A sliver of which n⃗ is not more than this rounding, of a height below 1e-15 of its length, has no normal
/// to speak of.
#[inline(always)]
fn on_triangle(u: f64, p: [f64; 3], [p_1, p_2, p_3]: [[f64; 3]; 3]) -> Put {
    let from_p_1 = |q: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| q[axis] - p_1[axis]) };
    let (a, b, away) = (from_p_1(p_2), from_p_1(p_3), from_p_1(p));
    let part = |i: usize, j: usize| (a[i] * b[j] - a[j] * b[i], (a[i] * b[j]).abs() + (a[j] * b[i]).abs());
    let [(x, x_size), (y, y_size), (z, z_size)] = [part(1, 2), part(2, 0), part(0, 1)];
    let put = on_plane(u, p, p_1, [x, y, z]);
    let tilt = away[0].abs() * x_size + away[1].abs() * y_size + away[2].abs() * z_size;
    // n⃗ · (n⃗ / ‖n⃗‖) = ‖n⃗‖
    let length = dot([x, y, z], put.normal);
    Put { error: put.error + 8.0 * u * tilt / length, ..put }
}

/// On a cap its height is the cap's; on the wall its distance from the axis is the wall's there, off by five
/// roundings. And a normal there, of any length.
#[inline(always)]
fn on_unit(solid: quadric::Shape, n: [f64; 3], [x, y, z]: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let is_cap = n[0] == 0.0 && n[1] == 0.0;
    let (radius, cap, rise) = match solid {
        quadric::Shape::Cylinder => (1.0, if n[2] > 0.0 { 1.0 } else { -1.0 }, 0.0),
        quadric::Shape::Cone => ((1.0 - z) / 2.0, 0.0, 0.5),
    };
    if is_cap {
        return ([x, y, cap], [0.0, 0.0, n[2]]);
    }
    // on the axis there is no way from it but the normal's
    let [x, y] = if x == 0.0 && y == 0.0 { [n[0], n[1]] } else { [x, y] };
    let from_axis = (x * x + y * y).sqrt();
    if from_axis == 0.0 {
        return ([x, y, z], n);
    }
    let k = radius / from_axis;
    ([x * k, y * k, z], [x / from_axis, y / from_axis, rise])
}

/// With w⃗ = p̄ − b̄, split along the axis and away from it: what is away from it is given the wall's radius
/// there. It is not quite at right angles to the axis, by 15u ‖w⃗‖, and k times that is how much the height
/// is off for which the radius is; the radius itself is off by five roundings.
fn on_open_cone<R: Real>(u: f64, p: [f64; 3], n: [f64; 3], cone: &OpenCone<R>) -> Put {
    let [base, apex] = [cone.base, cone.apex].map(Vector::in_f64::<3>);
    let [r_b, r_a]: [f64; 2] = [cone.base_radius, cone.apex_radius].map(Into::into);
    let v: [f64; 3] = std::array::from_fn(|axis| apex[axis] - base[axis]);
    let w: [f64; 3] = std::array::from_fn(|axis| p[axis] - base[axis]);
    let squared = dot(v, v);
    let s = dot(w, v) / squared;
    let away: [f64; 3] = std::array::from_fn(|axis| w[axis] - s * v[axis]);
    let (from_axis, radius) = (dot(away, away).sqrt(), r_b + s * (r_a - r_b));
    let (k, slope) = (radius / from_axis, (r_a - r_b) / squared);
    let error = 16.0 * u * (dot(w, w).sqrt() * k.abs().max(1.0) + r_b + r_a);
    // at a tip there is no direction away from the axis
    if from_axis == 0.0 {
        return Put { point: p, normal: n, error: 16.0 * u * (dot(w, w).sqrt() + r_b + r_a) };
    }
    let point = std::array::from_fn(|axis| base[axis] + (s * v[axis] + k * away[axis]));
    let normal = unit_length(std::array::from_fn(|axis| away[axis] / from_axis - slope * v[axis]));
    Put { point, normal, error }
}

/// In the object's own space, and back: A x̄ + t. Where x̄ is off along the surface it is still on it; off
/// the surface it is by five roundings, and each part of A x̄ + t by three more.
fn on_deformed<R: Real>(u: f64, p: [f64; 3], n: [f64; 3], deformed: &Deformed<R>) -> Put {
    let a = Matrix3::<f64> { columns: deformed.affine.a.columns.map(|column| column.in_f64::<3>().into()) };
    let t: [f64; 3] = deformed.affine.t.in_f64();
    let inverse = a.inverse();
    let (columns, rows) = (inverse.columns.map(f64::xyz), a.rows());
    let back = |q: [f64; 3]| f64::xyz(inverse.times(q.into()));
    let from_t: [f64; 3] = std::array::from_fn(|axis| p[axis] - t[axis]);
    let x = back(from_t);
    // what A⁻¹ has lost, once more: then A x̄ is p̄ − t to a few roundings
    let lost = back(std::array::from_fn(|axis| from_t[axis] - dot(rows[axis], x)));
    let x = std::array::from_fn(|axis| x[axis] + lost[axis]);
    // the normal goes back by Aᵀ
    let own_n = f64::xyz(a.transposed_times(n.into()));
    let put = |x: [f64; 3]| {
        let (x, own_n) = match deformed.object {
            affine::Object::Sphere => (unit_length(x), unit_length(x)),
            affine::Object::Cylinder => on_unit(quadric::Shape::Cylinder, cap_or_wall(own_n), x),
            affine::Object::Cone => on_unit(quadric::Shape::Cone, cap_or_wall(own_n), x),
            affine::Object::Plane | affine::Object::Triangle => ([x[0], x[1], 0.0], [0.0, 0.0, 1.0]),
        };
        (x, unit_length(columns.map(|column| dot(column, own_n))))
    };
    let (x, normal) = match put(x) {
        // p̄ is so coarse for this solid that it is on its other side, or in its middle: n⃗ tells better
        // where it is
        (_, normal) if !deformed.object.is_flat() && dot(normal, n) <= 0.0 => {
            let height = if deformed.object == affine::Object::Sphere { own_n[2] } else { x[2] };
            put([own_n[0], own_n[1], height])
        }
        found => found,
    };
    let point = std::array::from_fn(|axis| dot(rows[axis], x) + t[axis]);
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| {
        let [i, j, k] = rows[axis];
        let all = (i * x[0]).abs() + (j * x[1]).abs() + (k * x[2]).abs() + t[axis].abs();
        (normal[axis] * all).abs()
    });
    Put { point, normal, error: 8.0 * u * (x + y + z) }
}

/// Of a normal that was carried to and fro: what of it is left across the axis is rounding on a cap. A wall's
/// normal has at least as much across the axis as a cone's, 2 parts to 1 along it.
fn cap_or_wall([x, y, z]: [f64; 3]) -> [f64; 3] {
    if x.abs() + y.abs() < z.abs() { [0.0, 0.0, z] } else { [x, y, z] }
}

/// n⃗ / ‖n⃗‖ where that is a number, else n⃗ as it is.
#[inline(always)]
pub(crate) fn unit_length(n: [f64; 3]) -> [f64; 3] {
    let length = dot(n, n).sqrt();
    if length > 0.0 && length < f64::INFINITY { n.map(|component| component / length) } else { n }
}

#[cfg(test)]
mod tests;

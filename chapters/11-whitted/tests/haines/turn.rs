//! Turning points, by angles in radians. Haines writes rows times matrices, so that his turns about an axis
//! by an angle are ours, right-handed.

use crate::nff::Point;

/// About an axis, which need not be of length 1 (Rodrigues).
pub(crate) fn about([x, y, z]: Point, angle: f64, p: Point) -> Point {
    let length = (x * x + y * y + z * z).sqrt();
    let k = [x / length, y / length, z / length];
    let (sin, cos) = angle.sin_cos();
    let along = dot(k, p) * (1.0 - cos);
    let across = cross(k, p);
    std::array::from_fn(|i| p[i] * cos + across[i] * sin + k[i] * along)
}

/// About the x axis.
pub(crate) fn about_x(angle: f64, [x, y, z]: Point) -> Point {
    let (sin, cos) = angle.sin_cos();
    [x, y * cos - z * sin, y * sin + z * cos]
}

/// About the z axis.
pub(crate) fn about_z(angle: f64, [x, y, z]: Point) -> Point {
    let (sin, cos) = angle.sin_cos();
    [x * cos - y * sin, x * sin + y * cos, z]
}

pub(crate) fn plus(a: Point, b: Point) -> Point {
    std::array::from_fn(|i| a[i] + b[i])
}

pub(crate) fn times(a: Point, k: f64) -> Point {
    a.map(|x| x * k)
}

pub(crate) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

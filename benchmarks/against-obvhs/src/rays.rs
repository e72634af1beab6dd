//! Rays: of a picture, off what they hit, and any.

use std::f64::consts::TAU;

use math::{Ray3, Real, Vector};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use crate::scenes::{Camera, vector};

/// A ray in `f64`, to be rounded.
pub(crate) type Line = ([f64; 3], [f64; 3]);

/// The rays in a precision.
pub(crate) fn rounded<R: Real>(lines: &[Line]) -> Vec<Ray3<R>> {
    lines.iter().map(|&(o, d)| Ray3::new(vector::<R>(o), vector::<R>(d))).collect()
}

/// Through the middle of every pixel of a square picture, row by row.
pub(crate) fn primary(camera: &Camera, size: usize) -> Vec<Line> {
    let ahead = unit(minus(camera.at, camera.from));
    let right = unit(cross(ahead, camera.up));
    let up = cross(right, ahead);
    let half = (camera.angle.to_radians() / 2.0).tan();
    let at = |place: usize| half * ((2 * place + 1) as f64 / size as f64 - 1.0);
    let pixel = |row: usize, column: usize| {
        let (x, y) = (at(column), -at(row));
        let d = [0, 1, 2].map(|axis| ahead[axis] + x * right[axis] + y * up[axis]);
        (camera.from, unit(d))
    };
    (0..size).flat_map(|row| (0..size).map(move |column| pixel(row, column))).collect()
}

/// One ray off every hit, more likely the steeper it leaves the surface. `hits` has the point and the normal
/// that faces the eye.
pub(crate) fn bounces(hits: &[([f64; 3], [f64; 3])], size: f64) -> Vec<Line> {
    let mut random = Random::new(2);
    let bounce = |&(point, normal): &([f64; 3], [f64; 3])| {
        let direction = random.direction();
        let d = [0, 1, 2].map(|axis| normal[axis] + 0.999 * direction[axis]);
        ([0, 1, 2].map(|axis| point[axis] + 1e-4 * size * normal[axis]), unit(d))
    };
    hits.iter().map(bounce).collect()
}

/// From anywhere in a box in any direction.
pub(crate) fn random((low, high): ([f64; 3], [f64; 3]), count: usize) -> Vec<Line> {
    let mut random = Random::new(3);
    let mut ray = || {
        let origin = [0, 1, 2].map(|axis| low[axis] + (high[axis] - low[axis]) * random.unit());
        (origin, random.direction())
    };
    (0..count).map(|_| ray()).collect()
}

struct Random(Pcg64);

impl Random {
    fn new(stream: u128) -> Random {
        Random(Pcg64::new(1, stream))
    }

    /// From 0 to 1.
    fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Archimedes: z is as uniform as the angle.
    fn direction(&mut self) -> [f64; 3] {
        let (z, angle) = (2.0 * self.unit() - 1.0, TAU * self.unit());
        let r = (1.0 - z * z).sqrt();
        [r * angle.cos(), r * angle.sin(), z]
    }
}

pub(crate) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn unit(v: [f64; 3]) -> [f64; 3] {
    f64::xyz(vector::<f64>(v).normalized())
}

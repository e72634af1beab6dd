//! Texture: a color from place to place (CSC418 11.7.2).
//!
//! "We simply need a way to map each point on the surface to a point in texture space": (u, v), in the object's own
//! space, before its transform. Then the texture says which color that is.

use std::sync::Arc;

use affine::{Affine, Matrix3};
use math::plain::dot;
use math::{Real, Vector, portable};

use crate::Rgb;

/// A texture on an object.
#[derive(Clone, Debug, PartialEq)]
pub struct Textured {
    /// From the point to (u, v).
    pub mapping: Mapping,
    /// From (u, v) to the color.
    pub texture: Texture,
}

/// How a shape gets its (u, v). All in `f64`.
#[derive(Clone, Debug, PartialEq)]
pub enum Mapping {
    /// u and v along two axes of the plane, from its point, in the units of the object's own space.
    Plane {
        /// Back to the object's own space; `None` where it is in it.
        back: Option<Back>,
        /// Its point.
        point: [f64; 3],
        /// The axis of u.
        u: [f64; 3],
        /// The axis of v.
        v: [f64; 3],
    },
    /// u once around the y axis from 0 to 1, ½ where x is largest and from there toward z; v from 0 at the
    /// highest y to 1 at the lowest.
    Sphere {
        /// Back to the object's own space; `None` where it is in it.
        back: Option<Back>,
        /// c⃗
        center: [f64; 3],
        /// r
        radius: f64,
    },
    /// (α, β), which no transform changes.
    Triangle,
}

/// x̄ = A⁻¹ (q̄ − t).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Back {
    inverse: Matrix3<f64>,
    t: [f64; 3],
}

impl Back {
    /// The way back of a transform with an inverse.
    pub fn of(by: &Affine<f64>) -> Back {
        Back { inverse: by.a.inverse(), t: by.t.in_f64() }
    }

    fn from(&self, q: [f64; 3]) -> [f64; 3] {
        let from_t: [f64; 3] = std::array::from_fn(|axis| q[axis] - self.t[axis]);
        f64::xyz(self.inverse.times(from_t.into()))
    }
}

impl Mapping {
    /// The axes of a plane with this normal, not zero: u is the world's axis that is least aligned with n⃗ (the first of
    /// x, y, z on a tie), made perpendicular to it, and v = n⃗ × u.
    pub fn plane(point: [f64; 3], normal: [f64; 3], back: Option<Back>) -> Mapping {
        let n = f64::vec3(normal[0], normal[1], normal[2]).normalized();
        let sizes = f64::xyz(n).map(f64::abs);
        let least = (0..3).fold(0, |least, axis| if sizes[axis] < sizes[least] { axis } else { least });
        let axis = [f64::vec3(1.0, 0.0, 0.0), f64::vec3(0.0, 1.0, 0.0), f64::vec3(0.0, 0.0, 1.0)][least];
        let u = (axis - n * axis.dot(n)).normalized();
        let v = f64::cross(n, u);
        Mapping::Plane { back, point, u: f64::xyz(u), v: f64::xyz(v) }
    }

    /// (u, v) of a point of the surface in the world; of a triangle, (α, β) as the method has them, (0, 0)
    /// without.
    pub fn uv(&self, q: [f64; 3], alpha_beta: Option<(f64, f64)>) -> (f64, f64) {
        let own = |back: &Option<Back>| back.as_ref().map_or(q, |back| back.from(q));
        match self {
            Mapping::Plane { back, point, u, v } => {
                let x = own(back);
                let from_point = [x[0] - point[0], x[1] - point[1], x[2] - point[2]];
                // exercise uv: How far along each axis of the plane is the point, from the plane's own point?
                (dot(from_point, *u), dot(from_point, *v))
                // end uv
            }
            Mapping::Sphere { back, center, radius } => {
                let x = own(back);
                let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| (x[axis] - center[axis]) / radius);
                let turn = portable::atan2(z, x) / (2.0 * std::f64::consts::PI);
                (turn + 0.5, portable::acos(y.clamp(-1.0, 1.0)) / std::f64::consts::PI)
            }
            Mapping::Triangle => alpha_beta.unwrap_or((0.0, 0.0)),
        }
    }
}

/// What (u, v) looks like.
#[derive(Clone, Debug, PartialEq)]
pub enum Texture {
    /// Two colors in turns.
    Checker {
        /// The one at (0, 0), and the other.
        colors: [Rgb; 2],
        /// The side of a square, above 0. Around a sphere there are two in the width of one.
        scale: f64,
    },
    /// A picture, repeated.
    Image {
        /// Columns and rows, neither 0.
        size: (u32, u32),
        /// Red, green and blue from 0 to 255, row by row from the top, where v is 0. They are taken as
        /// linear: an sRGB picture is not decoded.
        pixels: Arc<[[u8; 3]]>,
        /// How much of (u, v) it covers, above 0.
        scale: f64,
    },
}

impl Textured {
    /// The color at a point of the surface in the world, linear. (α, β) is for triangles: see
    /// [`Mapping::uv`].
    pub fn at(&self, q: [f64; 3], alpha_beta: Option<(f64, f64)>) -> Rgb {
        let (u, v) = self.mapping.uv(q, alpha_beta);
        self.color(u, v)
    }

    /// The color at (u, v), linear.
    pub fn color(&self, u: f64, v: f64) -> Rgb {
        match &self.texture {
            Texture::Checker { colors, scale } => {
                let around = if matches!(self.mapping, Mapping::Sphere { .. }) { 2.0 } else { 1.0 };
                // exercise squares: How many squares is it from the one at (0, 0), along u and along v together?
                let squares: f64 = (around * u / scale).floor() + (v / scale).floor();
                // end squares
                // exercise turns: When is it the turn of the other color?
                // a sum without a number (a plane's horizon) is even, too
                colors[usize::from(squares.rem_euclid(2.0) == 1.0)]
                // end turns
            }
            Texture::Image { size, pixels, scale } => {
                let place = |x: f64, count: u32| {
                    let x = x / scale;
                    // frac may round to 1, and is no number at a plane's horizon
                    (((x - x.floor()) * f64::from(count)) as u32).min(count - 1)
                };
                let (col, row) = (place(u, size.0), place(v, size.1));
                let pixel = pixels[row as usize * size.0 as usize + col as usize];
                Rgb(pixel.map(|byte| f64::from(byte) / 255.0))
            }
        }
    }
}

#[cfg(test)]
mod tests;

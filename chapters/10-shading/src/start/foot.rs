//! p̄ put back on its surface, and how far it may still be off.
//!
//! p̄ = ā + λ d⃗ is off by what λ is off along the ray, and by its own rounding: the farther away the eye,
//! the more. Put back on the surface ([`mod@put`]) it is off by the roundings of that step alone, which
//! depend on the numbers of the shape: on c⃗ and r of a sphere, on how large the coordinates are along n⃗.
//! All of it is worked out in `f64`, for rays of `f32` too, where then only the last rounding counts.
//!
//! Why along n⃗: a convex shape lies behind each plane that touches it. A ray that starts before that plane
//! and does not go toward it never meets the shape, wherever else rounding has moved its origin. So nothing
//! but the height above the tangent plane matters, and that height is what [`Foot::error`] and
//! [`Foot::rounding`] bound. A ray into a sphere starts within it if it also starts below where the sphere is
//! by then: that is [`Foot::bend`].
//!
//! In what follows u is half a unit of the last digit, the error of one operation. Each bound counts the
//! roundings on the way and takes the next power of two of them. The notes' formulas are in the precision of
//! the ray, and what they can still tell apart from zero is no less than as many u of that precision: for
//! them u is that one. Nothing more is promised of them: at `f32` a few rays by the notes' formulas still
//! meet what they leave, the more of them the flatter it was squashed, as A⁻¹ is rounded.

pub mod put;

use math::plain::dot;
use math::{Real, Vector};
use signature::{Method, Shape};

use crate::Landing;
use put::Put;

/// A point on a surface in the world, in `f64`. Lengths are in units of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot<R: Real> {
    /// The point.
    pub point: [f64; 3],
    /// The unit normal of the surface there, on the side of the landing's face normal: outward for a solid.
    pub normal: [f64; 3],
    /// How far from the surface the point is at most.
    pub error: f64,
    /// What it will cost along the normal to round the point to R: u (|n_x p_x| + |n_y p_y| + |n_z p_z|), and
    /// for what is below the smallest number that one, four times: of a product, of two sums, and of the
    /// point. On the plane y = 0 that would be all, and a ray start at a subnormal y, with which processors
    /// take a hundred times as long. So 2⁻²¹² (|p_x| + |p_y| + |p_z|) is added, of which nothing is left
    /// beside anything else.
    pub rounding: f64,
    /// How much lower a sphere may be where that puts the point: see `bend` below. 0 for the other shapes,
    /// which every ray that starts below their surface is tried on.
    pub bend: f64,
    precision: std::marker::PhantomData<R>,
}

impl<R: Real> Foot<R> {
    /// How far along the normal a ray starts: the error and the rounding, so that it starts outside even if
    /// both are against it.
    ///
    /// The offset is rounded too. With δ for it, the origin is q̄ + δ n⃗ in `f64`, then in R: along n⃗ that
    /// is off by `rounding`, by u δ for the product, twice u δ for the sum in which δ n⃗ is now, and ‖n⃗‖ is
    /// off 1 by 4u. What is left of δ is more than δ (1 − 8u), and 1 / (1 − 8u) < 1 + 16u.
    #[inline(always)]
    pub fn offset(&self) -> f64 {
        (self.error + self.rounding) * (1.0 + 16.0 * unit(R::DIGITS))
    }

    /// The points to start from on the side of the normal, and on the other.
    #[inline(always)]
    pub fn origins(&self) -> [R::Vec3; 2] {
        let offset = self.offset();
        [self.above(offset), self.above(-(offset + self.bend))]
    }

    /// The point so far along the normal.
    #[inline(always)]
    fn above(&self, offset: f64) -> R::Vec3 {
        let along = |axis: usize| R::round_from(self.point[axis] + offset * self.normal[axis]);
        R::vec3(along(0), along(1), along(2))
    }
}

/// u⁴ of `f64`: see [`Foot::rounding`].
const AWAY_FROM_ZERO: f64 = 1.0 / (1u128 << 106) as f64 / (1u128 << 106) as f64;

/// u of a precision, half a unit of the last digit of 1.
pub(crate) const fn unit(digits: u32) -> f64 {
    1.0 / (1u64 << digits) as f64
}

/// How much lower than its tangent plane a sphere may be at an origin. Rounded to R, that is off along the
/// surface by w = u (|x| + |y| + |z|) at most, and there the sphere is lower by r − √(r² − w²), which is less
/// than w²/r. (Where w is more than r there may be no number within.)
#[inline(always)]
fn bend<R: Real>([x, y, z]: [f64; 3], r: f64) -> f64 {
    let w = unit(R::DIGITS) * (x.abs() + y.abs() + z.abs());
    w * (w / r).min(1.0)
}

/// The foot of a landing on a shape; `face` is the face of a mesh. The landing's point must be finite.
///
/// Where the numbers are so large or so small that their squares are none, nothing is known of the surface
/// but p̄ itself: then that is the point, with the landing's normal, and an error of its rounding alone.
#[inline]
pub fn of<R: Real>(formulas: Method, shape: &Shape<R>, face: Option<usize>, landing: &Landing<R>) -> Foot<R> {
    let u = match formulas {
        Method::Robust => unit(<f64 as Real>::DIGITS),
        Method::Notes => unit(R::DIGITS),
    };
    let (p, n) = (landing.point.in_f64::<3>(), put::unit_length(landing.face_normal.in_f64()));
    let put = Put::on(u, p, n, shape, face);
    let Put { point, normal, error } = if put.is_finite() { put } else { Put::at(p, n) };
    // a triangle's corners may go round the other way, and a surface be met from within
    let normal = if dot(normal, n) < 0.0 { normal.map(|x| -x) } else { normal };
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| (normal[axis] * point[axis]).abs());
    let (size, smallest) = (x + y + z, 4.0 * Into::<f64>::into(R::SMALLEST));
    // the last sum of the point's coordinates was rounded to f64
    let error = error + unit(<f64 as Real>::DIGITS) * size;
    let rounding = unit(R::DIGITS) * size + (AWAY_FROM_ZERO * math::plain::size(point) + smallest);
    let bend = match shape {
        Shape::Sphere(sphere) => bend::<R>(point, sphere.radius.into()),
        _ => 0.0,
    };
    Foot { point, normal, error, rounding, bend, precision: std::marker::PhantomData }
}

#[cfg(all(test, feature = "stage"))]
mod tests;

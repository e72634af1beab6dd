//! Where a second ray starts.
//!
//! The page sends it from p̄ and takes what it meets at λ > 0 (0 ≤ λ in the text, slip 16). On paper p̄ is on
//! the surface, and λ > 0 leaves the surface out. But p̄ is rounded: half of all points lie behind their
//! surface, and from there it is met again, a moment later. The surface shades itself, in specks: acne. Step
//! too far away from it, and what stands close by is stepped over: a light leak.
//!
//! - [`Start::None`]: the page. From p̄, λ > 0.
//! - [`Start::Fixed`]: from p̄, and what is nearer than 1e-3 does not count. In a scene of that size nothing
//!   does; and in a large one the error of p̄ is larger.
//! - [`Start::Scaled`]: from p̄, and what is nearer than the rounding of its coordinates does not count. That
//!   knows where p̄ is, not how p̄ came about, nor that a ray along the surface gets away from it slowly.
//! - [`Start::Bound`]: p̄ is put back on the surface, as well as its numbers allow ([`mod@foot`]); how far it
//!   may still be off follows from the shape. By so much along the normal, to the side where the ray goes,
//!   and it starts outside.
//! - [`Start::Exclude`]: from p̄, and what it is on does not count, however far. But a ray within a sphere
//!   has to meet it.

pub mod foot;

use bounds::{Leaves, Query};
use math::{Ray3, Real, Span, Vector};
use signature::{Method, Shape};

use crate::Landing;

/// The remedies, by the names that `--method` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// λ > 0.
    None,
    /// The customary 1e-3.
    Fixed,
    /// In units of the last digit of p̄.
    Scaled,
    /// By the error bound of the intersection.
    Bound,
    /// Not the same part again.
    Exclude,
}

impl Start {
    /// All, the default first, then from the simplest to the surest.
    pub const ALL: [Start; 5] = [Start::Bound, Start::None, Start::Fixed, Start::Scaled, Start::Exclude];

    /// The name that `--method` takes.
    pub fn name(self) -> &'static str {
        match self {
            Start::None => "none",
            Start::Fixed => "fixed",
            Start::Scaled => "scaled",
            Start::Bound => "bound",
            Start::Exclude => "exclude",
        }
    }
}

/// The customary offset, in units of the scene, whatever those are.
pub const CUSTOMARY: f64 = 1e-3;

/// Where the rays start that leave one point. Of two, the first is for those that leave to the side of the
/// face's normal, the second for the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Starts<R: Real> {
    /// Their origins.
    pub origins: [R::Vec3; 2],
    /// What is known of the part that they leave.
    pub leaves: [Leaves; 2],
    /// The face's normal.
    pub face_normal: R::Vec3,
    /// How much of their way does not count: a length, in units of the scene, whatever the direction's is.
    pub skipped: R,
}

/// What rays need not be tried on that leave `part`, to one side and to the other.
///
/// A ray that starts outside of something convex and goes away from it does not come back: there is nothing
/// to try. Of what stands here, everything is convex, or inside of something convex that it touches there
/// (NFF's open cone, which is met again from within only). What is flat has no inside.
pub fn spared<R: Real>(shape: &Shape<R>, part: usize) -> [Leaves; 2] {
    match shape {
        Shape::Plane(_) | Shape::Triangle(_) | Shape::Polygon(_) | Shape::Mesh(_) => {
            [Leaves::Passes(part), Leaves::Passes(part)]
        }
        Shape::Sphere(_) | Shape::Solid(_) | Shape::OpenCone(_) | Shape::Deformed(_) => {
            [Leaves::Passes(part), Leaves::Within(part)]
        }
    }
}

impl<R: Real> Starts<R> {
    /// Where the rays start from a point on `shape`, which was met by the formulas of `formulas`; `face` is
    /// the face of a mesh. The landing's point must be finite. Every part is tried but what
    /// [`Start::Exclude`] passes.
    #[inline(always)]
    pub fn of(
        start: Start,
        formulas: Method,
        shape: &Shape<R>,
        face: Option<usize>,
        landing: &Landing<R>,
    ) -> Starts<R> {
        let p = landing.point;
        let zero = R::from(0.0);
        let from_p = Starts {
            origins: [p, p],
            leaves: [Leaves::Unknown; 2],
            face_normal: landing.face_normal,
            skipped: zero,
        };
        match start {
            Start::None => from_p,
            Start::Fixed => Starts { skipped: R::round_from(CUSTOMARY), ..from_p },
            Start::Scaled => Starts { skipped: last_digits(p), ..from_p },
            Start::Exclude => Starts { leaves: [Leaves::Passes(landing.part); 2], ..from_p },
            Start::Bound => Starts { origins: foot::of(formulas, shape, face, landing).origins(), ..from_p },
        }
    }

    /// A ray in some direction, of any length but zero, for as far as it goes. λ is in lengths of it.
    #[inline(always)]
    pub fn toward(&self, direction: R::Vec3) -> Query<R> {
        let span = Span::new(self.first_t(direction), R::INFINITY);
        self.leaving(direction, |origin| Query::new(Ray3::new(origin, direction), span))
    }

    /// A ray to a light, which is at λ = 1; `to_light` is the direction in which to leave. The ray has no
    /// direction where the light is at the very place from where it starts.
    ///
    /// The light itself does not count, nor a surface that it lies on: λ ends below 1 by what λ may be off
    /// there, which is [`bounds::Reach::ULPS`] units of its last digit, the rounding of the direction among
    /// them.
    #[inline(always)]
    pub fn to(&self, light: R::Vec3, to_light: R::Vec3) -> Query<R> {
        let digit = 1.0 / (1u64 << R::DIGITS) as f64;
        // exercise light: Up to which λ can something stand before the light?
        let before_the_light: R = R::round_from(1.0 - bounds::Reach::ULPS * digit);
        // end light
        self.leaving(to_light, |origin| {
            // exercise direction: Which direction has the light at λ = 1?
            let direction: R::Vec3 = light - origin;
            // end direction
            // exercise span: Which λ count: from where to where, and do the ends?
            let span: Span<R> = Span::new(self.first_t(direction), before_the_light);
            // end span
            Query::new(Ray3::new(origin, direction), span)
        })
    }

    /// A query for a ray that leaves in this direction, with what is known of the part that it leaves.
    #[inline(always)]
    fn leaving(&self, direction: R::Vec3, from: impl Fn(R::Vec3) -> Query<R>) -> Query<R> {
        let ([above, below], [leaves_above, leaves_below]) = (self.origins, self.leaves);
        match self.face_normal.dot(direction) < R::from(0.0) {
            false => Query { leaves: leaves_above, ..from(above) },
            true => Query { leaves: leaves_below, ..from(below) },
        }
    }

    /// The smallest λ that counts: above 0 in any case.
    #[inline(always)]
    fn first_t(&self, direction: R::Vec3) -> R {
        if self.skipped > R::from(0.0) {
            let t = self.skipped / direction.length();
            if t > R::SMALLEST {
                return t;
            }
        }
        R::SMALLEST
    }
}

/// 2 ε (|x| + |y| + |z|), a unit of the last digit of each coordinate twice: once for p̄, once for the ray
/// from it.
fn last_digits<R: Real>(p: R::Vec3) -> R {
    let digit = 1.0 / (1u64 << (R::DIGITS - 1)) as f64;
    let size: f64 = p.in_f64::<3>().into_iter().map(f64::abs).sum();
    R::round_from(2.0 * digit * size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// By hand: what goes down starts below, all else above; what runs along the surface does not go into it.
    #[test]
    fn a_ray_along_the_surface_starts_above_it() {
        let (above, below) = (DVec3::new(1.0, 0.25, 2.0), DVec3::new(1.0, -0.25, 2.0));
        let starts = Starts::<f64> {
            origins: [above, below],
            leaves: [Leaves::Passes(3), Leaves::Within(3)],
            face_normal: DVec3::Y,
            skipped: 0.0,
        };
        let (steep, smallest) = (DVec3::new(1.0, 2.0, 0.0), f64::SMALLEST);
        for (direction, want) in [
            (steep, (above, Leaves::Passes(3))),
            (-steep, (below, Leaves::Within(3))),
            (DVec3::X, (above, Leaves::Passes(3))),
            (DVec3::new(-3.0, -smallest, 4.0), (below, Leaves::Within(3))),
        ] {
            let query = starts.toward(direction);
            assert_eq!((query.ray.origin, query.leaves), want, "{direction:?}");
        }
    }
}

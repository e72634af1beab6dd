//! No division by det A, and no digit lost on the way.
//!
//! A⁻¹ = adj A / det A is where the notes lose their digits: the numbers of adj A are differences of products, and where
//! A squashes an object a million times, what is left of them after rounding, divided by a small det A, is off by as
//! much. But nothing has to be divided. In a space that is larger by s = |det A| the ray is
//!
//! ```text
//! o″ = adj A (a − t) sgn det A,   d″ = adj A d sgn det A
//! ```
//!
//! and the object is the unit object at scale s: sums and products of the numbers as given, each of which can be kept
//! with all its digits ([`math::Sure`]). λ is the same in this space too.
//!
//! Where only the line matters, even o″ is too much. The line's moment m = (a − t) × d is deformed by Aᵀ alone:
//!
//! ```text
//! o″ × d″ = adj A (a − t) × adj A d = det A · Aᵀ m
//! ```
//!
//! so that the discriminant B² − A C = A s² − ‖o″ × d″‖² of the sphere ‖o″ + λ d″‖ = s is s² (‖d″‖² − ‖w‖²), with
//! w = Aᵀ m, and s² decides nothing. For a triangle the components of w are what α and β are decided by; and the point
//! on the unit object follows from w and d″ with nothing large to subtract.
//!
//! Each formula is tried in `f64` with a bound on its error, then with twice the digits, then exactly: first for the
//! verdict, which consists of signs, then for the λ of the one place that is met. What this promises for every finite
//! ray and every matrix that is not singular: hit or miss is exact, and λ is off by less than a unit of its last digit.
//! What it costs is told by `trade`: about four times the notes' time in the ordinary regime, at whatever condition; and
//! microseconds for a tie, for an origin on the surface, and for numbers at the ends of the range.

mod corrected;
mod exact;
mod flat;
mod line;
mod place;
mod solid;
mod solve;
mod sphere;
mod stored;
#[cfg(test)]
mod tests;

use math::{Certainty, Degenerate, Hit, Ray3, Real, Span, Vector, Wide};
use quadric::robust::Verdict;

use crate::{Deformed, Found, Hit3};

pub(crate) use stored::Stored;

/// Every number of the robust method in `f64`, rounded for the reader.
///
/// A degenerate ray gives values that mean nothing; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<'a, R: Real> {
    /// The ray a + λ d.
    pub ray: Ray3<R>,
    /// The deformed object, with adj A.
    pub deformed: &'a Deformed<R>,
    /// What becomes of the ray, in chapter 06's words: it misses, starts on the surface, enters or leaves. A sphere is
    /// all wall, a plane or a triangle all base.
    pub verdict: Verdict,
    /// The numbers on the way.
    pub steps: Steps,
    /// The smallest λ ≥ 0 at which the ray is on the surface; `None` for a miss.
    pub first: Option<Crossing<R>>,
}

/// The numbers on the way to λ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// How the verdict was reached.
    pub certainty: Certainty,
    /// How λ was; for a miss the same.
    pub lambda_certainty: Certainty,
    /// o″ = adj A (a − t) sgn det A
    pub o: [f64; 3],
    /// d″ = adj A d sgn det A
    pub d: [f64; 3],
    /// s = |det A|
    pub s: f64,
    /// w = Aᵀ ((a − t) × d), the moment of the line: o″ × d″ = det A w.
    pub w: [f64; 3],
    /// Of a sphere or the wall of a cylinder or cone, A, B, C and D: A λ² − 2 B λ + C = 0. For the sphere A = d″·d″,
    /// B = −o″·d″, C = o″·o″ − s², D = B² − A C = s² (A − w·w).
    pub quadratic: Option<[f64; 4]>,
}

/// Where the ray crosses the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<R> {
    /// λ*, in lengths of the direction as given, off by less than a unit of its last digit.
    pub lambda: R,
    /// r′(λ*), in the object's own space: the point on the unit object.
    pub p: [f64; 3],
    /// n, the outward unit normal there.
    pub n: [f64; 3],
    /// A⁻ᵀ n, of any length.
    pub a_inverse_transposed_n: [f64; 3],
    /// The ray comes from without. (A plane has only an outside.)
    pub enters: bool,
}

/// Works out the robust method, for a direction of any length but zero.
#[inline(always)]
pub fn robust<'a, R: Real>(ray: &Ray3<R>, deformed: &'a Deformed<R>) -> Robust<'a, R> {
    let solved = if ray.check().is_ok() { solve::first(ray, deformed) } else { solve::Solved::NOTHING };
    let solve::Solved { verdict, steps, crossing } = solved;
    Robust { ray: *ray, deformed, verdict, steps, first: crossing }
}

impl<R: Real> Robust<'_, R> {
    /// adj A sgn det A by rows, and |det A|, as they are kept.
    pub fn adjugate(&self) -> ([[f64; 3]; 3], f64) {
        let stored = &self.deformed.stored;
        (stored.near.adjugate.map(|row| row.map(|x| x.value)), stored.near.s.value)
    }

    /// The λ* of the nearest hit in `span`, in both spaces. What lies behind the origin is not looked for.
    /// `None` for a miss, [`Degenerate`] as [`Ray3::check`] says.
    #[inline(always)]
    pub fn found(&self, span: Span<R>) -> Result<Option<Found<R>>, Degenerate> {
        self.ray.check()?;
        let Some(first) = self.first else { return Ok(None) };
        // Where that comes too early, as for a ray that leaves a surface and looks for λ > 0, it may still leave.
        let crossing =
            if first.lambda < span.min { solve::exit(&self.ray, self.deformed) } else { Some(first) };
        let Some(crossing) = crossing.filter(|crossing| span.contains(crossing.lambda)) else {
            return Ok(None);
        };
        let vector = |v: [f64; 3]| {
            let [x, y, z] = v.map(R::round_from);
            R::vec3(x, y, z)
        };
        Ok(Some(Found {
            lambda: crossing.lambda,
            p: vector(crossing.p),
            n: vector(crossing.n),
            a_inverse_transposed_n: vector(crossing.a_inverse_transposed_n),
            point: self.point(&crossing),
        }))
    }

    /// The nearest hit in `span`; `None` and [`Degenerate`] as [`Robust::found`] says.
    #[inline(always)]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        let Some(found) = self.found(span)? else { return Ok(None) };
        Ok(Some(Hit { t: found.lambda + R::from(0.0), point: found.point, normal: found.normal() }))
    }

    /// r(λ*) = a + λ* d or A r′(λ*) + t, whichever adds the smaller vector.
    #[inline(always)]
    fn point(&self, crossing: &Crossing<R>) -> R::Vec3 {
        let Deformed { affine, .. } = self.deformed;
        let [a, d, t] = [self.ray.origin, self.ray.direction, affine.t].map(Vector::in_f64::<3>);
        let [e_x, e_y, e_z] = affine.a.columns.map(Vector::in_f64::<3>);
        let (lambda, [x, y, z]): (f64, _) = (crossing.lambda.into(), crossing.p);
        let along = d.map(|d| lambda * d);
        let across: [f64; 3] = [0, 1, 2].map(|axis| e_x[axis] * x + e_y[axis] * y + e_z[axis] * z);
        let size = |v: [f64; 3]| v[0].abs() + v[1].abs() + v[2].abs();
        let (from, way) = if size(along) <= size(across) { (a, along) } else { (t, across) };
        let sum = [0, 1, 2].map(|axis| from[axis] + way[axis]);
        if !size(sum).is_finite() {
            return self.far_point(crossing);
        }
        let [x, y, z] = sum.map(R::round_from);
        R::vec3(x, y, z)
    }

    /// A r′(λ*) + t in numbers that do not overflow on the way, where λ* or something else does.
    #[cold]
    #[inline(never)]
    fn far_point(&self, crossing: &Crossing<R>) -> R::Vec3 {
        if !crossing.p.iter().all(|x| x.is_finite()) {
            return self.ray.at(crossing.lambda);
        }
        let Deformed { affine, .. } = self.deformed;
        let [e_x, e_y, e_z] = affine.a.columns.map(Wide::vector::<R, 3>);
        let ([x, y, z], t) = (crossing.p.map(Wide::from), Wide::vector::<R, 3>(affine.t));
        let sum = [0, 1, 2].map(|axis| t[axis] + e_x[axis] * x + e_y[axis] * y + e_z[axis] * z);
        let [x, y, z] = sum.map(|x| R::round_from(x.to_f64()));
        R::vec3(x, y, z)
    }
}

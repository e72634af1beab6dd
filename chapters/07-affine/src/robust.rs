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
//! For a sphere even that is too much. The line's moment m = (a − t) × d is deformed by Aᵀ alone:
//!
//! ```text
//! o″ × d″ = adj A (a − t) × adj A d = det A · Aᵀ m
//! ```
//!
//! so that the discriminant B² − A C = A s² − ‖o″ × d″‖² of the sphere ‖o″ + λ d″‖ = s is s² (‖d″‖² − ‖w‖²), with
//! w = Aᵀ m, and s² decides nothing. For a triangle the components of w are what α and β are decided by.
//!
//! Each formula is tried in `f64` with a bound on its error, then with twice the digits, then exactly. The verdict is
//! exact, and λ is the number next to the true one or beside it.

mod flat;
mod sphere;
mod stored;

use math::{Degenerate, Hit, Ray3, Real, Span, Vector};

use crate::deformed::check_ray;
use crate::{Deformed, Found, Hit3, Object};

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
    /// The numbers on the way.
    pub steps: Steps,
    /// The smallest λ ≥ 0 at which the ray is on the surface; `None` for a miss.
    pub first: Option<Crossing<R>>,
}

/// The numbers on the way to λ. What a verdict did not need is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// How the verdict and λ were reached.
    pub certainty: Certainty,
    /// o″ = adj A (a − t) sgn det A
    pub o: [f64; 3],
    /// d″ = adj A d sgn det A
    pub d: [f64; 3],
    /// s = |det A|
    pub s: f64,
    /// w = Aᵀ ((a − t) × d), the moment of the line; o″ × d″ = det A w.
    pub w: [f64; 3],
    /// Of a sphere, A, B, C and D: A λ² − 2 B λ + C = 0 with A = d″·d″, B = −o″·d″, C = o″·o″ − s², and
    /// D = B² − A C = s² (A − w·w).
    pub quadratic: Option<[f64; 4]>,
}

/// Where the ray crosses the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<R> {
    /// λ*
    pub lambda: R,
    /// r′(λ*), in the object's own space: the point on the unit object.
    pub p: [f64; 3],
    /// n, the outward unit normal there.
    pub n: [f64; 3],
    /// A⁻ᵀ n, of any length.
    pub a_inverse_transposed_n: [f64; 3],
    /// The ray goes in here.
    pub enters: bool,
}

/// How the verdict was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// In plain `f64`: by more than any rounding could make up for.
    AtOnce,
    /// With twice the digits.
    TwoPart,
    /// By exact sums.
    Exact,
}

impl Certainty {
    /// What it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Certainty::AtOnce => "certain at once",
            Certainty::TwoPart => "certain with twice the digits",
            Certainty::Exact => "too close to call: summed exactly",
        }
    }
}

/// Works out the robust method.
#[inline(always)]
pub fn robust<'a, R: Real>(ray: &Ray3<R>, deformed: &'a Deformed<R>) -> Robust<'a, R> {
    let (steps, first) = if check_ray(ray).is_err() {
        (Steps::NONE, None)
    } else {
        match deformed.object {
            Object::Sphere => sphere::first(ray, deformed),
            Object::Cylinder | Object::Cone => (Steps::NONE, None),
            Object::Plane | Object::Triangle => flat::first(ray, deformed),
        }
    };
    Robust { ray: *ray, deformed, steps, first }
}

impl Steps {
    /// Nothing was worked out.
    const NONE: Steps = Steps {
        certainty: Certainty::AtOnce,
        o: [0.0; 3],
        d: [0.0; 3],
        s: 0.0,
        w: [0.0; 3],
        quadratic: None,
    };
}

impl<R: Real> Robust<'_, R> {
    /// adj A sgn det A by rows, and |det A|, as they are kept.
    pub fn adjugate(&self) -> ([[f64; 3]; 3], f64) {
        let stored = &self.deformed.stored;
        (stored.near.adjugate.map(|row| row.map(|x| x.value)), stored.near.s.value)
    }

    /// The λ* of the nearest hit in `span`, in both spaces. What lies behind the origin is not looked for.
    #[inline(always)]
    pub fn found(&self, span: Span<R>) -> Result<Option<Found<R>>, Degenerate> {
        check_ray(&self.ray)?;
        let Some(first) = self.first else { return Ok(None) };
        let crossing = if span.contains(first.lambda) {
            first
        } else {
            match self.second(first) {
                Some(second) if span.contains(second.lambda) => second,
                _ => return Ok(None),
            }
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

    /// The nearest hit in `span`.
    #[inline(always)]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        let Some(found) = self.found(span)? else { return Ok(None) };
        Ok(Some(Hit { t: found.lambda + R::from(0.0), point: found.point, normal: found.normal() }))
    }

    /// Where a ray that enters leaves again.
    #[cold]
    #[inline(never)]
    fn second(&self, first: Crossing<R>) -> Option<Crossing<R>> {
        match self.deformed.object {
            Object::Sphere if first.enters => sphere::second(&self.ray, self.deformed),
            _ => None,
        }
    }

    /// r(λ*) = a + λ* d or A r′(λ*) + t, whichever adds the smaller vector.
    #[inline(always)]
    fn point(&self, crossing: &Crossing<R>) -> R::Vec3 {
        let Deformed { affine, .. } = self.deformed;
        let [d, t] = [self.ray.direction, affine.t].map(Vector::in_f64::<3>);
        let columns = affine.a.columns.map(Vector::in_f64::<3>);
        let lambda: f64 = crossing.lambda.into();
        let way = d.map(|d| lambda * d);
        let [x, y, z] = crossing.p;
        let across: [f64; 3] =
            [0, 1, 2].map(|axis| columns[0][axis] * x + columns[1][axis] * y + columns[2][axis] * z);
        let size = |v: [f64; 3]| v[0].abs() + v[1].abs() + v[2].abs();
        if size(across) < size(way) {
            let [x, y, z] = [0, 1, 2].map(|axis| R::round_from(t[axis] + across[axis]));
            R::vec3(x, y, z)
        } else {
            self.ray.at(crossing.lambda)
        }
    }
}

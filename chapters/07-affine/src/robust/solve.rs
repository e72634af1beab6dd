//! The verdict, then λ, each with the first kind of number that is good enough; then the point and its normal.

use std::cmp::Ordering;

use math::{Bounded, Certainty, Quadratic, Ray3, Real, Sure, TwoPart};
use quadric::robust::{Place, Verdict, rise_to};
use quadric::{Part, Shape};

use super::corrected::{Corrected, corrected};
use super::exact::ExactLine;
use super::line::Line;
use super::place::{self, Plucker};
use super::{Crossing, Steps, flat, solid, sphere};
use crate::{Deformed, Object};

/// What was found.
pub(super) struct Solved<R> {
    pub(super) verdict: Verdict,
    pub(super) steps: Steps,
    pub(super) crossing: Option<Crossing<R>>,
}

/// The solid of chapter 06 that it is; `None` for the others.
pub(super) fn shape_of(object: Object) -> Option<Shape> {
    match object {
        Object::Cylinder => Some(Shape::Cylinder),
        Object::Cone => Some(Shape::Cone),
        Object::Sphere | Object::Plane | Object::Triangle => None,
    }
}

impl<N: Sure> Line<N> {
    /// What the ray meets, by signs alone; `None` in doubt, which with [`math::Exact`] nothing is.
    #[inline(always)]
    fn verdict(&self, object: Object) -> Option<Verdict> {
        match object {
            Object::Sphere => sphere::verdict(self),
            Object::Cylinder => solid::verdict(self, Shape::Cylinder),
            Object::Cone => solid::verdict(self, Shape::Cone),
            Object::Plane | Object::Triangle => flat::verdict(self, object),
        }
    }

    /// The equation of the sphere or the wall; `None` for what is flat.
    #[inline(always)]
    pub(super) fn quadratic(&self, object: Object) -> Option<Quadratic<N>> {
        match object {
            Object::Sphere => Some(sphere::quadratic(self)),
            _ => shape_of(object).map(|shape| solid::quadratic(self, shape)),
        }
    }

    /// D / s² of it.
    #[inline(always)]
    pub(super) fn chord(&self, object: Object) -> N {
        match object {
            Object::Sphere => sphere::chord(self),
            Object::Cylinder => solid::chord(self, Shape::Cylinder),
            Object::Cone => solid::chord(self, Shape::Cone),
            Object::Plane | Object::Triangle => N::of(0.0),
        }
    }

    /// λ of a place where the line enters or leaves; `None` in doubt.
    #[inline(always)]
    pub(super) fn lambda<R: Real>(&self, object: Object, place: Place, enters: bool) -> Option<R> {
        if let Some(plane) = place.plane {
            return N::quotient(&self.rise_to(plane), &self.d[2]);
        }
        let quadratic = self.quadratic(object)?;
        if quadratic.a.sign() == Some(Ordering::Equal) {
            // Along the slope of the cone: −2 B λ + C = 0
            return N::quotient(&quadratic.c, &(quadratic.b.clone() + quadratic.b));
        }
        N::root(&quadratic, if enters { -1.0 } else { 1.0 })
    }

    /// How far the plane of a part is above o″.
    #[inline(always)]
    pub(super) fn rise_to(&self, part: Part) -> N {
        rise_to(part, self.s.clone(), self.o[2].clone())
    }
}

/// The place that a verdict names, and whether the ray comes from without.
#[inline(always)]
pub(super) fn place_of(verdict: Verdict) -> Option<(Place, bool)> {
    match verdict {
        Verdict::Misses => None,
        Verdict::Starts(part) => Some((Place { part, plane: None }, true)),
        Verdict::Enters(place) => Some((place, true)),
        Verdict::Leaves(place) => Some((place, false)),
    }
}

/// The first crossing at λ ≥ 0. The ray must not be degenerate.
#[inline(always)]
pub(super) fn first<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>) -> Solved<R> {
    let near = Line::<Bounded<f64>>::of(ray, deformed, deformed.stored.near);
    let Some(verdict) = near.verdict(deformed.object) else { return carefully(ray, deformed, None) };
    let steps = |lambda_certainty| near.steps(deformed, [Certainty::AtOnce, lambda_certainty]);
    if verdict == Verdict::Misses {
        return Solved { verdict, steps: steps(Certainty::AtOnce), crossing: None };
    }
    // No λ is certain to the last digit of f64 after a rounding in f64.
    let (crossing, how) = if R::DIGITS < f64::MANTISSA_DIGITS {
        (near.crossing(deformed, verdict), Certainty::AtOnce)
    } else {
        (near.corrected_crossing(ray, deformed, verdict), Certainty::TwoPart)
    };
    match crossing {
        Some(_) => Solved { verdict, steps: steps(how), crossing },
        None => carefully(ray, deformed, Some(verdict)),
    }
}

/// The same with twice the digits, where the verdict is in doubt, or λ.
#[cold]
#[inline(never)]
fn carefully<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>, verdict: Option<Verdict>) -> Solved<R> {
    let fine = Line::<Bounded<TwoPart>>::of(ray, deformed, deformed.stored.fine);
    let how = if verdict.is_some() { Certainty::AtOnce } else { Certainty::TwoPart };
    let verdict = verdict.or_else(|| fine.verdict(deformed.object));
    let crossing = verdict.and_then(|verdict| fine.crossing(deformed, verdict));
    let steps = |certainties| fine.steps(deformed, certainties);
    match (verdict, crossing) {
        (Some(verdict), Some(_)) => Solved { verdict, steps: steps([how, Certainty::TwoPart]), crossing },
        (Some(Verdict::Misses), _) => {
            Solved { verdict: Verdict::Misses, steps: steps([how; 2]), crossing: None }
        }
        (Some(verdict), None) => {
            let crossing = ExactLine::of(ray, deformed).crossing(deformed, verdict);
            Solved { verdict, steps: steps([how, Certainty::Exact]), crossing }
        }
        (None, _) => {
            let exact = ExactLine::of(ray, deformed);
            // No sign of an exact number is in doubt.
            let verdict = exact.line.verdict(deformed.object).unwrap_or(Verdict::Misses);
            let crossing = exact.crossing(deformed, verdict);
            Solved { verdict, steps: steps([Certainty::Exact; 2]), crossing }
        }
    }
}

/// Where a line that meets a solid leaves it, at an λ of either sign; `None` for what is flat.
#[cold]
#[inline(never)]
pub(super) fn exit<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>) -> Option<Crossing<R>> {
    let exact = ExactLine::of(ray, deformed);
    let place = match (deformed.object, shape_of(deformed.object)) {
        (Object::Sphere, _) => sphere::WALL,
        (_, Some(shape)) => solid::beside(&exact.line, shape).exit()?,
        _ => return None,
    };
    exact.crossing(deformed, Verdict::Leaves(place))
}

impl<T: Copy> Line<Bounded<T>>
where
    Bounded<T>: Sure,
{
    /// The crossing that a verdict names; `None` where λ is in doubt, or a number overflows.
    #[inline(always)]
    fn crossing<R: Real>(&self, deformed: &Deformed<R>, verdict: Verdict) -> Option<Crossing<R>> {
        let object = deformed.object;
        let (place, enters) = place_of(verdict)?;
        let about = |v: &[Bounded<T>; 3]| [v[0].about(), v[1].about(), v[2].about()];
        let (lambda, p) = if let Verdict::Starts(_) = verdict {
            let s = self.s.about();
            (R::from(0.0), about(&self.o).map(|x| x / s))
        } else {
            let line = Plucker { d: about(&self.d), w: about(&self.w), chord: self.chord(object).about() };
            (self.lambda(object, place, enters)?, line.point(object, place, enters))
        };
        crossing_at(deformed, lambda, p, place.part, enters)
    }
}

impl Line<Bounded<f64>> {
    /// The same with λ corrected to the last digit of `f64`.
    #[inline(always)]
    fn corrected_crossing<R: Real>(
        &self,
        ray: &Ray3<R>,
        deformed: &Deformed<R>,
        verdict: Verdict,
    ) -> Option<Crossing<R>> {
        if let Verdict::Starts(_) = verdict {
            return self.crossing(deformed, verdict);
        }
        let (place, enters) = place_of(verdict)?;
        let Corrected { lambda, p } = corrected(self, ray, deformed, place, enters)?;
        crossing_at(deformed, lambda, p, place.part, enters)
    }
}

/// The crossing at a point of the unit object, with its normal; `None` where a number overflows.
#[inline(always)]
fn crossing_at<R: Real>(
    deformed: &Deformed<R>,
    lambda: R,
    p: [f64; 3],
    part: Part,
    enters: bool,
) -> Option<Crossing<R>> {
    let n = place::normal(deformed.object, part, p);
    // A⁻ᵀ n is adjᵀ A n but for its length.
    let [x, y, z] = deformed.stored.near.adjugate.map(|row| row.map(|x| x.value));
    let m = [0, 1, 2].map(|axis| x[axis] * n[0] + y[axis] * n[1] + z[axis] * n[2]);
    let largest = m.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let fits = p.iter().chain(&m).all(|x| x.is_finite()) && largest > 0.0;
    let lambda = lambda + R::from(0.0); // minus zero is zero
    fits.then(|| Crossing { lambda, p, n, a_inverse_transposed_n: m.map(|x| x / largest), enters })
}

impl<N: Sure> Line<N> {
    /// The numbers for the reader.
    #[inline(always)]
    fn steps<R: Real>(&self, deformed: &Deformed<R>, [certainty, lambda_certainty]: [Certainty; 2]) -> Steps {
        let about = |v: &[N; 3]| [v[0].about(), v[1].about(), v[2].about()];
        let quadratic = self.quadratic(deformed.object);
        let quadratic = quadratic.map(|Quadratic { a, b, c, d }| [a, b, c, d].map(|x| x.about()));
        // in the line the sign of det A is in it
        let w = about(&self.w).map(|x| if deformed.stored.mirrors { -x } else { x });
        let (o, d, s) = (about(&self.o), about(&self.d), self.s.about());
        Steps { certainty, lambda_certainty, o, d, s, w, quadratic }
    }
}

impl<R> Solved<R> {
    /// For a ray that asks nothing.
    pub(super) const NOTHING: Solved<R> = Solved {
        verdict: Verdict::Misses,
        steps: Steps {
            certainty: Certainty::AtOnce,
            lambda_certainty: Certainty::AtOnce,
            o: [f64::NAN; 3],
            d: [f64::NAN; 3],
            s: f64::NAN,
            w: [f64::NAN; 3],
            quadratic: None,
        },
        crossing: None,
    };
}

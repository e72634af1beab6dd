//! One ray, one part after the other: which is hit first?
//!
//! The robust methods say so exactly. They need not be asked for every part: a glance in plain `f64` tells
//! nearly always that a part is not met, or that it is nearer or farther than the nearest so far
//! ([`math::glance`]). What is close is decided by the robust λ, and so the answer is the one that the robust
//! methods alone would give.
//!
//! The notes' formulas are sometimes wrong about a ray that passes by, and which of the parts a ray is tried
//! on depends on the bounds; so would then what is seen. To be the same by every bound, a hit of theirs
//! counts only where the ray is in the part's own box, and not before it enters that box: a bound in which
//! that box is leaves no such hit out.

use std::hint::black_box;

use affine::Affine;
use math::glance::First;
use math::{Glance, Ray3, Real, Span};
use ray_sphere::Line;
use signature::{Method, Shape};

use crate::wide::{Passages, Spheres};
use crate::{Box3, Leaves, Parts, Query, Reach, Slabs};

/// By which formulas.
#[derive(Clone, Debug)]
pub(crate) enum Trial {
    Robust,
    /// With each part's own box; `None` for a plane.
    Notes(Vec<Option<Box3>>),
}

impl Trial {
    pub(crate) fn of<R: Real>(formulas: Method, parts: &Parts<'_, R>) -> Trial {
        match formulas {
            Method::Robust => Trial::Robust,
            Method::Notes => Trial::Notes((0..parts.count()).map(|part| parts.bounds(part)).collect()),
        }
    }

    pub(crate) fn formulas(&self) -> Method {
        match self {
            Trial::Robust => Method::Robust,
            Trial::Notes(_) => Method::Notes,
        }
    }

    /// A ray that was tried on nothing yet.
    #[inline(always)]
    pub(crate) fn begins<'a, R: Real>(
        &'a self,
        parts: &'a Parts<'a, R>,
        carried: Option<&'a Affine<R>>,
        query: &'a Query<R>,
    ) -> Tried<'a, R> {
        let boxes = match self {
            Trial::Robust => None,
            Trial::Notes(boxes) => Some(boxes.as_slice()),
        };
        let (without, within) = match query.leaves {
            Leaves::Unknown => (usize::MAX, usize::MAX),
            Leaves::Passes(part) | Leaves::PassesIdly(part) => (part, usize::MAX),
            Leaves::Within(part) => (usize::MAX, part),
        };
        let line = Line::of(&query.ray);
        Tried { parts, query, line, without, within, boxes, carried, nearest: None }
    }
}

/// A ray, and the nearest of the parts that it was tried on.
pub(crate) struct Tried<'a, R: Real> {
    parts: &'a Parts<'a, R>,
    query: &'a Query<R>,
    line: Line,
    without: usize,
    within: usize,
    boxes: Option<&'a [Option<Box3>]>,
    carried: Option<&'a Affine<R>>,
    nearest: Option<Nearest<R>>,
}

/// The nearest part so far.
#[derive(Clone, Copy)]
struct Nearest<R> {
    part: usize,
    /// λ is not below this, as the robust method rounds it.
    low: f64,
    /// Nor is it above this, which is not beyond the span.
    reach: R,
    /// λ, where it was needed.
    lambda: Option<R>,
}

impl<R: Real> Nearest<R> {
    /// With λ to its last digit.
    fn at(part: usize, lambda: R) -> Nearest<R> {
        let exact: f64 = lambda.into();
        Nearest { part, low: exact, reach: lambda, lambda: Some(lambda) }
    }
}

impl<R: Real> Tried<'_, R> {
    /// A glance at many spheres does not tell which of them it is to be tried on: it is tried by the notes'
    /// formulas, or carried into a space of each part's own.
    #[inline(always)]
    pub(crate) fn is_tried_on_all(&self) -> bool {
        self.boxes.is_some() || self.carried.is_some()
    }

    /// The line of the ray.
    #[inline(always)]
    pub(crate) fn line(&self) -> Line {
        self.line
    }

    /// Tries one more part. If it is the nearest so far, how far a nearer one can be: λ, or a little more.
    #[inline(always)]
    pub(crate) fn on(&mut self, part: usize) -> Option<R> {
        if part == self.without {
            self.on_idly(part);
            return None;
        }
        if self.is_tried_on_all() {
            return self.on_the_long_way(part);
        }
        let glance = self.parts.glance(part, &self.query.ray, &self.line);
        self.on_at_a_glance(part, glance)
    }

    /// The same for a sphere in a block, of which somebody has seen how the line passes it.
    #[inline(always)]
    pub(crate) fn on_sphere(&mut self, block: &Spheres, past: &Passages, lane: usize) -> Option<R> {
        let part = block.part(lane);
        if part == self.without {
            self.on_idly(part);
            return None;
        }
        if self.is_tried_on_all() {
            return self.on_the_long_way(part);
        }
        self.on_at_a_glance(part, Spheres::glance(&self.line, past, lane))
    }

    /// A part that does not count, where it is tried all the same.
    #[inline(always)]
    fn on_idly(&self, part: usize) {
        let Query { ray, span, leaves } = self.query;
        if matches!(leaves, Leaves::PassesIdly(_)) {
            let glance = self.parts.glance(part, ray, &self.line);
            if black_box(glance.first_within(*span)) == First::Unsure {
                black_box(self.parts.hit(part, ray, *span));
            }
        }
    }

    #[inline(always)]
    fn on_at_a_glance(&mut self, part: usize, glance: Glance) -> Option<R> {
        let glance = if part == self.within { glance.from_within() } else { glance };
        let Span { min, max } = self.query.span;
        // what is certainly farther than the nearest is as good as missed
        let reach = self.nearest.as_ref().map_or(max, |nearest| nearest.reach);
        match glance.first_within(Span::new(min, reach)) {
            First::None => None,
            First::Between(low, high) => match &self.nearest {
                Some(nearest) if high >= nearest.low => self.on_exactly(part),
                _ => {
                    let above = R::round_from(high * (1.0 + 2.0 / (1u64 << R::DIGITS) as f64));
                    let reach = if above < max { above } else { max };
                    self.nearest = Some(Nearest { part, low, reach, lambda: None });
                    Some(reach)
                }
            },
            First::Unsure => self.on_exactly(part),
        }
    }

    /// λ by the robust method. A ray that starts within a sphere can only leave it.
    fn hit(&self, part: usize) -> Option<R> {
        let Query { ray, span, .. } = self.query;
        match self.parts.shape(part) {
            Shape::Sphere(sphere) if part == self.within => {
                Some(ray_sphere::robust::hit_from_within(ray, sphere, *span).ok()??.t)
            }
            _ => self.parts.hit(part, ray, *span),
        }
    }

    /// Where λ to its last digit is needed.
    #[cold]
    #[inline(never)]
    fn on_exactly(&mut self, part: usize) -> Option<R> {
        let lambda = self.hit(part)?;
        if let Some(nearest) = self.nearest {
            // what is certain at a glance is a hit
            let other = nearest.lambda.or_else(|| self.hit(nearest.part))?;
            if !(lambda < other || (lambda == other && part < nearest.part)) {
                self.nearest = Some(Nearest::at(nearest.part, other));
                return None;
            }
        }
        self.nearest = Some(Nearest::at(part, lambda));
        Some(lambda)
    }

    /// By the notes' formulas, or in a space of the part's own: A⁻¹ (p̄ − t) and A⁻¹ d⃗.
    #[inline(never)]
    fn on_the_long_way(&mut self, part: usize) -> Option<R> {
        let Some(by) = self.carried else { return self.on_by_notes(part, self.query.ray) };
        let Ray3 { origin, direction } = self.query.ray;
        let ray = Ray3::new(by.a.times(origin - by.t), by.a.times(direction));
        match self.boxes {
            Some(_) => self.on_by_notes(part, ray),
            None => {
                let glance = self.parts.glance(part, &ray, &Line::of(&ray));
                self.on_at_a_glance(part, glance)
            }
        }
    }

    fn on_by_notes(&mut self, part: usize, ray: Ray3<R>) -> Option<R> {
        let boxes = self.boxes?;
        let span = self.query.span;
        let max = self.nearest.as_ref().and_then(|nearest| nearest.lambda).unwrap_or(span.max);
        let span = Span::new(span.min, max);
        let enters = match &boxes[part] {
            Some(bounds) => Slabs::new(&ray).enter(bounds, Reach::of(span))?,
            None => 0.0,
        };
        let lambda = self.parts.whole_hit(Method::Notes, part, &ray, span)?.t;
        let exact: f64 = lambda.into();
        let loses_tie = self.nearest.as_ref().is_some_and(|nearest| lambda == max && nearest.part < part);
        if exact < f64::from(enters) || loses_tie {
            return None;
        }
        self.nearest = Some(Nearest::at(part, lambda));
        Some(lambda)
    }

    /// The nearest part, and its λ where it was needed.
    #[inline(always)]
    pub(crate) fn nearest(&self) -> Option<(usize, Option<R>)> {
        self.nearest.as_ref().map(|nearest| (nearest.part, nearest.lambda))
    }
}

#[cfg(test)]
mod tests;

//! Signs first, then one root: [`mod@crate::robust`]'s way, for an open cone anywhere in space.
//!
//! The axis v = apex − base is a difference, and a rounded one would be another cone's: a ray that lies in the wall
//! would be beside it. So v is kept with all its digits, and f, which the notes divide by (v·v)², is not divided at all.
//! Each formula is tried in `f64` with a bound on its error, then with twice the digits, then exactly.
//!
//! Before that both roots are worked out in plain `f64`, with bounds that follow from a few lengths
//! (`at_once.rs`). Nearly every ray is told so, and λ needs f in one more place then
//! (`plain.rs`, `place.rs`).

use math::wide::{exponent_of, scaled};
use math::{Bounded, Certainty, Degenerate, Exact, Hit, Ray3, Real, Span, TwoPart, Vector, Wide};

use super::line::Line;
use super::plain::{plain_t, plainly};
use super::{OpenCone, Verdict};
use crate::Hit3;

/// Every number of the robust method.
///
/// A degenerate question is a miss here; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray.
    pub ray: Ray3<R>,
    /// The cone.
    pub cone: OpenCone<R>,
    /// What becomes of the ray at λ ≥ 0.
    pub verdict: Verdict,
    /// With what kind of number the verdict was reached.
    pub certainty: Certainty,
    /// λ ≥ 0 of the place that is met, in lengths of the direction, off by less than a unit of its last
    /// digit; `None` for a miss.
    pub t: Option<R>,
    /// With what kind of number t was worked out.
    pub t_certainty: Certainty,
    refused: Option<Degenerate>,
}

/// Works out the robust method, for a direction of any length but zero.
#[inline]
pub fn robust<R: Real>(ray: &Ray3<R>, cone: &OpenCone<R>) -> Robust<R> {
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let measures = cone.in_f64();
    let Some((wall, verdict, lambda)) = plainly(&measures, o, d) else {
        return carefully(ray, cone, &measures, [o, d]);
    };
    let (t, t_certainty) = match verdict {
        Verdict::Misses => (None, Certainty::AtOnce),
        _ => plain_t(&wall, &measures, [o, d], verdict, lambda)
            .unwrap_or_else(|| t_of(&measures, o, d, verdict)),
    };
    let certainty = Certainty::AtOnce;
    Robust { ray: *ray, cone: *cone, verdict, certainty, t, t_certainty, refused: None }
}

/// The same where plain `f64` is in doubt.
#[cold]
#[inline(never)]
fn carefully<R: Real>(
    ray: &Ray3<R>,
    cone: &OpenCone<R>,
    measures: &OpenCone<f64>,
    [o, d]: [[f64; 3]; 2],
) -> Robust<R> {
    let (ray, cone, at_once) = (*ray, *cone, Certainty::AtOnce);
    if let Err(reason) = cone.check(&ray) {
        let (verdict, t, refused) = (Verdict::Misses, None, Some(reason));
        return Robust { ray, cone, verdict, certainty: at_once, t, t_certainty: at_once, refused };
    }
    let (verdict, certainty) = match Line::<Bounded<f64>>::new(measures, o, d).verdict() {
        Some(verdict) => (verdict, at_once),
        None => careful_verdict(measures, o, d, 0.0),
    };
    let (t, t_certainty) = t_of(measures, o, d, verdict);
    Robust { ray, cone, verdict, certainty, t, t_certainty, refused: None }
}

/// The verdict from λ on, with twice the digits, or exactly.
#[cold]
#[inline(never)]
fn careful_verdict(cone: &OpenCone<f64>, o: [f64; 3], d: [f64; 3], lambda: f64) -> (Verdict, Certainty) {
    if let Some(verdict) = Line::<Bounded<TwoPart>>::new(cone, o, d).starting_at(lambda).verdict() {
        return (verdict, Certainty::TwoPart);
    }
    // No sign of an exact number is in doubt.
    let verdict = Line::<Exact>::new(cone, o, d).starting_at(lambda).verdict();
    (verdict.unwrap_or(Verdict::Misses), Certainty::Exact)
}

/// λ of the verdict: for f32 plain f64 is nearly always enough, for f64 twice the digits.
#[inline(always)]
fn t_of<R: Real>(cone: &OpenCone<f64>, o: [f64; 3], d: [f64; 3], verdict: Verdict) -> (Option<R>, Certainty) {
    if verdict == Verdict::Misses {
        return (None, Certainty::AtOnce);
    }
    if R::DIGITS < f64::MANTISSA_DIGITS
        && let Some(t) = Line::<Bounded<f64>>::new(cone, o, d).t(verdict)
    {
        return (Some(t), Certainty::AtOnce);
    }
    if let Some(t) = Line::<Bounded<TwoPart>>::new(cone, o, d).t(verdict) {
        return (Some(t), Certainty::TwoPart);
    }
    (exact_t(cone, o, d, verdict), Certainty::Exact)
}

#[cold]
#[inline(never)]
fn exact_t<R: Real>(cone: &OpenCone<f64>, o: [f64; 3], d: [f64; 3], verdict: Verdict) -> Option<R> {
    Line::<Exact>::new(cone, o, d).t(verdict)
}

/// Whether the λ ≥ 0 of which t is the rounded value is clearly in a span from `min` on: that begins no later than the
/// ray, or t is larger by so much that λ is, too.
#[inline(always)]
fn is_clearly_from<R: Real>(min: R, t: R) -> bool {
    const LESS: f64 = 1.0 - 1.0 / (1 << 20) as f64;
    let (t, min): (f64, f64) = (t.into(), min.into());
    min <= 0.0 || t * LESS > min
}

impl<R: Real> Robust<R> {
    /// The first hit in `span`. That λ ≥ span.min is decided exactly, and so a t that comes out a rounding below it is
    /// given as span.min; span.max is compared with t as rounded. What lies behind the origin is not looked
    /// for. The normal is that of [`OpenCone::normal`], away from the axis.
    ///
    /// `None` for a miss, [`Degenerate`] for a question without an answer, see [`OpenCone::check`].
    #[inline(always)]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        let Some(t) = self.t else { return self.refused.map_or(Ok(None), Err) };
        let (verdict, t) = if is_clearly_from(span.min, t) {
            (self.verdict, t)
        } else {
            let Some(later) = self.later(span.min) else { return Ok(None) };
            later
        };
        if !(span.min <= t && t <= span.max) {
            return Ok(None);
        }
        let t = t + R::from(0.0); // minus zero is zero
        Ok(Some(self.hit_at(verdict, t)))
    }

    /// The verdict from an λ > 0 on, and its t.
    #[cold]
    #[inline(never)]
    fn later(&self, lambda: R) -> Option<(Verdict, R)> {
        if !lambda.is_finite() {
            return None;
        }
        let [o, d] = [self.ray.origin, self.ray.direction].map(Vector::in_f64::<3>);
        let cone = self.cone.in_f64();
        let (verdict, _) = careful_verdict(&cone, o, d, lambda.into());
        let t = match verdict {
            Verdict::Starts(_) => lambda,
            _ => t_of::<R>(&cone, o, d, verdict).0?,
        };
        Some((verdict, if t < lambda { lambda } else { t }))
    }

    /// Point and normal.
    #[inline(always)]
    fn hit_at(&self, verdict: Verdict, t: R) -> Hit3<R> {
        let point = self.ray.at(t);
        if t.is_finite() && point.is_finite() {
            let normal = if self.is_tip(verdict) { self.cone.tip_normal() } else { self.cone.normal(point) };
            return Hit { t, point, normal };
        }
        self.far_hit(verdict, t)
    }

    /// Where λ or the point is beyond the largest number. A direction that is 2^k times as long leads to the same point,
    /// by a λ that is a number.
    #[cold]
    #[inline(never)]
    fn far_hit(&self, verdict: Verdict, t: R) -> Hit3<R> {
        let [o, mut d] = [self.ray.origin, self.ray.direction].map(Vector::in_f64::<3>);
        let cone = self.cone.in_f64();
        let mut lambda: f64 = t.into();
        if !t.is_finite() {
            // The direction is short: longer it keeps all its digits.
            let longest = d.iter().fold(0.0, |most: f64, component| most.max(component.abs()));
            d = d.map(|component| scaled(component, 10 - exponent_of(longest)));
            lambda = t_of::<f64>(&cone, o, d, verdict).0.unwrap_or(0.0);
        }
        let point = [0, 1, 2].map(|axis| Wide::from(o[axis]) + Wide::from(lambda) * Wide::from(d[axis]));
        let [x, y, z] = point.map(|component| R::round_from(component.to_f64()));
        let normal = if self.is_tip(verdict) { self.cone.tip_normal() } else { self.cone.wide_normal(point) };
        Hit { t, point: R::vec3(x, y, z), normal }
    }

    /// Whether it is the tip that is met, where the wall has no normal.
    #[inline(always)]
    fn is_tip(&self, verdict: Verdict) -> bool {
        verdict.end().is_some_and(|end| self.cone.radius(end) == R::from(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 2^20 (1 − 2^−20) is 2^20 − 1.
    #[test]
    fn a_span_clearly_begins_before_t() {
        let (t, less) = (2.0_f64.powi(20), 2.0_f64.powi(20) - 1.0);
        for min in [f64::NEG_INFINITY, -1.0, 0.0, 1.0, less.next_down()] {
            assert!(is_clearly_from(min, t), "{min}");
        }
        for min in [less, t, f64::INFINITY, f64::NAN] {
            assert!(!is_clearly_from(min, t), "{min}");
        }
        assert!(is_clearly_from(0.0, 0.0), "no λ is below zero");
    }
}

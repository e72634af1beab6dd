//! The deformed sphere: ‖o″ + λ d″‖ = s.

use std::cmp::Ordering;

use math::{Exact, Quadratic, Ray3, Real, Sure, Wide};

use super::stored::{self, Line, Scaled};
use super::{Certainty, Crossing, Steps};
use crate::Deformed;

/// Everything that is worked out, in one kind of number.
struct Work<N> {
    line: Line<N>,
    scaled: Scaled<N>,
    quadratic: Quadratic<N>,
    /// D / s² = ‖d″‖² − ‖w‖²
    chord: N,
}

/// What a ray does.
#[derive(Clone, Copy)]
enum Verdict {
    Misses,
    /// From without, or on the surface and inward.
    Enters,
    /// On the surface, and outward or along it.
    Starts,
    /// From within.
    Leaves,
}

impl<N: Sure> Work<N> {
    #[inline(always)]
    fn of<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>, scaled: Scaled<N>) -> Work<N> {
        let line = Line::of(ray, deformed, &scaled.adjugate);
        let s = scaled.s.clone();
        let a = N::dot(&line.d, &line.d);
        let b = -N::dot(&line.o, &line.d);
        let c = N::dot(&line.o, &line.o) - s.clone() * s.clone();
        let chord = a.clone() - N::dot(&line.w, &line.w);
        let d = s.clone() * s * chord.clone();
        Work { line, scaled, quadratic: Quadratic { a, b, c, d }, chord }
    }

    /// By signs alone; `None` in doubt.
    #[inline(always)]
    fn verdict(&self) -> Option<Verdict> {
        use Ordering::{Equal, Greater, Less};
        let Quadratic { b, c, .. } = &self.quadratic;
        if self.chord.sign()? == Less {
            return Some(Verdict::Misses);
        }
        Some(match (c.sign()?, b.sign()?) {
            (Greater, Greater) => Verdict::Enters,
            (Greater, _) => Verdict::Misses,
            (Equal, Greater) => Verdict::Enters,
            (Equal, _) => Verdict::Starts,
            (Less, _) => Verdict::Leaves,
        })
    }

    /// λ* for a verdict that is no miss; `None` in doubt.
    #[inline(always)]
    fn lambda<R: Real>(&self, leaves: bool) -> Option<R> {
        N::root(&self.quadratic, if leaves { 1.0 } else { -1.0 })
    }

    fn steps(&self, certainty: Certainty) -> Steps {
        let Quadratic { a, b, c, d } = &self.quadratic;
        let Line { o, d: d2, w } = &self.line;
        let about = |v: &[N; 3]| [v[0].about(), v[1].about(), v[2].about()];
        let quadratic = Some([a, b, c, d].map(N::about));
        Steps { certainty, o: about(o), d: about(d2), s: self.scaled.s.about(), w: about(w), quadratic }
    }
}

/// The first crossing at λ ≥ 0. The ray must not be degenerate.
#[inline(always)]
pub(super) fn first<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>) -> (Steps, Option<Crossing<R>>) {
    let near = Work::of(ray, deformed, deformed.stored.near);
    if let Some(answer) = certain(&near, deformed, Certainty::AtOnce) {
        return answer;
    }
    slowly(ray, deformed)
}

#[cold]
#[inline(never)]
fn slowly<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>) -> (Steps, Option<Crossing<R>>) {
    let fine = Work::of(ray, deformed, deformed.stored.fine);
    if let Some(answer) = certain(&fine, deformed, Certainty::TwoPart) {
        return answer;
    }
    let exact = Work::of(ray, deformed, stored::exactly(&deformed.affine));
    let steps = exact.steps(Certainty::Exact);
    let crossing = exact.verdict().and_then(|verdict| exactly(&exact, verdict, deformed));
    (steps, crossing)
}

/// The answer, where neither the verdict nor λ is in doubt.
#[inline(always)]
fn certain<N: Sure, R: Real>(
    work: &Work<N>,
    deformed: &Deformed<R>,
    certainty: Certainty,
) -> Option<(Steps, Option<Crossing<R>>)> {
    let verdict = work.verdict()?;
    let (leaves, lambda) = match verdict {
        Verdict::Misses => return Some((work.steps(certainty), None)),
        Verdict::Starts => (true, R::from(0.0)),
        Verdict::Enters => (false, work.lambda(false)?),
        Verdict::Leaves => (true, work.lambda(true)?),
    };
    let steps = work.steps(certainty);
    let p = point(&steps, work.chord.about(), deformed.stored.mirrors, leaves)?;
    let rows = deformed.stored.near.adjugate.map(|row| row.map(|x| x.value));
    let a_inverse_transposed_n =
        [0, 1, 2].map(|axis| p[0] * rows[0][axis] + p[1] * rows[1][axis] + p[2] * rows[2][axis]);
    Some((steps, Some(Crossing { lambda, p, n: p, a_inverse_transposed_n, enters: !leaves })))
}

/// The point on the unit sphere: the closest approach (d″ × w) sgn det A / A, and ∓ √(A − w·w) d″ / A from there.
#[inline(always)]
fn point(steps: &Steps, chord: f64, mirrors: bool, leaves: bool) -> Option<[f64; 3]> {
    let Steps { d, w, quadratic, .. } = steps;
    let [a, ..] = (*quadratic)?;
    let h = chord.max(0.0).sqrt();
    let (h, side) = (if leaves { h } else { -h }, if mirrors { -1.0 } else { 1.0 });
    let cross = [d[1] * w[2] - d[2] * w[1], d[2] * w[0] - d[0] * w[2], d[0] * w[1] - d[1] * w[0]];
    let p = [0, 1, 2].map(|axis| (side * cross[axis] + h * d[axis]) / a);
    p.iter().all(|x| x.is_finite()).then_some(p)
}

/// The same from exact sums, in numbers that cannot overflow.
fn exactly<R: Real>(work: &Work<Exact>, verdict: Verdict, deformed: &Deformed<R>) -> Option<Crossing<R>> {
    let (leaves, lambda) = match verdict {
        Verdict::Misses => return None,
        Verdict::Starts => (true, R::from(0.0)),
        Verdict::Enters => (false, work.lambda(false)?),
        Verdict::Leaves => (true, work.lambda(true)?),
    };
    let wide = |v: &[Exact; 3]| [v[0].to_wide(), v[1].to_wide(), v[2].to_wide()];
    let (d, w, a) = (wide(&work.line.d), wide(&work.line.w), work.quadratic.a.to_wide());
    let h = work.chord.to_wide().sqrt();
    let h = if leaves { h } else { -h };
    let cross = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| d[i] * w[j] - d[j] * w[i]);
    let cross = if deformed.stored.mirrors { cross.map(|x| -x) } else { cross };
    let p: [Wide; 3] = [0, 1, 2].map(|axis| (cross[axis] + h * d[axis]) / a);
    let rows = [0, 1, 2].map(|row| wide(&work.scaled.adjugate[row]));
    // A⁻ᵀ n is a direction: divided by its largest component it fits any number.
    let m = [0, 1, 2].map(|axis| p[0] * rows[0][axis] + p[1] * rows[1][axis] + p[2] * rows[2][axis]);
    let a_inverse_transposed_n = within_range(m);
    let p = p.map(Wide::to_f64);
    Some(Crossing { lambda, p, n: p, a_inverse_transposed_n, enters: !leaves })
}

/// A direction divided by its largest component.
pub(super) fn within_range(m: [Wide; 3]) -> [f64; 3] {
    let size = |x: Wide| if x.is_negative() { -x } else { x };
    let largest =
        m.into_iter().map(size).fold(Wide::ZERO, |most, x| if (most - x).is_negative() { x } else { most });
    if largest.is_zero() {
        return [0.0; 3];
    }
    m.map(|x| (x / largest).to_f64())
}

/// Where a ray that enters leaves again.
pub(super) fn second<R: Real>(ray: &Ray3<R>, deformed: &Deformed<R>) -> Option<Crossing<R>> {
    let exact = Work::of(ray, deformed, stored::exactly(&deformed.affine));
    exactly(&exact, Verdict::Leaves, deformed)
}

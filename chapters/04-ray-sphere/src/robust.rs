//! Why the others fail, and what to do about it.
//!
//! On paper D = B² − A C decides, and t = (B ± √D)/A. In floating point three things go wrong:
//!
//! 1. **B² − A C cancels.** Seen from afar both terms are (distance/radius)² times their difference:
//!    at 1e8 radii nothing of D is left in `f64`, and the verdict is a coin toss. House's way round
//!    avoids this: with P = c − x_close, at right angles to the ray, D = A (r² − P·P), and P is small.
//!    But x_close − c taken in world coordinates loses what a distant origin costs, and near a tangent
//!    r² − P·P cancels all the same.
//! 2. **B − √D cancels** when the sphere is near and large. Vieta's C = A t₁ t₂ gives the small root from
//!    the large one without a subtraction.
//! 3. **C = L·L − r² cancels** when the origin is near the surface, and even L = c − p_r is rounded.
//!
//! So: walk to the point of closest approach as House does, but from the center. Four ways of doing it follow,
//! each slower and surer than the one before; a ray takes the first whose error bound says that what is
//! left over can matter neither to the verdict nor to t nor to the normal.
//!
//! 1. **At once**, in plain `f64`. Most rays miss most spheres, and by far. A ray in `f32` ends here
//!    nearly always: products of `f32` are exact in `f64`.
//! 2. **Corrected.** t_close is a rounded number; but with that number P = L − t_close d is exact again, if it is
//!    computed in two parts ([`math::two_part`]: a number and what its rounding left, twice the digits), with
//!    the rounding error of L too. P is then not quite at right angles to d: δ = P·d / A is what the rounding of
//!    t_close left, and a² = r² − P·P + δ P·d, summed in two parts, is half the chord squared. An error ε in a²
//!    moves a by at most √ε, so t is good to the last digits even next to a tangent.
//! 3. **Near the surface**, where one of t_close ∓ h cancels, that root comes from the other by Vieta, and
//!    C, which cancels as well, from a sum with three times the digits.
//! 4. **Exactly**, in integers as long as it takes ([`math::exact`]), where even that leaves a doubt. The
//!    verdict is then true, not likely.
//!
//! Squares of 1e±200 overflow or vanish; such a question is scaled first, by powers of two (`scaled.rs`), and then
//! takes one of these ways. `f32` is computed in `f64` and rounded at the end.
//!
//! What this promises for every finite ray and sphere: hit or miss is exact. In `f64`, t is within 8 ulps, near the
//! surface 9, by the bounds that are derived beside their constants; in tens of millions of rays of every kind more
//! than 4 was never seen, and a search for the worst ones ended at 6. In `f32` it is within 1. What it costs is told by
//! `trade`: the first way is for nearly all rays; it is a few times as much near a tangent or the surface, and
//! microseconds for an exact tie.

mod at_once;
mod corrected;
mod exact;
mod near_surface;
mod scaled;

use math::two_part::two_sum;
use math::{Degenerate, Hit, Ray3, Real, Roots, Span, TwoPart, Vector};

use crate::{Hit3, Sphere};

/// Every number of the robust method, in `f64` whatever the precision of the ray. What is worked out with
/// twice the digits is rounded for the reader, so one line may not follow from the line above as it is
/// printed.
///
/// A degenerate ray or sphere gives values that mean nothing; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray.
    pub ray: Ray3<R>,
    /// The sphere.
    pub sphere: Sphere<R>,
    /// L = c − p_r: the rounded difference.
    pub l: [f64; 3],
    /// What the rounding of L dropped.
    pub l_error: [f64; 3],
    /// The closest approach, and what of the line is inside the sphere.
    pub chord: Chord,
}

/// Where the line comes closest to the center, and where it crosses the sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    /// How the verdict was reached.
    pub certainty: Certainty,
    /// A = d · d
    pub a: f64,
    /// B = L · d (CSC418's with the other sign)
    pub b: f64,
    /// t_close = B / A, in lengths of the direction as given.
    pub t_close: f64,
    /// P = L − t_close d: from the point of closest approach to the center.
    pub p: [f64; 3],
    /// δ = P · d / A: what the rounding of t_close left. Zero where it is of no account.
    pub correction: f64,
    /// a² = r² − P · P + δ P · d, the square of half the chord: negative for a miss, unless it
    /// is too small for a number (`roots` tells). NaN for a degenerate ray or sphere.
    pub half_chord_squared: f64,
    /// h = √(a² / A), half the chord in lengths of the direction. `None` for a miss.
    pub h: Option<f64>,
    /// C = L · L − r², where the smaller root was found from it and not from t_close ∓ h.
    pub c: Option<f64>,
    /// The roots in lengths of the direction, t_close + (δ ∓ h), or one of them C over A and the other.
    /// `None` for a miss.
    pub roots: Option<Roots<f64>>,
}

/// How the verdict was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// In plain `f64`: by more than any rounding could make up for.
    AtOnce,
    /// With P and a² to twice the digits.
    Corrected,
    /// The same, and C to three times the digits.
    NearSurface,
    /// In one of these three ways, at a scale where squares neither overflow nor vanish.
    Scaled,
    /// By exact sums.
    Exact,
}

impl Certainty {
    /// What it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Certainty::AtOnce => "certain at once",
            Certainty::Corrected | Certainty::NearSurface => "certain by its error bound",
            Certainty::Scaled => "certain by its error bound, at another scale",
            Certainty::Exact => "too close to call: summed exactly",
        }
    }
}

/// Works out the robust method, for a direction of any length but zero.
#[inline(always)]
pub fn robust<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Robust<R> {
    robust_from(ray, sphere, f64::NEG_INFINITY)
}

/// What [`Robust::hit`] of [`robust`] says, by a shorter way: a crossing that is before the span
/// is not worked out to its last digit. That is what a ray asks that starts just within the sphere.
#[inline(always)]
pub fn hit<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
    robust_from(ray, sphere, span.min.into()).hit(span)
}

/// The same for a ray that is known to start within the sphere, however little: it can only leave it. Nothing
/// checks that it does; the crossing at the smaller root is never the hit. The span must not begin at −∞.
#[inline(always)]
pub fn hit_from_within<R: Real>(
    ray: &Ray3<R>,
    sphere: &Sphere<R>,
    span: Span<R>,
) -> Result<Option<Hit3<R>>, Degenerate> {
    let mut robust = robust_from(ray, sphere, f64::INFINITY);
    if let Some(roots) = &mut robust.chord.roots {
        roots.near = f64::NEG_INFINITY;
    }
    robust.hit(span)
}

/// The robust method; the near root may be rough where it is before `from`.
#[inline(always)]
fn robust_from<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>, from: f64) -> Robust<R> {
    let [p_r, d, c] = [ray.origin, ray.direction, sphere.center].map(Vector::in_f64::<3>);
    let r: f64 = sphere.radius.into();
    let l = two_part_difference(c, p_r);
    let chord = match at_once::chord::<R>(l, d, r) {
        at_once::Found::Certain(chord) => chord,
        at_once::Found::Doubtful { a, b, t_close } => {
            corrected::chord(l, d, r, [a, b, t_close], from).unwrap_or_else(|| exact::chord(ray, sphere))
        }
        at_once::Found::OutOfRange => scaled::chord(ray, sphere),
    };
    Robust { ray: *ray, sphere: *sphere, l: l.map(|part| part.hi), l_error: l.map(|part| part.lo), chord }
}

/// The chord by the first three ways; `None` where they leave a doubt, or squares overflow or vanish.
fn certain<R: Real>(l: [TwoPart; 3], d: [f64; 3], r: f64) -> Option<Chord> {
    match at_once::chord::<R>(l, d, r) {
        at_once::Found::Certain(chord) => Some(chord),
        at_once::Found::Doubtful { a, b, t_close } => {
            corrected::chord(l, d, r, [a, b, t_close], f64::NEG_INFINITY)
        }
        at_once::Found::OutOfRange => None,
    }
}

/// a − b, and what its rounding dropped.
#[inline(always)]
fn two_part_difference(a: [f64; 3], b: [f64; 3]) -> [TwoPart; 3] {
    std::array::from_fn(|axis| two_sum(a[axis], -b[axis]))
}

impl Chord {
    /// That of a degenerate ray or sphere.
    const NONE: Chord = Chord {
        certainty: Certainty::AtOnce,
        a: f64::NAN,
        b: f64::NAN,
        t_close: f64::NAN,
        p: [f64::NAN; 3],
        correction: f64::NAN,
        half_chord_squared: f64::NAN,
        h: None,
        c: None,
        roots: None,
    };

    /// The same with the roots t_close ∓ h, where neither is a small difference.
    #[inline(always)]
    fn crossed(self, h: f64) -> Chord {
        let root = |h: f64| self.t_close + (self.correction + h);
        Chord { h: Some(h), roots: Some(Roots { near: root(-h), far: root(h) }), ..self }
    }
}

impl<R: Real> Robust<R> {
    /// The two crossings, rounded to the precision of the ray, with no negative one rounded to zero; `None`
    /// for a miss, and for a degenerate ray or sphere.
    #[inline(always)]
    pub fn roots(&self) -> Option<Roots<R>> {
        let Roots { near, far } = self.chord.roots?;
        Some(Roots { near: R::root_from(near), far: R::root_from(far) })
    }

    /// The nearest hit in `span`: n = ((δ ∓ h) d − P) / r, and x is p_r + t d or c + r n, whichever adds the
    /// smaller number.
    ///
    /// `None` for a miss, [`Degenerate`] for a question without an answer, see [`Sphere::check`].
    #[inline(always)]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        let (ray, sphere, chord) = (self.ray, self.sphere, self.chord);
        if chord.half_chord_squared.is_nan() {
            return sphere.check(&ray).map(|()| None);
        }
        let Some(roots) = self.roots() else { return Ok(None) };
        let Some(t) = roots.first_within(span) else { return Ok(None) };
        let enters = span.contains(roots.near);
        match chord.certainty {
            Certainty::Exact => return Ok(Some(exact::hit(&ray, &sphere, t, enters))),
            Certainty::Scaled => return Ok(Some(scaled::hit(&ray, &sphere, t, enters))),
            Certainty::AtOnce | Certainty::Corrected | Certainty::NearSurface => {}
        }
        let [p_r, d, c] = [ray.origin, ray.direction, sphere.center].map(Vector::in_f64::<3>);
        let found = point_and_normal(p_r, d, c, sphere.radius.into(), &chord, enters);
        Ok(found.map(|([x, y, z], [n_x, n_y, n_z])| {
            let round = R::round_from;
            let point = R::vec3(round(x), round(y), round(z));
            Hit { t, point, normal: R::vec3(round(n_x), round(n_y), round(n_z)) }
        }))
    }
}

/// The point at the near root or the far one, and its normal; `None` for a miss.
#[inline(always)]
fn point_and_normal(
    p_r: [f64; 3],
    d: [f64; 3],
    c: [f64; 3],
    r: f64,
    chord: &Chord,
    enters: bool,
) -> Option<([f64; 3], [f64; 3])> {
    let (roots, h) = (chord.roots?, chord.h?);
    let (t, h) = if enters { (roots.near, -h) } else { (roots.far, h) };
    let along = chord.correction + h;
    let from_center: [f64; 3] = std::array::from_fn(|axis| along * d[axis] - chord.p[axis]);
    let origin_is_nearer = t * t * chord.a < r * r;
    let point = std::array::from_fn(|axis| match origin_is_nearer {
        true => p_r[axis] + t * d[axis],
        false => c[axis] + from_center[axis],
    });
    Some((point, from_center.map(|component| component / r + 0.0))) // minus zero is zero
}

#[cfg(test)]
mod tests;

//! Why the three fail, and what to do about it.
//!
//! On paper D = B² − A C decides, and t = (B ± √D)/A. In floating point three things go wrong:
//!
//! 1. **B² − A C cancels.** Seen from afar both terms are (distance/radius)² times their difference:
//!    at 1e8 radii nothing of D is left in `f64`, and the verdict is a coin toss. House's
//!    ‖x_close − c‖ avoids this, but takes the difference in world coordinates, and near a tangent
//!    r² − d² cancels all the same.
//! 2. **B − √D cancels** when the sphere is near and large. Vieta's C = A t₁ t₂ gives the small root from
//!    the large one without a subtraction.
//! 3. **C = L·L − r² cancels** when the origin is near the surface, and even L = c − p_r is rounded.
//!
//! So: keep L in two parts (its rounding error is a number too), compute A, B, C and D with twice the
//! digits, and take the roots as q/A and C/q with q = B ± √D, the sign that adds. Then ask whether
//! the error that is left could matter. The bound is derived below; where it could, sum C and D
//! exactly, in integers as long as it takes ([`math::exact`]). The verdict is then true, not likely,
//! and t is good to a rounding. An error δ in D moves √D by no more than √δ, which is why twice the
//! digits serve t even close to a tangent.
//!
//! Squares of 1e±200 overflow or vanish; there the exact sums are taken straight away. `f32` is
//! computed in `f64`, where products of `f32` are exact, and rounded at the end.

use math::two_part::two_sum;
use math::{Degenerate, Exact, Hit, Ray3, Real, Roots, Span, TwoPart, Vector, Wide};

use crate::{Hit3, Sphere};

/// How the verdict was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// With twice the digits, and an error bound that excludes any other verdict.
    TwoPart,
    /// By exact sums.
    Exact,
}

impl Certainty {
    /// What it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Certainty::TwoPart => "two-part sums, certain by their error bound",
            Certainty::Exact => "too close for two-part sums: summed exactly",
        }
    }
}

/// Every number of the robust method, each rounded to `f64` for the reader.
///
/// A degenerate ray or sphere gives NaN throughout; [`Robust::hit`] refuses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Robust<R: Real> {
    /// The ray.
    pub ray: Ray3<R>,
    /// The sphere.
    pub sphere: Sphere<R>,
    /// How it was decided.
    pub certainty: Certainty,
    /// L = c − p_r: the rounded difference.
    pub l: [f64; 3],
    /// What the rounding of L dropped.
    pub l_error: [f64; 3],
    /// A = d · d
    pub a: f64,
    /// B = L · d (CSC418's with the other sign)
    pub b: f64,
    /// C = L · L − r²
    pub c: f64,
    /// D = B² − A C, its sign exact
    pub d: f64,
    /// B + √D or B − √D, whichever adds. `None` for a miss.
    pub q: Option<f64>,
    /// The roots before they are rounded.
    wide_roots: Option<Roots<Wide>>,
}

/// A, B, C and D.
#[derive(Clone, Copy)]
struct Coefficients {
    a: Wide,
    b: Wide,
    c: Wide,
    d: Wide,
    certainty: Certainty,
}

/// The rounding errors of the dozen two-part operations behind D, each at most 2^−102, add up to
/// less than 2^−97 of A (L·L + r²), and those of C to less than 2^−99 of L·L + r².
const D_ERROR: f64 = 1.0 / (1u128 << 97) as f64;
const C_ERROR: f64 = 1.0 / (1u128 << 99) as f64;
/// What those errors may do to a root, relatively: a quarter of the last digit of an `f64`.
const HARMLESS: f64 = 1.0 / (1u64 << 55) as f64;
/// Between these, fourth powers and the errors of their products neither overflow nor vanish.
const SAFE: std::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// Works out the robust method.
pub fn robust<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Robust<R> {
    let [origin, direction, center] = [ray.origin, ray.direction, sphere.center].map(exact_in_f64::<R>);
    let r: f64 = sphere.radius.into();
    let l: [TwoPart; 3] = std::array::from_fn(|axis| two_sum(center[axis], -origin[axis]));
    let mut work = Robust {
        ray: *ray,
        sphere: *sphere,
        certainty: Certainty::TwoPart,
        l: l.map(|part| part.hi),
        l_error: l.map(|part| part.lo),
        a: f64::NAN,
        b: f64::NAN,
        c: f64::NAN,
        d: f64::NAN,
        q: None,
        wide_roots: None,
    };
    if sphere.check(ray).is_err() {
        return work;
    }
    let two_part = if is_safe(direction, work.l, r) { in_two_parts(direction, l, r) } else { None };
    let Coefficients { a, b, c, d, certainty } =
        two_part.unwrap_or_else(|| exactly(origin, direction, center, r));
    work.certainty = certainty;
    [work.a, work.b, work.c, work.d] = [a, b, c, d].map(Wide::to_f64);
    if d.is_negative() {
        return work;
    }

    // A t² − 2 B t + C = 0: the root that adds is q/A; Vieta gives the other as C/q.
    let root = d.sqrt();
    let q = if b.is_negative() { b - root } else { b + root };
    let roots = match (q.is_zero(), b.is_negative()) {
        (true, _) => Roots { near: Wide::ZERO, far: Wide::ZERO }, // B = C = D = 0: it touches at its origin
        (_, false) => Roots { near: c / q, far: q / a },
        (_, true) => Roots { near: q / a, far: c / q },
    };
    work.q = Some(q.to_f64());
    work.wide_roots = Some(roots);
    work
}

/// A, B, C and D with twice the digits; `None` where their error could change the verdict or a root.
fn in_two_parts(direction: [f64; 3], l: [TwoPart; 3], r: f64) -> Option<Coefficients> {
    let dir = direction.map(TwoPart::from);
    let r = TwoPart::from(r);
    let l_l = dot(l, l);
    let a = dot(dir, dir);
    let b = dot(l, dir);
    let c = l_l - r * r;
    let d = b * b - a * c;

    let size = l_l.hi + r.hi * r.hi;
    let d_error = D_ERROR * a.hi * size;
    let certain = if d.hi < 0.0 {
        -d.hi > d_error
    } else {
        // √D is off by δ/2√D; the roots C/q and q/A then by that over q, and by the error of C.
        let root = d.hi.sqrt();
        d_error <= HARMLESS * root * (b.hi.abs() + root) && C_ERROR * size <= HARMLESS * c.hi.abs()
    };
    let [a, b, c, d] = [a, b, c, d].map(Wide::from);
    certain.then_some(Coefficients { a, b, c, d, certainty: Certainty::TwoPart })
}

/// A, B, C and D without any rounding.
fn exactly(origin: [f64; 3], direction: [f64; 3], center: [f64; 3], r: f64) -> Coefficients {
    let direction = direction.map(Exact::new);
    let l: [Exact; 3] = std::array::from_fn(|axis| Exact::new(center[axis]) - Exact::new(origin[axis]));
    let r = Exact::new(r);
    let a = Exact::dot(&direction, &direction);
    let b = Exact::dot(&l, &direction);
    let c = Exact::dot(&l, &l) - r.clone() * r;
    let d = b.clone() * b.clone() - a.clone() * c.clone();
    let [a, b, c, d] = [a, b, c, d].map(|exact| exact.to_wide());
    Coefficients { a, b, c, d, certainty: Certainty::Exact }
}

/// Whether squares and fourth powers of these numbers stay well inside the range of `f64`.
fn is_safe(direction: [f64; 3], l: [f64; 3], r: f64) -> bool {
    let largest = |v: [f64; 3]| v.into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    SAFE.contains(&largest(direction)) && SAFE.contains(&largest(l).max(r))
}

/// a · b in two parts.
fn dot(a: [TwoPart; 3], b: [TwoPart; 3]) -> TwoPart {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The components as `f64`: every `f32` is one.
fn exact_in_f64<R: Real>(v: R::Vec3) -> [f64; 3] {
    std::array::from_fn(|axis| v.components()[axis].into())
}

impl<R: Real> Robust<R> {
    /// The two crossings, rounded to the precision of the ray; `None` for a miss.
    pub fn roots(&self) -> Option<Roots<R>> {
        self.wide_roots.map(|Roots { near, far }| Roots { near: near.rounded(), far: far.rounded() })
    }

    /// The nearest hit in `span`: t, x = p_r + t d and n = (t d − L) / r, each rounded once at the end.
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.sphere.check(&self.ray)?;
        let (Some(wide), Some(roots)) = (self.wide_roots, self.roots()) else { return Ok(None) };
        let Some(t) = roots.first_within(span) else { return Ok(None) };
        let wide_t = if span.contains(roots.near) { wide.near } else { wide.far };

        let [origin, direction, center] =
            [self.ray.origin, self.ray.direction, self.sphere.center].map(Wide::vector::<R, 3>);
        let r = Wide::of(self.sphere.radius);
        let round = |x: Wide| R::round_from(x.to_f64());
        let along = direction.map(|d| wide_t * d);
        let [x, y, z] = std::array::from_fn(|axis| round(origin[axis] + along[axis]));
        let [n_x, n_y, n_z] =
            std::array::from_fn(|axis| round((along[axis] - (center[axis] - origin[axis])) / r));
        Ok(Some(Hit { t, point: R::vec3(x, y, z), normal: R::vec3(n_x, n_y, n_z) }))
    }
}

//! The slow ways of [`robust`](super): two parts throughout, and exact sums.
//!
//! They are for the few rays that plain `f64` and one correction leave in doubt: an origin on the
//! surface or close to a much larger sphere, a tangent, numbers whose squares overflow or vanish.

use math::two_part::{dot, two_product, two_sum};
use math::{Exact, Hit, Ray3, Real, Roots, TwoPart, Vector, Wide};

use super::{Certainty, Chord};
use crate::{Hit3, Sphere};

/// A line through the sphere, as precisely as it is known.
struct Crossing {
    roots: Roots<Wide>,
    p: [Wide; 3],
    h: Wide,
}

/// What decides: the numbers of the closest approach, seen from the center.
#[derive(Clone, Copy)]
struct Approach {
    a: Wide,
    b: Wide,
    c: Wide,
    t_close: Wide,
    p: [Wide; 3],
    half_chord_squared: Wide,
    certainty: Certainty,
}

/// How far a component of P may be off, in ‖L‖. With two-part operations that err by 2^−102 at the
/// most, a dot product is within 2^−100 of the sum of its magnitudes, t_close = B/A then within
/// 2^−99 ‖L‖/‖d‖, and P = L − t_close d within 2^−98 ‖L‖: a fourth of this.
const P_ERROR: f64 = 1.0 / (1u128 << 96) as f64;
/// How far a sum of squares, r² − P·P or L·L − r², is off on its own account, in the sum of their
/// magnitudes. (P's error adds 2 ‖P‖ P_ERROR ‖L‖ and its square to the former.)
const SUM_ERROR: f64 = 1.0 / (1u128 << 99) as f64;
/// What an error may be of the number that it spoils: a quarter of the last digit of an `f64`.
const HARMLESS: f64 = 1.0 / (1u64 << 55) as f64;
/// Between these, squares and the errors of their products neither overflow nor vanish.
const SAFE: std::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// The chord. For a degenerate ray or sphere a² is NaN: neither a miss nor a hit.
#[cold]
#[inline(never)]
pub(super) fn chord<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> Chord {
    if sphere.check(ray).is_err() {
        let nan = f64::NAN;
        return Chord {
            certainty: Certainty::AtOnce,
            a: nan,
            b: nan,
            t_close: nan,
            p: [nan; 3],
            correction: nan,
            half_chord_squared: nan,
            h: None,
            c: None,
            roots: None,
        };
    }
    let [p_r, d, c] = [ray.origin, ray.direction, sphere.center].map(Vector::in_f64::<3>);
    let r: f64 = sphere.radius.into();
    let approach = in_two_parts(p_r, d, c, r).unwrap_or_else(|| exactly(p_r, d, c, r));
    let crossing = crossing(&approach);
    Chord {
        certainty: approach.certainty,
        a: approach.a.to_f64(),
        b: approach.b.to_f64(),
        t_close: approach.t_close.to_f64(),
        p: approach.p.map(Wide::to_f64),
        correction: 0.0,
        half_chord_squared: approach.half_chord_squared.to_f64(),
        h: crossing.as_ref().map(|crossing| crossing.h.to_f64()),
        c: Some(approach.c.to_f64()),
        roots: crossing.map(|Crossing { roots: Roots { near, far }, .. }| Roots {
            near: near.rounded(),
            far: far.rounded(),
        }),
    }
}

/// Where the line enters and leaves; `None` for a miss.
fn crossing(&Approach { a, c, t_close, p, half_chord_squared, .. }: &Approach) -> Option<Crossing> {
    if half_chord_squared.is_negative() {
        return None;
    }
    // On the side where h adds, nothing cancels; the other root follows from A t₁ t₂ = C.
    let h = (half_chord_squared / a).sqrt();
    let outer = if t_close.is_negative() { t_close - h } else { t_close + h };
    let inner = if h.is_zero() { outer } else { c / (a * outer) };
    let roots = if t_close.is_negative() {
        Roots { near: outer, far: inner }
    } else {
        Roots { near: inner, far: outer }
    };
    Some(Crossing { roots, p, h })
}

/// The closest approach with twice the digits; `None` where the error left could matter, or squares
/// overflow or vanish.
fn in_two_parts(origin: [f64; 3], d: [f64; 3], center: [f64; 3], r: f64) -> Option<Approach> {
    let l: [TwoPart; 3] = std::array::from_fn(|axis| two_sum(center[axis], -origin[axis]));
    if !is_safe(d, l.map(|part| part.hi), r) {
        return None;
    }
    let r_r = two_product(r, r);
    let (a, b, l_l) = (dot(d.map(TwoPart::from), d), dot(l, d), dot(l, l));
    let c = l_l - r_r;
    let t_close = b / a;
    let p: [TwoPart; 3] = std::array::from_fn(|axis| l[axis] - t_close * d[axis]);
    let p_p = dot(p, p);
    let half_chord_squared = r_r - p_p;

    let p_error = P_ERROR * l_l.hi.sqrt();
    let error = p_error * (2.0 * p_p.hi.sqrt() + p_error) + SUM_ERROR * (p_p.hi + r * r);
    let certain = if half_chord_squared.hi < 0.0 {
        -half_chord_squared.hi > error
    } else {
        // An error δ in a² is one of δ/2a in a. It spoils t as a share of the way to the outer root, and n
        // as a share of r; so does the error of P. That of C spoils the inner root. (And since δ is at
        // least SUM_ERROR r², a² that passes is far above its error: the line does hit.)
        let half_chord = half_chord_squared.hi.sqrt();
        let way = t_close.hi.abs() * a.hi.sqrt() + half_chord;
        let spoiled = way.min(r);
        error <= HARMLESS * half_chord * spoiled
            && p_error <= HARMLESS * spoiled
            && SUM_ERROR * (l_l.hi + r * r) <= HARMLESS * c.hi.abs()
    };
    let [a, b, c, t_close, half_chord_squared] = [a, b, c, t_close, half_chord_squared].map(Wide::from);
    let approach = Approach {
        a,
        b,
        c,
        t_close,
        p: p.map(Wide::from),
        half_chord_squared,
        certainty: Certainty::TwoPart,
    };
    certain.then_some(approach)
}

/// The closest approach from exact sums: A, B, C, D = B² − A C and A P = A L − B d, each rounded once.
fn exactly(origin: [f64; 3], direction: [f64; 3], center: [f64; 3], r: f64) -> Approach {
    let direction = direction.map(Exact::new);
    let l: [Exact; 3] = std::array::from_fn(|axis| Exact::new(center[axis]) - Exact::new(origin[axis]));
    let r = Exact::new(r);
    let a = Exact::dot(&direction, &direction);
    let b = Exact::dot(&l, &direction);
    let c = Exact::dot(&l, &l) - r.clone() * r;
    let d = b.clone() * b.clone() - a.clone() * c.clone();
    let a_p: [Exact; 3] =
        std::array::from_fn(|axis| a.clone() * l[axis].clone() - b.clone() * direction[axis].clone());
    let [a, b, c, d] = [a, b, c, d].map(|exact| exact.to_wide());
    let p = a_p.map(|component| component.to_wide() / a);
    Approach { a, b, c, t_close: b / a, p, half_chord_squared: d / a, certainty: Certainty::Exact }
}

/// Whether squares of these numbers stay well inside the range of `f64`.
fn is_safe(direction: [f64; 3], l: [f64; 3], r: f64) -> bool {
    let largest = |v: [f64; 3]| v.into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    SAFE.contains(&largest(direction)) && SAFE.contains(&largest(l).max(r))
}

/// The hit at the near root or the far one, which is `t` when rounded: n = (∓ h d − P) / r and x are
/// worked out from exact sums, in numbers that cannot overflow, and rounded at the end; x is p_r + t d
/// or c + r n, whichever adds the smaller number. The line must hit.
#[cold]
#[inline(never)]
pub(super) fn hit<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>, t: R, enters: bool) -> Hit3<R> {
    let [origin, direction, center] = [ray.origin, ray.direction, sphere.center].map(Vector::in_f64::<3>);
    let approach = exactly(origin, direction, center, sphere.radius.into());
    let Some(Crossing { roots, p, h }) = crossing(&approach) else {
        return sphere.hit_at(t, ray.at(t));
    };
    let (wide_t, h) = if enters { (roots.near, -h) } else { (roots.far, h) };
    let [p_r, d, c]: [[Wide; 3]; 3] = [ray.origin, ray.direction, sphere.center].map(Wide::vector::<R, 3>);
    let r = Wide::of(sphere.radius);
    let from_center: [Wide; 3] = std::array::from_fn(|axis| h * d[axis] - p[axis]);
    let from_origin = d.map(|component| wide_t * component);
    let origin_is_nearer = (dot_wide(from_origin, from_origin) - r * r).is_negative();

    let round = |x: Wide| R::round_from(x.to_f64());
    let [x, y, z] = std::array::from_fn(|axis| match origin_is_nearer {
        true => round(p_r[axis] + from_origin[axis]),
        false => round(c[axis] + from_center[axis]),
    });
    let [n_x, n_y, n_z] = from_center.map(|component| round(component / r));
    Hit { t, point: R::vec3(x, y, z), normal: R::vec3(n_x, n_y, n_z) }
}

fn dot_wide(a: [Wide; 3], b: [Wide; 3]) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

//! The third way of [`robust`](super): the origin is so near the surface that one of t_close ∓ h cancels.
//!
//! The outer root, where they add, is good. The inner one follows from A t₁ t₂ = C, if C = L·L − r² is; and C is
//! the difference of two nearly equal numbers, of which a rounded surface point leaves the last sixteen
//! digits. So it is summed from exact products with three times the digits.

use math::two_part::{threefold_sum, two_product, two_sum};
use math::{Roots, TwoPart};

use super::{Certainty, Chord};

/// The error of C in L·L + r²: seventeen terms, so (34 · 2^−53)³, and as much again for the squares of
/// what the rounding of L dropped.
const C_ERROR: f64 = 1.0 / (1u128 << 126) as f64 / (1u64 << 16) as f64;
/// The same with twice the digits: ten sums of numbers below 8u (L·L + r²), and the squares that are left out, 128u² of it.
const C_TWOFOLD_ERROR: f64 = 1.0 / (1u128 << 98) as f64;
/// What the inner root may be off by as a difference, of the outer root: 8u.
const ROUGH: f64 = 4.0 * f64::EPSILON;
/// What it may be of C: 2^−54, half a rounding.
const HARMLESS: f64 = f64::EPSILON / 4.0;

/// The chord of a line that hits: `hit` has its P, its a² and a rounded A, `p` the same P in two parts.
/// `None` where C is too near to zero, as it is for an origin exactly on the surface.
///
/// With u = 2^−53, the error of one operation: A and P · d are rounded once here. a² with its error bound, A and their
/// quotient leave 1.5u in the root, whose own rounding is u, and δ ∓ h is u: 3.5u h. A root by t_close ∓ h adds u,
/// and where h is at most twice that root, as it is for the outer one and where the inner one is half of the outer
/// or more, that makes 8u. Where it is less, way is h/3 or more and the outer root within 4u; the inner root then has
/// that and, from C, A, a product and a quotient, 4.5u more: at most 9 ulps.
///
/// Where the near root is the inner one and certainly before `from`, nobody asks for it, and it stays t_close − h: off by
/// at most 8u of the outer root, as everything it is made of is at most that, and most of it is behind the origin then.
/// (C, which is A times the two, is then too far from zero for the doubt above.) A `from` of ∞ says that the origin is known
/// to be within the sphere.
pub(super) fn chord(
    hit: &Chord,
    p: [TwoPart; 3],
    l: [TwoPart; 3],
    d: [f64; 3],
    r_r: TwoPart,
    from: f64,
) -> Option<Chord> {
    let a = rounded_dot(d.map(TwoPart::from), d);
    let correction = rounded_dot(p, d) / a;
    let h = (hit.half_chord_squared / a).sqrt();
    let outward = if hit.t_close < 0.0 { -h } else { h };
    let outer = hit.t_close + (correction + outward);
    let difference = hit.t_close + (correction - outward);
    let hit = Chord { certainty: Certainty::NearSurface, a, correction, h: Some(h), ..*hit };
    let is_before = from == f64::INFINITY || difference + ROUGH * outer < from.min(f64::MIN_POSITIVE);
    if hit.t_close >= 0.0 && from >= 0.0 && is_before {
        return Some(Chord { roots: Some(Roots { near: difference, far: outer }), ..hit });
    }
    let l_l: f64 = l.iter().map(|part| part.hi * part.hi).sum();
    let scale = l_l + r_r.hi;
    let twofold = c_twofold(l, r_r);
    let c = if C_TWOFOLD_ERROR * scale <= HARMLESS * twofold.abs() { twofold } else { c(l, r_r) };
    if C_ERROR * scale > HARMLESS * c.abs() {
        return None;
    }
    let inner = if 2.0 * difference.abs() >= outer.abs() { difference } else { c / (a * outer) };
    let roots = match hit.t_close < 0.0 {
        true => Roots { near: outer, far: inner },
        false => Roots { near: inner, far: outer },
    };
    Some(Chord { c: Some(c), roots: Some(roots), ..hit })
}

/// C = L·L − r² with twice the digits, which is enough unless the origin is as near to the surface as rounding leaves it.
fn c_twofold(l: [TwoPart; 3], r_r: TwoPart) -> f64 {
    let [x, y, z] = l.map(|part| two_product(part.hi, part.hi));
    let one = two_sum(x.hi, y.hi);
    let two = two_sum(one.hi, z.hi);
    let three = two_sum(two.hi, -r_r.hi);
    let of_l: f64 = l.iter().map(|part| 2.0 * part.hi * part.lo).sum();
    let lower = ((x.lo + y.lo) + (z.lo - r_r.lo)) + ((one.lo + two.lo) + three.lo);
    three.hi + (lower + of_l)
}

/// C = L·L − r²: the squares of both parts of L and twice their product, as exact products.
fn c(l: [TwoPart; 3], r_r: TwoPart) -> f64 {
    let mut terms = [0.0; 17];
    for (axis, TwoPart { hi, lo }) in l.into_iter().enumerate() {
        let (square, twice) = (two_product(hi, hi), two_product(2.0 * hi, lo));
        terms[5 * axis..5 * axis + 5].copy_from_slice(&[square.hi, square.lo, twice.hi, twice.lo, lo * lo]);
    }
    (terms[15], terms[16]) = (-r_r.hi, -r_r.lo);
    threefold_sum(terms)
}

/// a · b, rounded once.
fn rounded_dot(a: [TwoPart; 3], b: [f64; 3]) -> f64 {
    let dot = math::two_part::dot(a, b);
    dot.hi + dot.lo
}

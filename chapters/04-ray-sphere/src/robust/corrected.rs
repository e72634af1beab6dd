//! The second way of [`robust`](super): for the t_close that is there, P and a² with twice the digits.
//!
//! With u = 2^−53: the components of P are within 5u² ‖L‖. P · d is computed from their leading parts, and so
//! within 4u ‖d‖ ‖P‖ of a number of at most 9u ‖d‖ ‖L‖, which leaves 88u² ‖L‖ ‖P‖ in (P · d)² / A. Together
//! 98u² ‖L‖ ‖P‖, and some twenty-five roundings of lower parts, u² of r² + P·P each.

use math::TwoPart;
use math::plain::{dot, size};
use math::two_part::{two_product, two_sum};

use super::{Certainty, Chord, near_surface};

/// The error of ‖P‖² in ‖L‖ ‖P‖: 2^−99 is 128u².
const P_ERROR: f64 = 1.0 / (1u128 << 99) as f64;
/// The error of r² − P·P on its own account, in r² + P·P.
const SUM_ERROR: f64 = 1.0 / (1u128 << 99) as f64;
/// The relative error of (P · d)² / A.
const CORRECTION_ERROR: f64 = 1.0 / (1u64 << 49) as f64;
/// What the error of a² may be of the numbers that it spoils: u.
const HARMLESS: f64 = f64::EPSILON / 2.0;

/// The chord, this way or the [third](near_surface), whose near root may be rough where it is before `from`; `None` where
/// the error left could matter.
#[inline(never)]
pub(super) fn chord(
    l: [TwoPart; 3],
    d: [f64; 3],
    r: f64,
    [a, b, t_close]: [f64; 3],
    from: f64,
) -> Option<Chord> {
    let p: [TwoPart; 3] = std::array::from_fn(|axis| {
        let step = two_product(t_close, d[axis]);
        let rest = two_sum(l[axis].hi, -step.hi);
        two_sum(rest.hi, rest.lo + (l[axis].lo - step.lo))
    });
    let [p_hi, p_lo] = [p.map(|part| part.hi), p.map(|part| part.lo)];
    let p_d = dot(p_hi, d);
    let correction = p_d / a;

    // a² = r² − P·P + (P·d)²/A: the leading parts exactly, then what they left.
    let r_r = two_product(r, r);
    let squares = p_hi.map(|p| two_product(p, p));
    let [one, two] = [two_sum(r_r.hi, -squares[0].hi), two_sum(-squares[1].hi, -squares[2].hi)];
    let sum = two_sum(one.hi, two.hi);
    let lower = (r_r.lo - squares[0].lo) - (squares[1].lo + squares[2].lo);
    let left = (sum.lo + (one.lo + two.lo)) + (lower - 2.0 * dot(p_hi, p_lo));
    let half_chord_squared = sum.hi + (left + p_d * correction);

    let p_p = squares[0].hi + squares[1].hi + squares[2].hi;
    let l_size = size(l.map(|part| part.hi));
    let error =
        P_ERROR * l_size * size(p_hi) + SUM_ERROR * (r_r.hi + p_p) + CORRECTION_ERROR * (p_d * correction);
    let certainty = Certainty::Corrected;
    let miss = Chord {
        certainty,
        a,
        b,
        t_close,
        p: p_hi,
        correction,
        half_chord_squared,
        h: None,
        c: None,
        roots: None,
    };
    if half_chord_squared < -error {
        return Some(miss);
    }

    let h = (half_chord_squared / a).sqrt();
    let spoils_nothing = half_chord_squared > error
        && error * error <= HARMLESS * HARMLESS * half_chord_squared * r_r.hi
        && error <= HARMLESS * h * a * (t_close.abs() + h);
    if !spoils_nothing {
        return None;
    }
    // h is off by 3.5u (A is by 3u, halved by the root; a², the quotient and the root), δ by 4u ‖P‖/‖d‖, and δ ∓ h
    // and the root are rounded. That is at most 8u of the inner root where h + ‖P‖/‖d‖ is at most one and a half
    // times that.
    let inner = (t_close.abs() - h).abs();
    let spare = 1.5 * inner - h;
    let inner_is_good = spare > 0.0 && spare * spare * a >= p_p && error <= HARMLESS * h * a * inner;
    if inner_is_good { Some(miss.crossed(h)) } else { near_surface::chord(&miss, p, l, d, r_r, from) }
}

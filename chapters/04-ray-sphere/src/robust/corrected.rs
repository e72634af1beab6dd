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

#[cfg(test)]
mod tests {
    use super::super::tests::{two, work};
    use super::*;

    /// A ray that misses the unit sphere by x: P is L = (1 + x, 0, 0). By hand: the error of a² is 2⁻⁹⁹ of ‖L‖ ‖P‖ = 1
    /// and of r² + P·P = 2, and a² = −2x, so there is no doubt where x is above 3 · 2⁻¹⁰⁰.
    #[test]
    fn a_miss_by_no_more_than_the_error_is_left_in_doubt() {
        let certainty = |x: f64| work([-x, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], 1.0).chord.certainty;
        let error = 3.0 * two(-100);
        assert_eq!(certainty(error), Certainty::Exact);
        assert_eq!(certainty(error.next_up()), Certainty::Corrected);
    }

    /// Any t_close will do, here 1 where it is 0. By hand: P = (1 + x, 0, −1) and P·d = −1; nearly all of the error is
    /// that of (P·d)²/A = 1, which is 2⁻⁴⁹; and a² is 1 − P·P + 1 = −2x, but for x².
    #[test]
    fn the_error_of_what_t_close_left_counts() {
        let at = |x: f64| {
            let l = [1.0 + x, 0.0, 0.0].map(TwoPart::from);
            chord(l, [0.0, 0.0, 1.0], 1.0, [1.0, 0.0, 1.0], f64::NEG_INFINITY)
        };
        assert_eq!(at(two(-51)), None);
        let miss = at(two(-49)).expect("it is 2⁻⁴⁸, twice the error");
        assert_eq!((miss.half_chord_squared, miss.roots), (-two(-48), None));
    }

    /// An origin x within the unit sphere, at right angles to the ray: a² = h² = 2x, but for x². By hand: the error is
    /// 3 · 2⁻⁹⁹, as for the miss; t = h can bear 2⁻⁵³ h², which is 4 · 2⁻⁹⁹ for the one x and 2 · 2⁻⁹⁹ for the other.
    #[test]
    fn an_error_that_spoils_t_is_left_in_doubt() {
        let certainty = |x: f64| work([0.0; 3], [0.0, 0.0, 1.0], [1.0 - x, 0.0, 0.0], 1.0).chord.certainty;
        assert_eq!(certainty(two(-45)), Certainty::NearSurface);
        assert_eq!(certainty(two(-46)), Certainty::Exact);
    }

    /// By hand: the center 5 ahead and the radius 3, the inner root is 2 and h once and a half as much. That is left to
    /// the third way, as it is where the sphere is nearer, and not where it is farther.
    #[test]
    fn an_inner_root_that_cancels_is_found_from_the_outer() {
        let certainty = |z: f64| work([0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, z], 3.0).chord.certainty;
        assert_eq!([4.75, 5.0].map(certainty), [Certainty::NearSurface; 2]);
        assert_eq!(certainty(5.25), Certainty::Corrected);
    }

    /// An error that the outer root can bear, and the inner one not. By hand: with L = (5/4 − x, 0, 1) and r = 5/4,
    /// ‖L‖₁ ‖P‖₁ = 45/16 and r² + P·P = 50/16, so the error is 2⁻⁵³ E with E = 95/16 · 2⁻⁴⁶. With
    /// x = ⅖ E² = 3610/256 · 2⁻⁹², a² = h² is E², and h (1 − h) < E < h (1 + h). With 4 times that x, h is 2 E, and both
    /// can bear it.
    #[test]
    fn an_error_that_spoils_the_inner_root_is_left_to_the_third_way() {
        let (e, x) = (95.0 / 16.0 * two(-46), 3610.0 / 256.0 * two(-92));
        let at = |x: f64| work([x, 0.0, 0.0], [0.0, 0.0, 1.0], [1.25, 0.0, 1.0], 1.25).chord;
        let (less, more) = (at(x), at(4.0 * x));
        assert_eq!((less.h, less.certainty), (Some(e), Certainty::NearSurface));
        assert_eq!((more.h, more.certainty), (Some(2.0 * e), Certainty::Corrected));
    }
}

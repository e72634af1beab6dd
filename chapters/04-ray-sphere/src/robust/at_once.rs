//! The first way of [`robust`](super): House's closest approach in plain `f64`, with its error bound.
//!
//! With u = 2^−53, the error of one operation, what is computed is off by at most
//!
//! | number | of | because |
//! | --- | --- | --- |
//! | B = L · d | 4u ‖L‖ ‖d‖ | L is rounded, then three products and two sums |
//! | A = d · d | 3u A | three products and two sums |
//! | t_close = B · (1/A) | 9u ‖L‖/‖d‖ | the two, a quotient and a product |
//! | P = L − t_close d | 12u ‖L‖ | t_close, a product and a difference |
//! | r² − P · P | 40u (L·L + r²) | twice ‖P‖ times that, and its own rounding |
//!
//! That is enough for the verdict of most rays, and for every digit of an `f32`. For the digits of an `f64` the
//! bound is taken apart in [`spoiled`].

use math::plain::dot;
use math::{Real, TwoPart};

use super::{Certainty, Chord};

/// What plain `f64` can say.
pub(super) enum Found {
    /// A certain miss, or a hit whose numbers are good.
    Certain(Chord),
    /// Too close to call, or too inexact.
    Doubtful {
        /// A = d · d
        a: f64,
        /// B = L · d
        b: f64,
        /// t_close = B / A
        t_close: f64,
    },
    /// Squares may overflow or vanish, or the question is degenerate.
    OutOfRange,
}

/// u, the relative error of one operation.
const UNIT: f64 = f64::EPSILON / 2.0;
/// The error of r² − P·P in L·L + r²: more than 40u.
const ERROR: f64 = 64.0 * UNIT;
/// What the error of t may be of t, where t is an `f64`: at most eight units of its last digit.
const OF_T: f64 = 7.5 * UNIT;
/// What the error of the normal may be, as an angle: a 500 000th of the last digit of an `f32`. (The other ways are
/// a hundred times better; here it would cost the ray a second look.)
const OF_NORMAL: f64 = 1024.0 * UNIT;
/// Between these, neither a square nor the errors of its products overflow or vanish.
const SAFE_SQUARE: std::ops::RangeInclusive<f64> = 1e-120..=1e120;

/// The chord, where plain `f64` is enough for the precision R. (Inlined into every caller: it is most of
/// what `robust` costs.)
#[inline(always)]
pub(super) fn chord<R: Real>(l: [TwoPart; 3], d: [f64; 3], r: f64) -> Found {
    let is_f64 = R::DIGITS == f64::MANTISSA_DIGITS;
    let [l, l_error] = [l.map(|part| part.hi), l.map(|part| part.lo)];
    let (a, b, l_l, r_r) = (dot(d, d), dot(l, d), dot(l, l), r * r);
    // Squares of an f32 are ordinary numbers as f64. NaN fails either test.
    let in_range = match is_f64 {
        true => SAFE_SQUARE.contains(&r_r) && SAFE_SQUARE.contains(&a) && l_l <= *SAFE_SQUARE.end(),
        false => a > 0.0 && a + (l_l + r_r) < f64::INFINITY,
    };
    if !(r > 0.0 && in_range) {
        return Found::OutOfRange;
    }
    let one_over_a = 1.0 / a;
    let t_close = b * one_over_a;
    let mut p: [f64; 3] = std::array::from_fn(|axis| l[axis] - t_close * d[axis]);
    if is_f64 {
        p = std::array::from_fn(|axis| p[axis] + l_error[axis]);
    }
    let half_chord_squared = r_r - dot(p, p);
    let miss = Chord {
        certainty: Certainty::AtOnce,
        a,
        b,
        t_close,
        p,
        correction: 0.0,
        half_chord_squared,
        h: None,
        c: None,
        roots: None,
    };
    let error = ERROR * (l_l + r_r);
    if half_chord_squared < -error {
        return Found::Certain(miss);
    }
    let h = (half_chord_squared * one_over_a).sqrt();
    let is_enough = match is_f64 {
        true => is_enough_for_f64(t_close.abs(), h, (r_r * one_over_a).sqrt()),
        false => is_enough_for_f32(half_chord_squared, l_l, r_r),
    };
    if !(half_chord_squared > error && is_enough) {
        return Found::Doubtful { a, b, t_close };
    }
    // In f32 the rounding of t_close is of no account.
    let correction = if is_f64 { dot(p, d) * one_over_a } else { 0.0 };
    Found::Certain(Chord { correction, ..miss }.crossed(h))
}

/// Whether t and the normal are good, for lengths in units of the direction: the way to the closest
/// approach, half the chord h, the radius.
#[inline(always)]
fn is_enough_for_f64(way: f64, h: f64, r: f64) -> bool {
    let spoiled = spoiled(way, h, r);
    let inner = (way - h).abs();
    spoiled <= OF_T * (h * inner) && 2.0 * spoiled <= OF_NORMAL * (h * r)
}

/// h times the error of either root.
///
/// The error of t_close does not matter, since δ = P · d / A makes up for it. For the t_close that is there, in
/// lengths of the direction and with ‖P‖ ≤ r:
///
/// | number | is off by |
/// | --- | --- |
/// | P | u way, its product, and 2u r, its two sums |
/// | δ | that, and 3u r, its own products and sums: u way + 5u r |
/// | a² | 2r times the error of P, and 5u r²: 2u way r + 9u r² |
/// | h | that over 2h, and 3.5u h, from A, 1/A, a product and the root |
/// | t = t_close + (δ ∓ h) | all that, ½u h and ½u (way + h), its two sums |
///
/// With h ≤ r the sum, times h, is at most what stands below. (That a² leaves out δ P · d, at most 81u² ‖L‖², is of no
/// account: a² is above [`ERROR`], 64u of it.)
#[inline(always)]
fn spoiled(way: f64, h: f64, r: f64) -> f64 {
    UNIT * (h * (1.5 * way + 9.5 * r) + r * (way + 4.5 * r))
}

/// Whether t and the normal are good to a quarter of the last digit of an `f32`, 2^−26.
///
/// With S = L·L + r² and half the chord a, a root is within 40u S/a, as a length: the error of a² over 2a, and
/// that of t_close. The product of the roots is |L·L − r²|, and the outer one at most √2S, so the inner is at
/// least |L·L − r²| / √2S. The normal is within 40u S/(a r). And 40 √2 · 2^−53 · 2^26 is less than 2^−21.
#[inline(always)]
fn is_enough_for_f32(half_chord_squared: f64, l_l: f64, r_r: f64) -> bool {
    const SHARE: f64 = 1.0 / (1u64 << 42) as f64; // (2^−21)²
    let (s, c) = (l_l + r_r, l_l - r_r);
    let of_t = half_chord_squared * (c * c) >= SHARE * (s * s * s);
    let of_normal = half_chord_squared * r_r >= SHARE * (s * s);
    of_t && of_normal
}

#[cfg(test)]
mod tests {
    use super::super::tests::{two, work};
    use super::*;

    /// The squares of an `f32` are ordinary numbers, unless there is nothing to square, or no end to it.
    #[test]
    fn in_f32_only_what_is_degenerate_is_out_of_range() {
        let is_out = |l: f64, d: f64, r: f64| {
            matches!(chord::<f32>([l, 0.0, 0.0].map(TwoPart::from), [d, 0.0, 0.0], r), Found::OutOfRange)
        };
        let (most, least) = (f64::from(f32::MAX), f64::from(f32::from_bits(1)));
        assert!(!is_out(4.0, 1.0, 1.0) && !is_out(2.0 * most, most, most) && !is_out(0.0, least, least));
        assert!(is_out(4.0, 0.0, 1.0) && is_out(4.0, 1.0, 0.0) && is_out(4.0, 1.0, -1.0));
        let endless = f64::INFINITY;
        assert!(is_out(endless, 1.0, 1.0) && is_out(4.0, endless, 1.0) && is_out(4.0, 1.0, endless));
    }

    /// By hand: L = (1, 2⁻²⁴, 2⁻²⁴) is at right angles to d, and so is P; and r² is 1 − 2⁻⁴⁷ when rounded. P·P − r² is
    /// 2⁻⁴⁶, and so is the error, 2⁻⁴⁷ of L·L + r² = 2. With r a digit less there is no doubt.
    #[test]
    fn a_miss_by_no_more_than_the_error_is_doubtful() {
        let tiny = two(-24);
        let r = 1.0 - two(-48);
        let certainty = |r| work([0.0; 3], [0.0, 1.0, -1.0], [1.0, tiny, tiny], r).chord.certainty;
        assert_eq!(certainty(r), Certainty::Corrected);
        assert_eq!(certainty(r.next_down()), Certainty::AtOnce);
    }
}

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

#[cfg(test)]
mod tests {
    use super::super::robust_from;
    use super::super::tests::{two, work};
    use super::*;
    use crate::Sphere;
    use glam::DVec3;
    use math::Ray3;

    /// A ray along d from the origin, past the center (0, 0, 2²² − 1) of a sphere of radius 2²² + 1: by hand,
    /// (2²² + 1)² − (2²² − 1)² is 2²⁴.
    fn across(d: [f64; 3]) -> Chord {
        work([0.0; 3], d, [0.0, 0.0, two(22) - 1.0], two(22) + 1.0).chord
    }

    /// Where t_close is zero the roots are ∓2¹², and the near one is the negative one.
    #[test]
    fn an_origin_at_the_closest_approach_is_between_the_roots() {
        let Chord { certainty, t_close, roots, .. } = across([1.0, 0.0, 0.0]);
        assert_eq!((certainty, t_close), (Certainty::NearSurface, 0.0));
        assert_eq!(roots, Some(Roots { near: -two(12), far: two(12) }));
    }

    /// By hand: (5/4 · 2⁻²⁷)² is 25/64 of the last digit of 1, and is lost when it is added; twice that is rounded to a
    /// digit.
    #[test]
    fn a_is_rounded_once() {
        let less = 1.25 * two(-27);
        let Chord { certainty, a, .. } = across([1.0, less, less]);
        assert_eq!((certainty, a), (Certainty::NearSurface, 1.0_f64.next_up()));
        assert_eq!(math::plain::dot([1.0, less, less], [1.0, less, less]), 1.0, "rounded more often");
    }

    /// Straight at the center z of a sphere of radius r the roots are z ∓ r, by hand, and away from it −z ∓ r. C is
    /// not asked for where a ray that looks ahead surely starts within the sphere, by more than 2⁻⁵⁰ of z + r, or is
    /// known to.
    #[test]
    fn c_is_not_asked_for_where_the_near_root_is_before_the_span() {
        let is_asked = |[z, r]: [f64; 2], d: f64, from: f64| {
            let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::new(0.0, 0.0, d));
            let sphere = Sphere { center: DVec3::new(0.0, 0.0, z), radius: r };
            let Chord { certainty, c, roots, .. } = robust_from(&ray, &sphere, from).chord;
            assert_eq!(certainty, Certainty::NearSurface);
            assert_eq!(roots, Some(Roots { near: d * z - r, far: d * z + r }));
            c.is_some()
        };
        let (within, before) = ([1.0 - two(-20), 1.0], [1.0 + two(-20), 1.0]);
        assert!(is_asked(within, 1.0, f64::NEG_INFINITY), "behind the origin counts");
        assert!(!is_asked(within, 1.0, 0.0));
        assert!(is_asked(before, 1.0, 0.0));
        assert!(is_asked(before, 1.0, 1.0), "only what is behind the origin is let be");
        assert!(!is_asked(before, 1.0, f64::INFINITY), "it is said to start within");
        assert!(is_asked(within, -1.0, 0.0) && is_asked(before, -1.0, 0.0), "the near root is the outer one");
        // z − r is half as much as may be off, twice, and just as much: −2⁻⁴⁹ where z + r is 2
        assert!(is_asked([1.0 - two(-50), 1.0], 1.0, 0.0));
        assert!(!is_asked([1.0 - two(-48), 1.0], 1.0, 0.0));
        assert!(is_asked([1.0 - two(-50), 1.0 + two(-50)], 1.0, 0.0));
    }

    /// L = (2⁴⁰ − 2⁻¹⁵, 2¹³, 2⁻³) and r = 2⁴⁰. By hand: 2 · 2⁴⁰ · 2⁻¹⁵ is the square of 2¹³, so C is 2⁻⁶ and 2⁻³⁰, the
    /// square of what the rounding of L dropped. The sum with twice the digits leaves that out, and may be off by
    /// 2⁻¹⁷.
    #[test]
    fn c_has_three_times_the_digits_where_it_takes_them() {
        let work = work([two(-15), 0.0, 0.0], [1.0, 0.0, 0.0], [two(40), two(13), two(-3)], two(40));
        let l = std::array::from_fn(|axis| TwoPart { hi: work.l[axis], lo: work.l_error[axis] });
        assert_eq!(c_twofold(l, two_product(two(40), two(40))), two(-6));
        assert_eq!(work.chord.certainty, Certainty::NearSurface);
        assert_eq!(work.chord.c, Some(two(-6) + two(-30)));
    }

    /// L = (1 − 2⁻⁵⁵, 2⁻²¹, 2⁻⁴⁸) and r = 1. By hand: C is 2⁻⁴² − 2⁻⁵⁴, 2⁻⁹⁶, half the last digit of that, and 2⁻¹¹⁰.
    /// The sum with twice the digits leaves the last out, and so rounds to even; that it is off by less than 2⁻⁹⁷ is
    /// enough.
    #[test]
    fn c_has_twice_the_digits_where_that_is_enough() {
        let work = work([two(-55), 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, two(-21), two(-48)], 1.0);
        assert_eq!(work.chord.certainty, Certainty::NearSurface);
        assert_eq!(work.chord.c, Some(two(-42) - two(-54)));
    }

    /// L = (1, 2⁻⁴⁴, z) and r = 1. By hand: the error of C is 2⁻¹⁴² of L·L + r² = 2, and may be 2⁻⁵⁴ of C. For
    /// z = 2⁻⁴⁴ C is 2⁻⁸⁷, and the two are the same; for z = 0 it is half. The near root is half of C, as the far one
    /// is 2.
    #[test]
    fn a_c_that_could_be_zero_is_left_in_doubt() {
        let at = |z: f64| work([0.0; 3], [1.0, 0.0, 0.0], [1.0, two(-44), z], 1.0).chord;
        let certain = at(two(-44));
        assert_eq!((certain.certainty, certain.c), (Certainty::NearSurface, Some(two(-87))));
        assert_eq!(certain.roots, Some(Roots { near: two(-88), far: 2.0 }));
        assert_eq!(at(0.0).certainty, Certainty::Exact);
    }
}

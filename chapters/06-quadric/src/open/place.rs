//! f at a place of the line, with half as many digits again: near the wall nearly all of it cancels.
//!
//! λ is cut off after 26 binary digits there, and so is s, the height along the axis in lengths of it. With d, v and
//! r_a − r_b in halves of 26 and 27 no product is rounded then, and x = p + λ d, w = x − s v and r = r_b + s (r_a − r_b)
//! come out in two parts. As s is cut off, w is not quite at right angles to v: the height is σ = w·v / v·v more than
//! s, and
//!
//! ```text
//! f = w·w − r² − 2 r (r_a − r_b) σ − σ² (v·v + (r_a − r_b)²)
//! ```
//!
//! With u = 2^−53, κ = |r_a − r_b| / ‖v‖, ρ = r_b + κ ‖x‖ and Z = ‖p‖ + |λ| ‖d‖:
//!
//! | number | is at most, or off by at most | because |
//! | --- | --- | --- |
//! | x | off by 2^−77 Z | two sums of numbers below 2^−25 Z |
//! | σ ‖v‖ | at most 2^−24 ‖x‖ | s is cut off, and 16 u |
//! | w | off by 2^−77 Z + 2^−75 ‖x‖ | x, and three sums of numbers below 2^−25 ‖x‖ |
//! | r | off by 2^−76 ρ | the same |
//! | σ ‖v‖ | off by 2^−72.9 ‖x‖ + 2^−74.6 Z | w; seven sums of numbers below 2^−24 ‖x‖; a quotient, 8 u σ ‖v‖ |
//! | w·w − r² | off by 2^−74 (‖x‖² + ρ²) | seven sums of numbers below 2^−24 of that |
//!
//! w and r twice, and 2 ρ κ times what σ is off by, make less than 2^−71 (‖x‖² + ρ²) + 2^−73 Z (‖x‖ + κ ρ) of all this.
//! That is less than 2^−70 (1 + κ) (‖x‖ + ρ) (Z + ρ); and f
//! itself is rounded.

use math::two_part::two_sum;
use math::{Bounded, Real, TwoPart};

use super::OpenCone;
use super::at_once::{SAFE, Wall, sum_of_sizes};

/// 2^−70
const OFF: f64 = 1.0 / (1u128 << 70) as f64;

/// A place of a line, and f there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// x = p + λ d, rounded.
    pub(super) x: [f64; 3],
    /// Z
    pub(super) reach: f64,
    pub(super) f: Bounded<f64>,
}

impl Place {
    /// The place at `lambda`, which must be cut off by [`upper_half`]; `None` for sizes that are out of the ordinary.
    #[inline(never)]
    pub(super) fn at(lambda: f64, wall: &Wall, cone: &OpenCone<f64>, [o, d]: [[f64; 3]; 2]) -> Option<Place> {
        let [base, apex] = [cone.base, cone.apex].map(f64::xyz);
        let p: [TwoPart; 3] = std::array::from_fn(|axis| two_sum(o[axis], -base[axis]));
        let x: [TwoPart; 3] = std::array::from_fn(|axis| {
            let [upper, lower] = halves(d[axis]);
            let first = two_sum(p[axis].hi, lambda * upper);
            two_sum(first.hi, (first.lo + p[axis].lo) + lambda * lower)
        });
        let reach = sum_of_sizes(p.map(|p| p.hi)) + lambda.abs() * sum_of_sizes(d);
        let whole = x.map(|x| x.hi);

        let s = upper_half(wall.height(whole) / wall.length);
        let v: [TwoPart; 3] = std::array::from_fn(|axis| two_sum(apex[axis], -base[axis]));
        let w: [TwoPart; 3] = std::array::from_fn(|axis| less_share(x[axis], s, v[axis]));
        let k = two_sum(cone.apex_radius, -cone.base_radius);
        let r = less_share(TwoPart::from(cone.base_radius), -s, k);

        let f = squares(w, r) - {
            let sigma = product(w, v) / (wall.length * wall.length);
            let by_slope = 2.0 * r.hi * k.hi * sigma;
            by_slope + sigma * sigma * (wall.length * wall.length + k.hi * k.hi)
        };
        let rho = wall.radius + wall.slope.abs() * sum_of_sizes(whole);
        let (size, reach_and_rho) = (sum_of_sizes(whole) + rho, reach + rho);
        let error = OFF * (1.0 + wall.slope.abs()) * size * reach_and_rho + f64::EPSILON * f.abs();
        let is_ordinary = SAFE.contains(&size) && SAFE.contains(&reach_and_rho);
        is_ordinary.then_some(Place { x: whole, reach, f: Bounded { value: f, error } })
    }
}

/// x − s v for an s that is cut off: no product is rounded.
#[inline(always)]
fn less_share(x: TwoPart, s: f64, v: TwoPart) -> TwoPart {
    let [upper, lower] = halves(v.hi);
    let first = two_sum(x.hi, -(s * upper));
    two_sum(first.hi, ((first.lo + x.lo) - s * lower) - s * v.lo)
}

/// w·v: the products of upper halves exactly, then what they left.
#[inline(always)]
fn product(w: [TwoPart; 3], v: [TwoPart; 3]) -> f64 {
    let mut lower = 0.0;
    let upper: [f64; 3] = std::array::from_fn(|axis| {
        let ([w_upper, w_lower], [v_upper, v_lower]) = (halves(w[axis].hi), halves(v[axis].hi));
        lower += w_upper * v_lower
            + w_lower * v_upper
            + (w_lower * v_lower + w[axis].lo * v[axis].hi + w[axis].hi * v[axis].lo);
        w_upper * v_upper
    });
    let first = two_sum(upper[0], upper[1]);
    let second = two_sum(first.hi, upper[2]);
    second.hi + (first.lo + second.lo + lower)
}

/// w·w − r²: the squares of upper halves exactly, then what they left.
#[inline(always)]
fn squares(w: [TwoPart; 3], r: TwoPart) -> f64 {
    let square = |x: TwoPart| {
        let [upper, lower] = halves(x.hi);
        (upper * upper, (upper + x.hi) * lower + 2.0 * x.hi * x.lo)
    };
    let ([[x, x_lower], [y, y_lower], [z, z_lower]], (r, r_lower)) = (w.map(|w| square(w).into()), square(r));
    let first = two_sum(x, y);
    let second = two_sum(first.hi, z);
    let third = two_sum(second.hi, -r);
    third.hi + ((first.lo + second.lo + third.lo) + (x_lower + y_lower + z_lower - r_lower))
}

/// `x` cut off after 26 binary digits.
#[inline(always)]
pub(super) fn upper_half(x: f64) -> f64 {
    const CUT: u64 = !((1 << 27) - 1);
    f64::from_bits(x.to_bits() & CUT)
}

/// 26 binary digits and the other 27.
#[inline(always)]
fn halves(x: f64) -> [f64; 2] {
    let upper = upper_half(x);
    [upper, x - upper]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 1 + 2⁻⁵³ + 2⁻⁵³ is a number, though neither sum of two is; the same with what the lower halves bring.
    #[test]
    fn a_product_keeps_what_its_sums_lose() {
        let (u, one) = (f64::EPSILON / 2.0, TwoPart::from(1.0));
        let of = |x: f64, y: f64, z: f64| product([one; 3], [x, y, z].map(TwoPart::from));
        assert_eq!(of(1.0, u, u), 1.0 + 2.0 * u);
        assert_eq!(of(u, 1.0, u), 1.0 + 2.0 * u);
        assert_eq!(of(1.0, u, 0.0), 1.0, "half a digit is not enough");
        // (1 + 2⁻³⁰)² − 1 − 2⁻²⁹ = 2⁻⁶⁰, of which the first two cancel
        let x = 1.0 + 2.0_f64.powi(-30);
        let w = [x, 1.0, 2.0_f64.powi(-29)].map(TwoPart::from);
        assert_eq!(product(w, [x, -1.0, -1.0].map(TwoPart::from)), 2.0_f64.powi(-60));
        // and the second parts of the factors
        let tiny = TwoPart { hi: 1.0, lo: u * u };
        assert_eq!(product([tiny, one, one], [one, -one, TwoPart::from(0.0)]), u * u);
        assert_eq!(product([one, one, one], [tiny, -one, TwoPart::from(0.0)]), u * u);
    }

    /// By hand: from 1 beside the axis to the axis of a thread, where f is −r², x is zero and ρ is r; 2^−190 is 6e−58.
    #[test]
    fn on_the_axis_of_a_thread_squares_may_vanish() {
        let f = |radius: f64| {
            let thread = OpenCone::new(f64::vec3(0.0, 0.0, 0.0), radius, f64::vec3(0.0, 0.0, 1.0), radius);
            let (wall, line) = (Wall::of(&thread).unwrap(), [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]]);
            Place::at(1.0, &wall, &thread, line).map(|place| place.f.value)
        };
        assert_eq!(f(2.0_f64.powi(-190)), Some(-(2.0_f64.powi(-380))));
        assert_eq!(f(2.0_f64.powi(-240)), None, "of numbers below 1e−60 nothing is said");
    }
}

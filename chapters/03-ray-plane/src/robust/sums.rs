//! The fast ways of [`robust`](super): n · v in plain `f64` and in two parts, with their error bounds.
//!
//! With u = 2^−53, the relative error of one operation, and S = Σ |n_i v_i|, a sum is accepted where |n · v| is at
//! least 2^−23 S in plain `f64`, and at least 2^−45 S in two parts. Its sign is then certain.

use math::TwoPart;
use math::two_part::{fast_two_sum, two_product, two_sum};

/// n · v as hi + lo.
#[derive(Clone, Copy)]
pub(super) struct Sum {
    pub(super) hi: f64,
    pub(super) lo: f64,
    /// Whether the error left over is of no account.
    pub(super) is_certain: bool,
}

/// Between these, neither a product nor its rounding error overflows or vanishes, nor does the quotient of
/// two sums of such products, of which at least 2^−92 is left.
pub(super) const SAFE: std::ops::RangeInclusive<f64> = 1e-130..=1e130;

/// p_r − p_0 exactly.
#[inline(always)]
pub(super) fn from_plane(p_r: [f64; 3], p_0: [f64; 3]) -> [TwoPart; 3] {
    std::array::from_fn(|axis| two_sum(p_r[axis], -p_0[axis]))
}

impl Sum {
    /// In plain `f64`, with v rounded once at the most.
    ///
    /// A component of v, a product and two sums err by u each, so that the sum is within 5u S, and within
    /// 2^−27 of itself. Then t, the quotient of two, is within 2^−26 of itself: a quarter of the last
    /// digit of an `f32`.
    #[inline(always)]
    pub(super) fn at_once(n: [f64; 3], v: [f64; 3]) -> Sum {
        const LEAST: f64 = 1.0 / (1u32 << 23) as f64;
        let products: [f64; 3] = std::array::from_fn(|axis| n[axis] * v[axis]);
        let hi = products[0] + products[1] + products[2];
        Sum { hi, lo: 0.0, is_certain: is_certain(hi, products, LEAST) }
    }

    /// With the rounding errors of v, of the products and of the sums, which are summed in plain `f64`.
    ///
    /// Those of v, of the products and of either sum are at most u S together, 4u S in all. None is rounded
    /// more than five times on its way into `lo`: it loses 20u² S, less than 2^−101 S. Of the sum that is
    /// at most 2^−56, or u/8.
    #[inline(always)]
    pub(super) fn in_two_parts(n: [f64; 3], v: [TwoPart; 3]) -> Sum {
        const LEAST: f64 = 1.0 / (1u64 << 45) as f64;
        let products: [TwoPart; 3] = std::array::from_fn(|axis| two_product(n[axis], v[axis].hi));
        let first = two_sum(products[0].hi, products[1].hi);
        let second = two_sum(first.hi, products[2].hi);
        let dropped: [f64; 3] = std::array::from_fn(|axis| products[axis].lo + n[axis] * v[axis].lo);
        let lo = (first.lo + second.lo) + (dropped[0] + dropped[1] + dropped[2]);
        let sum = fast_two_sum(second.hi, lo);
        let is_certain = is_certain(sum.hi, products.map(|product| product.hi), LEAST);
        Sum { hi: sum.hi, lo: sum.lo, is_certain }
    }

    /// The quotient of two certain sums. In two parts it is good to 1.25 units of its last digit: a half
    /// for the rounding of each line, and an eighth for each sum.
    #[inline(always)]
    pub(super) fn over(self, other: Sum) -> f64 {
        let quotient = self.hi / other.hi;
        quotient + (self.lo - quotient * other.lo) / other.hi
    }
}

/// Whether a sum of products is at least `least` of S, and S of an ordinary size.
///
/// That refuses what is degenerate as well: S is zero for a vector that is zero, infinite or NaN for one
/// that is not finite, and no comparison holds for NaN.
#[inline(always)]
fn is_certain(sum: f64, products: [f64; 3], least: f64) -> bool {
    let size = products[0].abs() + products[1].abs() + products[2].abs();
    SAFE.contains(&size) && sum.abs() >= least * size
}

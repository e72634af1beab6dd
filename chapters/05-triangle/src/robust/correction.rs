//! λ to its last digit: the solution put back into the equations.
//!
//! The three equations ā + λ d = p̄1 + α e1 + β e2 were solved in plain `f64`, so λ is off by some of its last digits.
//! How much, the equations tell: y = (p̄1 − ā) − λ d + α e1 + β e2 is what they leave. It has a share along n,
//! and λ is too small by y · n / d · n, whatever α and β are, for e1 and e2 are at right angles to n. (This is one step of
//! iterative refinement: Wilkinson 1963; Higham, *Accuracy and Stability*, 12.)
//!
//! All the art is in y, of which nearly everything cancels. So λ, α and β are cut off after 26 digits first, and d, e1 and e2
//! are split into halves of 26 and 27: then no product is rounded, and y is small without being all noise.

use math::plain::dot;
use math::two_part::two_sum;

/// λ, α and β.
#[derive(Clone, Copy)]
pub(super) struct Solution {
    pub(super) lambda: f64,
    pub(super) alpha: f64,
    pub(super) beta: f64,
}

/// λ, off by less than a unit of its last digit.
///
/// With u = 2^−53, |x| for the sum of the magnitudes of a vector's components, S = |λ| |d| + |e1| + |e2|, H = |e1| |e2| S, and
/// N = (p̄1 − ā) · n, which the caller has made sure is at least 2^−17 H:
///
/// | number | is at most, or off by at most | because |
/// | --- | --- | --- |
/// | λ, α, β | 2^−25 of themselves and 2^−31 S | cut off, and solved: 14u H / N |
/// | y | at most 2^−24 S | |
/// | y | off by 2^−75 S | of numbers below 2^−25 S seven sums, and those rounded once; u \|y\| |
/// | n | off by 3u \|e1\| \|e2\| | two differences, a product, a subtraction, of which one is in y · n |
/// | y · n | off by 2^−73 H | 7u \|y\| \|e1\| \|e2\|, and y's error |
/// | that over d · n, as a share of λ | off by 2^−56 and 2^−57 | 2^−73 H / N; and 7u H / N of a correction of 2^−25 λ |
///
/// Together that is less than a quarter of the last digit, which is at least u of λ, before λ and its correction are added and
/// rounded.
#[inline(always)]
pub(super) fn corrected(
    solution: Solution,
    [o, d]: [[f64; 3]; 2],
    [p1, p2, p3]: [[f64; 3]; 3],
    n: [f64; 3],
    one_over_d_dot_n: f64,
) -> f64 {
    let [lambda, alpha, beta] = [solution.lambda, solution.alpha, solution.beta].map(upper_half);
    let y: [f64; 3] = std::array::from_fn(|axis| {
        let to_p1 = two_sum(p1[axis], -o[axis]);
        let (e1, e2) = (two_sum(p2[axis], -p1[axis]), two_sum(p3[axis], -p1[axis]));
        let [d_upper, e1_upper, e2_upper] = [d[axis], e1.hi, e2.hi].map(upper_half);
        let d_lower = d[axis] - d_upper;
        let (e1_lower, e2_lower) = ((e1.hi - e1_upper) + e1.lo, (e2.hi - e2_upper) + e2.lo);
        // the large parts, with every rounding error kept
        let first = two_sum(to_p1.hi, -(lambda * d_upper));
        let second = two_sum(first.hi, alpha * e1_upper);
        let third = two_sum(second.hi, beta * e2_upper);
        // and the small ones
        let kept = (first.lo + second.lo) + (third.lo + to_p1.lo);
        let lower = (alpha * e1_lower + beta * e2_lower) - lambda * d_lower;
        third.hi + (kept + lower)
    });
    lambda + dot(y, n) * one_over_d_dot_n
}

/// `x` cut off after 26 binary digits. What is cut off has 27, and neither is rounded.
#[inline(always)]
fn upper_half(x: f64) -> f64 {
    const CUT: u64 = !((1 << 27) - 1);
    f64::from_bits(x.to_bits() & CUT)
}

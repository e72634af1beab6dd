//! The first way of [`robust`](super): the four determinants of [`mod@matrix`](mod@crate::matrix) in plain `f64`, with their
//! error bound.
//!
//! With u = 2^−53, the error of one operation, |x| for the sum of the magnitudes of a vector's components, e1 = p̄2 − p̄1,
//! e2 = p̄3 − p̄1 and A = p̄1 − ā, what is computed is off by at most
//!
//! | number | of | because |
//! | --- | --- | --- |
//! | n = e1 × e2, d · n | 7u \|d\| \|e1\| \|e2\| | two differences, a product and a subtraction; a product and two sums |
//! | q = d × A, v = −e2 · q | 7u \|d\| \|A\| \|e2\| | as many |
//! | w = e1 · q | 7u \|d\| \|A\| \|e1\| | as many |
//! | u = d · n − v − w | 9u of these three together | they and two subtractions |
//!
//! One bound for all, 16u \|d\| (\|e1\| \|e2\| + \|A\| (\|e1\| + \|e2\|)), is enough for the verdict of nearly all rays. It
//! grows with the edges, not with the distance alone, for the volumes are taken from the edges: d · (C × A) is d · (e2 × A).

use math::plain::{cross, difference, dot, size};
use math::{Certainty, Ray3, Real, Vector};

use super::correction::{Solution, corrected};
use super::{Passage, Robust};
use crate::Triangle;

/// u, the relative error of one operation.
const UNIT: f64 = f64::EPSILON / 2.0;
/// The error of the three volumes and d · n: more than 9u.
const ERROR: f64 = 16.0 * UNIT;
/// Between these, neither a product of four lengths nor the errors of its factors overflow or vanish.
const SAFE: std::ops::RangeInclusive<f64> = 1e-70..=1e70;

/// What plain `f64` can say; `None` where it leaves a doubt, or the question is degenerate. (Inlined into every caller: it is
/// most of what `robust` costs.)
#[inline(always)]
pub(super) fn robust<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<Robust<R>> {
    let is_f64 = R::DIGITS == f64::MANTISSA_DIGITS;
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let [p1, p2, p3] = triangle.corners().map(Vector::in_f64::<3>);

    let (e1, e2, to_p1) = (difference(p2, p1), difference(p3, p1), difference(p1, o));
    let n = cross(e1, e2);
    let q = cross(d, to_p1);
    let d_dot_n = dot(d, n);
    let (v, w) = (-dot(e2, q), dot(e1, q));
    let u = d_dot_n - v - w;

    let [d_size, e1_size, e2_size, to_p1_size] = [d, e1, e2, to_p1].map(size);
    let area = e1_size * e2_size;
    let edges = e1_size + e2_size;
    let error = ERROR * d_size * (area + to_p1_size * edges);
    // Products of four numbers of an f32 are ordinary numbers as f64. NaN fails either test, and the next.
    let in_range = match is_f64 {
        true => {
            SAFE.contains(&d_size)
                && e1_size.min(e2_size) >= *SAFE.start()
                && to_p1_size + edges <= *SAFE.end()
        }
        false => error < f64::INFINITY,
    };
    let (lowest, highest) = (lower(lower(u, v), w), higher(higher(u, v), w));
    let past = Robust {
        ray: *ray,
        triangle: *triangle,
        volumes: [u, v, w],
        d_dot_n,
        lambda: None,
        certainty: Certainty::AtOnce,
        passage: Passage::Past,
        fine_lambda: f64::NAN,
        n: None,
    };
    if !in_range {
        return None;
    }
    // Of corners on one line the volumes differ in sign too.
    let n_size = size(n);
    if lowest < -error && highest > error {
        return (n_size > ERROR * area).then_some(past);
    }
    if !(lowest > error || highest < -error) {
        return None;
    }

    // λ = A · n / d · n
    let one_over = 1.0 / d_dot_n;
    let to_p1_dot_n = dot(to_p1, n);
    let lambda = to_p1_dot_n * one_over;
    if !is_enough::<R>(to_p1_dot_n, area * (lambda.abs() * d_size + edges)) {
        return None;
    }
    let fine_lambda = match is_f64 {
        true => {
            let plain = Solution { lambda, alpha: v * one_over, beta: w * one_over };
            corrected(plain, [o, d], [p1, p2, p3], n, one_over)
        }
        false => lambda,
    };
    let normal_is_good = n_size >= OF_NORMAL * area;
    Some(Robust {
        lambda: Some(R::root_from(fine_lambda)),
        passage: Passage::Through,
        fine_lambda,
        n: normal_is_good.then_some(n),
        ..past
    })
}

/// Whether λ is good to the last digit of R, with N = A · n and H = |e1| |e2| (|λ| |d| + |e1| + |e2|).
///
/// Where the line passes through the triangle, A = λ d − α e1 − β e2 with α and β from 0 to 1, so that
/// |A| ≤ |λ| |d| + |e1| + |e2|. N is then within 7u |A| |e1| |e2| ≤ 7u H, and d · n, times |λ|, within 7u H too. In `f32`, with
/// |N| ≥ 2^−22 H, λ is within 14u 2^22 and two roundings of itself, which is less than 2^−26, a quarter of the last
/// digit. In `f64` what is found here is only what [`corrected`] starts from; there is said why it asks for 2^−17 H.
#[inline(always)]
fn is_enough<R: Real>(to_p1_dot_n: f64, h: f64) -> bool {
    const FOR_F32: f64 = 1.0 / (1u64 << 22) as f64;
    const FOR_F64: f64 = 1.0 / (1u64 << 17) as f64;
    let least = if R::DIGITS == f64::MANTISSA_DIGITS { FOR_F64 } else { FOR_F32 };
    to_p1_dot_n.abs() >= least * h
}

/// n is off by 4u |e1| |e2| at most. Where |n| is at least this share of |e1| |e2| that is 1024u of it: a 500 000th of the last
/// digit of an `f32`.
const OF_NORMAL: f64 = 1.0 / 256.0;

/// The lower of two numbers, neither of them NaN: one instruction.
#[inline(always)]
fn lower(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The higher of two.
#[inline(always)]
fn higher(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

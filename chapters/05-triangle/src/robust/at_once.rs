//! The first way of [`robust`](super): the [`Volumes`] in plain `f64`, with their error bound.

use math::plain::{dot, size};
use math::{Certainty, Ray3, Real};

use super::correction::{Solution, corrected};
use super::{Passage, Robust};
use crate::Triangle;
use crate::volumes::{ERROR, Volumes};

/// What plain `f64` can say; `None` where it leaves a doubt, or the question is degenerate. (Inlined into every caller: it is
/// most of what `robust` costs.)
#[inline(always)]
pub(super) fn robust<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<Robust<R>> {
    let is_f64 = R::DIGITS == f64::MANTISSA_DIGITS;
    let computed = Volumes::of(ray, triangle);
    let Volumes { n, to_p1, d_dot_n, uvw: [u, v, w], d_size, error, .. } = computed;
    let (area, edges) = (computed.area(), computed.edges());
    // Products of four numbers of an f32 are ordinary numbers as f64. NaN fails either test, and the next.
    let in_range = if is_f64 { computed.are_in_range() } else { error < f64::INFINITY };
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
            corrected(plain, computed.ray, computed.corners, n, one_over)
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

//! Eight triangles that the ray surely misses, before chapter 05's `robust` decides about the others.
//!
//! The determinants of `robust`'s first way with its error bounds, but in R and not in `f64`. With u =
//! 2^−DIGITS, |x| for the sum of the magnitudes of a vector's components, e1 = p̄2 − p̄1, e2 = p̄3 − p̄1, A =
//! p̄1 − ā and q = d × A:
//!
//! | number | is off by at most |
//! | --- | --- |
//! | d · n, v = −e2 · q, w = e1 · q and u = d · n − v − w | 9u of E = \|d\| (\|e1\| \|e2\| + \|A\| (\|e1\| + \|e2\|)) |
//! | A · n | 7u \|A\| \|e1\| \|e2\| |
//!
//! (It is derived there.) Products that vanish lose half of the smallest number η each, and then take part in
//! another product: fewer than 16 such halves times 1 + |d| + |e1| + |e2| + |A|. 16u and 16η are taken, which
//! leaves room for the roundings of the bounds themselves. If E is finite so is every product in it, and no
//! sum of them is NaN.
//!
//! A ray whose volumes have both signs for sure passes the triangle. Elsewhere λ = A · n / d · n, and it is
//! surely beyond the span if A · n − max d · n, signs turned so that d · n is positive, is above twice all
//! that both may be off by: also if the sign of d · n is wrong, for then λ is negative. Before the span
//! likewise, but only with a sign that is sure. max and min are widened by η, as λ may be rounded into the
//! span; a relative rounding is far below 16u.

use math::{Ray3, Real, Span, Vector};
use triangle::Triangle;

use super::block::{Block, LaneSet};
use super::mesh::Lanes;
use super::node::{Column, LANES};

/// By `robust`.
pub(crate) struct ByRobust;

impl<R: Real> Lanes<R> for ByRobust {
    #[inline(always)]
    fn candidates(&self, block: &Block<R>, ray: &Ray3<R>, span: Span<R>) -> (Column<R>, LaneSet) {
        let [zero, one, two, sixteen] = [R::from(0.0), R::from(1.0), R::from(2.0), R::from(16.0)];
        let unit = R::from(1.0 / (1u64 << R::DIGITS) as f32);
        let (min, max) = (span.min - R::SMALLEST, span.max + R::SMALLEST);
        let d_size = size::<R>(ray.direction);
        let mut left = [zero; LANES];
        for (lane, left) in left.iter_mut().enumerate() {
            let Triangle { p1, p2, p3 } = block.triangle(lane);
            let (e1, e2, to_p1) = (p2 - p1, p3 - p1, p1 - ray.origin);
            let n = R::cross(e1, e2);
            let q = R::cross(ray.direction, to_p1);
            let d_dot_n = ray.direction.dot(n);
            let (v, w) = (-e2.dot(q), e1.dot(q));
            let u = d_dot_n - v - w;

            let (e1_size, e2_size, to_p1_size) = (size::<R>(e1), size::<R>(e2), size::<R>(to_p1));
            let (area, edges) = (e1_size * e2_size, e1_size + e2_size);
            let e = d_size * (area + to_p1_size * edges);
            let vanished = sixteen * R::SMALLEST * (one + d_size + edges + to_p1_size);
            let volume_error = sixteen * unit * e + vanished;
            let (lowest, highest) = (lower(lower(u, v), w), higher(higher(u, v), w));
            let is_past = (lowest < -volume_error) & (highest > volume_error);

            // λ against the span
            let is_downward = d_dot_n < zero;
            let above = to_p1.dot(n);
            let (above, rise) = (select(is_downward, -above, above), magnitude(d_dot_n));
            let above_error = sixteen * unit * to_p1_size * area + vanished;
            let is_beyond = above - max * rise > two * (above_error + max * volume_error);
            let is_before = above - min * rise < -two * (above_error + min * volume_error);
            let is_out = is_beyond | (is_before & (rise > volume_error));

            let is_missed = (is_past | is_out) & (e < R::INFINITY);
            *left = select(is_missed, -one, one);
        }
        (left, LaneSet::not_negative(&left))
    }

    #[inline(always)]
    fn hit(&self, ray: &Ray3<R>, triangle: &Triangle<R>, span: Span<R>, _t: R) -> Option<R> {
        triangle::robust(ray, triangle).lambda.filter(|&lambda| span.contains(lambda))
    }
}

/// |x| + |y| + |z|
#[inline(always)]
fn size<R: Real>(v: R::Vec3) -> R {
    let [x, y, z] = R::xyz(v);
    magnitude(x) + magnitude(y) + magnitude(z)
}

#[inline(always)]
fn magnitude<R: Real>(x: R) -> R {
    select(x < R::from(0.0), -x, x)
}

#[inline(always)]
fn lower<R: Real>(a: R, b: R) -> R {
    select(a < b, a, b)
}

#[inline(always)]
fn higher<R: Real>(a: R, b: R) -> R {
    select(a > b, a, b)
}

/// One of two numbers that are there already: an instruction, not a branch.
#[inline(always)]
fn select<R>(condition: bool, a: R, b: R) -> R {
    if condition { a } else { b }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    const U: f64 = f64::EPSILON / 2.0;

    /// Whether a ray along the axis z, from one unit before the triangle or behind it, is left to the test. The triangle's
    /// sides are 2 along x and 4 along y, so n⃗ = (0, 0, 8); the direction is 2 long, so λ = ½.
    fn is_left(x: f64, span: Span<f64>) -> bool {
        let triangle =
            Triangle { p1: DVec3::ZERO, p2: DVec3::new(2.0, 0.0, 0.0), p3: DVec3::new(0.0, 4.0, 0.0) };
        let block = Block::of(&[0], &|_| triangle);
        let [above, below] = [1.0, -1.0].map(|side| {
            let ray = Ray3::new(DVec3::new(x, 0.5, side), DVec3::new(0.0, 0.0, -2.0 * side));
            !ByRobust.candidates(&block, &ray, span).1.is_empty()
        });
        assert_eq!(above, below);
        above
    }

    /// By hand: so little beyond the edge x = 0 the volume is 8 |x|, and its error 16u · 2 (2 · 4 + 1.5 · 6) = 544u.
    #[test]
    fn what_is_surely_past_an_edge_is_left_out() {
        assert!(is_left(0.5, Span::ahead()));
        assert!(is_left(-64.0 * U, Span::ahead()));
        assert!(!is_left(-72.0 * U, Span::ahead()));
    }

    /// By hand: n⃗·(p̄1 − o⃗) = 8 and n⃗·d⃗ = 16. Twice the errors is 2 (16u · 2 · 8 + λ · 16u · 2 (8 + 2 · 6)) = 1152u, which is
    /// 72u of λ.
    #[test]
    fn what_is_surely_out_of_the_span_is_left_out() {
        assert!(is_left(0.5, Span::new(0.0, 0.5 - 70.0 * U)));
        assert!(!is_left(0.5, Span::new(0.0, 0.5 - 74.0 * U)));
        assert!(is_left(0.5, Span::new(0.5 + 70.0 * U, 1.0)));
        assert!(!is_left(0.5, Span::new(0.5 + 74.0 * U, 1.0)));
        assert!(!is_left(-72.0 * U, Span::new(0.0, 0.25)), "past it as well");
    }

    /// By hand: on the long edge x is 1¾, the volume beyond it 8 (x − 1¾), and its error 16u · 2 (2 · 4 + 3¼ · 6) = 880u.
    #[test]
    fn the_long_edge_is_an_edge_too() {
        assert!(is_left(1.75 + 100.0 * U, Span::ahead()));
        assert!(!is_left(1.75 + 120.0 * U, Span::ahead()));
    }

    /// From a corner, so that A⃗ = 0 and λ = 0: the only one in a span that ends there.
    #[test]
    fn a_hit_at_the_very_end_of_the_span_is_left() {
        let [zero, x, y] = [[0.0, 0.0], [64.0, 0.0], [0.0, 64.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let block = Block::of(&[0], &|_| Triangle { p1: zero, p2: x, p3: y });
        for direction in [DVec3::Z * 64.0, DVec3::Z * -64.0] {
            let ray = Ray3::<f64>::new(zero, direction);
            assert!(!ByRobust.candidates(&block, &ray, Span::new(0.0, 0.0)).1.is_empty(), "{direction}");
        }
    }

    /// By hand, in units η of the smallest number: a direction so short, 2¹⁴ η, that the volumes of a triangle with
    /// sides of ½ are whole numbers, 2¹³ η x beside the edge x = 0, and all products with u vanish. A⃗ is 8¼ and
    /// a little more, and 16η (1 + ½ + ½ + 8¼ + x) is between 164η and 165η.
    #[test]
    fn products_that_vanish_are_allowed_for() {
        let [zero, x, y] = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let block = Block::of(&[0], &|_| Triangle { p1: zero, p2: x, p3: y });
        let short = 16384.0 * f64::from_bits(1);
        for (volume, is_left) in [(40, true), (-156, true), (-164, true), (-172, false)] {
            for side in [8.0, -8.0] {
                let origin = DVec3::new(f64::from(volume) / 8192.0, 0.25, side);
                let ray = Ray3::<f64>::new(origin, DVec3::new(0.0, 0.0, -short * side.signum()));
                let candidates = ByRobust.candidates(&block, &ray, Span::ahead());
                assert_eq!(!candidates.1.is_empty(), is_left, "{volume} {side}");
            }
        }
    }
}

//! Has a triangle an area? Exactly.
//!
//! Its corners lie on one line if n = (p̄2 − p̄1) × (p̄3 − p̄1) is zero. Computed, n is almost never zero and
//! almost always a little wrong, so "too small" would refuse slivers and accept lines. Here the three
//! components are taken to be zero only if they are, as real numbers of the corners as given.

use std::cmp::Ordering;

use math::{Bounded, Exact, Real, Sure, TwoPart, Vector};

use crate::Triangle;

/// Whether n ≠ 0, exactly. The corners must be finite.
pub fn has_area<R: Real>(triangle: &Triangle<R>) -> bool {
    let corners = triangle.corners().map(Vector::in_f64::<3>);
    // One component that is surely not zero is enough; that all are zero, only exact numbers can say.
    is_not_zero(normal::<Bounded<f64>>(corners))
        || is_not_zero(normal::<Bounded<TwoPart>>(corners))
        || is_not_zero(normal::<Exact>(corners))
}

/// n = (p̄2 − p̄1) × (p̄3 − p̄1)
#[inline(always)]
pub(crate) fn normal<N: Sure>([p1, p2, p3]: [[f64; 3]; 3]) -> [N; 3] {
    let edge = |to: [f64; 3]| -> [N; 3] { std::array::from_fn(|axis| N::difference(to[axis], p1[axis])) };
    N::cross(&edge(p2), &edge(p3))
}

fn is_not_zero<N: Sure>(n: [N; 3]) -> bool {
    n.iter().any(|component| component.sign().is_some_and(Ordering::is_ne))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use glam::Vec3;
    use math::Wide;

    /// n_z of [`sliver`] as a multiple of 2^−90.
    pub(crate) const SLIVER_RISE: f64 = 1.0 + 3.0 / (1u64 << 17) as f64;

    /// Corners of which twice the digits are not enough for a normal: the products cancel to 2^−90, and what the sum
    /// of lower parts rounds away, some 2^−106, is a 2^16th of that.
    ///
    /// By hand, with h = 2^−52 and b = 3 · 2^−55, e1 = (1 + ih, 1 + kh − b, 0) and e2 = (1 + lh, 1 + jh − b, 2^−90),
    /// with k = j − 1 and l = i + 1. n_x is 2^−90 (1 + kh − b), and since i + j is k + l, n_z is
    /// (ij − kl) h² + b (l − i) h = (i − j + 1) h² + b h. With i − j = 2^14 − 1 that is 2^−90 (1 + 3 · 2^−17).
    pub(crate) fn sliver() -> [[f64; 3]; 3] {
        let h = |of: u64| 1.0 + of as f64 / (1u64 << 52) as f64;
        let (i, b) = ((3 << 50) + 1, 3.0 / (1u64 << 55) as f64);
        let j = i - (1 << 14) + 1;
        let up = 1.0 / (1u128 << 90) as f64;
        [[0.0, b, 0.0], [h(i), h(j - 1), 0.0], [h(i + 1), h(j), up]]
    }

    /// The sliver's numbers are what is said, exactly.
    #[test]
    fn the_rise_of_the_sliver() {
        let n_z = normal::<Exact>(sliver())[2].to_wide() * Wide::from((1u128 << 90) as f64);
        assert_eq!(n_z.to_f64(), SLIVER_RISE);
    }

    fn spans(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> bool {
        has_area(&Triangle::<f64> { p1: a.into(), p2: b.into(), p3: c.into() })
    }

    #[test]
    fn corners_on_one_line_have_no_area() {
        assert!(!spans([1.0, 2.0, 3.0], [1.0, 2.0, 3.0], [4.0, 5.0, 6.0]), "two corners are one");
        assert!(!spans([1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [-3.0, -6.0, -9.0]), "on a line");
        assert!(!spans([0.0; 3], [1e300, 0.0, 0.0], [-1e300, 0.0, 0.0]), "products overflow");
        assert!(!spans([0.0; 3], [1e-300, 1e-300, 0.0], [5e-324, 5e-324, 0.0]), "products vanish");
    }

    #[test]
    fn a_sliver_has_an_area_however_thin() {
        assert!(spans([0.0; 3], [1.0, 0.0, 0.0], [0.5, 1e-300, 0.0]));
        assert!(spans([0.0; 3], [1e-200, 0.0, 0.0], [0.0, 1e-200, 0.0]), "n = 1e−400, which is no f64");
        assert!(spans([0.0; 3], [1e200, 0.0, 0.0], [0.0, 1e200, 0.0]), "n = 1e400");
        // as decimal numbers these lie on a line; as floats they do not
        assert!(spans([0.0; 3], [0.1, 0.3, 0.0], [0.3, 0.9, 0.0]));
        assert!(!spans([0.0; 3], [0.5, 1.5, 0.0], [1.5, 4.5, 0.0]));
    }

    /// The computed normal is no judge: here it is zero, and the corners are on no line.
    #[test]
    fn a_normal_that_cancels_is_not_zero() {
        let up = 1.0_f32.next_up();
        let triangle = Triangle::<f32> {
            p1: Vec3::ZERO,
            p2: Vec3::new(up, 1.0, 0.0),
            p3: Vec3::new(1.0, 1.0_f32.next_down(), 0.0),
        };
        // by hand: (1 + 2ε)(1 − ε) − 1 = ε − 2ε² with ε = 2^−24, and that product rounds to 1
        assert!(has_area(&triangle));
        let turned = Triangle::<f32> { p3: triangle.p2, p2: triangle.p3, ..triangle };
        assert!(has_area(&turned));
    }
}

//! The volumes of [`mod@robust`](mod@crate::robust) in plain `f64`, with their error bound.
//!
//! They are the four determinants of [`mod@matrix`](mod@crate::matrix). With u = 2^−53, the error of one
//! operation, |x| for the sum of the magnitudes of a vector's components, e1 = p̄2 − p̄1, e2 = p̄3 − p̄1 and
//! A = p̄1 − ā, what is computed is off by at most
//!
//! | number | of | because |
//! | --- | --- | --- |
//! | n = e1 × e2, d · n | 7u \|d\| \|e1\| \|e2\| | two differences, a product and a subtraction; a product and two sums |
//! | q = d × A, v = −e2 · q | 7u \|d\| \|A\| \|e2\| | as many |
//! | w = e1 · q | 7u \|d\| \|A\| \|e1\| | as many |
//! | u = d · n − v − w | 9u of these three together | they and two subtractions |
//!
//! One bound for all, 16u \|d\| (\|e1\| \|e2\| + \|A\| (\|e1\| + \|e2\|)), is enough for the verdict of
//! nearly all rays. It grows with the edges, not with the distance alone, for the volumes are taken from the
//! edges: d · (C × A) is d · (e2 × A).

use math::plain::{cross, difference, dot, size};
use math::{Ray3, Real, Vector};

use crate::Triangle;

/// u, the relative error of one operation.
pub(crate) const UNIT: f64 = f64::EPSILON / 2.0;
/// The error of the three volumes and d · n: more than 9u.
pub(crate) const ERROR: f64 = 16.0 * UNIT;
/// Between these, neither a product of four lengths nor the errors of its factors overflow or vanish.
const SAFE: std::ops::RangeInclusive<f64> = 1e-70..=1e70;

/// The volumes, what they are made of, and how far they may be off.
pub(crate) struct Volumes {
    /// ā and d, in `f64`.
    pub(crate) ray: [[f64; 3]; 2],
    /// p̄1, p̄2 and p̄3, in `f64`.
    pub(crate) corners: [[f64; 3]; 3],
    /// n = e1 × e2
    pub(crate) n: [f64; 3],
    /// A = p̄1 − ā
    pub(crate) to_p1: [f64; 3],
    /// d · n
    pub(crate) d_dot_n: f64,
    /// u, v and w, one for each edge.
    pub(crate) uvw: [f64; 3],
    /// |d|
    pub(crate) d_size: f64,
    /// |A|
    to_p1_size: f64,
    /// |e1|, |e2|
    edge_sizes: [f64; 2],
    /// How far u, v, w and d · n may be off, where [`Volumes::are_in_range`].
    pub(crate) error: f64,
}

impl Volumes {
    /// Of any ray and triangle. (Inlined into every caller, of which some need but half of it.)
    #[inline(always)]
    pub(crate) fn of<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Volumes {
        // one by one: of an array of vectors `map` may be a call
        let (o, d) = (ray.origin.in_f64::<3>(), ray.direction.in_f64::<3>());
        let Triangle { p1, p2, p3 } = *triangle;
        let (p1, p2, p3) = (p1.in_f64::<3>(), p2.in_f64::<3>(), p3.in_f64::<3>());

        let (e1, e2, to_p1) = (difference(p2, p1), difference(p3, p1), difference(p1, o));
        let n = cross(e1, e2);
        let q = cross(d, to_p1);
        let d_dot_n = dot(d, n);
        let (v, w) = (-dot(e2, q), dot(e1, q));
        let u = d_dot_n - v - w;

        let (d_size, e1_size, e2_size, to_p1_size) = (size(d), size(e1), size(e2), size(to_p1));
        let error = ERROR * d_size * (e1_size * e2_size + to_p1_size * (e1_size + e2_size));
        let edge_sizes = [e1_size, e2_size];
        let (uvw, ray, corners) = ([u, v, w], [o, d], [p1, p2, p3]);
        Volumes { ray, corners, n, to_p1, d_dot_n, uvw, d_size, to_p1_size, edge_sizes, error }
    }

    /// |e1| |e2|
    #[inline(always)]
    pub(crate) fn area(&self) -> f64 {
        self.edge_sizes[0] * self.edge_sizes[1]
    }

    /// |e1| + |e2|
    #[inline(always)]
    pub(crate) fn edges(&self) -> f64 {
        self.edge_sizes[0] + self.edge_sizes[1]
    }

    /// Nothing on the way has overflowed or vanished, and nothing is NaN.
    #[inline(always)]
    pub(crate) fn are_in_range(&self) -> bool {
        let shorter = self.edge_sizes[0].min(self.edge_sizes[1]);
        SAFE.contains(&self.d_size)
            && shorter >= *SAFE.start()
            && self.to_p1_size + self.edges() <= *SAFE.end()
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use glam::DVec3;

    /// What the bound is for the rays of [`inside_by`].
    pub(crate) const BOUND: f64 = 1.0 / (1u64 << 48) as f64;

    /// Along z from the world's origin, with edges of 1 along x and along y, and then with these exchanged. The line
    /// of the ray is so far inside of one edge, or outside where it is below zero.
    pub(crate) fn inside_by(e: f64) -> [(Ray3<f64>, Triangle<f64>); 2] {
        let p1 = DVec3::new(e.abs() - 0.25, -e, 0.25);
        let (p2, p3) = (p1 + DVec3::X, p1 + DVec3::Y);
        let ray = Ray3::new(DVec3::ZERO, DVec3::Z);
        [(ray, Triangle { p1, p2, p3 }), (ray, Triangle { p1, p2: p3, p3: p2 })]
    }

    /// By hand, with A = (x, y, ¼): v = −x, w = −y and u = 1 + x + y, and |A| = ½. The bound is
    /// 2^−49 (1 · 1 + ½ (1 + 1)). The other way round v and w are exchanged, and all have the other sign.
    #[test]
    fn the_volumes_and_their_bound() {
        for e in [BOUND, -BOUND, 2.0 * BOUND, -2.0 * BOUND] {
            let [one, other] = inside_by(e).map(|(ray, triangle)| Volumes::of(&ray, &triangle));
            let [u, v, w] = [0.75 + e.abs() - e, 0.25 - e.abs(), e];
            assert_eq!((one.uvw, one.d_dot_n, one.error), ([u, v, w], 1.0, BOUND));
            assert_eq!((other.uvw, other.d_dot_n, other.error), ([-u, -w, -v], -1.0, BOUND));
            assert!(one.are_in_range() && other.are_in_range());
        }
    }
}

//! "What does it mean when d · n = 0? What does it mean when d · n = 0 and (p̄1 − ā) · n = 0?"
//!
//! The page asks twice and answers neither. With d · n = 0 the ray runs along the triangle's plane, for n is at
//! right angles to it. If (p̄1 − ā) · n ≠ 0 the ray is beside the plane and never meets it:
//! [`Parallel::Apart`]. If that is zero too, λ* = 0/0, and the ray lies within the plane: [`Parallel::Within`].
//! Such a ray may cross the triangle from edge to edge; then it meets it at every point of a stretch, and none is
//! "the" intersection. By the rule of this workbench both are misses, with a reason: from the side a triangle has
//! no height, and whatever solid it bounds is hit on one of its other faces.
//!
//! d · n = 0 is decided on the numbers as given, exactly; a tolerance would lose every ray that grazes.

use std::cmp::Ordering;

use math::{Bounded, Degenerate, Exact, Parallel, Ray3, Real, Sure, TwoPart, Vector};

use crate::{Triangle, area};

/// With u = 2^−53, the rounding error of one operation, d · n as computed below is off by at most 7u of its
/// size: two differences, a product and a subtraction for n, a product and two sums for d · n. This is 16u.
const ERROR: f64 = 8.0 * f64::EPSILON;
/// What vanishes of products below the smallest number is nothing beside this.
const SMALLEST_SAFE: f64 = 1e-290;

/// How the ray runs along the plane; `None` where d · n ≠ 0. Decided on the numbers as given, exactly.
///
/// The numbers must be finite, the direction not zero and the triangle have an area, see [`Triangle::check`].
#[inline]
pub fn parallel<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<Parallel> {
    if surely_crosses(ray, triangle) { None } else { certainly(ray, triangle) }
}

/// The same for any ray and triangle: [`Degenerate`] for a question without an answer. `None` is the good case: there
/// is one λ.
///
/// A ray for which d · n is surely not zero has a direction and the triangle an area: for nearly all rays that is
/// the only thing to find out.
#[inline(always)]
pub fn try_parallel<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Result<Option<Parallel>, Degenerate> {
    if surely_crosses(ray, triangle) && ray.origin.is_finite() {
        return Ok(None);
    }
    look_closely(ray, triangle)
}

#[cold]
#[inline(never)]
fn look_closely<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Result<Option<Parallel>, Degenerate> {
    triangle.check(ray)?;
    Ok(certainly(ray, triangle))
}

/// |d · n| is more than what rounding can do; false where a corner or the direction is not finite.
#[inline(always)]
fn surely_crosses<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> bool {
    let d: [f64; 3] = ray.direction.in_f64();
    let [p1, p2, p3]: [[f64; 3]; 3] = triangle.corners().map(Vector::in_f64);
    let edge = |to: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| to[axis] - p1[axis]) };
    let (e1, e2) = (edge(p2), edge(p3));
    let (mut d_n, mut size) = (0.0, 0.0);
    for (axis, d) in d.into_iter().enumerate() {
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let (plus, minus) = (e1[i] * e2[j], e1[j] * e2[i]);
        d_n += d * (plus - minus);
        size += d.abs() * (plus.abs() + minus.abs());
    }
    d_n.abs() > ERROR * size + SMALLEST_SAFE && size < f64::INFINITY
}

/// The same with more digits, and exactly in the end.
#[cold]
#[inline(never)]
fn certainly<R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<Parallel> {
    let signs = signs::<Bounded<TwoPart>, R>(ray, triangle).or_else(|| signs::<Exact, R>(ray, triangle));
    match signs? {
        [Ordering::Equal, Ordering::Equal] => Some(Parallel::Within),
        [Ordering::Equal, _] => Some(Parallel::Apart),
        _ => None,
    }
}

/// How d · n and (p̄1 − ā) · n compare with zero; `None` where that is in doubt.
fn signs<N: Sure, R: Real>(ray: &Ray3<R>, triangle: &Triangle<R>) -> Option<[Ordering; 2]> {
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let corners = triangle.corners().map(Vector::in_f64::<3>);
    let n = area::normal::<N>(corners);
    let d_n = N::dot(&d.map(N::of), &n).sign()?;
    if d_n.is_ne() {
        return Some([d_n, Ordering::Equal]); // whatever the other may be
    }
    let to_p1 = std::array::from_fn(|axis| N::difference(corners[0][axis], o[axis]));
    Some([d_n, N::dot(&to_p1, &n).sign()?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// n = (0, 0, 1)
    const UPRIGHT: Triangle<f64> = Triangle { p1: DVec3::ZERO, p2: DVec3::X, p3: DVec3::Y };

    fn from(origin: [f64; 3], direction: [f64; 3]) -> Option<Parallel> {
        parallel(&Ray3::<f64>::new(origin.into(), direction.into()), &UPRIGHT)
    }

    /// The page's two questions (slip 19).
    #[test]
    fn both_questions_have_an_answer() {
        assert_eq!(from([0.2, 0.2, 1.0], [1.0, 0.0, 0.0]), Some(Parallel::Apart));
        assert_eq!(from([-1.0, 0.2, 0.0], [1.0, 0.0, 0.0]), Some(Parallel::Within), "through the triangle");
        assert_eq!(from([-1.0, 5.0, 0.0], [1.0, 0.0, 0.0]), Some(Parallel::Within), "past it");
        assert_eq!(from([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]), Some(Parallel::Within), "along an edge");
        assert_eq!(from([0.2, 0.2, 1.0], [1.0, 0.0, -1e-300]), None, "it meets the plane at λ = 1e300");
    }

    /// As printed, λ* = (p̄1 − ā) · n / d · n is −1/0 for the first and 0/0 for the second.
    #[test]
    fn as_printed_lambda_is_infinite_or_no_number() {
        let lambda = |origin: DVec3, direction: DVec3| {
            (UPRIGHT.p1 - origin).dot(UPRIGHT.normal()) / direction.dot(UPRIGHT.normal())
        };
        assert_eq!(lambda(DVec3::new(0.2, 0.2, 1.0), DVec3::X), f64::NEG_INFINITY);
        assert!(lambda(DVec3::new(-1.0, 0.2, 0.0), DVec3::X).is_nan());
    }

    #[test]
    fn zero_means_zero() {
        // d lies in the plane x + y + z = const if its components sum to 0
        let sloped = Triangle::<f64> { p1: DVec3::X, p2: DVec3::Y, p3: DVec3::Z };
        let along =
            |x: f64, y: f64, z: f64| parallel(&Ray3::<f64>::new(DVec3::ZERO, DVec3::new(x, y, z)), &sloped);
        assert_eq!(along(1.0, -2.0, 1.0), Some(Parallel::Apart));
        assert_eq!(along(0.1, 0.2, -0.3), None, "0.1 + 0.2 is not 0.3 as floats");
        assert_eq!(along(1e-300, -2e-300, 1e-300), Some(Parallel::Apart), "products vanish");
        assert_eq!(along(1e308, -1e308, 5e-324), None);
    }

    #[test]
    fn what_is_degenerate_is_never_surely_crossed() {
        let good = [0.5, 0.25, 1.0, 0.25, -0.5, -0.75, 0.5, 0.25, 0.125, 2.0, 0.5, 0.25, 0.5, 3.0, -0.5];
        let reason = |c: [f64; 15]| {
            let v = |i: usize| DVec3::new(c[i], c[i + 1], c[i + 2]);
            let (ray, triangle) = (Ray3::<f64>::new(v(0), v(3)), Triangle { p1: v(6), p2: v(9), p3: v(12) });
            try_parallel(&ray, &triangle)
        };
        assert_eq!(reason(good), Ok(None));
        for place in 0..15 {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut case = good;
                case[place] = bad;
                assert_eq!(reason(case), Err(Degenerate::NotFinite), "{bad} in place {place}");
            }
        }
        let mut case = good;
        case[3..6].fill(-0.0);
        assert_eq!(reason(case), Err(Degenerate::ZeroDirection));
        let mut case = good;
        case.copy_within(6..9, 12);
        assert_eq!(reason(case), Err(Degenerate::NoArea));
    }

    /// By hand: in the plane of two axes the edges (x, y) and (1, 1), and d the unit vector of the third. d · n = x −
    /// y, of size x + y, and so the bound is 2^−49 (x + y), beside which 1e−290 is nothing.
    #[test]
    fn it_surely_crosses_by_more_than_the_bound() {
        let unit = 1.0 / (1u64 << 52) as f64;
        for axis in 0..3 {
            let crosses = |x: f64, y: f64| {
                let place = |u: f64, v: f64, along: f64| {
                    let mut place = [0.0; 3];
                    (place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]) = (along, u, v);
                    DVec3::from(place)
                };
                let triangle =
                    Triangle::<f64> { p1: DVec3::ZERO, p2: place(x, y, 0.0), p3: place(1.0, 1.0, 0.0) };
                [1.0, -1.0].map(|d| surely_crosses(&Ray3::new(DVec3::ZERO, place(0.0, 0.0, d)), &triangle))
            };
            assert_eq!(crosses(4.0, 1.0), [true; 2], "3 is more than 2^−49 · 5");
            assert_eq!(
                crosses(1.0 + 17.0 * unit, 1.0),
                [true; 2],
                "2^−48 (1 + 2^−4) is more than 2^−48 (1 + 2^−49)"
            );
            assert_eq!(crosses(1.0 + 16.0 * unit, 1.0), [false; 2], "2^−48 is less than that");
            assert_eq!(
                crosses(1.0 + 8.0 * unit, 1.0 - 8.0 * unit),
                [false; 2],
                "2^−48 is not more than 2^−49 · 2"
            );
        }
    }
}

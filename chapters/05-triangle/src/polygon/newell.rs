//! The normal of a polygon that may not be convex, nor quite planar.

use math::wide::{exponent_of, scaled};
use math::{Bounded, Exact, Real, Sure, TwoPart, Vector, Wide};

/// A sum in two parts is good enough where its largest component is so many times its error: 2^60, more than
/// the 53 digits that are kept.
const DIGITS_ENOUGH: f64 = (1u64 << 60) as f64;
/// Between 2^−30 and 2^30 a normal is kept as it is: its square is an ordinary number of `f32` too.
const KEPT: i32 = 30;

/// Newell's normal: Σ p̄_i × p̄_{i+1}, twice the area seen along each axis, rounded to the precision. It is
/// scaled by a power of two where it is very large or very small, and to a largest component of 1 where
/// only exact numbers tell it. `None` where it is zero, exactly.
///
/// The corners must be finite, three or more.
pub(super) fn normal<R: Real>(corners: &[R::Vec3]) -> Option<R::Vec3> {
    let corners: Vec<[f64; 3]> = corners.iter().map(|corner| corner.in_f64()).collect();
    let n = newell::<Bounded<TwoPart>>(&corners);
    let largest = n.iter().map(|n| n.value.hi.abs()).fold(0.0, f64::max);
    let is_enough = n.iter().all(|n| n.error * DIGITS_ENOUGH < largest);
    let [x, y, z] = if is_enough && largest.is_finite() {
        let exponent = exponent_of(largest);
        let shift = if exponent.abs() <= KEPT { 0 } else { -exponent };
        n.map(|n| scaled(n.value.hi, shift))
    } else {
        exactly(&corners)?
    };
    Some(R::vec3(R::round_from(x), R::round_from(y), R::round_from(z)))
}

/// Σ (p̄_i − p̄_1) × (p̄_{i+1} − p̄_1): the same, of smaller numbers.
fn newell<N: Sure>(corners: &[[f64; 3]]) -> [N; 3] {
    let from_first = |corner: [f64; 3]| -> [N; 3] {
        std::array::from_fn(|axis| N::difference(corner[axis], corners[0][axis]))
    };
    corners.windows(2).fold([0.0; 3].map(N::of), |[x, y, z], side| {
        let [dx, dy, dz] = N::cross(&from_first(side[0]), &from_first(side[1]));
        [x + dx, y + dy, z + dz]
    })
}

/// In integers as long as it takes, and only then rounded, in units of the largest component.
#[cold]
fn exactly(corners: &[[f64; 3]]) -> Option<[f64; 3]> {
    let n = newell::<Exact>(corners).map(|n| n.to_wide());
    let size = |n: Wide| if n.is_negative() { -n } else { n };
    let larger = |a: Wide, b: Wide| if (a - b).is_negative() { b } else { a };
    let largest = larger(size(n[0]), larger(size(n[1]), size(n[2])));
    (!largest.is_zero()).then(|| n.map(|n| (n / largest).to_f64()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::area::tests::{SLIVER_RISE, sliver};
    use glam::{DVec3, Vec3};

    #[test]
    fn corners_seen_counterclockwise() {
        // by hand: twice the area of the 4 × 3 rectangle, along z
        let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]].map(|[x, y]| DVec3::new(x, y, 5.0));
        assert_eq!(normal::<f64>(&corners), Some(DVec3::new(0.0, 0.0, 24.0)));
        // a dart: its notch takes away 2 of the 8 of the triangle, twice
        let dart = [[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [2.0, 4.0]].map(|[x, y]| DVec3::new(x, 7.0, y));
        // by hand, by the shoelace: 0 + (4·1 − 2·0) + (2·4 − 2·1) + 0 = 10; z × x is y, so x × z is −y
        assert_eq!(normal::<f64>(&dart), Some(DVec3::new(0.0, -10.0, 0.0)));
    }

    #[test]
    fn without_area_is_exact() {
        let line = [0.1, 0.2, 0.7].map(|x| DVec3::new(x, 3.0 * x, 0.0));
        let exact = [1.0, 3.0, 7.0].map(|x| DVec3::new(x, 3.0 * x, -x));
        assert!(
            normal::<f64>(&line).is_some(),
            "0.1, 0.3; 0.2, 0.6; 0.7, 2.1 are not on a line as they are read"
        );
        assert_eq!(normal::<f64>(&exact), None);
        // one unit of the last digit beside the line
        let beside = [exact[0], exact[1], DVec3::new(7.0_f64.next_up(), 21.0, -7.0)];
        assert!(normal::<f64>(&beside).is_some());
    }

    #[test]
    fn size_does_not_matter() {
        for scale in [1e-300, 1e-160, 1e160, 1e300] {
            let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| scale * DVec3::new(x, y, y));
            let n = normal::<f64>(&corners).unwrap();
            assert_eq!(n.normalized(), DVec3::new(0.0, -1.0, 1.0).normalize(), "{scale:e}");
        }
        for scale in [1e-44, 1e-30, 1e30] {
            let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| scale * Vec3::new(x, y, y));
            assert_eq!(normal::<f32>(&corners).unwrap().normalized(), Vec3::new(0.0, -1.0, 1.0).normalize());
        }
    }

    /// By hand: see [`sliver`]. n_z (y2 − b) = SLIVER_RISE n_x. Five numbers are rounded by 2^−53 at most, the two
    /// components, y2 − b and both products, and none counts twice or more in what is left.
    #[test]
    fn the_normal_of_a_sliver_is_right_to_the_last_digit() {
        let [p1, p2, p3] = sliver().map(DVec3::from);
        let n = normal::<f64>(&[p1, p2, p3]).unwrap();
        assert_eq!(n.x.abs().max(n.y.abs()).max(n.z.abs()), 1.0, "in units of the largest");
        let off = n.z * (p2.y - p1.y) - n.x * SLIVER_RISE;
        assert!(off.abs() <= 5.0 * f64::EPSILON, "{n} {off:e}");
    }
}

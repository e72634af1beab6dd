//! Where a ray passes the plane of a polygon in plain `f64`, and how far off that may be: enough for nearly every ray and
//! nearly every side.
//!
//! With u = 2^−53, D = d · n, N = (p̄1 − ā) · n and S_D, S_N for the same sums of magnitudes: a difference, a product
//! and two sums err by u each, so that D and N are within 5u S_D and 5u S_N. Then t = N/D is within
//!
//! ```text
//! (N_off + |t| D_off) / (|D| − D_off) + u |t|
//! ```
//!
//! and x_i = a_i + t d_i within |d_i| t_off + 2u (|a_i| + |t d_i|). The constants below are larger than these, by what the
//! bounds are rounded themselves.

use std::cmp::Ordering;
use std::ops::RangeInclusive;

use math::{Around, Ray3, Real, Span, Vector};

use super::Polygon;
use super::crossing::{Relation, Way};

/// 8u instead of 5u, for D and N.
const SUM_OFF: f64 = 4.0 * f64::EPSILON;
/// 6u instead of 2u, for x; a bound of it is x less what it may be off, and rounded once more.
const POINT_OFF: f64 = 3.0 * f64::EPSILON;
/// 8u instead of 4u, for the area beside a side: two differences, a product and a subtraction.
const AREA_OFF: f64 = 4.0 * f64::EPSILON;
/// Between these no product of S overflows or vanishes so far that it matters. Of what is not finite, and of no
/// direction, S is not between them.
const SAFE: RangeInclusive<f64> = 1e-130..=1e130;
/// What a product may have lost below the smallest number, and much more.
const VANISHED: f64 = 1e-290;
/// So much larger is t than the end of a span that it is larger in either precision, however it is rounded.
const CLEARLY_LESS: f64 = 1.0 - 1.0 / (1 << 20) as f64;
/// An end of a span below this may have few digits.
const SMALLEST_END: f64 = 1e-30;

/// The point of the line of a ray in the plane of a polygon, on the axes of its outline.
#[derive(Clone, Copy, Debug)]
pub(super) struct AtOnce {
    /// N/D
    t: f64,
    /// How far N/D is off at most.
    t_off: f64,
    /// x_u and x_v
    x: [f64; 2],
    /// How far they are off at most.
    off: [f64; 2],
    /// x less what it may be off, and more.
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl AtOnce {
    /// The point; `None` where D or the size of a number leaves it open, and for a ray that is none.
    #[inline(always)]
    pub(super) fn of<R: Real>(polygon: &Polygon<R>, ray: &Ray3<R>) -> Option<AtOnce> {
        let (a, d): ([f64; 3], [f64; 3]) = (ray.origin.in_f64(), ray.direction.in_f64());
        let (p_1, n): ([f64; 3], [f64; 3]) = (polygon.plane.point.in_f64(), polygon.plane.normal.in_f64());
        let way: [f64; 3] = std::array::from_fn(|axis| (p_1[axis] - a[axis]) * n[axis]);
        let rise: [f64; 3] = std::array::from_fn(|axis| d[axis] * n[axis]);
        let size = |[x, y, z]: [f64; 3]| x.abs() + y.abs() + z.abs();
        let (way_size, rise_size) = (size(way), size(rise));
        let [way, rise] = [way, rise].map(|[x, y, z]| x + y + z);
        let (way_off, rise_off) = (SUM_OFF * way_size, SUM_OFF * rise_size);
        let is_sure = SAFE.contains(&way_size) && SAFE.contains(&rise_size) && rise.abs() > 2.0 * rise_off;
        if !is_sure {
            return None;
        }
        let t = way / rise;
        let t_off = (way_off + t.abs() * rise_off) / (rise.abs() - rise_off) + f64::EPSILON * t.abs();
        let of = |axis: usize| {
            let (a, step) = (a[polygon.axes[axis]], t * d[polygon.axes[axis]]);
            let off = t_off * d[polygon.axes[axis]].abs() + POINT_OFF * (a.abs() + step.abs()) + VANISHED;
            (a + step, off)
        };
        let [(x_u, off_u), (x_v, off_v)] = [of(0), of(1)];
        let (x, off) = ([x_u, x_v], [off_u, off_v]);
        let [low, high] = [-1.0, 1.0].map(|way| [x_u + way * off_u, x_v + way * off_v]);
        // infinite numbers tell nothing
        let is_finite = (low[0] + low[1] + high[0] + high[1]).is_finite();
        is_finite.then_some(AtOnce { t, t_off, x, off, low, high })
    }

    /// Whether the point is certainly beyond the rectangle from `low` to `high`.
    #[inline(always)]
    pub(super) fn is_outside(&self, [low, high]: [[f64; 2]; 2]) -> bool {
        (0..2).any(|axis| self.high[axis] < low[axis] || self.low[axis] > high[axis])
    }

    /// t, and how far it may be off.
    #[inline(always)]
    pub(super) fn around(&self) -> Around {
        Around { t: self.t, off: self.t_off }
    }

    /// Whether t is certainly below zero.
    #[inline(always)]
    pub(super) fn is_behind(&self) -> bool {
        self.t + self.t_off < 0.0
    }

    /// Whether t is certainly not in a span: behind the origin, or beyond its end.
    #[inline(always)]
    pub(super) fn is_before_or_after<R: Real>(&self, span: Span<R>) -> bool {
        let (min, max): (f64, f64) = (span.min.into(), span.max.into());
        self.is_behind() && min >= 0.0 || (self.t - self.t_off) * CLEARLY_LESS > max && max > SMALLEST_END
    }

    /// Where the point is with respect to a side, as [`relation`](super::crossing::relation) says it; `None` in doubt.
    #[inline(always)]
    pub(super) fn relation(&self, p: [f64; 2], q: [f64; 2]) -> Option<Relation> {
        let ([low_u, low_v], [high_u, high_v]) = (self.low, self.high);
        let (p_above, q_above) = (p[1] > high_v, q[1] > high_v);
        let (p_below, q_below) = (p[1] < low_v, q[1] < low_v);
        if p_above && q_above || p_below && q_below {
            return Some(Relation::Apart);
        }
        let way = match () {
            _ if p_below && q_above => Way::Up,
            _ if p_above && q_below => Way::Down,
            _ => return None,
        };
        if low_u > p[0].max(q[0]) {
            return Some(Relation::Apart);
        }
        if high_u < p[0].min(q[0]) {
            return Some(Relation::Crosses(way));
        }
        Some(match (self.turn(p, q)?, way) {
            (Ordering::Greater, Way::Up) | (Ordering::Less, Way::Down) => Relation::Crosses(way),
            _ => Relation::Apart,
        })
    }

    /// The sign of (q̄ − p̄) × (x̄ − p̄), never zero.
    #[inline(always)]
    fn turn(&self, p: [f64; 2], q: [f64; 2]) -> Option<Ordering> {
        let (side_u, side_v) = (q[0] - p[0], q[1] - p[1]);
        let (left, right) = (side_u * (self.x[1] - p[1]), side_v * (self.x[0] - p[0]));
        let by_point = side_u.abs() * self.off[1] + side_v.abs() * self.off[0];
        // by a few roundings more than it may be off
        let off = by_point * (1.0 + AREA_OFF) + AREA_OFF * (left.abs() + right.abs()) + VANISHED;
        let area = left - right;
        match () {
            _ if area > off => Some(Ordering::Greater),
            _ if area < -off => Some(Ordering::Less),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In the plane z = 0; n = (0, 0, 8).
    const SQUARE: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
    /// In the plane x + z = 0; n = (1, 0, 1).
    const SLOPED: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, -1.0], [0.0, 1.0, 0.0]];

    fn of(corners: &[[f64; 3]], origin: [f64; 3], direction: [f64; 3]) -> Option<AtOnce> {
        let polygon = Polygon::new(corners.iter().map(|&corner| corner.into()).collect()).unwrap();
        AtOnce::of(&polygon, &Ray3::<f64>::new(origin.into(), direction.into()))
    }

    fn units(of: f64) -> f64 {
        of / (1u64 << 50) as f64
    }

    /// By hand, with d = (1 + x, 0, −1 + z): D = x + z of S_D = 2 + x − z, so that D is off by 2^−49 where x = z, and
    /// twice that is too much.
    #[test]
    fn a_ray_along_the_plane_is_left_open() {
        let at = |x: f64, z: f64| of(&SLOPED, [0.0, 0.0, 1.0], [1.0 + units(x), 0.0, units(z) - 1.0]);
        assert!(at(2.0, 2.0).is_none(), "D = 2^−48 is not more than 2 · 2^−49");
        assert!(at(4.0, 2.0).is_some(), "D = 3 · 2^−49 is more than 2 (2^−49 + 2^−99)");
    }

    /// By hand: N = 5, off by 5 · 2^−50, and D = 5 · 2^−49, off by 2^−49. t = 2^49 is off by (5 · 2^−50 + 1) / (4 ·
    /// 2^−49) = 2^47 + 5/8, and by 2^−52 of itself, which is 1/8.
    #[test]
    fn how_far_t_may_be_off() {
        let point = of(&SLOPED, [-5.0, 0.0, 0.0], [1.0 + units(5.0), 0.0, units(5.0) - 1.0]).unwrap();
        let (t, off) = (2.0_f64.powi(49), 2.0_f64.powi(47) + 0.75);
        assert_eq!(point.around(), Around { t, off });
    }

    /// By hand: t = 2^200 / 2^−400. The point is found where it is a number, however large; two that are as far in
    /// opposite directions have a sum of 0.
    #[test]
    fn a_point_far_away_is_found() {
        let along = |d_u: f64, d_v: f64| {
            let origin = [0.0, 0.0, -2.0_f64.powi(200)];
            of(&SQUARE, origin, [d_u, d_v, 2.0_f64.powi(-400)]).map(|point| point.x)
        };
        let far = 2.0_f64.powi(600);
        assert_eq!(along(1.0, 1.0), Some([far; 2]));
        assert_eq!(along(1.0, -1.0), Some([far, -far]));
        let (step, farthest) = (1.5 * 2.0_f64.powi(423), 1.5 * 2.0_f64.powi(1023));
        assert_eq!(along(step, -step), Some([farthest, -farthest]));
        for (d_u, d_v) in [(far, 0.0), (0.0, far), (-far, far)] {
            assert_eq!(along(d_u, d_v), None, "2^1200 is none");
        }
    }

    /// At t, and off by so much.
    fn at(t: f64, t_off: f64) -> AtOnce {
        AtOnce { t, t_off, x: [0.0; 2], off: [0.0; 2], low: [0.0; 2], high: [0.0; 2] }
    }

    /// By hand: off by less than it is behind, by as much, and by more; and ahead.
    #[test]
    fn behind_is_behind_by_more_than_it_is_off() {
        let behind =
            [(-1.0, 0.5), (-1.0, 1.0), (-1.0, 2.0), (1.0, 0.5)].map(|(t, off)| at(t, off).is_behind());
        assert_eq!(behind, [true, false, false, false]);
    }

    /// By hand: 2^20 (1 − 2^−20) is 2^20 − 1.
    #[test]
    fn a_span_ends_before_what_is_clearly_more() {
        let is_out =
            |t: f64, off: f64, min: f64, max: f64| at(t, off).is_before_or_after(Span::<f64>::new(min, max));
        assert!(is_out(-1.0, 0.5, 0.0, 9.0), "behind the origin");
        assert!(!is_out(-1.0, 0.5, -2.0, 9.0), "behind the origin, and so is the span");
        assert!(!is_out(-1.0, 1.0, 0.0, 9.0), "at the origin, perhaps");
        assert!(is_out(4.0, 0.5, 0.0, 3.0), "3.5 is more than 3");
        assert!(!is_out(4.0, 0.5, 0.0, 3.75), "3.5 is not");
        let million = (1 << 20) as f64;
        assert!(!is_out(million, 0.0, 0.0, million - 1.0), "clearly more is more than 2^20 − 1");
        assert!(is_out(million.next_up(), 0.0, 0.0, million - 1.0));
        assert!(!is_out(1.0, 0.0, 0.0, SMALLEST_END), "so small an end has few digits");
        assert!(is_out(1.0, 0.0, 0.0, SMALLEST_END.next_up()));
    }

    /// The point (x, y), off by so much along u, and not along v.
    fn point(x: f64, y: f64, off: f64) -> AtOnce {
        let (low, high) = ([x - off, y], [x + off, y]);
        AtOnce { t: 1.0, t_off: 0.0, x: [x, y], off: [off, 0.0], low, high }
    }

    /// By hand: beside the side from (0, 0) to (0, 4), x may be as far off as the side is away.
    #[test]
    fn what_may_be_on_a_side_is_in_doubt() {
        for (x, off, relation) in [
            (0.5, 0.25, Some(Relation::Apart)),
            (0.5, 0.5, None),
            (-0.5, 0.5, None),
            (-0.5, 0.25, Some(Relation::Crosses(Way::Up))),
        ] {
            assert_eq!(point(x, 2.0, off).relation([0.0, 0.0], [0.0, 4.0]), relation, "{x} {off}");
        }
    }

    /// By hand, of a side from (0, 0) to (0, ±1) and x off by 1: the area is ∓x, and off by 1 + 2^−50 for the point
    /// and by 2^−50 x for the products, which for x = 1 + 2^−49 is x again, to the last digit.
    #[test]
    fn a_side_turns_by_more_than_the_area_may_be_off() {
        let turns = |x: f64| [1.0, -1.0].map(|end| point(x, 0.5, 1.0).turn([0.0, 0.0], [0.0, end]));
        let least = 1.0 + units(2.0);
        assert_eq!(turns(least), [None; 2]);
        assert_eq!(turns(least.next_up()), [Some(Ordering::Less), Some(Ordering::Greater)]);
    }

    /// By hand: 2^−600 · 2^−500 is below the smallest number, and the area is 0, though x is on the right of the
    /// side.
    #[test]
    fn products_that_vanish_are_in_doubt() {
        let (short, near) = (2.0_f64.powi(-600), 2.0_f64.powi(-500));
        assert_eq!(point(near, 0.0, 0.0).turn([0.0, 0.0], [0.0, short]), None);
    }
}

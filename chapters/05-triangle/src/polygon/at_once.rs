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

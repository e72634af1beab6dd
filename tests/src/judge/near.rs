//! How near an exact root is.

use lab::oracle::{Dyadic, ExactRoot};
use stage::Precision;

/// Whether the root lies within so many numbers of the precision from `t`, or `t` is infinite and the root
/// beyond the largest number.
pub fn is_within(ulps: u64, root: &ExactRoot, t: f64, precision: Precision) -> bool {
    if t.is_nan() {
        return false;
    }
    let moved = |step: fn(f64, Precision) -> f64| (0..ulps).fold(t, |t, _| step(t, precision));
    let below = moved(|t, precision| match precision {
        Precision::F32 => (t as f32).next_down().into(),
        Precision::F64 => t.next_down(),
    });
    let above = moved(|t, precision| match precision {
        Precision::F32 => (t as f32).next_up().into(),
        Precision::F64 => t.next_up(),
    });
    let is_below = below == f64::NEG_INFINITY || root.compared_with(&Dyadic::of(below)).is_ge();
    let is_above = above == f64::INFINITY || root.compared_with(&Dyadic::of(above)).is_le();
    is_below && is_above
}

//! What the oracle's tests share: drawn cases, and roots held between numbers beside them.

use std::cmp::Ordering;

use math::{TwoPart, Wide};
use stage::Precision;

use super::Dyadic;
use crate::{Draw, Root, Truth};

/// t, and t_out where there is one; empty for a miss.
pub(super) fn floats(truth: &Truth) -> Vec<f64> {
    match truth {
        Truth::Invalid(reason) => panic!("invalid: {reason}"),
        Truth::Miss(_) => vec![],
        Truth::Hit { t, out } => [Some(*t), *out].iter().flatten().map(|root| root.nearest).collect(),
    }
}

/// Calls with cases of every kind at both precisions, in f64.
pub(super) fn for_drawn<const N: usize>(name: &str, mut call: impl FnMut([f64; N], Precision)) {
    for precision in Precision::ALL {
        let mut draw = Draw::new(1, name, precision);
        for round in 0..10_000 {
            let case = std::array::from_fn(|_| number(&mut draw, round % 5));
            call(case.map(|x| draw.rounded(x)), precision);
        }
    }
}

/// A finite number: of ordinary size, whole, of any bits, of any size, with digits far apart.
fn number(draw: &mut Draw, kind: u64) -> f64 {
    let whole = draw.below(9) as f64 - 4.0;
    match kind {
        0 => draw.uniform(-10.0, 10.0),
        1 => whole,
        2 => Some(draw.any_number()).filter(|x| x.is_finite()).unwrap_or(whole),
        3 => draw.sign() * draw.log_uniform(1e-30, 1e30),
        // Sums and differences of these are ties.
        _ => whole / [1.0, 16_777_216.0, 9_007_199_254_740_992.0][draw.below(3) as usize],
    }
}

/// Fails unless the root is rounded correctly, by the places of numbers beside it: `place` says how a number
/// compares with the exact root.
pub(super) fn assert_rounded(root: &Root, precision: Precision, place: impl Fn(&Dyadic) -> Ordering) {
    let nearest = root.nearest;
    assert!(nearest > 0.0 || nearest.to_bits() == 0, "{nearest} is no t");
    let (below, above, even) = match precision {
        Precision::F32 => {
            let nearest = nearest as f32;
            (nearest.next_down().into(), nearest.next_up().into(), nearest.to_bits().is_multiple_of(2))
        }
        Precision::F64 => (nearest.next_down(), nearest.next_up(), nearest.to_bits().is_multiple_of(2)),
    };
    // Rounding takes infinity for the next power of two, and nothing is beyond.
    let value = |x: f64| match precision {
        _ if x.is_finite() => Dyadic::of(x),
        Precision::F32 => Dyadic::scaled(1, 128),
        Precision::F64 => Dyadic::scaled(1, 1024),
    };
    let midpoint = |x: f64| &(&value(x) + &value(nearest)) * &Dyadic::scaled(1, -1);
    let low = place(&midpoint(below));
    assert!(low.is_lt() || even && low.is_eq(), "{nearest:e} is too large");
    if nearest.is_finite() {
        let high = place(&midpoint(above));
        assert!(high.is_gt() || even && high.is_eq(), "{nearest:e} is too small");
    }
    // 2^−106 of it on either side
    let fine = exactly(root.fine);
    let slack = &fine * &Dyadic::scaled(1, -106);
    assert!(place(&(&fine - &slack)).is_le() && place(&(&fine + &slack)).is_ge(), "{:?}", root.fine);
}

/// Both parts of a wide number above zero, whatever its exponent.
pub(super) fn exactly(wide: Wide) -> Dyadic {
    for power in (-6000..=6000).step_by(600) {
        let scaled = wide * Wide::new(TwoPart::from(1.0), -power);
        let hi = scaled.to_f64();
        if (1e-100..1e100).contains(&hi) {
            let lo = (scaled - Wide::from(hi)).to_f64();
            return &(&Dyadic::of(hi) + &Dyadic::of(lo)) * &Dyadic::scaled(1, power);
        }
    }
    assert!(wide.is_zero(), "{wide:?} is no t");
    Dyadic::of(0.0)
}

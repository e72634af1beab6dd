//! For the chapters' own tests: what a method promises, held against the oracle in every regime.

use math::Real;
use stage::Precision;

use crate::{Answer, Judgment, Regime, Subject, Truth, judge};

/// Judges `count` cases of every regime in both precisions, and says which of a method's answers is wrong, or
/// off by more ulps than `allowed`: the first one. `None` where it keeps to that.
///
/// `method` is its place among the methods of the stage.
pub fn first_beyond<const N: usize>(
    subject: &impl Subject<N>,
    method: usize,
    count: usize,
    allowed: impl Fn(&Regime<N>, Precision) -> u64,
) -> Option<String> {
    let of = |regime: &Regime<N>| {
        first::<f32, N>(subject, method, regime, Precision::F32, count, allowed(regime, Precision::F32))
            .or_else(|| {
                let allowed = allowed(regime, Precision::F64);
                first::<f64, N>(subject, method, regime, Precision::F64, count, allowed)
            })
    };
    subject.regimes().iter().find_map(of)
}

fn first<R: Real, const N: usize>(
    subject: &impl Subject<N>,
    method: usize,
    regime: &Regime<N>,
    precision: Precision,
    count: usize,
    allowed: u64,
) -> Option<String> {
    const SEED: u64 = 3;
    regime.cases(SEED, precision).take(count).find_map(|case| {
        let answer = subject.answer(method, case.map(R::round_from));
        let truth = subject.truth(case, precision);
        let says = || said(regime.name, precision, &case, &answer, &truth);
        (!is_within(&answer, &truth, precision, allowed)).then(says)
    })
}

fn is_within(answer: &Answer, truth: &Truth, precision: Precision, allowed: u64) -> bool {
    match judge(answer, truth, precision) {
        Judgment::Right => true,
        Judgment::Off { ulps, .. } => ulps <= allowed,
        Judgment::Wrong => false,
    }
}

fn said(regime: &str, precision: Precision, case: &[f64], answer: &Answer, truth: &Truth) -> String {
    format!("{regime}, {}: {answer:?}, not {truth:?}, of {case:?}", precision.name())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Root;
    use math::Wide;

    /// By hand: the float above 1 is one ulp away from it, and the next two.
    #[test]
    fn as_many_ulps_are_allowed_as_are_said() {
        let nearest = 1.0_f64;
        let truth = Truth::Hit { t: Root { nearest, fine: Wide::from(nearest) }, out: None };
        let next = nearest.next_up();
        for (t, allowed, is_good) in
            [(nearest, 0, true), (next, 0, false), (next, 1, true), (next.next_up(), 1, false)]
        {
            assert_eq!(is_within(&Answer::Hit(t), &truth, Precision::F64, allowed), is_good, "{t} {allowed}");
        }
        assert!(!is_within(&Answer::Miss, &truth, Precision::F64, u64::MAX), "a wrong verdict never is");
        assert!(is_within(&Answer::Miss, &Truth::Miss(""), Precision::F64, 0));
    }
}

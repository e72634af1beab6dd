//! For the chapters' own tests: which of its ways a method takes, and how good what it answers is, counted.
//!
//! A method that has a fast way and a slow one is right whichever it takes. A bound that is too wide makes it slow, and a
//! correction that is lost makes it less good, and no answer is wrong. These counts see both.

use std::collections::BTreeMap;

use math::{Glance, Real};
use stage::Precision;

use crate::{Accuracy, Regime, Subject, Truth};

/// `count` cases of every regime at both precisions, a line each: how many were answered in which way, how many of the hits
/// have the nearest number as t or one that is 1, 2 or more ulps from it, and, of the worst, the residual of the point and the
/// angle of the normal. Verdicts that are wrong are told where there are any.
///
/// `method` is its place among the methods of the stage. The last argument names the way that a case takes, as numbers of
/// `f32` and of `f64`. The same text on every machine, for a snapshot.
pub fn tally<const N: usize>(
    subject: &impl Subject<N>,
    method: usize,
    count: usize,
    [narrow, wide]: [fn([f64; N]) -> String; 2],
) -> String {
    let of = |regime: &Regime<N>| {
        let f32 = line::<f32, N>(subject, method, regime, count, Precision::F32, narrow);
        f32 + &line::<f64, N>(subject, method, regime, count, Precision::F64, wide)
    };
    subject.regimes().iter().map(of).collect()
}

fn line<R: Real, const N: usize>(
    subject: &impl Subject<N>,
    method: usize,
    regime: &Regime<N>,
    count: usize,
    precision: Precision,
    way: fn([f64; N]) -> String,
) -> String {
    const SEED: u64 = 11;
    let mut accuracy = Accuracy::default();
    let mut ways: BTreeMap<String, usize> = BTreeMap::new();
    for case in regime.cases(SEED, precision).take(count) {
        *ways.entry(way(case)).or_default() += 1;
        let rounded = case.map(R::round_from);
        let truth = subject.truth(case, precision);
        accuracy.count(&subject.answer(method, rounded), &truth, precision);
        if matches!(truth, Truth::Hit { .. }) {
            accuracy.count_quality(subject.quality(method, rounded, &truth));
        }
    }
    let ways: Vec<String> = ways.iter().map(|(way, count)| format!("{way} {count}")).collect();
    let (name, ways, worth, quality) = (regime.name, ways.join(", "), worth(&accuracy), quality(&accuracy));
    format!("{name} {}: {ways}{worth}{quality}\n", precision.name())
}

/// How far the worst point and the worst normal are off, of what [`Accuracy::count_quality`] counted.
fn quality(accuracy: &Accuracy) -> String {
    let point = if accuracy.hits > 0 { format!("; point {:.1e}", accuracy.residual) } else { String::new() };
    point + &accuracy.normal_angle.map_or(String::new(), |angle| format!("; normal {angle:.1e}"))
}

/// What a glance says of `count` cases of every regime at both precisions, a line each: how often it is sure of what, and how
/// far the λ that it tells may be off, as shares of them, in the mean. The last argument asks it of a case, as numbers of
/// `f32` and of `f64`.
pub fn glances<const N: usize>(
    subject: &impl Subject<N>,
    count: usize,
    glances: [fn([f64; N]) -> Glance; 2],
) -> String {
    const SEED: u64 = 12;
    let line = |regime: &Regime<N>, precision: Precision, glance: fn([f64; N]) -> Glance| {
        let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
        let mut shares = Vec::new();
        for case in regime.cases(SEED, precision).take(count) {
            let (kind, around) = match glance(case) {
                Glance::Misses => ("misses", vec![]),
                Glance::Once(one) => ("once", vec![one]),
                Glance::First(one) => ("first", vec![one]),
                Glance::Twice(one, other) => ("twice", vec![one, other]),
                Glance::Unsure => ("unsure", vec![]),
            };
            *kinds.entry(kind).or_default() += 1;
            shares.extend(around.iter().map(|it| it.off / it.t.abs()).filter(|share| share.is_finite()));
        }
        let kinds: Vec<String> = kinds.iter().map(|(kind, count)| format!("{kind} {count}")).collect();
        let off = match shares.len() {
            0 => String::new(),
            all => format!("; off {:.2e}", shares.iter().sum::<f64>() / all as f64),
        };
        format!("{} {}: {}{off}\n", regime.name, precision.name(), kinds.join(", "))
    };
    let [narrow, wide] = glances;
    let of = |regime: &Regime<N>| line(regime, Precision::F32, narrow) + &line(regime, Precision::F64, wide);
    subject.regimes().iter().map(of).collect()
}

/// How many verdicts are wrong, if any, and how near the t of the hits are; nothing where there is none. See [`tally()`].
pub fn worth(accuracy: &Accuracy) -> String {
    let mut text = match accuracy.wrong {
        0 => String::new(),
        wrong => format!("; WRONG {wrong}"),
    };
    if accuracy.hits > 0 {
        let [nearest, by_1, by_2, by_more] = accuracy.ulps.up_to_three();
        text += &format!("; t {nearest} {by_1} {by_2} {by_more}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Answer, Quality, Root};
    use math::Wide;

    /// By hand: the nearest number once, its neighbor twice, one that is far off, a miss that is a hit in truth.
    #[test]
    fn what_hits_are_worth() {
        let mut accuracy = Accuracy::default();
        assert_eq!(worth(&accuracy), "");
        let truth = Truth::Hit { t: Root { nearest: 1.0, fine: Wide::from(1.0) }, out: None };
        let next = 1.0_f64.next_up();
        for t in [1.0, next, next, 2.0] {
            accuracy.count(&Answer::Hit(t), &truth, Precision::F64);
        }
        assert_eq!(worth(&accuracy), "; t 1 2 0 1");
        accuracy.count(&Answer::Miss, &truth, Precision::F64);
        accuracy.count_quality(Some(Quality { residual: 2.5e-16, normal_angle: Some(0.0) }));
        assert_eq!(worth(&accuracy), "; WRONG 1; t 1 2 0 1");
        assert_eq!(quality(&accuracy), "; point 2.5e-16; normal 0.0e0");
    }
}

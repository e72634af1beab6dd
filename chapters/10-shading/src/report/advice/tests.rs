use lab::Nanoseconds;

use super::*;
use crate::Start;
use crate::measure::judged::Faults;
use crate::measure::regimes::REGIMES;

/// An entry of 1000 cases with so many faults.
fn entry(start: Start, ns: f64, acne: u64, leaks: Option<u64>) -> Entry {
    let ns = Nanoseconds { median: ns, low: ns, high: ns };
    let faults = Faults { cases: 1000, acne, leaks };
    Entry { start, precision: Precision::F64, ns, faults, on_front: false }
}

fn measured(entries: [Vec<Entry>; 2]) -> Vec<Measured> {
    let of = |(regime, entries)| Measured { regime, entries };
    REGIMES.into_iter().zip(entries).map(of).collect()
}

/// By hand: the faster one misses everything in the second regime, and the last line says so of whichever it
/// is.
#[test]
fn the_last_line_is_of_all_regimes() {
    for (good, bad) in [(Start::Bound, Start::Exclude), (Start::Fixed, Start::None)] {
        let text = sentences(&measured([
            vec![entry(good, 40.0, 0, Some(0)), entry(bad, 30.0, 0, None)],
            vec![entry(good, 40.0, 0, Some(0)), entry(bad, 30.0, 0, Some(1000))],
        ]));
        let (good, bad) = (good.name(), bad.name());
        let last = format!(
            "What to take: over all regimes {good} f64 is the only one without acne and leaks; {bad} f64, the fastest \
             of the faultless in 1 of them, has leaks in 1 of 2, most in small-at-7: every ray"
        );
        assert_eq!(text.lines().last(), Some(last.as_str()));
        assert!(text.contains(&format!("  unit-at-0   f64 ({bad}, 30.0 ns)\n")), "{text}");
        assert!(text.contains(&format!("  small-at-7  f64 {good}, 40.0 ns\n")), "{text}");
    }
}

#[test]
fn where_none_or_all_are_right_it_says_so() {
    let [none, all] = [1, 0].map(|acne| {
        let both = || vec![entry(Start::Bound, 40.0, acne, None), entry(Start::Exclude, 30.0, acne, None)];
        sentences(&measured([both(), both()]))
    });
    assert!(none.ends_with("over all regimes none of these is without acne and leaks\n"), "{none}");
    assert!(all.ends_with("over all regimes bound f64, exclude f64 are without acne and leaks\n"), "{all}");
}

#[test]
fn one_regime_is_not_all_of_them() {
    let mut one = measured([vec![entry(Start::Exclude, 30.0, 0, None)], vec![]]);
    one.truncate(1);
    assert!(!sentences(&one).contains("over all"));
    assert_eq!(sentences(&[]).lines().count(), 1);
}

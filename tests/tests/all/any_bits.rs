//! Numbers of every size through `eval`: no method prints NaN or a t behind the origin, and what
//! `robust` decides is true.
//!
//! The cases are the same on every run. `ANY_BITS_SEED=7 cargo test -p tests any_bits` draws others.

use std::collections::BTreeMap;

use lab::oracle::Verdict;
use stage::{Precision, Stage};
use tests::{Folder, Judge, case_of, with_cases};

use crate::draw::Draw;
use crate::exact::{Answer, answers, assert_none};

const ROWS: usize = 2000;
const SEED: u64 = 20260101;

/// The seed of this run.
fn seed() -> u64 {
    match std::env::var("ANY_BITS_SEED") {
        Ok(text) => text.parse().unwrap_or_else(|_| panic!("ANY_BITS_SEED is a whole number, not `{text}`")),
        Err(_) => SEED,
    }
}

/// The faults in the answers of these methods of a stage.
fn faults(
    stage: &dyn Stage,
    methods: &[&str],
    mut fault: impl FnMut(&Answer, &str, Precision) -> Option<String>,
) -> Vec<String> {
    let (seed, about, folder) = (seed(), stage.about(), Folder::new());
    let mut failures = Vec::new();
    for precision in Precision::ALL {
        let file = format!("{}_{}_seed_{seed}.csv", about.name, precision.name());
        folder.put(&file, Draw::new(seed, precision).case_file(stage, ROWS));
        let file = folder.path().join(file);
        for method in methods {
            for answer in answers(&file, about.name, method, precision) {
                let fault = fault(&answer, method, precision);
                failures.extend(fault.map(|fault| format!("seed {seed}: {fault}; {}", answer.place)));
            }
        }
    }
    failures
}

#[test]
fn every_answer_is_in_order() {
    let mut failures = Vec::new();
    for stage in with_cases() {
        let about = stage.about();
        failures.extend(faults(stage, &about.methods, |answer, method, precision| {
            let case = case_of(&answer.want, &about, precision);
            Judge::of(&about, precision, &case).disorder(method, &answer.got)
        }));
    }
    assert_none(failures);
}

#[test]
fn what_robust_decides_is_true() {
    let mut failures = Vec::new();
    for stage in with_cases().filter(|stage| stage.about().methods.contains(&"robust")) {
        let about = stage.about();
        let mut seen: BTreeMap<(&str, &str), usize> = BTreeMap::new();
        failures.extend(faults(stage, &["robust"], |answer, _, precision| {
            let case = case_of(&answer.want, &about, precision);
            let judge = Judge::of(&about, precision, &case);
            let what = match judge.verdict() {
                Verdict::Hit { .. } => "hit",
                Verdict::Miss(reason) | Verdict::Invalid(reason) => reason,
            };
            *seen.entry((precision.name(), what)).or_default() += 1;
            judge.untrue(&answer.got)
        }));
        // A sweep that does not meet every verdict proves nothing.
        let has_parallels = !["ray-sphere", "quadric"].contains(&about.name);
        let kinds = if has_parallels { &["hit", "", "parallel", "in-plane"][..] } else { &["hit", ""] };
        for precision in Precision::ALL.map(Precision::name) {
            let seldom =
                kinds.iter().find(|kind| seen.get(&(precision, **kind)).is_none_or(|rows| *rows < 5));
            assert!(seldom.is_none(), "seed {}: {} {precision}: {seen:?}", seed(), about.name);
        }
    }
    assert_none(failures);
}

//! Numbers of every size through `eval`: no method prints NaN or a t behind the origin, and what
//! `robust` decides is true.
//!
//! The cases are the same on every run. `ANY_BITS_SEED=7 cargo test -p tests any_bits` draws others.

use std::collections::BTreeMap;

use lab::oracle::{Dyadic, ExactRoot, Verdict, exact_sphere, exact_wall};
use stage::{About, Precision, Stage};
use tests::{Folder, with_cases};

use crate::bars::Bars;
use crate::draw::Draw;
use crate::exact::{Answer, answers, assert_none, case_of, number};
use crate::oracle_on_cases::exact_verdict;

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
            disorder(answer).or_else(|| match about.name {
                "pinhole" => wrong_reason(answer, method, &case, precision),
                _ => wrong_hit(answer, &about, &case),
            })
        }));
    }
    assert_none(failures);
}

/// NaN anywhere, or a parameter behind the origin.
fn disorder(answer: &Answer) -> Option<String> {
    let behind = ["t", "t_out"].into_iter().filter(|column| answer.got.text(column).starts_with('-'));
    let columns: Vec<&str> = behind.chain(answer.got.nan_columns()).collect();
    let shown = columns.first().map(|column| answer.got.text(column));
    shown.map(|text| format!("{text} in {columns:?}"))
}

/// A row with a verdict is `invalid` exactly where the case is, and has the fields of its verdict.
fn wrong_hit(answer: &Answer, about: &About, case: &[f64]) -> Option<String> {
    let (hit, reason) = (answer.got.text("hit"), answer.got.text("reason"));
    let invalid = is_invalid(about, case);
    if invalid != (hit == "invalid") {
        return Some(format!("hit = {hit}, yet the case is {}", if invalid { "invalid" } else { "valid" }));
    }
    let has = |column: &str| !answer.got.text(column).is_empty();
    let [t, reason] = [has("t"), !reason.is_empty()];
    let right = match hit {
        "1" => t && has("x") && has("y") && !reason,
        "0" => !t && !has("t_out") && !has("x"),
        "invalid" => !t && !has("t_out") && !has("x") && !has("distance") && reason,
        _ => false,
    };
    (!right).then(|| format!("hit = {hit} with fields that do not go with it"))
}

/// The contract: a number that is not finite, a zero direction or normal, r ≤ 0, front > back; a triangle without
/// area and a singular matrix, which the oracle knows.
fn is_invalid(about: &About, case: &[f64]) -> bool {
    if ["triangle", "affine"].contains(&about.name) {
        return matches!(exact_verdict(about.name, case), Verdict::Invalid(_));
    }
    let value = |name: &str| about.inputs.iter().position(|column| *column == name).map(|place| case[place]);
    let is_zero = |vector: &str| {
        let components: Vec<f64> =
            ["x", "y", "z"].iter().filter_map(|axis| value(&format!("{vector}{axis}"))).collect();
        !components.is_empty() && components.iter().all(|component| *component == 0.0)
    };
    !case.iter().all(|number| number.is_finite())
        || is_zero("d")
        || is_zero("n")
        || value("r").is_some_and(|r| r <= 0.0)
        || value("front").zip(value("back")).is_some_and(|(front, back)| front > back)
}

/// A pixel has a point or a reason, and a reason only where there can be no point.
fn wrong_reason(answer: &Answer, method: &str, case: &[f64], precision: Precision) -> Option<String> {
    let [width, height, col, row, left, right, bottom, top, distance] = case.try_into().unwrap();
    let is_count = |count: f64| count.fract() == 0.0 && (1.0..=f64::from(u32::MAX)).contains(&count);
    let is_within = |place: f64, count: f64| place.fract() == 0.0 && (0.0..count).contains(&place);
    let possible = case.iter().all(|number| number.is_finite())
        && is_count(width)
        && is_count(height)
        && is_within(col, width)
        && is_within(row, height)
        && left < right
        && bottom < top
        && distance > 0.0
        && (method != "edges" || width > 1.0 && height > 1.0);
    // Where the window's edges times the number of pixels are no number, a method may give up.
    let largest = if precision == Precision::F32 { f32::MAX.into() } else { f64::MAX };
    let extent = |low: f64, high: f64, count: f64| (low.abs() + high.abs()) * count;
    let too_large = extent(left, right, width) > largest || extent(bottom, top, height) > largest;

    let point = ["x", "y", "z"].map(|column| answer.got.text(column));
    let is_empty = point.iter().all(|text| text.is_empty());
    let is_finite = point.iter().all(|text| text.parse().is_ok_and(f64::is_finite));
    match answer.got.text("reason") {
        "" if !possible => Some("there is no such pixel, and no reason is given".to_string()),
        "" if !is_finite => Some(format!("the pixel has a point, and it is not {point:?}")),
        reason if !reason.is_empty() && possible && !too_large => {
            Some(format!("`{reason}`, yet the pixel has a point"))
        }
        reason if !reason.is_empty() && !is_empty => Some(format!("`{reason}`, and a point too: {point:?}")),
        _ => None,
    }
}

#[test]
fn what_robust_decides_is_true() {
    let mut failures = Vec::new();
    for stage in with_cases().filter(|stage| stage.about().methods.contains(&"robust")) {
        let about = stage.about();
        let bars = Bars::of(about.name);
        let mut seen: BTreeMap<(&str, &str), usize> = BTreeMap::new();
        failures.extend(faults(stage, &["robust"], |answer, _, precision| {
            let case = case_of(&answer.want, &about, precision);
            let verdict = exact_verdict(about.name, &case);
            let what = match &verdict {
                Verdict::Hit { .. } => "hit",
                Verdict::Miss(reason) | Verdict::Invalid(reason) => reason,
            };
            *seen.entry((precision.name(), what)).or_default() += 1;
            untrue(answer, &verdict, precision, bars.promised(precision))
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

/// What an answer says that is not true.
fn untrue(answer: &Answer, verdict: &Verdict, precision: Precision, bar: u64) -> Option<String> {
    let got = |column: &str| answer.got.text(column);
    match verdict {
        Verdict::Hit { t, out } => {
            if got("hit") != "1" {
                return Some(format!("hit: want 1, got {}", got("hit")));
            }
            let roots = [("t", Some(t)), ("t_out", out.as_ref())];
            roots.into_iter().filter_map(|(column, root)| Some((column, root?))).find_map(|(column, root)| {
                let text = got(column);
                let near = is_within(bar, root, number(text, precision), precision);
                (!near).then(|| format!("{column} = {text} is more than {bar} ulps off"))
            })
        }
        Verdict::Miss(reason) => differs(["0", reason], ["hit", "reason"].map(got)),
        Verdict::Invalid(reason) => differs(["invalid", reason], ["hit", "reason"].map(got)),
    }
}

/// `hit` and `reason` are not as they should be.
fn differs(want: [&str; 2], got: [&str; 2]) -> Option<String> {
    (want != got).then(|| format!("hit and reason: want {want:?}, got {got:?}"))
}

/// Whether the root lies within so many numbers of the precision from `t`, or `t` is infinite and the root
/// beyond the largest number.
fn is_within(ulps: u64, root: &ExactRoot, t: f64, precision: Precision) -> bool {
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

#[test]
fn neighbors_of_a_root_are_next_to_it() {
    // by hand: the sphere of radius 5 around (0, 0, 13), the ray 3 beside its center: t = 13 ± 4
    let sphere = exact_sphere([3., 0., 0., 0., 0., 1., 0., 0., 13., 5.]);
    let Verdict::Hit { t, out: Some(out) } = sphere else { panic!("a hit") };
    for (root, exact) in [(t, 9.0_f64), (out, 17.0)] {
        for next in [exact, exact.next_up(), exact.next_down()] {
            assert!(is_within(1, &root, next, Precision::F64));
        }
        for far in [exact.next_up().next_up(), exact.next_down().next_down(), f64::NAN, f64::INFINITY] {
            assert!(!is_within(1, &root, far, Precision::F64));
        }
    }
    // by hand: 1e10 / 5e−324 is beyond the largest number
    let Verdict::Hit { t, .. } = exact_wall([0., 0., 5e-324, 0., 1e10, 2e10]) else { panic!("a hit") };
    assert!(is_within(1, &t, f64::INFINITY, Precision::F64) && !is_within(1, &t, 1e308, Precision::F64));
}

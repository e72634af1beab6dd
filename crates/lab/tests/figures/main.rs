//! What the lab makes of answers that are known: every figure can be counted by hand.

mod something;

use std::sync::LazyLock;

use lab::{Measured, measure};
use stage::{Error, Field, Precision, Record, TradeAsk, Traded};

use something::{ALL, METHODS, OFF, RIGHT, SLOW, Something, WRONG, is_wrong};

fn ask(regimes: &[&str]) -> TradeAsk {
    let regimes = regimes.iter().map(ToString::to_string).collect();
    TradeAsk { method: None, precision: None, regimes, cases: Some(ALL), seed: 7, quick: true, scene: None }
}

fn measured(ask: &TradeAsk) -> Measured {
    measure(&Something, ask).unwrap_or_else(|error| panic!("{error}"))
}

fn traded(ask: &TradeAsk) -> Traded {
    measured(ask).traded("Something")
}

/// All of it, measured once for all the tests that look at it.
static TRADED: LazyLock<Traded> = LazyLock::new(|| traded(&ask(&[])));

/// What stands in a column of a record.
fn field<'a>(record: &'a Record, column: &str) -> &'a Field {
    let found = record.iter().find(|(name, _)| *name == column);
    &found.unwrap_or_else(|| panic!("{column} in {record:?}")).1
}

fn number(record: &Record, column: &str) -> f64 {
    let Field::Number(number) = field(record, column) else { panic!("a number in {column}: {record:?}") };
    *number
}

/// The regime, the precision and the method of a record.
fn name(record: &Record) -> String {
    let name = ["regime", "precision", "method"].map(|column| match field(record, column) {
        Field::Text(text) => text.as_str(),
        other => panic!("{other:?} is no name"),
    });
    name.join(" ")
}

fn names(traded: &Traded) -> Vec<String> {
    traded.records.iter().map(name).collect()
}

/// The record of a method at a precision in a regime.
fn record<'a>(traded: &'a Traded, regime: &str, precision: Precision, method: usize) -> &'a Record {
    let wanted = format!("{regime} {} {}", precision.name(), METHODS[method]);
    let found = traded.records.iter().find(|record| name(record) == wanted);
    found.unwrap_or_else(|| panic!("{wanted} in {:?}", names(traded)))
}

/// The line that begins so and has this in it.
fn line<'a>(text: &'a str, beginning: &str, part: &str) -> &'a str {
    let is_it = |line: &&str| line.starts_with(beginning) && line.contains(part);
    let found = text.lines().map(str::trim).find(is_it);
    found.unwrap_or_else(|| panic!("{beginning} … {part}:\n{text}"))
}

/// The method that a sentence names at its end.
fn taken<'a>(text: &'a str, beginning: &str, part: &str) -> &'a str {
    line(text, beginning, part).rsplit("  ").next().unwrap_or_default()
}

/// What to take where every verdict and t must be right, at f32 and at f64.
fn taken_as_right(text: &str) -> [&str; 2] {
    ["f32", "f64"].map(|precision| taken(text, "every verdict right, t within 8 ulps", precision))
}

#[test]
fn every_figure_is_the_one_counted_by_hand() {
    let traded = &*TRADED;
    let count = Field::Count;
    for (precision, epsilon) in [(Precision::F32, f64::from(f32::EPSILON)), (Precision::F64, f64::EPSILON)] {
        // wrong verdicts; the median, 99 % and the worst of the ulps; what is lost in all, and of how many
        let mixed = [
            (RIGHT, 0, [0, 0, 0], 0.0, 200.0),
            // 0 to 198 and 1000: the 100th is 99, the 198th is 197; their sum is 198 · 199 / 2 + 1000
            (OFF, 0, [99, 197, 1000], 20_701.0 * epsilon, 200.0),
            // 200 hits less 7, and 12 wrong verdicts
            (WRONG, 12, [0, 0, 3000], 12.0 + 3000.0 * epsilon, 205.0),
            (SLOW, 0, [0, 0, 0], 0.0, 200.0),
        ];
        for (method, wrong, [median, p99, max], lost, of) in mixed {
            let record = record(traded, "mixed", precision, method);
            // of the hits the last is the case 199
            let angle = if method == OFF { Field::Number(199.0 / 512.0) } else { Field::Nothing };
            for (column, want) in [
                ("cases", count(250)),
                ("hits", count(200)),
                ("wrong_decisions", count(wrong)),
                ("t_ulp_median", count(median)),
                ("t_ulp_p99", count(p99)),
                ("t_ulp_max", count(max)),
                ("error", Field::Number(lost / of)),
                ("residual_max", Field::Number(max as f64)),
                ("normal_angle_max", angle),
                ("seed", count(7)),
            ] {
                assert_eq!(field(record, column), &want, "{column}: {record:?}");
            }
        }
        // Without a hit there is no t, and nothing is lost.
        for method in [RIGHT, OFF, WRONG, SLOW] {
            let record = record(traded, "none", precision, method);
            for column in ["t_ulp_median", "t_ulp_p99", "t_ulp_max", "normal_angle_max"] {
                assert_eq!(field(record, column), &Field::Nothing, "{column}: {record:?}");
            }
            for (column, want) in [("cases", 250), ("hits", 0), ("wrong_decisions", 0)] {
                assert_eq!(field(record, column), &count(want), "{column}: {record:?}");
            }
            assert_eq!(
                ["error", "residual_max"].map(|column| number(record, column)),
                [0.0; 2],
                "{record:?}"
            );
        }
    }
}

/// The times are forced, so that it is known who is fast.
#[test]
fn the_front_is_that_of_time_and_error() {
    let traded = &*TRADED;
    let on_front: Vec<String> = traded
        .records
        .iter()
        .filter(|record| field(record, "pareto") == &Field::Flag(true))
        .map(name)
        .collect();
    // In MIXED slower is more and more right, but `right` is as right at f32 as at f64. Elsewhere the fastest is
    // not wrong.
    let mixed =
        ["f32 right", "f32 off", "f32 wrong", "f64 off", "f64 wrong"].map(|name| format!("mixed {name}"));
    let [near, none] = ["near", "none"].map(|regime| [format!("{regime} f32 wrong")]);
    assert_eq!(on_front, [&near[..], &mixed, &none].concat());
    let starred = traded.text.lines().filter(|line| line.starts_with("★ "));
    assert_eq!(starred.count(), 7, "{}", traded.text);
}

#[test]
fn a_ratio_is_to_the_baseline_at_the_same_precision() {
    let all = traded(&ask(&["near"]));
    for precision in Precision::ALL {
        let figures = |column: &str| {
            [RIGHT, OFF, WRONG, SLOW].map(|method| number(record(&all, "near", precision, method), column))
        };
        let [ns, ratio, alone, low, high] =
            ["ns_per_ray", "ns_ratio", "ns_latency", "ns_low", "ns_high"].map(figures);
        for method in [RIGHT, OFF, WRONG, SLOW] {
            assert_eq!(ratio[method], ns[method] / ns[OFF]);
            assert!(0.0 < low[method] && low[method] <= ns[method] && ns[method] <= high[method]);
        }
        // who is fast among many is slow alone
        assert!(ns[WRONG] < ns[OFF] && ns[OFF] < ns[RIGHT] && ns[RIGHT] < ns[SLOW], "{ns:?}");
        assert!(alone[SLOW] < alone[RIGHT] && alone[RIGHT] < alone[OFF] && alone[OFF] < alone[WRONG]);
    }
    assert!(all.text.contains("in units of off at the same precision"), "{}", all.text);
    // The baseline is timed where it is not asked for, too: `right` takes 10 000 times as long.
    let alone = traded(&TradeAsk { method: Some(RIGHT), ..ask(&["near"]) });
    for record in &alone.records {
        assert!((1e3..1e5).contains(&number(record, "ns_ratio")), "{record:?}");
    }
}

#[test]
fn the_sentences_take_the_fastest_that_will_do() {
    let all = &TRADED.text;
    assert_eq!(taken(all, "speed above all", ""), "wrong f32");
    assert_eq!(taken(all, "nothing but near", ""), "wrong f32", "it is right there");
    assert_eq!(taken(all, "every verdict right  ", ""), "off f32", "as far off as it may be");
    assert_eq!(taken_as_right(all), ["right f32", "right f64"]);

    let mixed = traded(&ask(&["mixed"])).text;
    assert_eq!(taken(&mixed, "nothing but mixed", ""), "off f32");
    // Where nobody is wrong, the fastest will do for everything.
    let near = traded(&ask(&["near"])).text;
    assert_eq!(taken_as_right(&near), ["wrong f32", "wrong f64"]);

    // 8 ulps are within 8, 9 are not, and 1000 in one regime of two are too many.
    let of = |method, regimes| traded(&TradeAsk { method: Some(method), ..ask(regimes) }).text;
    assert_eq!(taken_as_right(&of(OFF, &["near"])), ["off f32", "off f64"]);
    assert_eq!(taken_as_right(&of(SLOW, &["near"])), ["none of them"; 2]);
    assert_eq!(taken_as_right(&of(OFF, &["near", "mixed"])), ["none of them"; 2]);

    // What is measured alone needs no advice.
    let alone = TradeAsk { method: Some(OFF), precision: Some(Precision::F64), ..ask(&["near"]) };
    let alone = traded(&alone).text;
    assert!(!alone.contains("What to take"), "{alone}");
}

#[test]
fn the_sentences_say_what_each_loses() {
    let text = &TRADED.text;
    let (_, sentences) = text.split_once("What each loses").expect("the sentences");
    for precision in Precision::ALL.map(Precision::name) {
        let loss = |method| line(sentences, &format!("{} {precision} ", METHODS[method]), "");
        for (method, part) in [
            (RIGHT, "no wrong verdict in 3 regimes"),
            (OFF, "no wrong verdict in 3 regimes"),
            (OFF, "1000 ulps off, in mixed"),
            (SLOW, "9 ulps off, in near"),
            (WRONG, "wrong verdicts in 1 of 3 regimes, most in mixed"),
        ] {
            assert!(loss(method).contains(part), "{part}: {}", loss(method));
        }
    }
    let places = [WRONG, OFF, RIGHT, SLOW].map(|method| sentences.find(&format!("{} f32 ", METHODS[method])));
    assert!(places.is_sorted(), "the fastest first: {sentences}");
}

#[test]
fn the_worst_case_is_a_row_for_eval() {
    for precision in Precision::ALL {
        let alone = |method, regime: &str| {
            traded(&TradeAsk { method: Some(method), precision: Some(precision), ..ask(&[regime]) }).text
        };
        let off = alone(OFF, "mixed");
        let end = format!(" -p something -- eval --method off --precision {}\n", precision.name());
        for part in ["t 1000 ulps off", "printf '%s\\n' 'case' '2199.0' | cargo run ", &end] {
            assert!(off.contains(part), "{part}:\n{off}");
        }
        let slow = alone(SLOW, "near");
        assert!(slow.contains("t 9 ulps off") && slow.contains("'1007.0'"), "{slow}");
        // A wrong verdict is worse than any t.
        let wrong = alone(WRONG, "mixed");
        assert!(wrong.contains("the worst of them, a wrong verdict"), "{wrong}");
        // What is right to the last digit has no worst.
        let right = alone(RIGHT, "mixed");
        assert!(!right.contains("the worst of them") && !right.contains("printf"), "{right}");
    }
    // Where there are several, nobody is singled out.
    let both = traded(&TradeAsk { method: Some(OFF), ..ask(&["mixed"]) }).text;
    assert!(!both.contains("printf"), "{both}");
}

#[test]
fn a_worst_case_is_one_of_those_that_are_wrong() {
    let one = TradeAsk { method: Some(WRONG), precision: Some(Precision::F32), ..ask(&["near", "mixed"]) };
    let measured = measured(&one);
    let [near, mixed] = [0, 1].map(|regime: usize| &measured.regimes[regime].entries[0].worst);
    assert!(near.is_none());
    let worst = mixed.as_ref().expect("a wrong verdict");
    assert!(is_wrong(WRONG, worst.row.parse().expect("a case is one number")), "{worst:?}");
}

#[test]
fn what_is_asked_for_is_what_is_measured() {
    let at = |regime: &str, precision: &str| METHODS.map(|method| format!("{regime} {precision} {method}"));
    let every = |regimes: &[&str]| -> Vec<String> {
        regimes.iter().flat_map(|regime| [at(regime, "f32"), at(regime, "f64")].concat()).collect()
    };
    assert_eq!(names(&TRADED), every(&["near", "mixed", "none"]));
    // in the subject's order, not in that of the request
    assert_eq!(names(&traded(&ask(&["none", "near"]))), every(&["near", "none"]));
    let double = TradeAsk { precision: Some(Precision::F64), ..ask(&["mixed"]) };
    assert_eq!(names(&traded(&double)), at("mixed", "f64"));
    let wrong = TradeAsk { method: Some(WRONG), ..ask(&["mixed"]) };
    assert_eq!(names(&traded(&wrong)), ["mixed f32 wrong", "mixed f64 wrong"]);
    let alone = TradeAsk { precision: Some(Precision::F32), ..wrong };
    assert_eq!(names(&traded(&alone)), ["mixed f32 wrong"]);
}

#[test]
fn a_regime_that_there_is_not_is_refused() {
    let refused = measure(&Something, &ask(&["near", "nowhere"]));
    let Err(Error::Request(text)) = refused else { panic!("{refused:?}") };
    assert!(text.contains("`nowhere`") && text.contains("near, mixed, none"), "{text}");
}

#[test]
fn a_single_case_is_judged_as_well() {
    let traded = traded(&TradeAsk { cases: Some(1), ..ask(&[]) });
    assert_eq!(traded.records.len(), 3 * 2 * 4);
    for record in &traded.records {
        assert_eq!(field(record, "cases"), &Field::Count(1), "{record:?}");
        for column in ["hits", "wrong_decisions"] {
            assert!(matches!(field(record, column), Field::Count(0 | 1)), "{column}: {record:?}");
        }
    }
}

/// 40 000 are more than are drawn at a time, and more than a thread takes: 160 times all of them.
#[test]
fn many_cases_are_counted_as_few_are() {
    let many = TradeAsk { cases: Some(160 * ALL), precision: Some(Precision::F64), ..ask(&["mixed"]) };
    let traded = traded(&many);
    let of = |method| record(&traded, "mixed", Precision::F64, method);
    assert_eq!(field(of(WRONG), "wrong_decisions"), &Field::Count(160 * 12));
    for (column, count) in
        [("hits", 160 * 200), ("t_ulp_median", 99), ("t_ulp_p99", 197), ("t_ulp_max", 1000)]
    {
        assert_eq!(field(of(OFF), column), &Field::Count(count), "{column}");
    }
    assert_eq!(number(of(OFF), "error"), 20_701.0 * f64::EPSILON / 200.0);
}

//! The case files of exact answers, and how far an answer is from one.
//!
//! `cases/STAGE.csv` is answered in f64, `cases/STAGE_f32.csv` in f32. Beside the columns of the stage
//! they hold `regime,hit,t,t_out,reason`: the verdict is exact, t is the exact smallest root ≥ 0,
//! rounded once. They were made with integer arithmetic by a program that shares nothing with this one.

use std::fs;
use std::path::{Path, PathBuf};

use stage::Precision;
use tests::{Record, records};

use crate::process::run;

/// A case, its exact answer, and what a method answered.
pub(crate) struct Answer {
    /// The case and its exact answer.
    pub(crate) want: Record,
    /// What the method answered.
    pub(crate) got: Record,
    /// Where it stands, and how to see it again.
    pub(crate) place: String,
}

impl Answer {
    /// The kind of case it is.
    pub(crate) fn regime(&self) -> &str {
        self.want.text("regime")
    }

    /// The method said `hit` = 1.
    pub(crate) fn is_hit(&self) -> bool {
        self.got.text("hit") == "1"
    }

    /// Hit, miss or invalid, and rightly so.
    pub(crate) fn has_right_verdict(&self) -> bool {
        self.got.text("hit") == self.want.text("hit")
    }

    /// How many values of the precision lie between the answer and the exact one, in the column `t`
    /// or `t_out`. An infinite number is no neighbor of a finite one.
    pub(crate) fn ulps(&self, column: &str, precision: Precision) -> u64 {
        let [want, got] = [&self.want, &self.got].map(|record| record.number(column));
        if want == got {
            return 0;
        }
        if !want.is_finite() || !got.is_finite() {
            return u64::MAX;
        }
        let place = |x: f64| match precision {
            Precision::F32 => ordered(u64::from((x as f32).to_bits()), 1 << 31),
            Precision::F64 => ordered(x.to_bits(), 1 << 63),
        };
        place(want).abs_diff(place(got))
    }
}

/// Fails with the first few of the failures.
pub(crate) fn assert_none(failures: Vec<String>) {
    let shown = &failures[..failures.len().min(5)];
    assert!(failures.is_empty(), "{} failures, of which\n{}", failures.len(), shown.join("\n"));
}

/// The place of a float in the row of all floats, from its bits: zero has the place 0.
fn ordered(bits: u64, sign: u64) -> i64 {
    let magnitude = (bits & !sign) as i64;
    if bits & sign == 0 { magnitude } else { -magnitude }
}

/// The file of a stage whose numbers are of that precision.
pub(crate) fn case_file(stage: &str, precision: Precision) -> PathBuf {
    let ending = if precision == Precision::F32 { "_f32" } else { "" };
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("cases/{stage}{ending}.csv"))
}

/// What a method answers to every case of a file, in a precision of its own.
pub(crate) fn answers(file: &Path, stage: &str, method: &str, precision: Precision) -> Vec<Answer> {
    let name = precision.name();
    let path = file.to_str().expect("a path in UTF-8");
    let args = ["eval", "--method", method, "--precision", name, "--cases", path];
    let run = run(Path::new("."), stage, &args);
    assert_eq!((run.status, run.errors.as_str()), (0, ""), "{stage} {args:?}");

    let text = fs::read_to_string(file).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let (want, got) = (records(&text), records(&run.output));
    assert_eq!(want.len(), got.len(), "one result row a case: {stage} {args:?}");
    want.into_iter()
        .zip(got)
        .enumerate()
        .map(|(i, (want, got))| {
            let place = format!(
                "regime {}, {}:{}\n  printf '%s\\n' '{}' '{}' | \
                 cargo run -q -p {stage} -- eval --method {method} --precision {name}",
                want.text("regime"),
                path,
                i + 2,
                lines[0],
                lines[i + 1]
            );
            Answer { want, got, place }
        })
        .collect()
}

#[test]
fn neighbors_are_one_apart() {
    let answer = |want: &str, got: &str| {
        let record = |t: &str| Record::with("t", t);
        Answer { want: record(want), got: record(got), place: String::new() }
    };
    for (want, got, ulps) in [
        ("1", "1.0000000000000002", 1),
        ("1", "0.9999999999999998", 2), // below 1 the neighbors stand twice as close
        ("5e-324", "-5e-324", 2),
        ("0", "-0", 0),
        ("inf", "inf", 0),
        ("1.7976931348623157e308", "inf", u64::MAX),
        ("1", "nan", u64::MAX),
    ] {
        assert_eq!(answer(want, got).ulps("t", Precision::F64), ulps, "{want} {got}");
    }
    assert_eq!(answer("1", "1.0000001").ulps("t", Precision::F32), 1);
}

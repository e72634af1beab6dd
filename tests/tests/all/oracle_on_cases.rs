//! The oracle against the case files of exact answers: to the last bit.
//!
//! The files were made by a program that shares nothing with the oracle (see `exact.rs`).

use std::fs;
use std::path::Path;

use lab::Truth;
use stage::Precision;
use tests::{Record, STAGES, case_of, exact_verdict, number, records};

use crate::exact::{assert_none, case_file};

#[test]
fn the_oracle_agrees_with_every_exact_answer_to_the_last_bit() {
    let (mut failures, mut files) = (Vec::new(), 0);
    for stage in STAGES.iter().map(|stage| stage.about()) {
        for precision in Precision::ALL {
            let file = case_file(stage.name, precision);
            let Ok(text) = fs::read_to_string(&file) else { continue };
            files += 1;
            for (i, want) in records(&text).iter().enumerate() {
                let case = case_of(want, &stage, precision);
                let got = exact_verdict(stage.name, &case).written(precision);
                let fault = fault(want, &got, precision);
                failures.extend(fault.map(|fault| format!("{fault}; {}:{}", file.display(), i + 2)));
            }
        }
    }
    assert_none(failures);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    assert_eq!(files, fs::read_dir(folder).unwrap().count(), "every case file belongs to a stage");
}

/// In what an exact answer and the oracle differ; `None` where they do not.
fn fault(want: &Record, got: &Truth, precision: Precision) -> Option<String> {
    let (hit, reason, t, out) = match got {
        Truth::Invalid(reason) => ("invalid", *reason, None, None),
        Truth::Miss(reason) => ("0", *reason, None, None),
        Truth::Hit { t, out } => ("1", "", Some(t.nearest), out.map(|out| out.nearest)),
    };
    let wanted = |column: &str| match want.text(column) {
        "" => None,
        text => Some(number(text, precision)),
    };
    let is_same = |want: Option<f64>, got: Option<f64>| want.map(f64::to_bits) == got.map(f64::to_bits);
    // An exact answer that is `invalid` may leave the reason to the program.
    let same_reason = want.text("reason") == reason || hit == "invalid" && want.text("reason").is_empty();
    let same =
        want.text("hit") == hit && same_reason && is_same(wanted("t"), t) && is_same(wanted("t_out"), out);
    let columns = ["hit", "reason", "t", "t_out"].map(|column| want.text(column));
    (!same).then(|| format!("want {columns:?}, got {got:?}"))
}

//! The oracle against the case files of exact answers: to the last bit.
//!
//! The files were made by a program that shares nothing with the oracle (see `exact.rs`).

use std::fs;
use std::path::Path;

use lab::Truth;
use lab::oracle::{self, UnitObject, Verdict};
use stage::Precision;
use tests::{STAGES, stage_named};

use crate::exact::{Record, assert_none, case_file, case_of, number, records};

/// What the oracle says of a stage's case, its numbers in the order of the columns, before it is rounded.
pub(crate) fn exact_verdict(stage: &str, case: &[f64]) -> Verdict {
    match stage {
        "ray-wall" => oracle::exact_wall(case.try_into().unwrap()),
        "ray-plane" => oracle::exact_plane(case.try_into().unwrap()),
        "ray-sphere" => oracle::exact_sphere(case.try_into().unwrap()),
        "triangle" => oracle::exact_triangle(case.try_into().unwrap()),
        "quadric" => {
            let (shape, case) = shape_apart(stage, case);
            oracle::exact_quadric(shape, case)
        }
        "affine" => {
            let (shape, case) = shape_apart(stage, case);
            oracle::exact_affine(shape, case)
        }
        _ => panic!("{stage} has exact answers: it needs an oracle here"),
    }
}

/// The shape and the other numbers of a case of `quadric` or `affine`, where it stands after the ray.
fn shape_apart<const N: usize>(stage: &str, case: &[f64]) -> (UnitObject, [f64; N]) {
    let words = stage_named(stage).unwrap().about().words[0].1;
    let word = words[case[6] as usize];
    let shape = UnitObject::ALL.into_iter().find(|shape| shape.name() == word).unwrap();
    (shape, [&case[..6], &case[7..]].concat().try_into().unwrap())
}

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

//! What `show` prints, for every stage, method and precision.

use std::path::Path;

use serde_json::Value as Json;
use stage::{Ask, Section, Transcript, Value, report};
use tests::STAGES;

use crate::assert_snapshot;
use crate::shown::{SHOWN, requests};

#[test]
fn every_method_prints_its_transcript() {
    for (stage, ask, shown) in SHOWN.iter() {
        let about = stage.about();
        let name = [about.name, about.methods[ask.method], ask.precision.name()];
        let name = if ask.size.is_some() { [&name[..], &["small"]].concat() } else { name.to_vec() };
        assert_snapshot(&name.join("."), &shown.transcript.to_string());
    }
}

#[test]
fn a_transcript_has_the_same_steps_and_tables_as_json() {
    for (_, ask, shown) in SHOWN.iter() {
        let json = report(shown, Path::new("picture.png"), true);
        let json: Json = serde_json::from_str(&json).unwrap();
        let said = json["steps"].as_array().unwrap();
        let steps: Vec<_> = shown.transcript.sections.iter().flat_map(|section| &section.steps).collect();
        assert!(!steps.is_empty(), "{ask:?}: no step at all");
        assert_eq!(said.len(), steps.len(), "{ask:?}");
        for (said, step) in said.iter().zip(steps) {
            let [symbol, formula] = ["symbol", "formula"].map(|key| said[key].as_str().unwrap());
            assert_eq!((symbol, formula), (step.symbol.as_str(), step.formula.as_str()), "{ask:?}");
            assert!(is_same(&said["value"], &step.value), "{ask:?}: {said}, {step:?}");
            assert_eq!(said["note"], step.note, "{ask:?}");
        }

        let said = json["tables"].as_array().unwrap();
        let tables: Vec<_> = shown.transcript.sections.iter().flat_map(|section| &section.table).collect();
        assert_eq!(said.len(), tables.len(), "{ask:?}");
        for (said, table) in said.iter().zip(tables) {
            let rows = Value::Array(table.rows.iter().cloned().map(Value::Array).collect());
            assert!(is_same(&said["rows"], &rows), "{ask:?}: {said}, {table:?}");
            assert_eq!(said["columns"], Json::from(table.columns.clone()), "{ask:?}");
        }
    }
}

/// Whether JSON says the very value: a number reads back to the same bits in the value's precision.
fn is_same(said: &Json, value: &Value) -> bool {
    match value {
        Value::F32(x) if x.is_finite() => {
            said.as_f64().is_some_and(|said| (said as f32).to_bits() == x.to_bits())
        }
        Value::F64(x) if x.is_finite() => said.as_f64().is_some_and(|said| said.to_bits() == x.to_bits()),
        Value::F32(x) => *said == not_finite((*x).into()),
        Value::F64(x) => *said == not_finite(*x),
        Value::Array(values) => said.as_array().is_some_and(|said| {
            said.len() == values.len() && said.iter().zip(values).all(|(said, value)| is_same(said, value))
        }),
        Value::Text(text) => said == text,
    }
}

/// What the contract writes for a number that is not finite.
fn not_finite(x: f64) -> &'static str {
    match () {
        _ if x.is_nan() => "nan",
        _ if x > 0.0 => "inf",
        _ => "-inf",
    }
}

#[test]
fn every_pixel_of_a_small_picture_is_explained() {
    let size = (3, 2);
    for stage in STAGES {
        let name = stage.about().name;
        for ask in requests(*stage) {
            for pixel in (0..size.1).flat_map(|row| (0..size.0).map(move |col| (col, row))) {
                let ask = Ask { size: Some(size), pixel: Some(pixel), ..ask.clone() };
                let mut shown = stage.show(&ask).unwrap();
                assert_eq!(shown.picture.size(), size, "{name} {ask:?}");
                assert!(
                    shown.transcript.sections.iter().take(2).any(states_a_verdict),
                    "{name} {ask:?}:\n{}",
                    shown.transcript
                );
                set_apart_what_is_nan_on_purpose(&mut shown.transcript);
                for json in [false, true] {
                    let report = report(&shown, Path::new("picture.png"), json);
                    let words = report.split(|letter: char| !letter.is_alphanumeric());
                    let nan = words.filter(|word| word.eq_ignore_ascii_case("nan")).count();
                    assert_eq!(nan, 0, "{name} {ask:?}:\n{report}");
                }
            }
        }
    }
}

/// Whether a section ends with a point, with `none` or with what a value means; a residual may follow.
fn states_a_verdict(section: &Section) -> bool {
    let (residuals, steps): (Vec<_>, Vec<_>) =
        section.steps.iter().partition(|step| step.symbol == "residual");
    let Some(last) = steps.last() else { return false };
    let verdict = match &last.value {
        Value::Array(numbers) => !numbers.is_empty() && numbers.iter().all(is_finite),
        Value::Text(text) => text == "none",
        _ => !last.note.is_empty(),
    };
    verdict && residuals.iter().all(|step| is_finite(&step.value))
}

fn is_finite(value: &Value) -> bool {
    match value {
        Value::F32(x) => x.is_finite(),
        Value::F64(x) => x.is_finite(),
        Value::Array(_) | Value::Text(_) => false,
    }
}

/// Takes out the row that shows Equation 4.2 dividing zero by zero.
fn set_apart_what_is_nan_on_purpose(transcript: &mut Transcript) {
    if transcript.stage == "ray-plane" {
        for table in transcript.sections.iter_mut().filter_map(|section| section.table.as_mut()) {
            table.rows.retain(|row| row[0] != Value::text("within the plane"));
        }
    }
}

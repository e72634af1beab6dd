//! What `show` prints, for every stage, method and precision.

use std::path::Path;

use stage::{Ask, Precision, Stage, default_ask, report};
use tests::STAGES;

use crate::assert_snapshot;

/// Every request of a stage that differs from the default one in method or precision only.
fn requests(stage: &dyn Stage) -> impl Iterator<Item = Ask> {
    let about = stage.about();
    let default = default_ask(&about);
    (0..about.methods.len())
        .flat_map(move |method| Precision::ALL.map(|precision| Ask { method, precision, ..default }))
}

#[test]
fn every_method_prints_its_transcript() {
    for stage in STAGES {
        let about = stage.about();
        for ask in requests(*stage) {
            let shown = stage.show(&ask).unwrap();
            let name = [about.name, about.methods[ask.method], ask.precision.name()].join(".");
            assert_snapshot(&name, &shown.transcript.to_string());
        }
    }
}

#[test]
fn a_transcript_has_the_same_steps_as_json() {
    for stage in STAGES {
        for ask in requests(*stage) {
            let shown = stage.show(&ask).unwrap();
            let json = report(&shown, Path::new("picture.png"), true);
            let json: serde_json::Value = serde_json::from_str(&json).unwrap();
            let said = json["steps"].as_array().unwrap().iter().map(|step| {
                let value = &step["value"];
                assert!(value.is_number() || value.is_array() || value.is_string(), "{step}");
                (step["symbol"].as_str().unwrap(), step["formula"].as_str().unwrap())
            });
            let sections = &shown.transcript.sections;
            let steps = sections.iter().flat_map(|section| &section.steps);
            let steps = steps.map(|step| (step.symbol.as_str(), step.formula.as_str()));
            assert!(said.clone().next().is_some(), "{ask:?}: no step at all");
            assert!(said.eq(steps), "{ask:?}");
        }
    }
}

#[test]
fn every_pixel_of_a_small_picture_is_explained() {
    let size = (8, 6);
    for stage in STAGES {
        let name = stage.about().name;
        for ask in requests(*stage) {
            for pixel in (0..size.1).flat_map(|row| (0..size.0).map(move |col| (col, row))) {
                let ask = Ask { size, pixel: Some(pixel), ..ask };
                let sections = stage.show(&ask).unwrap().transcript.sections;
                assert!(!sections[0].steps.is_empty(), "{name} {ask:?}");
            }
        }
    }
}

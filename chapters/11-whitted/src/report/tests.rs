use super::*;
use crate::Counts;
use crate::measure::Off;
use signature::Method;
use stage::Precision;

/// Three settings of a scene of depth 5: the safest, one that is off by a little, one that is off by much.
fn measured() -> Measured {
    let safest =
        Setting { method: Method::Robust, precision: Precision::F64, depth: 5, tolerance: None, samples: 4 };
    let entry = |setting, seconds, rmse| Entry {
        setting,
        seconds,
        counts: Counts { eye: 10, ..Counts::default() },
        off: Off { rmse, largest: 3.0 * rmse },
        alone: Off::default(),
        on_front: true,
    };
    let fast = Setting { precision: Precision::F32, samples: 2, ..safest };
    let faster = Setting { depth: 3, samples: 1, ..fast };
    Measured {
        name: "a".to_string(),
        what: "b".to_string(),
        path: Some("a.toml".to_string()),
        size: (20, 10),
        depth: 5,
        pixels: 10,
        entries: vec![entry(safest, 8.0, 0.004), entry(fast, 1.0, 0.015), entry(faster, 0.125, 0.06)],
    }
}

#[test]
fn the_answers_have_the_flags_to_type() {
    let answers = answers(&measured());
    let said: Vec<(&str, &str)> = answers.iter().filter_map(|it| it.split_once(": whitted ")).collect();
    let faster = "× faster than the safest";
    assert_eq!(
        said,
        [
            ("for error below 0.1", &*format!("--scene a.toml --precision f32 --depth 3, 64.0 {faster}")),
            ("for error below 0.02", &*format!("--scene a.toml --precision f32 --samples 2, 8.00 {faster}")),
            ("for error below 0.005", &*format!("--scene a.toml --samples 4, 1.00 {faster}")),
        ]
    );
    assert!(what_to_take(&[measured()]).contains("--precision f32 --samples 2, 8.00 ×"));
}

/// By hand: 10 rays in 10 of 200 pixels are 200 in the picture, and 8 s for them 40 ms a ray.
#[test]
fn a_record_has_the_contract_s_fields_first() {
    let measured = measured();
    let record = record(&measured, &measured.entries[0], 7);
    let names: Vec<&str> = record.iter().map(|(name, _)| *name).collect();
    let contract = [
        "method",
        "precision",
        "regime",
        "ns_per_ray",
        "cases",
        "wrong_decisions",
        "t_ulp_median",
        "t_ulp_p99",
        "t_ulp_max",
        "pareto",
    ];
    assert_eq!(names[..10], contract);
    assert_eq!(record[3].1, Field::Nothing, "whole pictures are not judged ray by ray");
    assert_eq!(record[4].1, Field::Count(10));
}

//! The judge is judged first: by answers and roots that were found by hand.

use lab::oracle::{Verdict, exact_sphere, exact_wall};
use stage::Precision;
use tests::{BARS, Judge, is_within, records, stage_named};

#[test]
fn nothing_was_seen_that_is_not_promised() {
    for bars in BARS {
        for precision in Precision::ALL {
            assert!(bars.seen(precision) <= bars.promised(precision), "{}", bars.stage);
        }
    }
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

/// What the judge says of a result row of a stage in f64.
fn said(stage: &str, case: &[f64], method: &str, row: &str) -> String {
    let about = stage_named(stage).unwrap().about();
    let text = format!("{}\n{row}", about.results.join(","));
    Judge::of(&about, Precision::F64, case).fault(method, &records(&text)[0]).unwrap_or_default()
}

#[test]
fn every_fault_of_an_answer_is_named() {
    // by hand: the sphere of before, met at (3, 0, 9), where its normal is (3, 0, −4)/5
    let case = [3., 0., 0., 0., 0., 1., 0., 0., 13., 5.];
    for (row, fault) in [
        ("1,9,17,3,0,9,0.6,0,-0.8,", ""),
        ("0,,,,,,,,,", "hit: want 1, got 0"),
        ("invalid,,,,,,,,,zero direction", "hit = invalid, yet the case is valid"),
        ("1,9,17,3,0,NaN,0.6,0,-0.8,", "NaN in [\"z\"]"),
        ("1,-9,17,3,0,9,0.6,0,-0.8,", "-9 in [\"t\"]"),
        ("1,9,17,,,,0.6,0,-0.8,", "hit = 1 with fields that do not go with it"),
        ("1,9.00000000000002,17,3,0,9,0.6,0,-0.8,", "t = 9.00000000000002 is more than 8 ulps off"),
        ("1,9,inf,3,0,9,0.6,0,-0.8,", "t_out = inf is more than 8 ulps off"),
        ("1,9,17,3,0,9,3,0,-4,", "the normal is [3.0, 0.0, -4.0]"),
    ] {
        assert_eq!(said("ray-sphere", &case, "robust", row), fault, "{row}");
    }
    // The methods of the notes may be wrong, and not out of order.
    assert_eq!(said("ray-sphere", &case, "quadratic", "0,,,,,,,,,"), "");
    assert_eq!(said("ray-sphere", &case, "quadratic", "1,nan,17,3,0,9,0.6,0,-0.8,"), "nan in [\"t\"]");
}

#[test]
fn a_point_outside_its_triangle_is_a_fault() {
    let case = [0.25, 0.5, -1., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1., 0.];
    assert_eq!(said("triangle", &case, "robust", "1,1,0.25,0.5,0.25,0.5,0,0,0,1,"), "");
    let fault = said("triangle", &case, "robust", "1,1,-0.25,0.5,0.25,0.5,0,0,0,1,");
    assert_eq!(fault, "alpha and beta are [-0.25, 0.5]");
}

//! Every regime of the chapter, against the oracle: what a glance calls certain is so.

use lab::{Truth, oracle};
use math::Span;
use math::glance::First;
use stage::Precision;

use super::*;
use crate::measure::question;
use crate::regimes::regimes;

/// Cases of a regime.
const CASES: usize = 500;

/// Whether what a glance says of a ray and a plane is true of them.
fn is_true(glance: Glance, truth: &Truth) -> bool {
    match (glance, truth) {
        (Glance::Unsure, _) => true,
        (Glance::Once(crossing), Truth::Hit { t, .. }) => t.is_within(crossing),
        // behind the origin, not parallel
        (Glance::Once(crossing), Truth::Miss("")) => crossing.t - crossing.off <= 0.0,
        _ => false,
    }
}

/// Whether the crossing ahead is where it says, as a method rounds λ.
fn first_is_true<R: Real>(glance: Glance, truth: &Truth) -> bool {
    match (glance.first_within(Span::<R>::ahead()), truth) {
        (First::Unsure, _) => true,
        (First::None, truth) => matches!(truth, Truth::Miss(_)),
        (First::Between(low, high), Truth::Hit { t, .. }) => (low..=high).contains(&t.nearest),
        (First::Between(..), _) => false,
    }
}

/// Looks at every regime, and returns how many of the ordinary rays are unsure.
fn unsure<R: Real>(precision: Precision) -> usize {
    let mut unsure = 0;
    for regime in regimes() {
        for case in regime.cases(1, precision).take(CASES) {
            let (ray, plane) = question(case.map(R::round_from));
            let (glance, truth) = (glance(&ray, &plane), oracle::plane(case, precision));
            let about = format!("{} {}: {case:?}, {glance:?}, {truth:?}", regime.name, R::NAME);
            assert!(is_true(glance, &truth), "{about}");
            assert!(first_is_true::<R>(glance, &truth), "{about}");
            unsure += usize::from(regime.name == "ordinary" && glance == Glance::Unsure);
        }
    }
    unsure
}

#[test]
fn what_is_certain_at_a_glance_is_true() {
    for unsure in [unsure::<f32>(Precision::F32), unsure::<f64>(Precision::F64)] {
        assert!(unsure < CASES / 100, "{unsure}");
    }
}

/// By hand: from a height of 3 straight down with the speed 2, and along the ground.
#[test]
fn closed_forms() {
    let ground = Plane { point: glam::DVec3::ZERO, normal: glam::DVec3::Y };
    let from_3 = |d: [f64; 3]| glance(&Ray3::<f64>::new(glam::DVec3::new(7.0, 3.0, 1.0), d.into()), &ground);
    // twice 8u (3 + 1½ · 2), over 2
    let once = Glance::Once(Around { t: 1.5, off: 48.0 * UNIT });
    assert_eq!(from_3([0.0, -2.0, 0.0]), once);
    assert_eq!(from_3([1.0, 0.0, 0.0]), Glance::Unsure);
}

/// By hand: n · d = 2^60 − 2^60 + rise, and 8u of the magnitudes is 2^−50 · 2^61 = 2^11.
#[test]
fn a_rise_that_rounding_may_have_made_is_unsure() {
    let big = 2.0_f64.powi(30);
    let along = |rise: f64| {
        let plane = Plane { point: [0.0; 3].into(), normal: [big, big, 1.0].into() };
        glance(&Ray3::<f64>::new([0.0, 0.0, 1.0].into(), [big, -big, rise].into()), &plane)
    };
    assert_eq!(along(2.0_f64.powi(9)), Glance::Unsure);
    assert!(matches!(along(2.0_f64.powi(13)), Glance::Once(_)));
}

/// How often a glance is sure in every regime, and how near: see [`lab::glances`].
#[cfg(feature = "stage")]
#[test]
fn how_sure() {
    fn at<R: math::Real>(case: [f64; 12]) -> math::Glance {
        let (ray, plane) = crate::measure::question(case.map(R::round_from));
        glance(&ray, &plane)
    }
    insta::assert_snapshot!(lab::glances(&crate::stage::RayPlane, 200, [at::<f32>, at::<f64>]));
}

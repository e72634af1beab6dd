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

/// Whether what a glance says of a ray and a sphere is true of them.
fn is_true(glance: Glance, truth: &Truth) -> bool {
    match (glance, truth) {
        (Glance::Unsure, _) => true,
        (Glance::Misses, truth) => matches!(truth, Truth::Miss(_)),
        // the line crosses it, behind the origin
        (Glance::Twice(_, far), Truth::Miss(_)) => far.t - far.off <= 0.0,
        (Glance::Twice(near, far), Truth::Hit { t, out: Some(out) }) => {
            let starts_within = t == out && near.t - near.off <= 0.0;
            out.is_within(far) && (starts_within || t.is_within(near))
        }
        _ => false,
    }
}

/// Whether the first crossing ahead is where it says, as a method rounds λ.
fn first_is_true<R: Real>(glance: Glance, truth: &Truth) -> bool {
    match (glance.first_within(Span::<R>::ahead()), truth) {
        (First::Unsure, _) => true,
        (First::None, truth) => matches!(truth, Truth::Miss(_)),
        (First::Between(low, high), Truth::Hit { t, .. }) => (low..=high).contains(&t.nearest),
        (First::Between(..), _) => false,
    }
}

/// Looks at every regime, and returns how many of the ordinary rays are called: a miss, a hit, unsure.
fn calls<R: Real>(precision: Precision) -> [usize; 3] {
    let mut ordinary = [0; 3];
    for regime in regimes() {
        for case in regime.cases(1, precision).take(CASES) {
            let (ray, sphere) = question(case.map(R::round_from));
            let glance = glance(&Line::of(&ray), &sphere);
            let truth = oracle::sphere(case, precision);
            let about = format!("{} {}: {case:?}, {glance:?}, {truth:?}", regime.name, R::NAME);
            assert!(is_true(glance, &truth), "{about}");
            assert!(first_is_true::<R>(glance, &truth), "{about}");
            if regime.name == "ordinary" {
                let called = [matches!(glance, Glance::Misses), matches!(glance, Glance::Twice(..))];
                ordinary[called.iter().position(|&it| it).unwrap_or(2)] += 1;
            }
        }
    }
    ordinary
}

/// Where a ray is aimed it misses a third of the time; and what is unsure is a miracle or a bad bound.
#[test]
fn what_is_certain_at_a_glance_is_true() {
    for [misses, hits, unsure] in [calls::<f32>(Precision::F32), calls::<f64>(Precision::F64)] {
        assert!(misses > CASES / 4 && hits > CASES / 2 && unsure < CASES / 100, "{misses} {hits} {unsure}");
    }
}

/// By hand: the unit sphere around (0, 0, 5) up the z axis, at 4 and at 6; a ray beside it, one away from it, and one that
/// touches it.
#[test]
fn closed_forms() {
    let at = |origin: [f64; 3], z: f64| {
        let ray = Ray3::<f64>::new(origin.into(), glam::DVec3::new(0.0, 0.0, z));
        glance(&Line::of(&ray), &Sphere { center: glam::DVec3::new(0.0, 0.0, 5.0), radius: 1.0 })
    };
    let Glance::Twice(near, far) = at([0.0; 3], 1.0) else { panic!("it crosses it") };
    assert_eq!((near.t, far.t), (4.0, 6.0));
    // 16u (5 + 1.5) and 2⁻²⁷
    assert!(near.off < 1e-8 && far.off == near.off, "{}", near.off);
    assert_eq!(at([2.0, 0.0, 0.0], 1.0), Glance::Misses);
    assert_eq!(at([0.0; 3], -1.0), Glance::Misses, "behind the origin, as far as a ray is concerned");
    assert_eq!(at([1.0, 0.0, 0.0], 1.0), Glance::Unsure);
}

/// By hand: with L = (1, 2⁻²⁴, 2⁻²⁴) and r² = 1 − 2⁻⁴⁷, L·L − r² is 2⁻⁴⁶, and so is the error, 2⁻⁴⁷ of L·L + r² = 2.
/// The sphere is not surely left behind, along −x, nor surely passed, at right angles to L, where P is L. With r² a
/// digit less it is.
#[test]
fn what_is_as_large_as_its_error_is_not_certain() {
    let tiny = 2.0_f64.powi(-24);
    let r_r = 1.0 - 2.0_f64.powi(-47);
    for d in [[-1.0, 0.0, 0.0], [0.0, 1.0, -1.0]] {
        let line = Line::of(&Ray3::<f64>::new(glam::DVec3::ZERO, d.into()));
        assert!(!line.past([1.0, tiny, tiny], r_r).is_missed, "{d:?}");
        assert!(line.past([1.0, tiny, tiny], r_r.next_down()).is_missed, "{d:?}");
    }
}

/// By hand: 4 away from a sphere of radius 3, S = √(16 + 9) = 5 and h = 3; 16 · 2⁻⁵³ S and 2⁻²⁷ h have few digits.
#[test]
fn how_far_off_a_glance_is() {
    let ray = Ray3::<f64>::new(glam::DVec3::ZERO, glam::DVec3::Z);
    let sphere = Sphere { center: glam::DVec3::new(0.0, 0.0, 4.0), radius: 3.0 };
    let Glance::Twice(near, far) = glance(&Line::of(&ray), &sphere) else { panic!("it crosses it") };
    let off = 80.0 * 2.0_f64.powi(-53) + 3.0 * 2.0_f64.powi(-27);
    assert_eq!([(near.t, near.off), (far.t, far.off)], [(1.0, off), (7.0, off)]);
}

/// A line grazes where a² is less than 2⁻²⁰ of L·L + r².
#[test]
fn what_grazes_is_unsure() {
    let line = Line::of(&Ray3::<f64>::new(glam::DVec3::ZERO, glam::DVec3::Z));
    let passage = |half_chord_squared: f64| Passage {
        t_close: 1000.0,
        half_chord_squared,
        scale: 2.0_f64.powi(20),
        is_missed: false,
        is_safe: true,
    };
    assert!(matches!(line.glance(&passage(1.0)), Glance::Twice(..)));
    assert_eq!(line.glance(&passage(1.0_f64.next_down())), Glance::Unsure);
}

/// How often a glance is sure in every regime, and how near: see [`lab::glances`].
#[cfg(feature = "stage")]
#[test]
fn how_sure() {
    fn at<R: math::Real>(case: [f64; 10]) -> math::Glance {
        let (ray, sphere) = crate::measure::question(case.map(R::round_from));
        glance(&Line::of(&ray), &sphere)
    }
    insta::assert_snapshot!(lab::glances(&crate::stage::RaySphere, 200, [at::<f32>, at::<f64>]));
}

//! Every regime of the chapter, against the oracle: what a glance calls certain is so.

use glam::DVec3;
use lab::{Truth, oracle};
use math::Span;
use math::glance::First;
use stage::Precision;

use super::*;
use crate::measure::question;
use crate::regimes::regimes;

/// Cases of a regime.
const CASES: usize = 500;

/// Whether what a glance says of a ray and a triangle is true of them.
fn is_true(glance: Glance, truth: &Truth) -> bool {
    match (glance, truth) {
        (Glance::Unsure, _) => true,
        (Glance::Misses, truth) => matches!(truth, Truth::Miss(_)),
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

/// Looks at every regime, and returns how many of the ordinary rays are called: a miss, a hit, unsure.
fn calls<R: Real>(precision: Precision) -> [usize; 3] {
    let mut ordinary = [0; 3];
    for regime in regimes() {
        for case in regime.cases(1, precision).take(CASES) {
            let (ray, triangle) = question(case.map(R::round_from));
            let (glance, truth) = (glance(&ray, &triangle), oracle::triangle(case, precision));
            let about = format!("{} {}: {case:?}, {glance:?}, {truth:?}", regime.name, R::NAME);
            assert!(is_true(glance, &truth), "{about}");
            assert!(first_is_true::<R>(glance, &truth), "{about}");
            if regime.name == "ordinary" {
                let called = [matches!(glance, Glance::Misses), matches!(glance, Glance::Once(_))];
                ordinary[called.iter().position(|&it| it).unwrap_or(2)] += 1;
            }
        }
    }
    ordinary
}

/// Half of the ordinary rays hit.
#[test]
fn what_is_certain_at_a_glance_is_true() {
    for [misses, hits, unsure] in [calls::<f32>(Precision::F32), calls::<f64>(Precision::F64)] {
        assert!(misses > CASES / 3 && hits > CASES / 3 && unsure < CASES / 100, "{misses} {hits} {unsure}");
    }
}

/// The corners of the triangle by hand.
fn at_height_2(origin: [f64; 3]) -> Glance {
    let corner = |x, y| DVec3::new(x, y, 2.0);
    let triangle = Triangle { p1: corner(0.0, 0.0), p2: corner(4.0, 0.0), p3: corner(0.0, 4.0) };
    glance(&Ray3::<f64>::new(origin.into(), DVec3::Z * 0.5), &triangle)
}

/// By hand: through it, beside it, and through the middle of a side.
#[test]
fn closed_forms() {
    let Glance::Once(crossing) = at_height_2([1.0, 1.0, 0.0]) else { panic!("it passes through it") };
    assert!(crossing.t == 4.0 && crossing.off < 1e-12, "{crossing:?}");
    assert_eq!(at_height_2([3.0, 3.0, 0.0]), Glance::Misses);
    assert_eq!(at_height_2([2.0, 2.0, 0.0]), Glance::Unsure);
}

/// By hand: corners at 0, 1 and 2 of a line. The volumes of a ray beside it differ in sign, as those of a miss do.
#[test]
fn a_triangle_without_area_is_not_called() {
    let triangle = Triangle { p1: DVec3::ZERO, p2: DVec3::X, p3: DVec3::X * 2.0 };
    let ray = Ray3::<f64>::new(DVec3::new(0.5, 1.0, -1.0), DVec3::Z);
    assert_eq!(glance(&ray, &triangle), Glance::Unsure);
}

/// A side so short that the volumes have few digits or none, and nor has a bound of their error.
#[test]
fn what_vanishes_is_not_called() {
    let mut draw = lab::Draw::new(1, "vanishing", Precision::F64);
    for _ in 0..5000 {
        let (short, long, speed) = (1e-230, 1e-70, draw.log_uniform(1e-26, 1e-20));
        let corners = [draw.in_cube(short), draw.in_cube(short), draw.in_cube(long)];
        let [origin, d] = [draw.in_cube(short), draw.in_cube(speed)];
        let case: Vec<f64> = [origin, d].iter().chain(&corners).flat_map(|v| v.to_array()).collect();
        let case: [f64; 15] = std::array::from_fn(|i| case[i]);
        let (ray, triangle) = question::<f64>(case);
        let (glance, truth) = (glance(&ray, &triangle), oracle::triangle(case, Precision::F64));
        assert!(is_true(glance, &truth), "{case:?}, {glance:?}, {truth:?}");
        let robust = crate::robust(&ray, &triangle).hit(Span::ahead()).unwrap();
        assert_eq!(robust.is_some(), matches!(truth, Truth::Hit { .. }), "robust: {case:?}");
    }
}

//! Every regime of the chapter, against the oracle: what a glance calls certain is so.

use glam::DVec3;
use lab::{Truth, oracle};
use math::glance::First;
use math::{Exact, Span};
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

/// By hand: corners at 0, 1 and 2 of a line. The volumes of a ray beside it differ in sign, as those of a
/// miss do.
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

/// The point where the line of the ray passes the plane, as p̄1 + α e1 + β e2: α and β over their
/// denominator, by areas, which are no volumes. With the plane's N = (p̄1 − ā) · n and D = d · n the point is
/// ā + (N/D) d; seen from p̄1, times D, it is x̄ = D (ā − p̄1) + N d, and α = (x̄ × e2) · n / D n · n.
fn exact_shares(case: [f64; 15]) -> ([Exact; 2], Exact) {
    let vector = |at: usize| -> [Exact; 3] { std::array::from_fn(|axis| Exact::new(case[at + axis])) };
    let minus = |a: &[Exact; 3], b: &[Exact; 3]| -> [Exact; 3] {
        std::array::from_fn(|axis| a[axis].clone() - b[axis].clone())
    };
    let cross = |a: &[Exact; 3], b: &[Exact; 3]| -> [Exact; 3] {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone())
    };
    let [o, d, p1, p2, p3] = [0, 3, 6, 9, 12].map(vector);
    let (e1, e2, from_p1) = (minus(&p2, &p1), minus(&p3, &p1), minus(&o, &p1));
    let n = cross(&e1, &e2);
    let (above, rise) = (-Exact::dot(&from_p1, &n), Exact::dot(&d, &n));
    let x: [Exact; 3] =
        std::array::from_fn(|axis| rise.clone() * from_p1[axis].clone() + above.clone() * d[axis].clone());
    let shares = [cross(&x, &e2), cross(&e1, &x)].map(|area| Exact::dot(&area, &n));
    (shares, rise * Exact::dot(&n, &n))
}

/// Whether a share is off the true one by no more than that: |s W − S| ≤ e |W|.
fn is_off_by_less(s: f64, share: &Exact, of: &Exact, e: f64) -> bool {
    let size = |x: Exact| if x.is_negative() { -x } else { x };
    let off = size(Exact::new(s) * of.clone() - share.clone());
    !(Exact::new(e) * size(of.clone()) - off).is_negative()
}

/// How many α and β were told for rays of a regime that hit, and of those how many are off by more than so
/// much.
fn shares_off<R: Real>(precision: Precision, name: &str, e: f64) -> [usize; 2] {
    let [mut told, mut off] = [0; 2];
    let regime = regimes().into_iter().find(|regime| regime.name == name).unwrap();
    for case in regime.cases(1, precision).take(CASES) {
        let (ray, triangle) = question::<R>(case.map(R::round_from));
        let Truth::Hit { .. } = oracle::triangle(case, precision) else { continue };
        let Some((alpha, beta)) = alpha_beta(&ray, &triangle) else { continue };
        let (shares, of) = exact_shares(case);
        let both = [alpha, beta].map(Into::<f64>::into).into_iter().zip(&shares);
        told += 1;
        off += usize::from(!both.into_iter().all(|(s, share)| is_off_by_less(s, share, &of, e)));
    }
    [told, off]
}

/// Off by the two roundings of `f64` that the bound speaks of, and by the one of R: half a unit of the last
/// digit of 1.
#[test]
fn alpha_and_beta_are_off_by_less_than_is_said() {
    const SAID: f64 = 1.0 / (1u64 << 30) as f64;
    let mut all = [0; 2];
    for regime in regimes().iter().filter(|regime| !["special", "bits"].contains(&regime.name)) {
        let narrow = shares_off::<f32>(Precision::F32, regime.name, SAID + f64::from(f32::EPSILON) / 2.0);
        let wide = shares_off::<f64>(Precision::F64, regime.name, SAID);
        assert_eq!((narrow[1], wide[1]), (0, 0), "{}", regime.name);
        all = [all[0] + narrow[0], all[1] + wide[0]];
    }
    assert!(all.iter().all(|&told| told > 2 * CASES), "{all:?}");
    // the bound is not idle: to the last digits they are off
    let [told, off] = shares_off::<f64>(Precision::F64, "ordinary", f64::EPSILON / 64.0);
    assert!(told > CASES / 3 && off > told / 2, "{told} {off}");
}

/// By hand, of the triangle above: (1, 2) is a quarter of the way along e1 and half of that along e2.
#[test]
fn the_shares_of_a_point_by_hand() {
    let case = [1.0, 2.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 2.0, 4.0, 0.0, 2.0, 0.0, 4.0, 2.0];
    let ([alpha, beta], of) = exact_shares(case);
    assert!(is_off_by_less(0.25, &alpha, &of, 0.0) && is_off_by_less(0.5, &beta, &of, 0.0));
    let (ray, triangle) = question::<f64>(case);
    assert_eq!(alpha_beta(&ray, &triangle), Some((0.25, 0.5)));
}

/// How often a glance is sure in every regime, and how near: see [`lab::glances`].
#[cfg(feature = "stage")]
#[test]
fn how_sure() {
    fn at<R: math::Real>(case: [f64; 15]) -> math::Glance {
        let (ray, triangle) = crate::measure::question(case.map(R::round_from));
        glance(&ray, &triangle)
    }
    insta::assert_snapshot!(lab::glances(&crate::stage::RayTriangle, 200, [at::<f32>, at::<f64>]));
}

/// By hand: see `volumes.rs`. At the bound itself nothing is certain, and at twice the bound it is.
#[test]
fn what_is_at_the_bound_is_not_called() {
    use crate::volumes::tests::{BOUND, inside_by};
    let called = |e: f64| inside_by(e).map(|(ray, triangle)| glance(&ray, &triangle));
    assert_eq!([called(BOUND), called(-BOUND)], [[Glance::Unsure; 2]; 2]);
    assert_eq!(called(-2.0 * BOUND), [Glance::Misses; 2]);
    assert!(
        called(2.0 * BOUND).iter().all(|glance| matches!(glance, Glance::Once(around) if around.t == 0.25))
    );
}

/// By hand: e1 = (1, 0, 0) and e2 = (1 − 2^−49, h, 0), so that |n| = h and |e1| |e2| = 1 to the last digit. The
/// volumes of the ray, 1 beside the edge, are 1 and −1. At |n| = 2^−49 it may be a line.
#[test]
fn a_miss_is_called_where_there_is_an_area_for_certain() {
    let least = 1.0 / (1u64 << 49) as f64;
    let called = |h: f64| {
        let triangle = Triangle { p1: DVec3::ZERO, p2: DVec3::X, p3: DVec3::new(1.0 - least, h, 0.0) };
        glance(&Ray3::<f64>::new(-DVec3::Y, DVec3::Z), &triangle)
    };
    assert_eq!([called(least), called(least.next_up())], [Glance::Unsure, Glance::Misses]);
}

//! Seeded rays of every kind, against the oracle.

mod draw;
mod plain;

use std::collections::BTreeMap;

use lab::oracle::open_cone;
use lab::{Accuracy, Answer, Draw, Judgment, Truth};
use math::glance::First;
use math::{Ray3, Real, Span, Vector, Wide};
use stage::Precision;

use super::{OpenCone, glance, notes, robust};

/// A ray and a cone from the columns of the oracle.
fn question<R: Real>(case: [R; 14]) -> (Ray3<R>, OpenCone<R>) {
    let [ox, oy, oz, dx, dy, dz, bx, by, bz, rb, ax, ay, az, ra] = case;
    let ray = Ray3::new(R::vec3(ox, oy, oz), R::vec3(dx, dy, dz));
    (ray, OpenCone::new(R::vec3(bx, by, bz), rb, R::vec3(ax, ay, az), ra))
}

/// A hit is one: no number of it is NaN, t is not below zero, the normal is of length 1.
fn assert_sound<R: Real>(hit: &crate::Hit3<R>, case: [R; 14]) {
    let length: f64 = hit.normal.length().into();
    let is_number = hit.point.in_f64::<3>().iter().all(|component| !component.is_nan());
    assert!(hit.t >= R::from(0.0) && is_number && (length - 1.0).abs() < 1e-6, "{hit:?} {case:?}");
}

/// What a glance is certain of is what robust says.
fn assert_glance<R: Real>((ray, cone): (&Ray3<R>, &OpenCone<R>), span: Span<R>, case: [f64; 14]) {
    let hit = robust(ray, cone).hit(span);
    match (glance(ray, cone).first_within(span), &hit) {
        (First::Unsure, _) | (First::None, Ok(None)) => {}
        (First::Between(low, high), Ok(Some(hit))) if (low..=high).contains(&hit.t.into()) => {}
        (first, hit) => panic!("{first:?}, not {hit:?}: {case:?}"),
    }
}

/// What is counted of a regime.
#[derive(Default)]
struct Counted {
    notes: Accuracy,
    robust: Accuracy,
    /// How robust came to its verdict, and to t.
    ways: BTreeMap<String, usize>,
}

/// Judges both methods. For a hit, robust is asked again for what comes from there on and from a digit later.
fn judge_case<R: Real>(case: [f64; 14], precision: Precision, counted: &mut Counted) {
    let (ray, cone) = question(case.map(R::round_from));
    let truth = open_cone(case, 0.0, precision);
    let by_notes = notes(&ray, &cone).hit(Span::ahead());
    counted.notes.count(&Answer::of(&by_notes), &truth, precision);
    let work = robust(&ray, &cone);
    *counted.ways.entry(format!("{:?} {:?}", work.certainty, work.t_certainty)).or_default() += 1;
    let found = work.hit(Span::ahead());
    assert_glance((&ray, &cone), Span::ahead(), case);
    let judged = |answer: &Answer, truth: &Truth, counted: &mut Accuracy| match counted
        .count(answer, truth, precision)
    {
        Judgment::Off { ulps, .. } => assert!(ulps <= 1, "{ulps} {truth:?} {case:?}"),
        Judgment::Right => {}
        Judgment::Wrong => panic!("{answer:?}, not {truth:?}: {case:?}"),
    };
    judged(&Answer::of(&found), &truth, &mut counted.robust);
    for hit in [by_notes, found].into_iter().flatten().flatten() {
        assert_sound(&hit, case.map(R::round_from));
    }
    let Ok(Some(hit)) = found else { return };
    let t: f64 = hit.t.into();
    let later = match precision {
        Precision::F32 => f64::from((t as f32).next_up()),
        Precision::F64 => t.next_up(),
    };
    for from in [t, later].into_iter().filter(|from| from.is_finite()) {
        let truth = open_cone(case, from, precision);
        let span = Span::new(R::round_from(from), R::INFINITY);
        judged(&Answer::of(&work.hit(span)), &truth, &mut counted.robust);
    }
}

/// So many cases of every regime, of which robust must get all right; what is counted, by regime.
fn counted<R: Real>(seed: u64, cases: usize, precision: Precision) -> Vec<(&'static str, Counted)> {
    let counted_of = |&(name, drawn): &(&'static str, draw::Regime)| {
        let mut draw = Draw::new(seed, name, precision);
        let mut counted = Counted::default();
        for _ in 0..cases {
            let case = drawn(&mut draw).map(|x| draw.rounded(x));
            judge_case::<R>(case, precision, &mut counted);
        }
        (name, counted)
    };
    draw::REGIMES.iter().map(counted_of).collect()
}

/// The notes' method misjudges most where a ray is aimed at what decides: an edge, a tip, a straight line of the wall.
#[test]
fn robust_is_right_in_every_regime() {
    let all = [counted::<f32>(1, 150, Precision::F32), counted::<f64>(1, 150, Precision::F64)];
    let mut lines = String::new();
    for (name, counted) in all.iter().flatten() {
        let Counted { notes, robust, ways } = counted;
        assert!(robust.wrong == 0 && robust.cases >= 150, "{name}");
        lines += &format!("{name}: {ways:?}{}; notes{}\n", lab::worth(robust), lab::worth(notes));
        if ["edge-exact", "generator-exact", "tip"].contains(name) {
            assert!(notes.wrong > 0, "{name}");
        }
    }
    insta::assert_snapshot!(lines);
}

/// No bits lead to a panic, a NaN, a t below zero or, for robust, a wrong verdict.
#[test]
fn any_bits() {
    fn sweep<R: Real>(precision: Precision, cases: usize) {
        let mut draw = Draw::new(2, "any bits", precision);
        for round in 0..cases {
            let case = any(&mut draw, round);
            let (ray, cone) = question(case.map(R::round_from));
            let span = if draw.coin() {
                Span::ahead()
            } else {
                Span::new(R::round_from(draw.any_number().abs()), R::INFINITY)
            };
            if span.min >= R::from(0.0) {
                assert_glance((&ray, &cone), span, case);
            }
            for hit in
                [notes(&ray, &cone).hit(span), robust(&ray, &cone).hit(span)].into_iter().flatten().flatten()
            {
                assert_sound(&hit, case.map(R::round_from));
            }
            let (low, high) = cone.bounds();
            assert!(cone.check(&ray).is_err() || (0..3).all(|axis| low[axis] <= high[axis]), "{case:?}");
        }
    }
    sweep::<f32>(Precision::F32, 20_000);
    sweep::<f64>(Precision::F64, 5_000);
}

/// Numbers of any bits, all or some of them; special ones among ordinary ones; all of one size that any number may have.
fn any(draw: &mut Draw, round: usize) -> [f64; 14] {
    let (_, ordinary) = draw::REGIMES[round % 17];
    let mut case = ordinary(draw);
    match round % 5 {
        0 => case = draw.any_numbers(),
        1 => case = draw.with_special_numbers(case),
        2 => {
            let size = draw.any_number();
            case = case.map(|x| x * size);
        }
        3 => {
            for _ in 0..3 {
                case[draw.below(14) as usize] = draw.any_number();
            }
        }
        _ => {}
    }
    if draw.below(8) > 0 {
        (case[9], case[13]) = (case[9].abs(), case[13].abs());
    }
    case
}

/// Points of the wall, with all the digits of two parts, are in the box.
#[test]
fn the_box_holds_every_point() {
    let mut draw = Draw::new(3, "box", Precision::F64);
    for round in 0..20_000 {
        let case = any(&mut draw, round / 17 * 5 + 4);
        let (_, cone) = question(case);
        let (low, high) = cone.bounds();
        let [b, a] = [cone.base, cone.apex].map(Wide::vector::<f64, 3>);
        let v = [0, 1, 2].map(|axis| a[axis] - b[axis]);
        let vv = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        // The farthest points of an end along an axis: r √(1 − v_i² / v·v), and its own sharp bound.
        for (middle, radius) in [(b, cone.base_radius), (a, cone.apex_radius)] {
            for axis in 0..3 {
                let others = [1, 2].map(|next| v[(axis + next) % 3]);
                let share = (others[0] * others[0] + others[1] * others[1]) / vv;
                let extent = Wide::from(radius) * share.sqrt();
                let [down, up] = [middle[axis] - extent, middle[axis] + extent];
                let holds = !(down - Wide::from(low[axis])).is_negative()
                    && !(Wide::from(high[axis]) - up).is_negative();
                assert!(holds, "{axis}: {cone:?}");
            }
        }
        let size: f64 = low.into_iter().chain(high).map(f64::abs).sum();
        let middles = [cone.base, cone.apex].map(|middle| middle.to_array());
        let reach = cone.base_radius.max(cone.apex_radius);
        for axis in 0..3 {
            let [lowest, highest] = [
                middles[0][axis].min(middles[1][axis]) - reach,
                middles[0][axis].max(middles[1][axis]) + reach,
            ];
            assert!(low[axis] >= lowest - 1e-14 * size && high[axis] <= highest + 1e-14 * size, "{cone:?}");
        }
    }
}

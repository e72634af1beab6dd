//! Plain `f64` against exact numbers: what it calls certain is so, and no number is off by more than it says.

use lab::{Draw, ulps};
use math::{Bounded, Exact, Real, Vector, Wide};
use stage::Precision;

use super::super::at_once::Wall;
use super::super::line::Line;
use super::super::place::{Place, upper_half};
use super::super::plain::{plain_t, plainly};
use super::super::{OpenCone, Verdict, robust};
use super::draw::REGIMES;
use super::question;

/// How many questions there were, how many plain `f64` answered, and how many of those are hits.
#[derive(Default, Debug)]
struct Counted {
    asked: u32,
    certain: u32,
    hits: u32,
    lambdas: u32,
}

/// Whether a number is within its bound of an exact one, which is `whole` over `part`.
fn holds(bounded: Bounded<f64>, whole: &Exact, part: Wide) -> bool {
    let off = Wide::from(bounded.value) - whole.to_wide() / part;
    let off = if off.is_negative() { -off } else { off };
    // that quotient is itself rounded to some hundred digits
    let rounding = 1e-29 * bounded.value.abs();
    !(Wide::from(bounded.error + rounding) - off).is_negative()
}

/// A, B and C with the origin at λ, which the exact ones are (v·v)² times as large as.
fn assert_bounded(cone: &OpenCone<f64>, [o, d]: [[f64; 3]; 2], lambda: f64) {
    let Some(wall) = Wall::of(cone) else { return };
    let Some(place) = Place::at(lambda, &wall, cone, [o, d]) else { return };
    let exact = Line::<Exact>::new(cone, o, d).starting_at(lambda);
    let (quadratic, vv) = (exact.quadratic(), exact.vv.to_wide());
    let part = vv * vv;
    let says = format!("{cone:?} {o:?} {d:?} {lambda:e}");
    assert!(holds(place.f, &quadratic.c, part), "f {:?}: {says}", place.f);
    if let Some(numbers) = wall.numbers(place.x, place.reach, d) {
        assert!(holds(numbers.a, &quadratic.a, part), "A {:?}: {says}", numbers.a);
        assert!(holds(numbers.b, &quadratic.b, part), "B {:?}: {says}", numbers.b);
        assert!(holds(numbers.c, &quadratic.c, part), "C {:?}: {says}", numbers.c);
    }
}

/// The verdict is the exact one, and λ at most a unit of the last digit from it.
fn judge<R: Real>(case: [f64; 14], precision: Precision, counted: &mut Counted) {
    let (ray, cone) = question(case.map(R::round_from));
    if cone.check(&ray).is_err() {
        assert!(plainly(&cone.in_f64(), ray.origin.in_f64(), ray.direction.in_f64()).is_none(), "{case:?}");
        return;
    }
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let measures = cone.in_f64();
    counted.asked += 1;
    assert_bounded(&measures, [o, d], 0.0);
    let Some((wall, verdict, lambda)) = plainly(&measures, o, d) else { return };
    counted.certain += 1;
    let exact = Line::<Exact>::new(&measures, o, d);
    assert_eq!(Some(verdict), exact.verdict(), "{case:?}");
    assert_eq!(robust(&ray, &cone).verdict, verdict, "{case:?}");
    if verdict == Verdict::Misses {
        return;
    }
    counted.hits += 1;
    assert_bounded(&measures, [o, d], upper_half(lambda.value));
    let root = exact.t::<f64>(verdict).unwrap();
    // the exact root is rounded once
    let off = (lambda.value - root).abs();
    assert!(off <= lambda.error + f64::EPSILON * root, "{lambda:?}, not {root}: {case:?}");
    let Some((t, _)) = plain_t::<R>(&wall, &measures, [o, d], verdict, lambda) else { return };
    counted.lambdas += 1;
    let [t, truth] = [t, exact.t::<R>(verdict)].map(|t| t.unwrap().into());
    assert!(ulps(t, truth, precision) <= 1, "{t}, not {truth}: {case:?}");
}

/// A ray that leaves a place of the wall, beside it by so little that plain numbers do not tell on which side.
fn leaving(draw: &mut Draw) -> [f64; 14] {
    loop {
        let (_, drawn) = REGIMES[draw.below(4) as usize];
        let mut case = drawn(draw);
        let (ray, cone) = question::<f64>(case);
        let Some(hit) = robust(&ray, &cone).hit(math::Span::ahead()).ok().flatten() else { continue };
        let beside = draw.log_uniform(1e-19, 1e-9) * if draw.coin() { 1.0 } else { -1.0 };
        let way = draw.direction();
        case[..3].copy_from_slice(&(hit.point + hit.normal * beside).to_array());
        case[3..6].copy_from_slice(&[way.x, way.y, way.z]);
        return case;
    }
}

fn sweep<R: Real>(precision: Precision, cases: u32) -> String {
    let mut lines = String::new();
    let mut all = Counted::default();
    for (name, drawn) in REGIMES.into_iter().chain([("leaving", leaving as fn(&mut Draw) -> [f64; 14])]) {
        let (mut draw, mut counted) = (Draw::new(4, name, precision), Counted::default());
        for _ in 0..cases {
            let case = drawn(&mut draw).map(|x| draw.rounded(x));
            judge::<R>(case, precision, &mut counted);
        }
        lines += &format!("{name} {}: {counted:?}\n", precision.name());
        // what is ordinary is nearly always certain, and what is exactly at an edge never
        match name {
            "ordinary" | "behind" | "inside" => {
                assert!(counted.certain * 100 >= counted.asked * 95, "{name}")
            }
            "leaving" if precision == Precision::F64 => {
                assert!(counted.certain * 100 >= counted.asked * 95, "{counted:?}");
            }
            _ => {}
        }
        all.asked += counted.asked;
        all.certain += counted.certain;
        all.hits += counted.hits;
        all.lambdas += counted.lambdas;
    }
    assert!(all.certain < all.asked && all.lambdas < all.hits && all.lambdas * 2 > all.hits, "{all:?}");
    lines
}

#[test]
fn what_plain_numbers_tell_is_exact() {
    insta::assert_snapshot!(sweep::<f64>(Precision::F64, 200) + &sweep::<f32>(Precision::F32, 100));
}

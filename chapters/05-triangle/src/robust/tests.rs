//! The robust method against what is known by hand, and against what its answers leave in the equations.

use std::cmp::Ordering;

use glam::{DVec3, Vec3};
use math::{Degenerate, Exact, Ray3, Real, Span, Sure, Vector};

use super::*;
use crate::Method;

const TRIANGLE: Triangle<f64> =
    Triangle { p1: DVec3::new(1.0, 1.0, 2.0), p2: DVec3::new(5.0, 1.0, 2.0), p3: DVec3::new(1.0, 3.0, 2.0) };

/// From the world's origin toward (x, y, 2), which is a point of the triangle's plane.
fn toward(x: f64, y: f64) -> Robust<f64> {
    robust(&Ray3::new(DVec3::ZERO, DVec3::new(x / 2.0, y / 2.0, 1.0)), &TRIANGLE)
}

/// Numbers that are the same on every run.
struct Numbers(u64);

impl Numbers {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 32) << 32 | self.0.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32
    }

    /// From −1 to 1.
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit())
    }
}

/// By hand: of d · n = 8 the corners have ¾, −¼ and ½ where the ray comes through the plane, to the left of the triangle.
#[test]
fn a_ray_past_an_edge_has_its_volumes_too() {
    let miss = carefully::robust(Ray3::new(DVec3::ZERO, DVec3::new(0.0, 1.0, 1.0)), TRIANGLE);
    assert_eq!((miss.volumes, miss.d_dot_n, miss.lambda), ([6.0, -2.0, 4.0], 8.0, None));
}

#[test]
fn a_ray_through_the_inside() {
    // by hand: d · n = 8, of which the corners have ½, ¼ and ¼, and (p̄1 − ā) · n = 16
    let work = toward(2.0, 1.5);
    assert_eq!((work.volumes, work.d_dot_n, work.lambda), ([4.0, 2.0, 2.0], 8.0, Some(2.0)));
    assert_eq!((work.certainty, work.alpha_beta()), (Certainty::AtOnce, Some((0.25, 0.25))));
    let hit = work.hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point, hit.normal), (2.0, DVec3::new(2.0, 1.5, 2.0), DVec3::Z));
}

#[test]
fn edges_and_corners_belong_to_it_and_a_digit_farther_out_does_not() {
    for (x, y) in [(1.0, 1.0), (5.0, 1.0), (1.0, 3.0), (3.0, 1.0), (3.0, 2.0), (1.0, 2.0)] {
        let work = toward(x, y);
        assert_eq!(work.hit(Span::ahead()).unwrap().map(|hit| hit.t), Some(2.0), "({x}, {y})");
        assert_eq!(work.certainty, Certainty::Exact);
    }
    for (x, y) in [(3.0, 1.0_f64.next_down()), (3.0, 2.0_f64.next_up()), (1.0_f64.next_down(), 2.0)] {
        let work = toward(x, y);
        assert_eq!((work.hit(Span::ahead()), work.certainty), (Ok(None), Certainty::TwoPart), "({x}, {y})");
    }
}

#[test]
fn what_is_behind_is_no_hit_and_touching_is() {
    let behind = robust(&Ray3::<f64>::new(DVec3::ZERO, DVec3::new(-1.0, -0.75, -1.0)), &TRIANGLE);
    assert_eq!((behind.lambda, behind.hit(Span::ahead())), (Some(-2.0), Ok(None)));
    for z in [1.0, -1.0] {
        let touching = robust(&Ray3::<f64>::new(TRIANGLE.p1, DVec3::new(0.0, 0.0, z)), &TRIANGLE);
        assert_eq!(touching.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0, "minus zero is zero");
    }
}

/// A square of two triangles, tilted, and rays at its diagonal: each must meet the one or the other.
fn leaks(method: Method, rays: usize) -> usize {
    let mut numbers = Numbers(1);
    let missed = |_: &usize| {
        let [a, b, c] = std::array::from_fn(|_| numbers.vector());
        let halves = [Triangle::<f64> { p1: a, p2: b, p3: c }, Triangle { p1: b, p2: b + c - a, p3: c }];
        let target = b + (c - b) * numbers.unit().abs();
        let origin = numbers.vector() * 5.0;
        let ray = Ray3::<f64>::new(origin, target - origin);
        halves.iter().all(|half| method.work(&ray, half).hit(Span::ahead()) == Ok(None))
    };
    (0..rays).filter(missed).count()
}

#[test]
fn nothing_slips_between_two_triangles() {
    assert_eq!(leaks(Method::Robust, 20_000), 0);
    for method in [Method::HalfPlanes, Method::Matrix] {
        assert!(leaks(method, 20_000) > 100, "{} leaks, as printed", method.name());
    }
}

/// (p̄1 − ā) · n and d · n, exactly.
fn exactly(ray: &Ray3<f64>, triangle: &Triangle<f64>) -> [Exact; 2] {
    let [o, d] = [ray.origin, ray.direction].map(Vector::in_f64::<3>);
    let corners = triangle.corners().map(Vector::in_f64::<3>);
    let n = crate::area::normal::<Exact>(corners);
    let to_p1: [Exact; 3] = std::array::from_fn(|axis| Exact::difference(corners[0][axis], o[axis]));
    [Exact::dot(&to_p1, &n), Exact::dot(&d.map(Exact::new), &n)]
}

/// λ is as near as a neighbor to (p̄1 − ā) · n / d · n: on either side of it the exact equation has another sign.
fn assert_nearest(work: &Robust<f64>) {
    let Some(lambda) = work.lambda else { return };
    let [above, rise] = exactly(&work.ray, &work.triangle);
    let left = |lambda: f64| (above.clone() - Exact::new(lambda) * rise.clone()).sign().unwrap();
    let [lower, upper] = [left(lambda.next_down()), left(lambda.next_up())];
    assert!(lower != upper && lower != Ordering::Equal && upper != Ordering::Equal, "{work:?}");
}

#[test]
fn lambda_is_a_neighbor_of_the_exact_one() {
    let mut numbers = Numbers(2);
    let mut seen = [0; 3];
    for _ in 0..20_000 {
        let [size, distance] = [numbers.unit(), numbers.unit()].map(|power| 10.0_f64.powf(3.0 * power));
        let [a, b, c] = std::array::from_fn(|_| numbers.vector() * size);
        // every other time nearly a line, and now and then one
        let c =
            if numbers.unit() < 0.0 { c } else { a + (b - a) * numbers.unit() + c * numbers.unit().powi(25) };
        let target = a + ((b - a) + (c - a)) * 0.3;
        let origin = target + numbers.vector() * distance;
        let work = robust(&Ray3::<f64>::new(origin, target - origin), &Triangle { p1: a, p2: b, p3: c });
        assert_nearest(&work);
        if work.lambda.is_some() {
            seen[work.certainty as usize] += 1;
        }
    }
    assert!(seen[0] > 5000 && seen[1] > 500, "{seen:?}");
}

/// The correction is not for show: without it, t is off by hundreds of its last digits somewhere.
#[test]
fn the_plain_quotient_is_not_enough() {
    let mut numbers = Numbers(3);
    let mut worst = 0;
    for _ in 0..20_000 {
        let [a, b, c] = std::array::from_fn(|_| numbers.vector());
        let target = a + ((b - a) + (c - a)) * 0.3;
        let origin = numbers.vector() * 10.0;
        let ray = Ray3::<f64>::new(origin, target - origin);
        let triangle = Triangle::<f64> { p1: a, p2: b, p3: c };
        let work = robust(&ray, &triangle);
        if work.lambda.is_some() && work.certainty == Certainty::AtOnce {
            let [above, rise] = exactly(&ray, &triangle);
            let exact: f64 = Exact::quotient(&above, &rise).unwrap();
            let plain = crate::matrix(&ray, &triangle).lambda;
            worst = worst.max(plain.to_bits().abs_diff(exact.to_bits()));
        }
    }
    assert!(worst > 100, "{worst}");
}

#[test]
fn a_scale_is_of_no_account() {
    for power in [-1000, -400, -200, -40, 0, 40, 200, 400, 1000] {
        let scale = 2.0_f64.powi(power);
        for length in [1.0, 2.0_f64.powi(-200), 2.0_f64.powi(200)] {
            let triangle =
                Triangle::<f64> { p1: TRIANGLE.p1 * scale, p2: TRIANGLE.p2 * scale, p3: TRIANGLE.p3 * scale };
            let direction = DVec3::new(1.0, 0.75, 1.0) * length;
            let hit = robust(&Ray3::<f64>::new(DVec3::ZERO, direction), &triangle).hit(Span::ahead());
            let hit = hit.unwrap().unwrap();
            let t = 2.0 * (scale / length);
            assert_eq!((hit.t, hit.normal), (t, DVec3::Z), "scale 2^{power}, length {length:e}");
            assert_eq!(hit.point, DVec3::new(2.0, 1.5, 2.0) * scale);
        }
    }
}

#[test]
fn what_overflows_or_vanishes_on_the_way_does_not_matter() {
    // by hand: t = 1e300 / 1e−300, and the ray is straight down on (1, y, 1)
    let ground = Triangle::<f64> { p1: DVec3::ZERO, p2: DVec3::Z * 4.0, p3: DVec3::X * 4.0 };
    let slow = Ray3::<f64>::new(DVec3::new(1.0, 1e300, 1.0), DVec3::new(0.0, -1e-300, 0.0));
    let hit = robust(&slow, &ground).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point.x, hit.point.z), (f64::INFINITY, 1.0, 1.0));
    // by hand: t = ± 1e−200 / 1e200, which is no number; in front it is 0, behind it is no hit
    for (y, expected) in [(1e-200, Some(0.0)), (-1e-200, None)] {
        let quick = Ray3::<f64>::new(DVec3::new(1.0, y, 1.0), DVec3::new(0.0, -1e200, 0.0));
        let found = robust(&quick, &ground).hit(Span::ahead()).unwrap().map(|hit| hit.t);
        assert_eq!(found, expected);
    }
    let tiny = Ray3::<f32>::new(Vec3::new(1.0, -1e-30, 1.0), Vec3::new(0.0, -1e30, 0.0));
    let ground = Triangle::<f32> { p1: Vec3::ZERO, p2: Vec3::Z * 4.0, p3: Vec3::X * 4.0 };
    assert_eq!(robust(&tiny, &ground).lambda, Some(-f32::SMALLEST));
}

/// The main way finds what is degenerate by its error bound.
#[test]
fn no_degenerate_number_passes_in_any_place() {
    let good = [0.0, 0.0, 0.0, 1.0, 0.75, 1.0, 1.0, 1.0, 2.0, 5.0, 1.0, 2.0, 1.0, 3.0, 2.0];
    let reason = |c: [f64; 15]| {
        let v = |i: usize| DVec3::new(c[i], c[i + 1], c[i + 2]);
        let narrow = |i: usize| v(i).as_vec3();
        let wide = robust(&Ray3::<f64>::new(v(0), v(3)), &Triangle { p1: v(6), p2: v(9), p3: v(12) });
        let ray = Ray3::<f32>::new(narrow(0), narrow(3));
        let found = robust(&ray, &Triangle { p1: narrow(6), p2: narrow(9), p3: narrow(12) });
        assert_eq!(wide.hit(Span::ahead()).err(), found.hit(Span::ahead()).err(), "{c:?}");
        wide.hit(Span::ahead()).err()
    };
    assert_eq!(reason(good), None);
    for place in 0..15 {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut case = good;
            case[place] = bad;
            assert_eq!(reason(case), Some(Degenerate::NotFinite), "{bad} in place {place}");
        }
    }
    let mut still = good;
    still[3..6].fill(-0.0);
    assert_eq!(reason(still), Some(Degenerate::ZeroDirection));
    // two corners are one; or all lie on a line that the ray passes by far
    for (from, to) in [(6, 9), (6, 12), (9, 12), (9, 6)] {
        let mut line = good;
        line.copy_within(from..from + 3, to);
        assert_eq!(reason(line), Some(Degenerate::NoArea), "{line:?}");
    }
    let mut line = good;
    line[12..15].copy_from_slice(&[-7.0, 1.0, 2.0]);
    assert_eq!(reason(line), Some(Degenerate::NoArea));
}

/// Numbers of any bits, of which some are near each other.
#[test]
fn no_hit_has_a_number_that_is_none() {
    fn assert_in_order<R: Real>(mut number: impl FnMut() -> R) {
        for _ in 0..40_000 {
            let mut v = || R::vec3(number(), number(), number());
            let (ray, triangle) = (Ray3::<R>::new(v(), v()), Triangle { p1: v(), p2: v(), p3: v() });
            for method in Method::ALL {
                let work = method.work(&ray, &triangle);
                let Ok(Some(hit)) = work.hit(Span::ahead()) else { continue };
                let [t, nx, ny, nz, x, y, z]: [f64; 7] = {
                    let [[nx, ny, nz], [x, y, z]] = [hit.normal, hit.point].map(R::xyz);
                    [hit.t, nx, ny, nz, x, y, z].map(Into::into)
                };
                let is_good = t >= 0.0 && [nx, ny, nz].iter().all(|x| x.is_finite());
                assert!(
                    is_good && ![x, y, z].iter().any(|x| x.is_nan()),
                    "{} {ray:?} {hit:?}",
                    method.name()
                );
                assert!(
                    (nx * nx + ny * ny + nz * nz - 1.0).abs() < 1e-6 || method != Method::Robust,
                    "{hit:?}"
                );
            }
        }
    }
    let mut numbers = Numbers(4);
    let mut any = move || {
        let bits = numbers.bits();
        match bits % 4 {
            0 => f64::from_bits(numbers.bits()),
            1 => numbers.unit() * 2.0_f64.powi((bits >> 8) as i32 % 600),
            2 => (numbers.unit() * 3.0).round(),
            _ => numbers.unit(),
        }
    };
    assert_in_order::<f64>(&mut any);
    assert_in_order::<f32>(|| any() as f32);
}

/// The verdict of the oracle, and its λ within a unit of the last digit.
#[cfg(feature = "stage")]
#[test]
fn right_in_every_regime() {
    assert_eq!(lab::first_beyond(&crate::stage::RayTriangle, 2, 300, |_, _| 1), None);
}

/// Which way the rays of every regime take, and how good it is: see [`lab::tally()`].
#[cfg(feature = "stage")]
#[test]
fn ways() {
    fn way<R: Real>(case: [f64; 15]) -> String {
        let (ray, triangle) = crate::measure::question(case.map(R::round_from));
        format!("{:?}", robust(&ray, &triangle).certainty)
    }
    insta::assert_snapshot!(lab::tally(&crate::stage::RayTriangle, 2, 200, [way::<f32>, way::<f64>]));
}

/// By hand: see `volumes.rs`. At the bound itself plain numbers leave a doubt, and at twice the bound they do not.
#[test]
fn what_is_at_the_bound_is_looked_at_carefully() {
    use crate::volumes::tests::{BOUND, inside_by};
    for (e, certainty) in [(BOUND, Certainty::TwoPart), (2.0 * BOUND, Certainty::AtOnce)] {
        for (inside, t) in [(1.0, Some(0.25)), (-1.0, None)] {
            for (ray, triangle) in inside_by(inside * e) {
                let work = robust(&ray, &triangle);
                let found = work.hit(Span::ahead()).unwrap().map(|hit| hit.t);
                assert_eq!((work.certainty, found), (certainty, t), "{e:e} {inside}");
            }
        }
    }
}

/// By hand: through the inside, past it, within the plane and along it, and no ray at all; the first two at once and
/// carefully.
#[test]
fn the_passage_is_told_from_the_signs() {
    let ray = |from: DVec3, d: DVec3| Ray3::<f64>::new(from, d);
    let (through, past) = (ray(DVec3::ZERO, DVec3::new(1.0, 0.75, 1.0)), ray(DVec3::ZERO, DVec3::Z));
    let within = ray(DVec3::new(0.0, 1.5, 2.0), DVec3::X);
    let still = ray(DVec3::ZERO, DVec3::ZERO);
    for (ray, passage, lambda) in [
        (through, Passage::Through, Some(2.0)),
        (past, Passage::Past, None),
        (within, Passage::Along, None),
        (still, Passage::Degenerate, None),
    ] {
        for work in [robust(&ray, &TRIANGLE), carefully::robust(ray, TRIANGLE)] {
            assert_eq!((work.passage, work.lambda), (passage, lambda), "{ray:?}");
        }
    }
}

/// By hand, seen along z: B = (1, 0), C = (0, 1) and A = (−h, −h) with h = 2^−53. The volumes are 1, h and h, of
/// which the sum is rounded to 1, and d · n = (1 + h)² − h² = 1 + 2h, which is the next number.
#[test]
fn d_dot_n_is_not_the_sum_of_what_is_rounded() {
    let h = f64::EPSILON / 2.0;
    let corner = |x, y| DVec3::new(x, y, 1.0);
    let triangle = Triangle::<f64> { p1: corner(-h, -h), p2: corner(1.0, 0.0), p3: corner(0.0, 1.0) };
    let work = robust(&Ray3::new(DVec3::ZERO, DVec3::Z), &triangle);
    assert_eq!((work.certainty, work.lambda), (Certainty::TwoPart, Some(1.0)));
    assert_eq!((work.volumes, work.d_dot_n), ([1.0, h, h], 1.0_f64.next_up()));
}

/// By hand: numbers whose sum is one are, however large, and the smallest λ with all its digits.
#[test]
fn a_point_is_ordinary_where_all_its_digits_are_there() {
    let (far, farthest) = (2.0_f64.powi(600), 1.5 * 2.0_f64.powi(1023));
    for (lambda, point, ordinary) in [
        (1.0, [far; 3], true),
        (1.0, [farthest, -farthest, 0.0], true),
        (1.0, [0.0, farthest, -farthest], true),
        (f64::MIN_POSITIVE, [0.0; 3], true),
        (-f64::MIN_POSITIVE, [0.0; 3], true),
        (f64::MIN_POSITIVE.next_down(), [0.0; 3], false),
        (1.0, [f64::INFINITY, 0.0, 0.0], false),
        (1.0, [0.0, f64::NAN, 0.0], false),
        (1.0, [0.0, 0.0, f64::NEG_INFINITY], false),
        (0.0, [0.0; 3], false),
    ] {
        assert_eq!(are_ordinary(lambda, point), ordinary, "{lambda:e} {point:?}");
    }
}

/// By hand: e1 = (1, 0, 0) and e2 = (1 − h, h, 0), so that |n| = h and |e1| |e2| = 1, and the ray is a quarter
/// of the way along both. The plain n is kept where h is a 256th.
#[test]
fn the_plain_normal_of_a_sliver_is_not_kept() {
    let kept = |h: f64| {
        let corner = |x, y| DVec3::new(x, y, 1.0);
        let triangle = Triangle::<f64> { p1: corner(0.0, 0.0), p2: corner(1.0, 0.0), p3: corner(1.0 - h, h) };
        let ray = Ray3::new(DVec3::new(0.5 - h / 4.0, h / 4.0, 0.0), DVec3::Z);
        let work = robust(&ray, &triangle);
        assert_eq!((work.certainty, work.lambda), (Certainty::AtOnce, Some(1.0)));
        assert_eq!(work.hit(Span::ahead()).unwrap().unwrap().normal, DVec3::Z);
        work.n
    };
    let least = 1.0 / 256.0;
    assert_eq!([kept(least), kept(least.next_down())], [Some([0.0, 0.0, least]), None]);
}

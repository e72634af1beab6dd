use super::*;
use glam::DVec3;

#[test]
fn exactly_parallel_is_parallel() {
    // by hand: 0.1 · 0.3 − 0.3 · 0.1 = 0, whatever 0.1 and 0.3 are rounded to
    let direction = DVec3::new(0.3, -0.1, 0.0);
    let plane = Plane { point: DVec3::ZERO, normal: DVec3::new(0.1, 0.3, 0.0) };
    let ray = Ray3::<f64>::new(DVec3::new(1.0, 1.0, 1.0), direction);
    assert_eq!(robust(&ray, &plane).meeting(), Meeting::Never(Parallel::Apart));
    let within = Ray3::<f64>::new(direction * 2.0, direction);
    assert_eq!(robust(&within, &plane).meeting(), Meeting::Never(Parallel::Within));
}

/// By hand: n · u_r = 1 + 2^−53, a number in two parts, and 1 over that is 1 − 2^−53 to far more than the
/// last digit.
#[test]
fn the_second_part_of_either_sum_counts() {
    let least = 2.0_f64.powi(-53);
    let plane = Plane { point: DVec3::ZERO, normal: DVec3::new(1.0, least, 0.0) };
    let from =
        |x: f64, y: f64| robust(&Ray3::<f64>::new(DVec3::new(x, y, 0.0), DVec3::new(1.0, 1.0, 0.0)), &plane);
    assert_eq!(from(-1.0, 0.0).meeting(), Meeting::At(1.0 - least));
    assert_eq!(from(-1.0, -1.0).meeting(), Meeting::At(1.0));
}

#[test]
fn nearly_parallel_keeps_its_digits() {
    // by hand: n · u_r = (1 + 2^−52) − 1 = 2^−52, hidden beside products of size 2^60
    let (big, tiny) = (2.0_f64.powi(60), 2.0_f64.powi(-52));
    let plane = Plane { point: DVec3::ZERO, normal: DVec3::new(big, -big, 1.0) };
    let ray = Ray3::<f64>::new(DVec3::new(0.0, 0.0, 1.0), DVec3::new(1.0, 1.0, -tiny));
    assert_eq!(robust(&ray, &plane).meeting(), Meeting::At(1.0 / tiny));
}

/// The large component of the one vector meets the small one of the other, on every axis.
#[test]
fn products_that_vanish_are_summed_exactly() {
    let ray = Ray3::<f64>::new(DVec3::new(0.0, 0.0, 1e-40), DVec3::new(1.0, 1e-300, 1e-300));
    let plane = Plane { point: DVec3::ZERO, normal: DVec3::new(-1e-300, 1e-15, 1.0) };
    // by hand: n · u_r = −1e−300 + 1e−315 + 1e−300 = 1e−315, and t = −1e−40 / 1e−315
    let work = robust(&ray, &plane);
    assert_eq!(work.n_dot_u.certainty, Certainty::Exact);
    let Meeting::At(t) = work.meeting() else { panic!("not parallel") };
    assert!((t / -1e275 - 1.0).abs() < 1e-15, "{t:e}");
    let as_printed = crate::notes(&ray, &plane).t;
    assert!((as_printed / -1e275 - 1.0).abs() > 1e-12, "as printed: {as_printed:e}");
}

/// By hand: from the plane itself, away from it on either side.
#[test]
fn on_the_plane_is_at_plus_zero() {
    let plane = Plane { point: DVec3::new(1.0, 2.0, 3.0), normal: DVec3::Y };
    for up in [1.0, -1.0] {
        let ray = Ray3::<f64>::new(DVec3::new(5.0, 2.0, -1.0), DVec3::new(1.0, up, 1.0));
        let hit = robust(&ray, &plane).hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t.to_bits(), hit.point), (0, ray.origin), "minus zero is zero");
    }
}

#[test]
fn lengths_of_the_normal_may_be_extreme() {
    let ray = Ray3::<f64>::new(DVec3::new(0.0, 3.0, 0.0), DVec3::new(0.0, -1.0, 0.0));
    for length in [1e300, 1.0, 1e-300, 5e-324] {
        let plane = Plane { point: DVec3::ZERO, normal: DVec3::Y * length };
        let work = robust(&ray, &plane);
        let hit = work.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.normal, work.distance()), (3.0, DVec3::Y, 3.0), "‖n‖ = {length:e}");
    }
}

/// One plane, n = (1, 1, 1) through the world's origin, and rays along (1, 1, 1) from next to it.
fn from(origin: [f64; 3]) -> Robust<f64> {
    let plane = Plane { point: DVec3::ZERO, normal: DVec3::ONE };
    robust(&Ray3::<f64>::new(origin.into(), DVec3::ONE), &plane)
}

#[test]
fn each_way_takes_over_where_the_one_before_it_ends() {
    // by hand: n · p_r = 1 − 1 + 2^−k of magnitudes 2 + 2^−k, and n · u_r = 3
    for (k, certainty) in [
        (43, Certainty::TwoPart),
        (44, Certainty::ThreePart),
        (91, Certainty::ThreePart),
        (92, Certainty::Exact),
        (1074, Certainty::Exact),
    ] {
        let (rest, least) = (2.0_f64.powi(-k / 2) * 2.0_f64.powi(-k - -k / 2), 2.0_f64.powi(-52));
        let work = from([1.0, rest, -1.0]);
        assert_eq!((work.n_dot_p.value, work.n_dot_p.certainty), (rest, certainty), "2^−{k}");
        let Meeting::At(t) = work.meeting() else { panic!("not parallel") };
        assert!((t / (-rest / 3.0) - 1.0).abs() <= least || k == 1074, "2^−{k}: {t:e}");
        assert_eq!(work.hit(Span::ahead()), Ok(None), "the plane is behind by 2^−{k}");
        let hit = from([1.0, -rest, -1.0]).hit(Span::ahead()).unwrap().unwrap();
        assert!(hit.t == -t || k == 1074, "2^−{k}: {hit:?}");
    }
    let touching = from([1.0, 0.0, -1.0]);
    assert_eq!(touching.n_dot_p, CertainSum { value: 0.0, certainty: Certainty::ThreePart });
    assert_eq!(touching.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0);
    let ray = Ray3::<f64>::new(DVec3::new(1.0, 0.0, -1.0), -DVec3::ONE);
    let back = robust(&ray, &touching.plane);
    assert_eq!(back.hit(Span::ahead()).unwrap().unwrap().t.to_bits(), 0, "minus zero is zero");
}

#[test]
fn a_product_too_small_to_be_seen_is_not_zero() {
    // by hand: n · p_r = 1 − 1 ± 1e−400
    for (z, ahead) in [(1e-200, false), (-1e-200, true)] {
        let plane = Plane { point: DVec3::ZERO, normal: DVec3::new(1.0, 1.0, 1e-200) };
        let ray = Ray3::<f64>::new(DVec3::new(1.0, -1.0, z), DVec3::X);
        let work = robust(&ray, &plane);
        assert_eq!(work.n_dot_p.certainty, Certainty::Exact);
        assert_eq!(work.hit(Span::ahead()).unwrap().is_some(), ahead);
    }
}

#[test]
fn plain_f64_is_enough_for_f32_but_where_it_cancels() {
    let plane = Plane::<f32> { point: glam::Vec3::ZERO, normal: glam::Vec3::ONE };
    let from = |y| robust(&Ray3::<f32>::new(glam::Vec3::new(1.0, y, -1.0), glam::Vec3::ONE), &plane);
    // by hand: n · p_r = 1 − 2^−k − 1 of magnitudes 2 + 2^−k
    for (k, certainty) in [(21, Certainty::AtOnce), (22, Certainty::TwoPart)] {
        let rest = 2.0_f32.powi(-k);
        let work = from(-rest);
        assert_eq!((work.n_dot_p.value, work.n_dot_p.certainty), (f64::from(-rest), certainty), "2^−{k}");
        assert_eq!(work.hit(Span::ahead()).unwrap().unwrap().t, rest / 3.0);
    }
    // t is a tenth of the smallest number, and negative
    let steep = Ray3::<f32>::new(glam::Vec3::new(0.0, f32::from_bits(1), 0.0), glam::Vec3::ONE * 10.0);
    assert_eq!(robust(&steep, &plane).hit(Span::ahead()), Ok(None));
    assert_eq!(robust(&steep, &plane).meeting(), Meeting::At(-f32::SMALLEST));
}

#[test]
fn what_overflows_on_the_way_does_not_matter() {
    // by hand: t = 1e300 / 1e−300; the point is where the ray, straight down, meets the ground
    let ground = Plane { point: DVec3::ZERO, normal: DVec3::Y };
    let slow = Ray3::<f64>::new(DVec3::new(1.0, 1e300, 2.0), DVec3::new(0.0, -1e-300, 0.0));
    let hit = robust(&slow, &ground).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point.x, hit.point.z), (f64::INFINITY, 1.0, 2.0));
    assert!(hit.point.y.abs() <= 1e300 * 2.0_f64.powi(-99), "{hit:?}");
    // t u_r = 2e308 is no number, and p_r + t u_r is
    let ray = Ray3::<f64>::new(DVec3::new(-1e308, 2.0, 0.0), DVec3::new(1e308, -1.0, 0.0));
    let hit = robust(&ray, &ground).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point), (2.0, DVec3::new(1e308, 0.0, 0.0)));
}

#[test]
fn what_vanishes_on_the_way_does_not_matter() {
    // by hand: t = 1e−140 / 1e290 is no number, and t u_r = 1e−140 is
    let ground = Plane { point: DVec3::ZERO, normal: DVec3::Y };
    let ray = Ray3::<f64>::new(DVec3::Y * 1e-140, DVec3::new(1e290, -1e290, 0.0));
    let hit = robust(&ray, &ground).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.point.x, hit.point.z), (1e-140, 0.0));
}

/// The main way finds what is degenerate by the size of its sums.
#[test]
fn no_degenerate_number_passes_in_any_place() {
    let good = [0.5, 1.0, 2.0, 0.25, -0.5, 0.75, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let reason = |c: [f64; 12]| {
        let v = |i: usize| DVec3::new(c[i], c[i + 1], c[i + 2]);
        let (ray, plane) = (Ray3::<f64>::new(v(0), v(3)), Plane::<f64> { point: v(6), normal: v(9) });
        let narrow = |v: DVec3| v.as_vec3();
        let narrow_ray = Ray3::<f32>::new(narrow(v(0)), narrow(v(3)));
        let narrow_plane = Plane::<f32> { point: narrow(v(6)), normal: narrow(v(9)) };
        let found = robust(&ray, &plane).hit(Span::ahead()).err();
        assert_eq!(found, robust(&narrow_ray, &narrow_plane).hit(Span::ahead()).err(), "{c:?}");
        found
    };
    assert_eq!(reason(good), None);
    for place in 0..12 {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut case = good;
            case[place] = bad;
            assert_eq!(reason(case), Some(Degenerate::NotFinite), "{bad} in place {place}");
        }
    }
    for (first, degenerate) in [(3, Degenerate::ZeroDirection), (9, Degenerate::ZeroNormal)] {
        let mut case = good;
        case[first..first + 3].fill(-0.0);
        assert_eq!(reason(case), Some(degenerate));
    }
}

/// The verdict of the oracle, and its t to 1¼ units and a rounding of `f64`, see [`Sum::over`]; an `f32` is
/// rounded once.
#[cfg(feature = "stage")]
#[test]
fn right_in_every_regime() {
    use stage::Precision::{self, F32};

    let allowed = |_: &_, precision: Precision| if precision == F32 { 1 } else { 2 };
    assert_eq!(lab::first_beyond(&crate::stage::RayPlane, 1, 300, allowed), None);
}

/// Which way the rays of every regime take, and how good it is: see [`lab::tally()`].
#[cfg(feature = "stage")]
#[test]
fn ways() {
    fn way<R: Real>(case: [f64; 12]) -> String {
        let (ray, plane) = crate::measure::question(case.map(R::round_from));
        let work = robust(&ray, &plane);
        format!("{:?} {:?}", work.n_dot_p.certainty, work.n_dot_u.certainty)
    }
    insta::assert_snapshot!(lab::tally(&crate::stage::RayPlane, 1, 200, [way::<f32>, way::<f64>]));
}

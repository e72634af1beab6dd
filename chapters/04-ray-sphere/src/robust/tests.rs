use super::*;
use glam::DVec3;

/// A ray and a sphere.
pub(super) fn work(origin: [f64; 3], direction: [f64; 3], center: [f64; 3], radius: f64) -> Robust<f64> {
    robust(&Ray3::new(origin.into(), direction.into()), &Sphere { center: center.into(), radius })
}

/// 2^power
pub(super) fn two(power: i32) -> f64 {
    2.0_f64.powi(power)
}

/// A tangent of whole numbers is one at every scale at which they are floats.
#[test]
fn a_tangent_is_a_tangent_at_every_scale() {
    // by hand: the ray x = 3 in the direction of z touches the sphere of radius 3 around (0, 0, 8)
    for power in [-1000, -300, -40, 0, 40, 300, 1000] {
        let scale = 2.0_f64.powi(power);
        let [x, r, z] = [3.0, 3.0, 8.0].map(|number| number * scale);
        for length in [1.0, 1e-150, 1e150, 5e-324] {
            let touching = work([x, 0.0, 0.0], [0.0, 0.0, length], [0.0, 0.0, z], r);
            assert_eq!(touching.chord.half_chord_squared, 0.0, "scale 2^{power}, length {length:e}");
            assert!(touching.roots().is_some_and(|roots| roots.near == roots.far));
            // one digit farther out it misses, one digit farther in it hits
            assert!(work([x.next_up(), 0.0, 0.0], [0.0, 0.0, length], [0.0, 0.0, z], r).roots().is_none());
            let inside = work([x.next_down(), 0.0, 0.0], [0.0, 0.0, length], [0.0, 0.0, z], r);
            assert!(inside.roots().is_some());
        }
    }
}

#[test]
fn a_normal_has_length_one_however_far_the_sphere() {
    for distance in [10.0, 1e8, 1e16, 1e40, 1e200] {
        // aimed half a radius off the center, from an origin whose digits reach below the radius
        let touching = work([0.5, 0.25, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, distance], 1.0);
        let hit = touching.hit(Span::ahead()).unwrap().unwrap();
        let closed_form = DVec3::new(0.5, 0.25, -(1.0 - 0.25 - 0.0625_f64).sqrt());
        assert!((hit.normal - closed_form).length() < 1e-15, "{distance:e}: {:?}", hit.normal);
    }
}

/// The two roots of an exact tangent are one number, also where it lies halfway between two floats.
#[test]
fn a_tangent_leaves_where_it_enters() {
    let touching = work([6.0, 0.0, -1.659_619_002_541_466_4e16], [0.0, 0.0, 0.5], [0.0, 0.0, 3.0], 6.0);
    let Roots { near, far } = touching.roots().unwrap();
    assert_eq!(near, far);
}

#[test]
fn a_point_near_the_eye_has_the_digits_of_the_eye_beside_a_huge_sphere() {
    // the ground: y = 0 to within 1e−11 around the origin, seen from a height of 1
    let radius = 2e11;
    let hit = work([0.0, 1.0, 0.0], [0.6, -0.8, 0.0], [0.0, -radius, 0.0], radius);
    let point = hit.hit(Span::ahead()).unwrap().unwrap().point;
    // closed form: −x²/2r to the first order; x = 0.75
    let y = -0.75 * 0.75 / (2.0 * radius);
    assert!((point.y - y).abs() < f64::EPSILON, "{point}: the digits of p_r, not those of c");
}

#[test]
fn an_origin_on_the_surface_touches_at_zero() {
    // (2, 3, 6) lies on the sphere of radius 7; by hand, along −x it leaves at x = −2
    let touching = work([2.0, 3.0, 6.0], [-1.0, 0.0, 0.0], [0.0; 3], 7.0);
    assert_eq!(touching.chord.certainty, Certainty::Exact);
    assert_eq!(touching.roots(), Some(Roots { near: 0.0, far: 4.0 }));
    // a tangent there
    let grazing = work([2.0, 3.0, 6.0], [3.0, -2.0, 0.0], [0.0; 3], 7.0);
    assert_eq!(grazing.roots(), Some(Roots { near: 0.0, far: 0.0 }));
}

/// A ray up the z axis, 2⁻⁶⁰ beside it, and a center y beside it: the digits of 2⁻⁶⁰ are lost in y. By hand: y, h and
/// r are 3, 4 and 5 (or an eighth of that), and t = t_close − h. The point is p_r + t d where t < r, and so has them;
/// else it is c + r n, whose y is 0.
#[test]
fn a_point_has_the_digits_of_the_nearer_of_origin_and_center() {
    let tiny = two(-60);
    for ([y, t_close, r], t, y_hit) in [
        ([0.375, 1.0, 0.625], 0.5, tiny),
        ([3.0, 8.0, 5.0], 4.0, tiny),
        ([3.0, 9.0, 5.0], 5.0, 0.0),
        ([3.0, 10.0, 5.0], 6.0, 0.0),
    ] {
        let hit = work([0.0, tiny, 0.0], [0.0, 0.0, 1.0], [0.0, y, t_close], r)
            .hit(Span::ahead())
            .unwrap()
            .unwrap();
        assert_eq!((hit.t, hit.point), (t, DVec3::new(0.0, y_hit, t)), "r = {r}");
    }
}

/// Straight at the center, by hand; as −1 · 0 is minus zero.
#[test]
fn no_component_of_a_normal_is_minus_zero() {
    let hit = work([0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, 8.0], 1.0).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!(hit.normal.to_array().map(f64::to_bits), [0.0_f64, 0.0, -1.0].map(f64::to_bits));
}

/// A ray that starts 2⁻²⁰ within the unit sphere, or as much before it, straight at the center. By hand: it crosses it
/// there, and 2 farther on.
#[test]
fn a_shorter_way_to_the_same_hit() {
    let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
    let at = |t: f64, n: f64| Hit { t, point: DVec3::new(0.0, 0.0, t), normal: DVec3::new(0.0, 0.0, n) };
    let tiny = two(-20);
    for (first, near) in [(-tiny, None), (tiny, Some(at(tiny, -1.0)))] {
        let sphere = Sphere { center: DVec3::new(0.0, 0.0, 1.0 + first), radius: 1.0 };
        let far = at(2.0 + first, 1.0);
        assert_eq!(hit(&ray, &sphere, Span::ahead()), Ok(near.or(Some(far))));
        assert_eq!(hit(&ray, &sphere, Span::new(0.5, 4.0)), Ok(Some(far)));
        assert_eq!(hit(&ray, &sphere, Span::new(0.5, 1.0)), Ok(None));
        // who is known to start within it is not asked
        assert_eq!(hit_from_within(&ray, &sphere, Span::ahead()), Ok(Some(far)));
        assert_eq!(hit_from_within(&ray, &sphere, Span::new(0.0, 1.0)), Ok(None));
    }
}

/// Each of the four ways is taken by the rays that it is for.
#[test]
fn four_ways() {
    let at = |x: f64, z: f64| work([x, 0.0, z], [0.0, 0.0, 1.0], [0.0, 0.0, 8.0], 1.0).chord.certainty;
    assert_eq!(at(2.0, 0.0), Certainty::AtOnce, "a clear miss");
    assert_eq!(at(0.5, 0.0), Certainty::AtOnce, "a clear hit");
    assert_eq!(at(1.0 - 1e-9, 0.0), Certainty::Corrected, "a hit next to a tangent");
    assert_eq!(at(0.5, 7.13), Certainty::NearSurface, "an origin next to the surface");
    assert_eq!(at(1.0, 0.0), Certainty::Exact, "a tangent");
    let half_the_digits = robust(
        &Ray3::<f32>::new(glam::Vec3::new(1.0 - 1e-5, 0.0, 0.0), glam::Vec3::Z),
        &Sphere { center: glam::Vec3::new(0.0, 0.0, 8.0), radius: 1.0 },
    );
    assert_eq!(half_the_digits.chord.certainty, Certainty::AtOnce, "next to a tangent for an f32");
}

/// Of a question whose squares overflow or vanish, the answer is that of the question at scale 1, digit by digit. The
/// eye is outside, and inside, where the near root is behind it.
#[test]
fn at_another_scale_with_the_same_digits() {
    for origin in [[0.25, -0.5, -3.0], [0.25, -0.5, 0.125]] {
        let ordinary = work(origin, [0.125, 0.25, 1.0], [0.0; 3], 1.0).chord;
        for power in [600, -600] {
            let scale = 2.0_f64.powi(power);
            let far = work(origin.map(|x| x * scale), [0.125, 0.25, 1.0], [0.0; 3], scale).chord;
            assert_eq!(far.certainty, Certainty::Scaled, "2^{power}");
            let Roots { near, far } = far.roots.unwrap();
            assert_eq!(Some(Roots { near: near / scale, far: far / scale }), ordinary.roots, "2^{power}");
        }
    }
}

/// C where a root was found from it: (½ − 2^−10)² + (½ + 2^−10)² + ½ − 1 is 2^−19, by hand.
#[test]
fn next_to_the_surface_c_is_told() {
    let tiny = 2.0_f64.powi(-10);
    let origin = [0.5 - tiny, 0.5 + tiny, 0.5_f64.sqrt()];
    let Chord { certainty, c, roots, .. } = work(origin, [0.0, 0.0, 1.0], [0.0; 3], 1.0).chord;
    assert_eq!(certainty, Certainty::NearSurface);
    // √½ is rounded, so that its square is off by at most 2^−53
    let c = c.unwrap();
    assert!((c - 2.0_f64.powi(-19)).abs() <= 2.0_f64.powi(-53), "{c:e}");
    // the product of the roots is C, a line along z with A = 1
    let Roots { near, far } = roots.unwrap();
    assert!((near * far / c - 1.0).abs() < 4.0 * f64::EPSILON);
}

/// The verdict of the oracle, and its t within what is derived beside the constants: 9 units of the last
/// digit, 1 of `f32`.
#[cfg(feature = "stage")]
#[test]
fn right_in_every_regime() {
    use stage::Precision::{self, F32};

    let allowed = |_: &_, precision: Precision| if precision == F32 { 1 } else { 9 };
    assert_eq!(lab::first_beyond(&crate::stage::RaySphere, 5, 300, allowed), None);
}

/// Which way the rays of every regime take, and how good it is: see [`lab::tally()`].
#[cfg(feature = "stage")]
#[test]
fn ways() {
    fn way<R: Real>(case: [f64; 10]) -> String {
        let (ray, sphere) = crate::measure::question(case.map(R::round_from));
        format!("{:?}", robust(&ray, &sphere).chord.certainty)
    }
    insta::assert_snapshot!(lab::tally(&crate::stage::RaySphere, 5, 200, [way::<f32>, way::<f64>]));
}

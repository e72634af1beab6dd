use super::*;
use glam::DVec3;

/// A way down at θ1 degrees, in the x-y plane.
fn down(theta1: f64) -> DVec3 {
    let theta1 = theta1.to_radians();
    DVec3::new(theta1.sin(), -theta1.cos(), 0.0)
}

/// The page's two indices: asin(1/1.33) = 48.7535°, asin(1/1.8) = 33.7490°.
#[test]
fn the_critical_angles_of_the_page() {
    for (n, theta_c) in [(1.33, 48.75), (1.8, 33.75)] {
        let computed = critical_angle(n, 1.0).unwrap();
        assert!((computed - theta_c).abs() < 0.005, "{computed}");
        // a hundredth of a degree before it light gets out, along the surface; a hundredth after it does not
        let out = |theta1| refract::<f64>(down(theta1), DVec3::Y, n, 1.0);
        assert!(out(computed - 0.01).theta2().unwrap() > 88.0);
        assert_eq!(out(computed + 0.01).t, None);
    }
    assert_eq!(critical_angle(1.0, 1.33), None);
    assert_eq!(critical_angle(1.0, 1.0), None);
}

/// Slip 14: "If c2 < c1, light bends towards the normal (e.g. air to water). If c2 < c1, light bends away
/// from the normal (e.g. water to air)." One condition cannot do both, and from water into air it does not
/// hold.
#[test]
fn as_printed_light_bends_both_ways_on_one_condition() {
    let (air, water) = (1.0, 1.33);
    let speed = |n: f64| 1.0 / n;
    for (n1, n2, bends_away) in [(air, water, false), (water, air, true)] {
        let theta2 = refract::<f64>(down(30.0), DVec3::Y, n1, n2).theta2().unwrap();
        assert_eq!(theta2 > 30.0, bends_away);
        let (c1, c2) = (speed(n1), speed(n2));
        assert_eq!(c2 > c1, bends_away, "as it should be");
        assert_ne!(c2 < c1, bends_away, "as printed");
    }
}

/// Slip 28: 1.8 is dense flint. Light at 38° inside window glass, of 1.5, gets out of it, and out of the
/// page's glass it does not: asin(1/1.5) = 41.8103°.
#[test]
fn as_printed_glass_keeps_light_that_leaves_a_window() {
    let out = |n| refract::<f64>(down(38.0), DVec3::Y, n, 1.0);
    assert_eq!(out(1.8).t, None);
    // by hand: 1.5 sin 38° = 0.923492, and asin of it is 67.4416°
    assert!((out(1.5).theta2().unwrap() - 67.4416).abs() < 0.001, "{:?}", out(1.5).theta2());
    assert!((critical_angle(1.5, 1.0).unwrap() - 41.8103).abs() < 0.001);
}

#[test]
fn toward_the_normal_into_the_slower_medium_and_away_out_of_it() {
    for theta1 in [1.0, 10.0, 30.0, 45.0] {
        let into = refract::<f64>(down(theta1), DVec3::Y, 1.0, 1.33);
        let out = refract::<f64>(down(theta1), DVec3::Y, 1.33, 1.0);
        assert!(into.theta2().unwrap() < theta1);
        assert!(out.theta2().unwrap() > theta1);
        // Snell's law itself, n1 sin θ1 = n2 sin θ2
        for it in [into, out] {
            let t = it.t.unwrap();
            assert!((it.n1 * down(theta1).x - it.n2 * t.x).abs() < 4.0 * f64::EPSILON);
            assert!((t.length() - 1.0).abs() < 4.0 * f64::EPSILON);
            assert!(t.y < 0.0, "on the other side");
        }
    }
}

#[test]
fn straight_on_it_passes_unbent() {
    for (n1, n2) in [(1.0, 1.8), (1.8, 1.0)] {
        for n in [DVec3::X, DVec3::new(0.6, 0.0, 0.8)] {
            assert_eq!(refract::<f64>(-n, n, n1, n2).t, Some(-n));
        }
    }
    // and at any angle where nothing changes
    let d = down(37.0);
    assert_eq!(refract::<f64>(d, DVec3::Y, 1.5, 1.5).t, Some(d));
}

/// t⃗ · (d⃗ × n⃗) = 0, in f64 and in f32, for directions from all sides.
#[test]
fn it_stays_in_the_plane_of_the_direction_and_the_normal() {
    let n = DVec3::new(1.0, -2.0, 0.5).normalize();
    for step in 0..500 {
        let angle = f64::from(step) * 0.7;
        let d = DVec3::new(angle.cos(), angle.sin(), (0.3 * angle).cos()).normalize();
        let n = if d.dot(n) > 0.0 { -n } else { n };
        for (n1, n2) in [(1.0, 1.33), (1.33, 1.0), (1.0, 1.8), (1.8, 1.33)] {
            let Some(t) = refract::<f64>(d, n, n1, n2).t else { continue };
            assert!(t.dot(d.cross(n)).abs() < 4.0 * f64::EPSILON);
            let Some(t) = refract::<f32>(d.as_vec3(), n.as_vec3(), n1, n2).t else { continue };
            assert!(t.dot(d.as_vec3().cross(n.as_vec3())).abs() < 4.0 * f32::EPSILON);
        }
    }
}

/// What grazes between equal indices is not bent, and its angle is not above 90°: its sine is rounded.
#[test]
fn a_grazing_ray_that_is_not_bent_has_an_angle() {
    let mut above = 0;
    for step in 0..1000 {
        let angle = f64::from(step) / 100.0;
        let d = DVec3::new(angle.cos(), angle.sin(), -1e-12).normalize();
        let same = refract::<f64>(d, DVec3::Z, 1.5, 1.5);
        above += usize::from(same.sin2_theta2 > 1.0);
        let theta2 = same.theta2().unwrap();
        assert!(same.t == Some(d) && (theta2 - 90.0).abs() < 1e-5, "{d}: {theta2}");
    }
    assert!(above > 0);
}

/// The angle by which it was made, to eight units of the last digit of the largest.
#[test]
fn the_angle_of_a_way_down_is_its_own() {
    for theta1 in [0.0, 0.001, 30.0, 45.0, 89.0] {
        let off = refract::<f64>(down(theta1), DVec3::Y, 1.0, 1.5).theta1() - theta1;
        assert!(off.abs() <= 8.0 * 90.0 * f64::EPSILON, "{theta1}: {off:e}");
    }
}

//! Closed forms by hand, and the ends of the range.

use glam::DVec3;
use math::{Certainty, Ray3, Span};

use quadric::Part;
use quadric::robust::Place;

use super::exact::ExactLine;
use super::{Verdict, robust};
use crate::{Affine, Deformed, Matrix3, Object};

fn deformed(object: Object, rows: [[f64; 3]; 3], t: [f64; 3]) -> Deformed<f64> {
    Deformed::new(object, Affine { a: Matrix3::from_rows(rows), t: t.into() }).unwrap()
}

/// By hand: half axes 2, 1 and 4 around (1, 0, 3).
#[test]
fn closed_forms() {
    let longer = [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 4.0]];
    let hit = |object, [x, z, d_x, d_z]: [f64; 4]| {
        let ray = Ray3::<f64>::new(DVec3::new(x, 0.0, z), DVec3::new(d_x, 0.0, d_z));
        let deformed = deformed(object, longer, [1.0, 0.0, 3.0]);
        robust(&ray, &deformed).hit(Span::ahead()).unwrap().map(|hit| (hit.t, hit.point, hit.normal))
    };
    let at = DVec3::new;
    let (x, z) = (DVec3::X, DVec3::Z);
    assert_eq!(hit(Object::Sphere, [-9.0, 3.0, 1.0, 0.0]), Some((8.0, at(-1.0, 0.0, 3.0), -x)));
    assert_eq!(hit(Object::Sphere, [1.0, 3.0, 1.0, 0.0]), Some((2.0, at(3.0, 0.0, 3.0), x)), "from inside");
    assert_eq!(hit(Object::Sphere, [-1.0, 0.0, 0.0, 1.0]), Some((3.0, at(-1.0, 0.0, 3.0), -x)), "a tangent");
    assert_eq!(hit(Object::Cylinder, [1.0, 10.0, 0.0, -2.0]), Some((1.5, at(1.0, 0.0, 7.0), z)), "its cap");
    assert_eq!(hit(Object::Cylinder, [9.0, 4.0, -2.0, 0.0]), Some((3.0, at(3.0, 0.0, 4.0), x)), "its wall");
    assert_eq!(hit(Object::Cone, [1.0, 10.0, 0.0, -2.0]), Some((1.5, at(1.0, 0.0, 7.0), z)), "its apex");
    assert_eq!(hit(Object::Cone, [1.0, -9.0, 0.0, 1.0]), Some((12.0, at(1.0, 0.0, 3.0), -z)), "its base");
    assert_eq!(hit(Object::Plane, [-9.0, 5.0, 1.0, -1.0]), Some((2.0, at(-7.0, 0.0, 3.0), z)));
    assert_eq!(hit(Object::Triangle, [3.0, 5.0, 0.0, -1.0]), Some((2.0, at(3.0, 0.0, 3.0), z)), "its corner");
    assert_eq!(hit(Object::Triangle, [3.0_f64.next_up(), 5.0, 0.0, -1.0]), None);
}

/// By hand, with 3-4-5: where rays that go along no axis meet what was made larger in all directions, in the object's own
/// space. p is a few roundings from the quotient, each below half a unit of the last digit of 1.
#[test]
fn slanted_rays_meet_the_unit_object() {
    for (object, size, from, along, place) in [
        (Object::Cylinder, 5.0, [-12.0, 1.0, -1.0], [4.0, 1.0, 1.0], [-4.0, 3.0, 1.0]),
        (Object::Cylinder, 5.0, [1.0, 2.0, 9.0], [1.0, -1.0, -2.0], [3.0, 0.0, 5.0]),
        (Object::Cone, 4.0, [-1.0, 1.0, -4.0], [1.0, -0.5, 2.0], [1.0, 0.0, 0.0]),
        (Object::Cone, 20.0, [9.0, 12.0, 8.0], [-3.0, -4.0, 1.0], [3.0, 4.0, 10.0]),
        (Object::Sphere, 3.0, [-3.0, 4.0, 3.0], [1.0, -1.0, -2.0], [-1.0, 2.0, -1.0]),
        (Object::Plane, 2.0, [1.0, -2.0, 6.0], [0.5, 2.0, -3.0], [2.0, 2.0, 0.0]),
        (Object::Triangle, 8.0, [1.0, 0.0, 6.0], [0.5, 1.0, -3.0], [2.0, 2.0, 0.0]),
    ] {
        let larger = [[size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size]];
        let deformed = deformed(object, larger, [0.0; 3]);
        let ray = Ray3::<f64>::new(from.into(), along.into());
        let found = robust(&ray, &deformed).found(Span::ahead()).unwrap().unwrap();
        if object != Object::Sphere {
            assert_eq!(found.lambda, 2.0, "{} from {from:?}", object.name());
            let off = found.p - DVec3::from(place) / size;
            assert!(off.abs().max_element() <= 4.0 * f64::EPSILON, "{}: {}", object.name(), found.p);
        } else {
            let off = (found.p.length() - 1.0).abs();
            assert!(off <= 4.0 * f64::EPSILON, "{}", found.p);
        }
    }
}

/// By hand: chords of what was made larger, from λ = 1 to 2. The far end is worked out exactly, and p is
/// rounded twice. Of the cylinder the middle of the chord is above z = 0 with its far end, below it with
/// it, or on the other side.
#[test]
fn slanted_rays_leave_the_unit_object() {
    for (object, size, from, along, place) in [
        (Object::Cylinder, 5.0, [-11.0, 2.0, 0.0], [7.0, 1.0, 1.0], [3.0, 4.0, 2.0]),
        (Object::Cylinder, 5.0, [-11.0, 2.0, 0.0], [7.0, 1.0, -1.0], [3.0, 4.0, -2.0]),
        (Object::Cylinder, 5.0, [-11.0, 2.0, -5.0], [7.0, 1.0, 3.0], [3.0, 4.0, 1.0]),
        (Object::Cone, 20.0, [-6.0, 0.0, 16.0], [3.0, 4.0, -6.0], [0.0, 8.0, 4.0]),
        (Object::Cone, 20.0, [3.0, 12.0, -2.0], [-3.0, -4.0, 6.0], [-3.0, 4.0, 10.0]),
        (Object::Sphere, 3.0, [-4.0, 3.0, -6.0], [3.0, -1.0, 4.0], [2.0, 1.0, 2.0]),
    ] {
        let larger = [[size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size]];
        let deformed = deformed(object, larger, [0.0; 3]);
        let ray = Ray3::<f64>::new(from.into(), along.into());
        let beyond = Span::new(1.5, f64::INFINITY);
        let found = robust(&ray, &deformed).found(beyond).unwrap().unwrap();
        assert_eq!(found.lambda, 2.0, "{} from {from:?}", object.name());
        let off = found.p - DVec3::from(place) / size;
        assert!(off.abs().max_element() <= f64::EPSILON, "{}: {}", object.name(), found.p);
        // from there it starts on the surface
        let on_surface = Ray3::<f64>::new(place.into(), along.into());
        let starts = robust(&on_surface, &deformed).found(Span::ahead()).unwrap().unwrap();
        let off = starts.p - DVec3::from(place) / size;
        assert!(starts.lambda == 0.0 && off.abs().max_element() <= f64::EPSILON, "{}", starts.p);
    }
}

/// Level with a plane, or away from it: the signs alone say that nothing is met.
#[test]
fn level_with_a_plane_or_away_from_it_nothing_is_met() {
    for object in [Object::Plane, Object::Triangle] {
        let flat = deformed(object, IDENTITY, [0.0; 3]);
        for (height, slope) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 0.0), (1.0, 1.0), (-1.0, -1.0)] {
            let ray = Ray3::<f64>::new(DVec3::new(0.25, 0.25, height), DVec3::new(1.0, 0.0, slope));
            assert_eq!(robust(&ray, &flat).verdict, Verdict::Misses, "{height} {slope}");
        }
    }
}

/// The coordinates of a point are numbers though their sum is not: 2¹⁰²³ (1, 1, ½) on a sphere of radius 1.5 · 2¹⁰²³.
#[test]
fn a_point_at_the_end_of_the_range_is_a_number() {
    let (end, radius) = (2.0_f64.powi(1023), 1.5 * 2.0_f64.powi(1023));
    let sphere =
        deformed(Object::Sphere, [[radius, 0.0, 0.0], [0.0, radius, 0.0], [0.0, 0.0, radius]], [0.0; 3]);
    let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::new(2.0, 2.0, 1.0));
    let point = robust(&ray, &sphere).hit(Span::ahead()).unwrap().unwrap().point;
    let off = point / end - DVec3::new(1.0, 1.0, 0.5);
    assert!(off.abs().max_element() <= 4.0 * f64::EPSILON, "{point}");
}

/// The same where λ is infinite, as the direction is that short.
#[test]
fn a_point_is_a_number_where_lambda_is_none() {
    let (end, radius) = (2.0_f64.powi(1023), 1.5 * 2.0_f64.powi(1023));
    let sphere =
        deformed(Object::Sphere, [[radius, 0.0, 0.0], [0.0, radius, 0.0], [0.0, 0.0, radius]], [0.0; 3]);
    let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::new(2.0, 2.0, 1.0) / 1024.0);
    let hit = robust(&ray, &sphere).hit(Span::ahead()).unwrap().unwrap();
    let off = hit.point / end - DVec3::new(1.0, 1.0, 0.5);
    assert!(hit.t.is_infinite() && off.abs().max_element() <= 4.0 * f64::EPSILON, "{hit:?}");
}

/// By hand: from 10¹⁶ away λ is a whole number and the point's y, −1, is lost in a + λ d. It is A r′ + t.
#[test]
fn a_point_is_added_up_from_the_smaller_vector() {
    let sphere = deformed(Object::Sphere, IDENTITY, [0.0; 3]);
    let hit = |y: f64| robust(&Ray3::<f64>::new(DVec3::Y * y, DVec3::Y), &sphere).hit(Span::ahead());
    assert_eq!(hit(-1e16).unwrap().unwrap().point, -DVec3::Y);
    // and from next to it a + λ d is: ½ away
    assert_eq!(hit(-1.5).unwrap().unwrap().point, -DVec3::Y);
}

/// By hand: of diag(±2, 3, 4) the adjugate is diag(12, ±8, ±6), and the determinant ±24.
#[test]
fn the_adjugate_has_the_sign_of_the_determinant_taken_out() {
    for side in [1.0, -1.0] {
        let rows = [[side * 2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 4.0]];
        let sphere = deformed(Object::Sphere, rows, [0.0; 3]);
        let worked = robust(&Ray3::<f64>::new(DVec3::ZERO, DVec3::X), &sphere);
        let adjugate = [[side * 12.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, 0.0, 6.0]];
        assert_eq!(worked.adjugate(), (adjugate, 24.0));
        // o″ × d″ = det A w
        let steps =
            robust(&Ray3::<f64>::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 0.0, 2.0)), &sphere).steps;
        let across = DVec3::from(steps.o).cross(DVec3::from(steps.d));
        assert_eq!(across, side * 24.0 * DVec3::from(steps.w), "{side}");
    }
}

/// By hand: (−1, 0, 2) + λ (1, 0, −2) runs along one slope of the cone, and meets the other in (−¼, 0, ½).
#[test]
fn along_one_slope_the_other_is_met_once() {
    let cone = deformed(Object::Cone, IDENTITY, [0.0; 3]);
    let hit = robust(&Ray3::<f64>::new(DVec3::new(-1.0, 0.0, 2.0), DVec3::new(1.0, 0.0, -2.0)), &cone);
    let hit = hit.hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point), (0.75, DVec3::new(-0.25, 0.0, 0.5)));
    // worked out to the end: A is zero there, and λ = C / 2 B
    let ray = Ray3::<f64>::new(DVec3::new(-1.0, 0.0, 2.0), DVec3::new(1.0, 0.0, -2.0));
    let wall = Place { part: Part::Wall, plane: None };
    let exact = ExactLine::of(&ray, &cone);
    assert_eq!(exact.line.lambda(Object::Cone, wall, true), Some(0.75_f64));
    let narrow = Deformed::<f32>::new(
        Object::Cone,
        Affine { a: Matrix3::from_rows(IDENTITY.map(|row| row.map(|x| x as f32))), t: glam::Vec3::ZERO },
    );
    let ray = Ray3::<f32>::new(glam::Vec3::new(-1.0, 0.0, 2.0), glam::Vec3::new(1.0, 0.0, -2.0));
    assert_eq!(robust(&ray, &narrow.unwrap()).hit(Span::ahead()).unwrap().unwrap().t, 0.75);
}

/// By hand: chords from λ = 1 to 2, one end of which is 2⁻³⁰ from the plane z = 0, or next to the cone's apex, of numbers
/// so long that no product of them is exact. Where they leave, all digits of z are right, or of x and y: nothing was lost
/// in a difference.
#[test]
fn where_a_chord_leaves_nothing_is_lost() {
    let [little, last, near] = [-30, -48, -24].map(|power| 2.0_f64.powi(power));
    let by_apex = [3.0 * near, 4.0 * near, 16.0 - 10.0 * near];
    for (object, size, enters, leaves) in [
        (Object::Cylinder, 5.0, [-4.0, 3.0, -4.0 + last], [3.0, 4.0, little]),
        (Object::Cylinder, 5.0, [-4.0, 3.0, little], [3.0, 4.0, 4.0 - last]),
        (Object::Cylinder, 5.0, [-4.0, 3.0, 4.0 - last], [3.0, 4.0, -little]),
        (Object::Cone, 16.0, [-3.0 + last, -4.0 - 2.0 * last, 0.0], by_apex),
        (Object::Cone, 16.0, [3.0 - last, 2.0 * last, 0.0], by_apex),
    ] {
        let larger = [[size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size]];
        let deformed = deformed(object, larger, [0.0; 3]);
        let (enters, leaves) = (DVec3::from(enters), DVec3::from(leaves));
        let ray = Ray3::<f64>::new(enters - (leaves - enters), leaves - enters);
        assert_eq!((ray.at(1.0), ray.at(2.0)), (enters, leaves), "no end of it was rounded");
        let found = robust(&ray, &deformed).found(Span::new(1.5, f64::INFINITY)).unwrap().unwrap();
        assert_eq!(found.lambda, 2.0, "{} {leaves}", object.name());
        let (off, most) = ((found.p - leaves / size).abs(), (leaves / size).abs() * (4.0 * f64::EPSILON));
        assert!(off.cmple(most).all(), "{} {off} {most}", object.name());
    }
}

/// A ray that starts on the surface and looks farther finds where it leaves.
#[test]
fn what_comes_too_early_is_passed_over() {
    let beyond = Span::new(1e-3, f64::INFINITY);
    for (object, from, leaves_at) in
        [(Object::Sphere, -1.0, 2.0), (Object::Cylinder, -1.0, 2.0), (Object::Cone, 0.0, 1.0)]
    {
        let deformed = deformed(object, IDENTITY, [0.0; 3]);
        let inward = Ray3::new(DVec3::new(0.0, 0.0, from), DVec3::Z);
        assert_eq!(robust(&inward, &deformed).hit(Span::ahead()).unwrap().unwrap().t, 0.0);
        let hit = robust(&inward, &deformed).hit(beyond).unwrap().unwrap();
        assert_eq!((hit.t, hit.normal), (leaves_at, DVec3::Z), "{}", object.name());
        let outward = Ray3::new(DVec3::new(0.0, 0.0, from), -DVec3::Z);
        assert_eq!(robust(&outward, &deformed).hit(beyond).unwrap(), None);
    }
    let plane = deformed(Object::Plane, IDENTITY, [0.0; 3]);
    assert_eq!(robust(&Ray3::new(DVec3::ZERO, DVec3::Z), &plane).hit(beyond).unwrap(), None);
}

/// A tangent of whole numbers is one at every scale at which they are floats: det A of 1e900 or of 1e−900.
#[test]
fn a_tangent_is_a_tangent_at_every_scale() {
    for power in [-1000, -300, -40, 0, 40, 300, 1000] {
        let scale = 2.0_f64.powi(power);
        // by hand: the ray x = 3 touches the sphere of half axes 3, 2 and 5, mirrored or not
        for mirrored in [1.0, -1.0] {
            let rows = [[3.0 * scale, 0.0, 0.0], [0.0, mirrored * 2.0 * scale, 0.0], [0.0, 0.0, 5.0 * scale]];
            let sphere = deformed(Object::Sphere, rows, [0.0, 0.0, 8.0 * scale]);
            let hit = |x: f64| {
                robust(&Ray3::new(DVec3::new(x, 0.0, 0.0), DVec3::Z), &sphere).hit(Span::ahead()).unwrap()
            };
            let touching = hit(3.0 * scale).unwrap();
            assert_eq!((touching.t, touching.normal), (8.0 * scale, DVec3::X), "2^{power}");
            assert_eq!(touching.point, DVec3::new(3.0, 0.0, 8.0) * scale);
            assert_eq!(hit((3.0 * scale).next_up()), None);
            assert!(hit((3.0 * scale).next_down()).is_some());
        }
    }
}

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// By hand, with ε = 1e−72: in the object's own space the ray is (0, 0, −1) + λ (−½, 0, 1), along the cone's slope, and
/// touches its rim at (−½, 0, 0), where n is along (−2, 0, 1). A⁻ᵀ n is m with m · A e_x = −2, m · A e_y = 0 and
/// m · A e_z = 1: (0, −1, 0). In `f64` the form of the slope is nothing or anything.
#[test]
fn along_the_slope_of_a_cone_squashed_flat() {
    let rows = [[-2.0, -2.0, 0.0], [2.0, 0.0, -1.0], [2.0, -1e-72, -1.0]];
    let cone = deformed(Object::Cone, rows, [-2.0, 1.0, 1.0]);
    let ray = Ray3::new(DVec3::new(-2.0, 2.0, 2.0), DVec3::new(1.0, -2.0, -2.0));
    let hit = robust(&ray, &cone).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point, hit.normal), (1.0, DVec3::new(-1.0, 0.0, 0.0), -DVec3::Y));
}

/// By hand: x = −2 + 1 at λ = 2^600, where z = 0. The square of d_x vanishes.
#[test]
fn through_the_wall_all_but_along_the_axis() {
    let far = 2.0_f64.powi(600);
    let ray = Ray3::new(DVec3::new(-2.0, 0.0, -far), DVec3::new(1.0 / far, 0.0, 1.0));
    let cylinder = deformed(Object::Cylinder, IDENTITY, [0.0; 3]);
    let hit = robust(&ray, &cylinder).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point, hit.normal), (far, -DVec3::X, -DVec3::X));
}

/// By hand: −1 is 2 away, which is 2^1075 directions of 2^−1074; a plane at the largest number from beside its negative,
/// twice that number away.
#[test]
fn a_lambda_beyond_the_largest_number_has_a_point() {
    let infinite = f64::INFINITY;
    let sphere = deformed(Object::Sphere, IDENTITY, [0.0; 3]);
    let ray = Ray3::new(DVec3::new(-3.0, 0.0, 0.0), DVec3::X * f64::from_bits(1));
    let hit = robust(&ray, &sphere).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point, hit.normal), (infinite, -DVec3::X, -DVec3::X));

    let plane = deformed(Object::Plane, IDENTITY, [0.0, 0.0, f64::MAX]);
    let ray = Ray3::new(DVec3::new(3.0, 0.0, -f64::MAX), DVec3::Z);
    let hit = robust(&ray, &plane).hit(Span::ahead()).unwrap().unwrap();
    assert_eq!((hit.t, hit.point), (infinite, DVec3::new(3.0, 0.0, f64::MAX)));
}

/// λ is right to its last digit and the point of the same way had none: the sphere is met where x and y are of size 1 and
/// z is squashed to 1e−308.
#[test]
fn a_point_without_digits_is_worked_out_again() {
    let rows = [[-1.0, 0.0, 0.0], [0.0, -0.7, -1.0], [0.0, 1.0, 1.0]];
    let sphere = deformed(Object::Sphere, rows, [-f64::MIN_POSITIVE, 1.0, -f64::EPSILON]);
    let ray = Ray3::new(DVec3::new(0.8, -2.0, -f64::MIN_POSITIVE), DVec3::new(f64::EPSILON, 1.0, 0.0));
    let first = robust(&ray, &sphere).first.unwrap();
    assert!((DVec3::from(first.p).length() - 1.0).abs() < 1e-15, "{first:?}");
}

/// Each kind of number is used by the rays that it is for.
#[test]
fn three_kinds_of_number() {
    let rows = [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let sphere = deformed(Object::Sphere, rows, [0.0; 3]);
    let certainties = |x: f64| {
        let steps = robust(&Ray3::new(DVec3::new(x, 0.0, -8.0), DVec3::Z), &sphere).steps;
        (steps.certainty, steps.lambda_certainty)
    };
    assert_eq!(certainties(3.0), (Certainty::AtOnce, Certainty::AtOnce), "a clear miss");
    assert_eq!(certainties(0.7), (Certainty::AtOnce, Certainty::TwoPart), "a clear hit");
    assert_eq!(certainties(2.0 - 1e-15), (Certainty::TwoPart, Certainty::TwoPart), "next to a tangent");
}

/// A few cases of every regime, against the oracle: the verdict, and λ within a unit of its last digit.
#[cfg(feature = "stage")]
#[test]
fn right_in_every_regime() {
    assert_eq!(lab::first_beyond(&crate::stage::Affine, 2, 300, |_, _| 1), None);
}

/// The point is on the surface and the normal at right angles to it, whatever the condition: to 16 roundings of the
/// largest coordinate, and to 1e−12 of a radian.
#[cfg(feature = "stage")]
#[test]
fn point_and_normal_are_as_good_as_lambda() {
    use lab::Subject;
    use stage::Precision;

    let (subject, robust) = (crate::stage::Affine, 2);
    for regime in crate::regimes::regimes() {
        if ["parallel", "subnormal", "special", "bits"].contains(&regime.name) {
            continue; // no hits, or coordinates that have few digits or none
        }
        for case in regime.cases(4, Precision::F64).take(300) {
            let truth = subject.truth(case, Precision::F64);
            let lab::Truth::Hit { .. } = truth else { continue };
            let quality = subject.quality(robust, case, &truth).expect("a hit");
            assert!(quality.residual <= 8.0 * f64::EPSILON, "{}: {quality:?}; {case:?}", regime.name);
            assert!(quality.normal_angle.is_none_or(|angle| angle < 1e-12), "{}: {quality:?}", regime.name);
        }
    }
}

/// Which way the rays of every regime take, and how good it is: see [`lab::tally()`].
#[cfg(feature = "stage")]
#[test]
fn ways() {
    fn way<R: math::Real>(case: [f64; 19]) -> String {
        let (ray, object, affine) = crate::measure::question(case.map(R::round_from));
        let Ok(deformed) = Deformed::for_ray(&ray, object, affine) else { return "Degenerate".to_string() };
        let steps = robust(&ray, &deformed).steps;
        format!("{:?} {:?}", steps.certainty, steps.lambda_certainty)
    }
    insta::assert_snapshot!(lab::tally(&crate::stage::Affine, 2, 200, [way::<f32>, way::<f64>]));
}

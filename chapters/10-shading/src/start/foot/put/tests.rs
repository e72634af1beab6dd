//! Points put on surfaces by hand, and how far they may be off.

use super::*;
use affine::{Affine, Object};
use glam::DVec3;
use quadric::Shape as Solid;

/// What an operation in `f64` is off.
const U: f64 = 1.0 / (1u64 << 53) as f64;

fn on(shape: &Shape<f64>, p: [f64; 3], n: [f64; 3]) -> Put {
    Put::on(U, p, n, shape, None)
}

fn deformed(object: Object, rows: [[f64; 3]; 3], t: [f64; 3]) -> Shape<f64> {
    let affine = Affine { a: Matrix3::from_rows(rows), t: t.into() };
    Shape::Deformed(Box::new(Deformed::new(object, affine).unwrap()))
}

/// Each number has its say, and so has the normal's length.
#[test]
fn what_is_finite_is_so_throughout() {
    let put = Put { point: [1.0, 2.0, 3.0], normal: [0.0, 0.0, 1.0], error: 0.5 };
    assert!(put.is_finite());
    let lost = [f64::INFINITY, f64::NAN];
    assert!(lost.iter().all(|&error| !Put { error, ..put }.is_finite()));
    assert!(lost.iter().all(|&z| !Put { point: [1.0, 2.0, z], ..put }.is_finite()));
    assert!(lost.iter().all(|&z| !Put { normal: [0.0, 0.0, z], ..put }.is_finite()));
    assert!(!Put { normal: [0.0; 3], ..put }.is_finite());
}

/// By hand: (0, 3, 4)/5, of a normal whose square is larger than any number, or vanishes.
#[test]
fn a_normal_of_any_length_is_brought_to_one() {
    for size in [2.0_f64.powi(600), 1.0, 2.0_f64.powi(-600)] {
        let plane = ray_plane::Plane { point: DVec3::ZERO, normal: DVec3::new(0.0, 3.0, 4.0) * size };
        let put = on(&Shape::Plane(plane), [0.0; 3], [0.0, 0.6, 0.8]);
        assert_eq!(put, Put { point: [0.0; 3], normal: [0.0, 0.6, 0.8], error: 0.0 });
    }
}

/// A square that is no number is not divided by.
#[test]
fn a_normal_too_long_for_a_square_stays() {
    assert_eq!(unit_length([1e200, 0.0, 0.0]), [1e200, 0.0, 0.0]);
    assert_eq!(unit_length([0.0; 3]), [0.0; 3]);
    assert_eq!(unit_length([0.0, -4.0, 3.0]), [0.0, -0.8, 0.6]);
}

/// By hand: away from the axis to where the wall is 1 away from it, though the landing's normal goes elsewhere;
/// from the axis itself along that normal.
#[test]
fn a_point_goes_straight_away_from_the_axis_to_the_wall() {
    let wall = |p, n| {
        let put = on(&Shape::Solid(Solid::Cylinder), p, n);
        assert_eq!(put.error, 8.0 * U);
        (put.point, put.normal)
    };
    let aslant = [0.6, 0.8, 0.0];
    assert_eq!(wall([0.0, 2.0, 0.5], aslant), ([0.0, 1.0, 0.5], [0.0, 1.0, 0.0]));
    assert_eq!(wall([-2.0, 0.0, 0.5], aslant), ([-1.0, 0.0, 0.5], [-1.0, 0.0, 0.0]));
    assert_eq!(wall([0.0, 0.0, 0.5], [0.0, -1.0, 0.0]), ([0.0, -1.0, 0.5], [0.0, -1.0, 0.0]));
}

/// A cone's normal is 2 across the axis to 1 along it, a cap's nothing to 1. In the middle it is not a cap's.
#[test]
fn a_cap_is_where_the_normal_is_mostly_along_the_axis() {
    assert_eq!(cap_or_wall([0.25, -0.5, -1.0]), [0.0, 0.0, -1.0]);
    for wall in [[0.5, -0.5, -1.0], [1.0, -1.0, 1.0]] {
        assert_eq!(cap_or_wall(wall), wall);
    }
}

/// By hand: from 8 at the base to 4 at the height 8. At half the height the wall is 6 away from the axis, twice
/// as far as (3, 0, 4); ‖w⃗‖ = 5, so that the bound is 16u (5 · 2 + 8 + 4). It gets narrower by 1 for 2: the
/// normal is (2, 0, 1)/√5. There and here a root and a quotient are rounded, four times in all.
#[test]
fn a_foot_on_an_open_cone() {
    let cone = OpenCone::new(DVec3::ZERO, 8.0, DVec3::Z * 8.0, 4.0);
    let put = on(&Shape::OpenCone(cone), [3.0, 0.0, 4.0], [1.0, 0.0, 0.0]);
    assert_eq!((put.point, put.error), ([6.0, 0.0, 4.0], 16.0 * U * 22.0));
    let want = [2.0, 0.0, 1.0].map(|x: f64| x / 5.0_f64.sqrt());
    assert!((0..3).all(|axis| (put.normal[axis] - want[axis]).abs() <= 4.0 * U), "{:?}", put.normal);
}

/// By hand: at a tip the point stays, with the normal that it has. From the base to a tip at the height 8, with
/// the radius 2, the bound is 16u (8 + 2 + 0); at a tip that is the base it is 16u (0 + 0 + 2).
#[test]
fn at_the_tip_of_an_open_cone_a_point_stays() {
    let n = [0.6, 0.0, 0.8];
    for (tip, [r_b, r_a], error) in [([0.0, 0.0, 8.0], [2.0, 0.0], 10.0), ([0.0; 3], [0.0, 2.0], 2.0)] {
        let cone = OpenCone::new(DVec3::ZERO, r_b, DVec3::Z * 8.0, r_a);
        let put = on(&Shape::OpenCone(cone), tip, n);
        assert_eq!(put, Put { point: tip, normal: n, error: 16.0 * U * error });
    }
}

/// By hand, with δ = 2⁻²⁷: (1 + δ)² − 1 = 2δ + δ² is rounded to 2δ, so that A⁻¹ is too large by the factor 1 + δ/2, and
/// instead of x = y = ½ / (1 + δ/2) it has ½. A of that is (1 + δ/2, 1 + δ/2), and what is lost −δ/4: then
/// A (½ − δ/4) = 1 − δ²/4, which is 1. On z = 0 it is put as well.
#[test]
fn what_the_inverse_has_lost_is_found_again() {
    let diagonal = 1.0 + (2.0_f64).powi(-27);
    let rows = [[diagonal, 1.0, 0.0], [1.0, diagonal, 0.0], [0.0, 0.0, 1.0]];
    let put = on(&deformed(Object::Plane, rows, [0.0; 3]), [1.0, 1.0, 0.25], [0.0, 0.0, 1.0]);
    assert_eq!((put.point, put.normal), ([1.0, 1.0, 0.0], [0.0, 0.0, 1.0]));
}

/// By hand: beyond the middle the point is on the other side. Of a cylinder's wall its height is still right; of
/// a sphere the normal alone says where it is.
#[test]
fn beyond_the_middle_the_normal_says_where_the_point_is() {
    let as_it_is = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for (object, p, n, want) in [
        (Object::Cylinder, [-0.5, 0.0, 0.25], [1.0, 0.0, 0.0], [1.0, 0.0, 0.25]),
        (Object::Sphere, [0.0, 0.5, -0.25], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]),
    ] {
        let put = on(&deformed(object, as_it_is, [0.0; 3]), p, n);
        assert_eq!((put.point, put.normal), (want, n), "{object:?}");
    }
}

/// By hand: the columns (4, −3, 1) and (8, −6, 1) have the product (3, 4, 0), along which the third, (2, ½, 3),
/// is 8: so much is det A, and the normal of a cap (3, 4, 0)/5. x̄ = (½, −¼, 1⅛) is put to the height 1, and A
/// x̄ + t is (2 − 2 + 2 + 16, −1½ + 1½ + ½ − 8, ½ − ¼ + 3). The sizes of those are 22 and 11½ together, 3/5 and
/// 4/5 of which are 22.4: eight roundings of it, which are found to eight units of the last digit.
#[test]
fn the_bound_of_a_deformed_cap() {
    let rows = [[4.0, 8.0, 2.0], [-3.0, -6.0, 0.5], [1.0, 1.0, 3.0]];
    let cap = deformed(Object::Cylinder, rows, [16.0, -8.0, 0.0]);
    let put = on(&cap, [18.25, -7.4375, 3.625], [0.6, 0.8, 0.0]);
    assert_eq!(put.point, [18.0, -7.5, 3.25]);
    assert!((put.error / (8.0 * U * 22.4) - 1.0).abs() <= 8.0 * f64::EPSILON, "{}", put.error / U);
}

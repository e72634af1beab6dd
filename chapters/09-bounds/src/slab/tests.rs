//! No box is passed that a point of the ray is in.

use math::{TwoPart, Vector};

use super::*;
use crate::tests::Numbers;

/// A ray, a t that is not rounded, and the box around the point there, with a face through it.
fn through_a_face<R: Real>(numbers: &mut Numbers) -> (Ray3<R>, TwoPart, Box3) {
    let mut v = |power: i32| -> R::Vec3 {
        let [x, y, z] = [0, 1, 2].map(|_| R::round_from(numbers.around_zero(power)));
        R::vec3(x, y, z)
    };
    let (o, d, middle) = (v(6), v(6), v(6));
    let (ray, face) = (Ray3::<R>::new(o, d), rounded_down(middle.x().into()));
    let (o, d): ([f64; 3], [f64; 3]) = (o.in_f64(), d.in_f64());
    // exact but for 2^−100 of it
    let t = (TwoPart::from(f64::from(face)) - TwoPart::from(o[0])) / TwoPart::from(d[0]);
    let point = [0, 1, 2].map(|axis| TwoPart::from(o[axis]) + t * d[axis]);
    let mut bounds = Box3 {
        low: point.map(|x| rounded_down(x.hi.next_down())),
        high: point.map(|x| rounded_up(x.hi.next_up())),
    };
    // flat, or with more on one side of the face
    (bounds.low[0], bounds.high[0]) = match numbers.below(3) {
        0 => (face, face),
        1 => (face, face + numbers.unit() as f32),
        _ => (face - numbers.unit() as f32, face),
    };
    (ray, t, bounds)
}

fn assert_no_point_is_passed<R: Real>(seed: u64) {
    let mut numbers = Numbers(seed);
    let mut ahead = 0;
    for _ in 0..200_000 {
        let (ray, t, bounds) = through_a_face::<R>(&mut numbers);
        if t.hi < 0.0 || !t.hi.is_finite() {
            continue;
        }
        ahead += 1;
        let t = R::round_from(t.hi);
        let near = Slabs::new(&ray).enter(&bounds, Reach::of(Span::<R>::ahead()));
        assert!(near.is_some_and(|near| near <= t.into() as f32), "{near:?} {t:?} {ray:?} {bounds:?}");
        let there = Slabs::new(&ray).enter(&bounds, Reach::of(Span::new(t, t)));
        assert!(there.is_some(), "{t:?} {ray:?} {bounds:?}");
    }
    assert!(ahead > 50_000);
}

#[test]
fn a_point_on_a_face_is_in_the_box_for_rays_of_either_precision() {
    assert_no_point_is_passed::<f32>(1);
    assert_no_point_is_passed::<f64>(2);
}

/// A bound that lets everything pass would be no use: it is a few units of the last digit wide.
#[test]
fn a_box_that_is_missed_by_a_little_is_passed() {
    let (mut numbers, mut passed) = (Numbers(3), [0, 0]);
    for _ in 0..20_000 {
        let (ray, t, mut bounds) = through_a_face::<f32>(&mut numbers);
        let y = f64::from(ray.origin.y) + t.hi * f64::from(ray.direction.y);
        // beside the ray, by 2^−18 of the way that it went
        let way = y.abs().max(f64::from(ray.origin.y.abs())) * f64::from(64.0 * UNIT);
        bounds.low[1] = rounded_up(y + way);
        bounds.high[1] = f32::INFINITY;
        (bounds.low[0], bounds.high[0]) =
            (bounds.low[0].max(bounds.high[0]), bounds.low[0].max(bounds.high[0]));
        let is_flat = bounds.low[0] == bounds.high[0] && t.hi > 0.0;
        let near = Slabs::new(&ray).enter(&bounds, Reach::of(Span::<f32>::ahead()));
        passed[0] += usize::from(is_flat);
        passed[1] += usize::from(is_flat && near.is_none());
    }
    assert!(passed[1] * 10 > passed[0] * 7, "{passed:?}");
}

fn enters(origin: [f64; 3], direction: [f64; 3], low: [f32; 3], high: [f32; 3]) -> Option<f32> {
    let wide = Ray3::<f64>::new(origin.into(), direction.into());
    Slabs::new(&wide).enter(&Box3 { low, high }, Reach::of(Span::<f64>::ahead()))
}

#[test]
fn a_ray_along_a_face_an_edge_or_through_a_corner_is_in_the_box() {
    let (low, high) = ([-1.0; 3], [1.0; 3]);
    for zero in [0.0, -0.0] {
        for [y, z] in [[1.0, 0.0], [-1.0, 0.5], [1.0, 1.0], [1.0, -1.0], [0.0, 0.0]] {
            for (x, d) in [(-3.0, 1.0), (3.0, -2.0), (-1.0, 1.0), (1.0, 1.0), (-1.0, -1.0)] {
                let along = enters([x, y, z], [d, zero, zero], low, high);
                assert!(
                    along.is_some_and(|near| f64::from(near) <= (x.abs() - 1.0) / d.abs()),
                    "{x} {y} {z} {d}"
                );
            }
        }
        let beside = f64::from(1.0_f32.next_up());
        assert_eq!(enters([-3.0, beside, 0.0], [1.0, zero, zero], low, high), None);
        assert_eq!(enters([-3.0, -beside, 0.0], [1.0, zero, zero], low, high), None);
        assert_eq!(enters([3.0, 0.0, 0.0], [1.0, zero, zero], low, high), None, "behind");
    }
}

#[test]
fn infinite_faces_and_extreme_numbers() {
    let (low, high) = ([f32::NEG_INFINITY; 3], [f32::INFINITY; 3]);
    for d in [[1.0, 0.0, 0.0], [5e-324, -1e300, 0.0], [1e-40, 1e-40, 1e-40]] {
        for o in [[0.0; 3], [1e300, -1e300, 5.0], [f64::from(f32::MAX), 0.0, -1e-310]] {
            assert_eq!(enters(o, d, low, high), Some(0.0), "{o:?} {d:?}");
        }
    }
    // half a space: by hand, it is entered at t = 5
    let upper = enters([0.0, -5.0, 0.0], [0.0, 1.0, 0.0], [low[0], 0.0, low[2]], high);
    assert!(upper.is_some_and(|near| near <= 5.0 && near > 4.9999));
    // beside it for all of an endless way, it may be entered at infinity, but not before
    let beside = enters([0.0, -5.0, 0.0], [1.0, 0.0, 0.0], [low[0], 0.0, low[2]], high);
    assert!(beside.is_none_or(|near| near > f32::MAX / 2.0), "{beside:?}");
    // a t that is no f32 and one that is not even an f64
    assert!(enters([-1.0, 0.0, 0.0], [1e-60, 0.0, 0.0], [0.0; 3], [0.0; 3]).is_some());
    assert!(enters([-1e200, 0.0, 0.0], [1e-200, 0.0, 0.0], [0.0; 3], [0.0; 3]).is_some());
    // one that vanishes
    assert!(enters([-1e-300, 0.0, 0.0], [1e300, 0.0, 0.0], [0.0; 3], [0.0; 3]).is_some());
}

#[test]
fn a_reach_is_a_little_wider_than_its_span() {
    let reach = Reach::of(Span::<f32>::new(1.0, 2.0));
    // by hand: a unit of the last digit is at most 2⁻²³ of t, and twice 16 of them are 2⁻¹⁸
    assert_eq!(reach, Reach { min: 1.0 - 2.0_f32.powi(-18), max: 2.0 + 2.0_f32.powi(-17) });
    assert_eq!(Reach::of(Span::<f64>::ahead()), Reach { min: 0.0, max: f32::INFINITY });
    assert_eq!(Reach::of(Span::<f64>::new(-1.0, 5e-324)).min.to_bits(), 0);
}

/// By hand: u is 2⁻²⁴, so 1/d is 2⁻²² of itself too small where the ray enters, and as much too large where it leaves.
#[test]
fn the_slope_is_widened_by_four_units() {
    let slabs = Slabs::new(&Ray3::<f64>::new(f64::vec3(0.0, 0.0, 0.0), f64::vec3(1.0, -2.0, 4.0)));
    let widened = 2.0_f32.powi(-22);
    for (axis, inverse) in [1.0, -0.5, 0.25].into_iter().enumerate() {
        assert_eq!(slabs.enter[axis].inverse, inverse * (1.0 - widened));
        assert_eq!(slabs.leave[axis].inverse, inverse * (1.0 + widened));
        assert_eq!(slabs.first[axis], usize::from(inverse < 0.0));
    }
}

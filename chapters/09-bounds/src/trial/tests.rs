//! One ray along z, tried on spheres by hand.

use super::*;
use affine::Matrix3;
use glam::DVec3;
use math::glance::Around;
use math::{Camera, Grid, Handedness, Window};
use ray_sphere::Sphere;
use signature::{Object, Scene};

/// Spheres of radius 1 on the axis z, whose near sides are at these places.
fn balls<R: Real>(near: &[f64]) -> Scene<R> {
    let [zero, one] = [R::from(0.0), R::from(1.0)];
    let [origin, y, z] = [R::vec3(zero, zero, zero), R::vec3(zero, one, zero), R::vec3(zero, zero, one)];
    let window = Window { left: -one, right: one, bottom: -one, top: one };
    let camera = Camera::looking(origin, z, y, Handedness::Left, one, window).unwrap();
    let ball = |&near: &f64| Shape::Sphere(Sphere { center: z * R::round_from(near + 1.0), radius: one });
    let objects = near.iter().map(|near| Object { id: None, shape: ball(near) }).collect();
    Scene { camera, grid: Grid::Centers, size: (1, 1), objects }
}

/// What is nearest to the origin, and whether that was certain at a glance, of spheres that are tried in this order.
fn nearest(formulas: Method, near: &[f64], order: [usize; 2]) -> (usize, bool) {
    let scene = balls::<f64>(near);
    let parts = Parts::of(&scene);
    let query = Query::new(Ray3::new(DVec3::ZERO, DVec3::Z), Span::ahead());
    let trial = Trial::of(formulas, &parts);
    let mut tried = trial.begins(&parts, None, &query);
    for part in order {
        tried.on(part);
    }
    let (part, lambda) = tried.nearest().unwrap();
    assert!(lambda.is_none_or(|lambda| lambda == near[part]), "{near:?} {lambda:?}");
    (part, lambda.is_none())
}

/// By hand: 4 and 5 are told apart at a glance, 4 and the next number are not, nor are 4 and 4: the earlier part has it.
#[test]
fn lambda_is_worked_out_where_a_glance_does_not_tell() {
    let next = 4.0_f64.next_up().next_up();
    for (near, want, is_certain) in [
        ([4.0, 5.0], 0, true),
        ([5.0, 4.0], 1, true),
        ([4.0, next], 0, false),
        ([next, 4.0], 1, false),
        ([4.0; 2], 0, false),
    ] {
        for order in [[0, 1], [1, 0]] {
            assert_eq!(nearest(Method::Robust, &near, order), (want, is_certain), "{near:?} {order:?}");
            assert_eq!(nearest(Method::Notes, &near, order).0, want, "{near:?} {order:?}");
        }
    }
}

/// Whatever is within what it says may be nearer: rounded to `f32`, it is not below the end of a glance.
#[test]
fn what_is_certain_at_a_glance_reaches_as_far_as_it_may_be() {
    let scene = balls::<f32>(&[1.0]);
    let (parts, trial) = (Parts::of(&scene), Trial::Robust);
    let query = Query::new(Ray3::<f32>::new(glam::Vec3::ZERO, glam::Vec3::Z), Span::ahead());
    for place in 0..1000 {
        let around = Around { t: 1.0 + 0.001 * f64::from(place), off: 1e-9 };
        let mut tried = trial.begins(&parts, None, &query);
        let reach = tried.on_at_a_glance(0, Glance::Once(around)).unwrap();
        let (_, high) = around.range::<f32>();
        assert!(f64::from(reach) >= high && f64::from(reach) < high * (1.0 + 4.0 * f64::from(f32::EPSILON)));
    }
}

/// Carried by A⁻¹ (p̄ − t), the ray of the origin starts at −t: what is 6 before it was 4 before the origin.
#[test]
fn a_ray_is_carried_to_where_its_part_is() {
    let scene = balls::<f64>(&[4.0]);
    let parts = Parts::of(&scene);
    let query = Query::new(Ray3::new(DVec3::ZERO, DVec3::Z), Span::ahead());
    for formulas in Method::ALL {
        let trial = Trial::of(formulas, &parts);
        let by = Affine { a: Matrix3::identity(), t: DVec3::Z * 2.0 };
        let reach = trial.begins(&parts, Some(&by), &query).on(0).unwrap();
        assert!((6.0..6.001).contains(&reach), "{}: {reach}", formulas.name());
    }
}

/// By hand, a sphere that is hit at 4: not where the part's box begins at 4.5, and just so where it begins at 4, which is
/// (face − 0) · (1 − 2⁻²²), rounded.
#[test]
fn a_hit_of_the_notes_counts_in_the_parts_own_box() {
    let scene = balls::<f64>(&[4.0]);
    let parts = Parts::of(&scene);
    let query = Query::new(Ray3::new(DVec3::ZERO, DVec3::Z), Span::ahead());
    for (face, counts) in [(3.0, true), (4.0 * (1.0 + 2.0_f32.powi(-22)), true), (4.5, false), (7.0, false)] {
        let bounds = Box3 { low: [-1.0, -1.0, face], high: [1.0, 1.0, 8.0] };
        let trial = Trial::Notes(vec![Some(bounds)]);
        assert_eq!(trial.begins(&parts, None, &query).on(0), counts.then_some(4.0), "{face}");
    }
}

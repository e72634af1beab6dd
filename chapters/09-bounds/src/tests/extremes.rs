//! What would break a tree: everything in one place, nothing but faces, numbers at the ends of what there is.

use glam::{DVec3, Vec3};
use math::{Ray3, Real, Span};
use ray_sphere::Sphere;
use triangle::Triangle;

use super::{Numbers, assert_agree, assert_spheres_agree, assert_triangles_agree, sphere_boxes};
use crate::tree::build::MAX_DEPTH;
use crate::wide::Wide;
use crate::{Box3, Tree, Uncounted};

/// How deep the deepest leaf is.
fn depth(tree: &Tree) -> usize {
    let mut depths = vec![0; tree.nodes.len()];
    for (at, node) in tree.nodes.iter().enumerate().filter(|(_, node)| node.count == 0) {
        for child in [0, 1] {
            depths[node.first as usize + child] = depths[at] + 1;
        }
    }
    depths.into_iter().max().unwrap_or(0)
}

#[test]
fn a_hundred_thousand_objects_in_one_point() {
    const COUNT: usize = 100_000;
    let sphere = Sphere::<f64> { center: DVec3::new(1.0, 2.0, 3.0), radius: 0.5 };
    let boxes = sphere_boxes(&vec![sphere; COUNT]);
    let (tree, wide) = (Tree::build(&boxes), Wide::build(&boxes));
    // by hand: leaves of at most 4 after 15 halvings
    assert!(depth(&tree) <= 17, "{}", depth(&tree));
    let ray = Ray3::<f64>::new(DVec3::ZERO, sphere.center);
    let t = ray_sphere::robust(&ray, &sphere).hit(Span::ahead()).unwrap().unwrap().t;
    let test = |_, span: Span<f64>| Some(t).filter(|&t| span.contains(t));
    assert_eq!(tree.closest(&ray, Span::ahead(), &mut Uncounted, test), Some((0, t)), "the first of all");
    assert_eq!(wide.closest(&ray, Span::ahead(), &mut Uncounted, test), Some((0, t)));
    assert!(tree.any(&ray, Span::ahead(), &mut Uncounted, |_, _| true));
    let points = vec![Box3 { low: [1.0; 3], high: [1.0; 3] }; COUNT];
    assert!(depth(&Tree::build(&points)) <= 17);
}

/// Each twice as far as the one before: by cost, one of them at a time is taken off.
#[test]
fn a_tree_that_would_be_a_chain_is_not_too_deep() {
    let far = |place: i32| 2.0_f32.powi(place - 120);
    let spheres: Vec<Sphere<f32>> = (0..240)
        .flat_map(|place| (0..40).map(move |_| place))
        .map(|place| Sphere { center: Vec3::X * far(place), radius: far(place) / 16.0 })
        .collect();
    let tree = Tree::build(&sphere_boxes(&spheres));
    assert!((20..=MAX_DEPTH).contains(&depth(&tree)), "{}", depth(&tree));
    let rays: Vec<Ray3<f32>> = (0..240)
        .step_by(7)
        .map(|place| Ray3::new(Vec3::new(far(place), far(place), 0.0), Vec3::new(0.0, -1.0, 1e-3)))
        .collect();
    assert!(assert_spheres_agree(&spheres, &rays) > 30);
}

/// Squares of whole corners in planes across each axis, and rays along and across those planes.
fn squares<R: Real>() {
    let mut numbers = Numbers(1);
    let corner = |axis: usize, plane: i32, u: i32, v: i32| {
        let mut c = [R::from(0.0); 3];
        (c[axis], c[(axis + 1) % 3], c[(axis + 2) % 3]) =
            (R::from(plane as f32), R::from(u as f32), R::from(v as f32));
        R::vec3(c[0], c[1], c[2])
    };
    let mut triangles: Vec<Triangle<R>> = Vec::new();
    for axis in 0..3 {
        for (plane, u, v) in (0..3).flat_map(|p| (0..3).flat_map(move |u| (0..3).map(move |v| (p, u, v)))) {
            let [a, b, c, d] =
                [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)].map(|(u, v)| corner(axis, plane, u, v));
            triangles.extend([Triangle { p1: a, p2: b, p3: c }, Triangle { p1: a, p2: c, p3: d }]);
        }
    }
    let mut whole =
        |low: i32, high: i32| R::from((low + numbers.below((high - low + 1) as u64) as i32) as f32);
    let mut rays = Vec::new();
    for _ in 0..1500 {
        let origin = R::vec3(whole(-2, 5), whole(-2, 5), whole(-2, 5));
        let direction = R::vec3(whole(-1, 1), whole(-1, 1), whole(-1, 1));
        rays.push(Ray3::new(origin, direction));
    }
    assert!(assert_triangles_agree(&triangles, &rays) > 300);
}

#[test]
fn flat_boxes_and_rays_along_their_faces() {
    squares::<f64>();
    squares::<f32>();
}

/// The same scene at every scale of numbers, and with directions of every length.
fn scaled<R: Real>(powers: &[i32], lengths: &[i32]) {
    let mut numbers = Numbers(2);
    for &power in powers {
        let size = 2.0_f64.powi(power);
        let sphere = |_| Sphere {
            center: numbers.vector::<R>(3.0 * size),
            radius: R::round_from(size * (0.1 + 0.4 * numbers.unit())),
        };
        let spheres: Vec<Sphere<R>> = (0..60).map(sphere).collect();
        let triangle = |_| {
            let a = numbers.vector::<R>(3.0 * size);
            Triangle { p1: a, p2: a + numbers.vector::<R>(size), p3: a + numbers.vector::<R>(size) }
        };
        let triangles: Vec<Triangle<R>> = (0..60).map(triangle).collect();
        for &length in lengths {
            let length = 2.0_f64.powi(length);
            let ray = |_| Ray3::new(numbers.vector::<R>(4.0 * size), numbers.vector::<R>(length));
            let rays: Vec<Ray3<R>> = (0..30).map(ray).collect();
            assert_spheres_agree(&spheres, &rays);
            assert_triangles_agree(&triangles, &rays);
        }
    }
}

#[test]
fn huge_and_subnormal_numbers() {
    scaled::<f32>(&[-147, -140, -126, -60, 60, 120, 125], &[-148, -130, -60, 0, 60, 126]);
    scaled::<f64>(
        &[-1072, -1020, -200, -150, -126, 126, 150, 200, 1000, 1021],
        &[-1073, -500, -140, 0, 140, 500, 1022],
    );
}

/// Half-spaces, whose boxes are infinite, and one thing that is everywhere.
#[test]
fn infinite_boxes() {
    let mut numbers = Numbers(3);
    let faces: Vec<(usize, f32)> =
        (0..200).map(|_| (numbers.below(3) as usize, numbers.signed() as f32 * 3.0)).collect();
    let half_space = |&(axis, face): &(usize, f32)| {
        let mut bounds = Box3 { low: [f32::NEG_INFINITY; 3], high: [f32::INFINITY; 3] };
        bounds.low[axis] = face;
        bounds
    };
    let mut boxes: Vec<Box3> = faces.iter().map(half_space).collect();
    boxes.push(Box3 { low: [f32::NEG_INFINITY; 3], high: [f32::INFINITY; 3] });
    let rays: Vec<Ray3<f64>> =
        (0..500).map(|_| Ray3::new(numbers.vector::<f64>(4.0), numbers.vector::<f64>(1.0))).collect();
    // where the ray crosses the face; the last object is hit at t = 7
    let hits = assert_agree(&boxes, &rays, Span::ahead(), |index, ray, span| {
        let Some(&(axis, face)) = faces.get(index) else { return Some(7.0).filter(|&t| span.contains(t)) };
        let t = (f64::from(face) - ray.origin[axis]) / ray.direction[axis];
        Some(t + 0.0).filter(|&t| span.contains(t))
    });
    assert_eq!(hits, 500);
}

/// A ray without a direction, or with a NaN, is answered as if there were no tree.
#[test]
fn a_ray_that_is_none_is_left_to_the_test() {
    let sphere = Sphere::<f64> { center: DVec3::ZERO, radius: 1.0 };
    for bad in [DVec3::ZERO, DVec3::NAN, DVec3::new(f64::INFINITY, 0.0, 0.0)] {
        let rays = [Ray3::<f64>::new(DVec3::ZERO, bad), Ray3::new(bad, DVec3::X)];
        assert_agree(&sphere_boxes(&[sphere; 20]), &rays[..1], Span::ahead(), |_, ray, span| {
            ray_sphere::robust(ray, &sphere).hit(span).ok()?.map(|hit| hit.t)
        });
    }
}

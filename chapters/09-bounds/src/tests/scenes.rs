//! Scenes as they are drawn at random.

use math::{Ray3, Real, Span, Vector};
use ray_sphere::Sphere;
use triangle::mesh::ball::bumpy_ball;
use triangle::{Method, Triangle};

use super::{Numbers, assert_spheres_agree, assert_triangles_agree, found, in_turn};
use crate::Counts;
use crate::wide::{Instructions, WideMesh};

/// Rays from within and from without, some of them along axes.
fn rays<R: Real>(numbers: &mut Numbers, count: usize) -> Vec<Ray3<R>> {
    let ray = |_| Ray3::new(numbers.vector::<R>(4.0), numbers.vector::<R>(1.0));
    (0..count).map(ray).collect()
}

fn spheres<R: Real>(seed: u64) {
    let mut numbers = Numbers(seed);
    for count in [1, 2, 9, 300] {
        let sphere = |_| Sphere {
            center: numbers.vector::<R>(3.0),
            radius: R::round_from(0.5 * 2.0_f64.powi(-(numbers.below(8) as i32))),
        };
        let spheres: Vec<Sphere<R>> = (0..count).map(sphere).collect();
        let hits = assert_spheres_agree(&spheres, &rays(&mut numbers, 600));
        assert!(count < 300 || hits > 100, "{hits}");
    }
}

#[test]
fn spheres_of_many_sizes() {
    spheres::<f64>(1);
    spheres::<f32>(2);
}

/// Triangles of many sizes; some are flat along an axis, share corners, are there twice or have no area.
fn drawn<R: Real>(numbers: &mut Numbers, count: usize) -> Vec<Triangle<R>> {
    let mut triangles: Vec<Triangle<R>> = Vec::new();
    for _ in 0..count {
        let size = 2.0_f64.powi(1 - numbers.below(5) as i32);
        let a = numbers.vector::<R>(3.0);
        let mut triangle =
            Triangle { p1: a, p2: a + numbers.vector::<R>(size), p3: a + numbers.vector::<R>(size) };
        match (numbers.below(8), triangles.last()) {
            (0, Some(&last)) => triangle = last,
            (1, Some(last)) => (triangle.p1, triangle.p2) = (last.p2, last.p3),
            (2, _) => triangle.p3 = triangle.p2,
            _ => {}
        }
        triangles.push(triangle);
    }
    triangles
}

fn triangles<R: Real>(seed: u64) {
    let mut numbers = Numbers(seed);
    for count in [1, 7, 9, 300] {
        let triangles = drawn::<R>(&mut numbers, count);
        let mut rays = rays(&mut numbers, 400);
        // and at corners and edges
        for _ in 0..400 {
            let Triangle { p1: a, p2: b, .. } = triangles[numbers.below(count as u64) as usize];
            let origin = numbers.vector::<R>(4.0);
            let share = R::round_from(numbers.unit());
            let target = if numbers.below(2) == 0 { a } else { a + (b - a) * share };
            rays.push(Ray3::new(origin, target - origin));
        }
        let hits = assert_triangles_agree(&triangles, &rays);
        assert!(count < 300 || hits > 300, "{hits}");
    }
}

#[test]
fn triangles_of_many_sizes() {
    triangles::<f64>(3);
    triangles::<f32>(4);
}

/// From inside a closed mesh at its edges: by `robust` no ray slips out, by `matrix` as many as do without a
/// tree.
fn ball<R: Real>(seed: u64) {
    let mut numbers = Numbers(seed);
    let mesh = bumpy_ball::<R>(3, [0.0; 3]);
    let best = WideMesh::of_mesh(&mesh);
    let base = best.clone().with(Instructions::Baseline);
    let (mut leaks, mut slipped) = (0, 0);
    for _ in 0..2000 {
        let origin = [0, 1, 2].map(|_| R::round_from(0.3 * numbers.signed()));
        let origin = R::vec3(origin[0], origin[1], origin[2]);
        let [from, to, _] = mesh.triangle(numbers.below(mesh.faces().len() as u64) as usize).corners();
        let target = from + (to - from) * R::round_from(numbers.unit());
        let ray = Ray3::<R>::new(origin, target - origin);
        for method in [Method::Robust, Method::Matrix, Method::HalfPlanes] {
            let expected = in_turn(mesh.faces().len(), Span::ahead(), |face, span| {
                method.work(&ray, &mesh.triangle(face)).hit(span).ok()?.map(|hit| hit.t)
            });
            let mut counts = [Counts::default(); 2];
            let by_base = base.closest(method, &ray, Span::ahead(), &mut counts[0]);
            let by_best = best.closest(method, &ray, Span::ahead(), &mut counts[1]);
            assert_eq!((found(by_base), counts[0]), (found(by_best), counts[1]));
            assert_eq!(found(by_best), expected, "{} {ray:?}", method.name());
            leaks += usize::from(method == Method::Robust && expected.is_none());
            slipped += usize::from(method == Method::Matrix && expected.is_none());
        }
    }
    assert_eq!(leaks, 0);
    assert!(slipped > 20, "{slipped}");
}

#[test]
fn a_closed_mesh_has_no_way_out_and_the_page_s_matrix_the_same_holes() {
    ball::<f64>(5);
    ball::<f32>(6);
}

/// A tree tests a few objects of many, and a wider one opens more boxes at once.
#[test]
fn few_are_tested() {
    let mesh = bumpy_ball::<f64>(5, [0.0; 3]);
    let wide = WideMesh::of_mesh(&mesh);
    let mut numbers = Numbers(7);
    let mut counts = Counts::default();
    for _ in 0..100 {
        let ray = Ray3::<f64>::new(numbers.vector::<f64>(3.0), -numbers.vector::<f64>(1.0));
        if !ray.direction.is_zero() {
            wide.closest(Method::Robust, &ray, Span::ahead(), &mut counts);
        }
    }
    assert!(mesh.faces().len() == 8192 && counts.tests < 100 * 60 && counts.boxes < 100 * 200, "{counts:?}");
    assert!(counts.hits <= counts.tests);
}

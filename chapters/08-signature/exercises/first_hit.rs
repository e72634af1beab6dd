//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Camera, Grid, Handedness, Ray3, Span, Window};
use ray_plane::Plane;
use ray_sphere::Sphere;

use crate::first_hit::first_hit;
use crate::{Method, Object, Scene, Shape};

/// The signature of two spheres and a wall at z = `wall`, from the origin along z.
pub fn probe(case: &Case, steps: &mut Steps) {
    let sphere = |number| {
        let center = case.point(&format!("c{number}")).into();
        let radius = case.number(&format!("r{number}"));
        Object { id: Some(number), shape: Shape::Sphere(Sphere { center, radius }) }
    };
    let (origin, forward, up) = ([0.0; 3].into(), [0.0, 0.0, 1.0].into(), [0.0, 1.0, 0.0].into());
    let wall = Plane { point: [0.0, 0.0, case.number("wall")].into(), normal: forward };
    let wall = Object { id: Some(3), shape: Shape::Plane(wall) };
    let objects = vec![sphere(1), sphere(2), wall];

    let ahead = Ray3::<f64>::new(origin, forward);
    for count in 1..=objects.len() {
        let after = format!("straight ahead, after object {count}");
        let first = first_hit(Method::Robust, &ahead, &objects[..count], Span::ahead());
        steps.maybe("λ_ij", &after, first.map(|it| it.lambda), "∞");
        if let Some(first) = first {
            steps.text("objID", &after, first.object + 1);
        }
    }

    let window = Window { left: -2.0, right: 2.0, bottom: -1.0, top: 1.0 };
    let camera = Camera::looking(origin, forward, up, Handedness::Left, 2.0, window);
    let camera = camera.expect("it looks along z");
    let scene = Scene { camera, grid: Grid::Centers, size: (8, 4), objects };
    for row in 0..scene.size.1 {
        let seen = |col| match scene.seen(Method::Robust, (col, row)) {
            Some(object) => (object + 1).to_string(),
            None => "·".to_string(),
        };
        let seen: Vec<String> = (0..scene.size.0).map(seen).collect();
        steps.text(&format!("sig, row {row}"), "the first object that each pixel sees", seen.join(" "));
    }
}

//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::Ray3;
use ray_sphere::Sphere;

use crate::trace_ray::trace_ray;
use crate::{Method, Object, Shape};

/// What `TraceRay` remembers after each of three spheres, of the ray `o`, `d` from `t_min` to `t_max`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let ray = Ray3::<f64>::new(case.point("o").into(), case.point("d").into());
    let range = [case.number("t_min"), case.number("t_max")];
    let spheres = [1, 2, 3].map(|number| {
        let center = case.point(&format!("c{number}")).into();
        let radius = case.number(&format!("r{number}"));
        Object { id: Some(number), shape: Shape::Sphere(Sphere { center, radius }) }
    });
    for count in 1..=spheres.len() {
        let after = format!("after sphere {count}");
        match trace_ray(Method::Robust, &ray, &spheres[..count], range) {
            Some(closest) => steps.number("closest_t", &after, closest.lambda).text(
                "closest_sphere",
                &after,
                format!("sphere {}", closest.object + 1),
            ),
            None => steps.text("closest_t", &after, "inf").text("closest_sphere", &after, "NULL"),
        };
    }
}

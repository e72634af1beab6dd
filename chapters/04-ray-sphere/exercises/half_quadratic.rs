//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::Ray3;

use crate::{Sphere, half_quadratic::half_quadratic};

/// CSC418's method for the ray `a`, `d` and the sphere `c`, `r`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let ray = Ray3::<f64>::new(case.point("a").into(), case.point("d").into());
    let sphere = Sphere::<f64> { center: case.point("c").into(), radius: case.number("r") };
    let work = half_quadratic(&ray, &sphere);
    steps
        .number("A", "with λ²", work.a)
        .number("B", "half of what stands with λ", work.b)
        .number("C", "by itself", work.c)
        .number("D", "under the root", work.d)
        .maybe("λ1", "the larger root", work.lambda_1, "none: a miss");
    let Some(lambda_2) = work.lambda_2 else { return };
    steps.number("λ2", "the smaller root", lambda_2);
    let case = work.visibility().map_or("none", |case| case.meaning());
    steps.text("so", "by their signs", case);
}

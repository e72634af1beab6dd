//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Ray3, Span};

use crate::{Sphere, quadratic::quadratic};

/// Gambetta's method for the ray `o`, `d` and the sphere `c`, `r`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let ray = Ray3::<f64>::new(case.point("o").into(), case.point("d").into());
    let sphere = Sphere::<f64> { center: case.point("c").into(), radius: case.number("r") };
    let work = quadratic(&ray, &sphere);
    steps
        .vector("CO", "O − C", work.co)
        .number("a", "with t²", work.a)
        .number("b", "with t", work.b)
        .number("c", "by itself", work.c)
        .number("discriminant", "under the root", work.discriminant)
        .maybe("t1", "the larger solution", work.t1, "none: a miss");
    let Some(t2) = work.t2 else { return };
    steps.number("t2", "the smaller solution", t2);
    match work.hit(Span::ahead()) {
        Ok(Some(hit)) => steps.vector("P", "O + t D", hit.point),
        _ => steps.text("P", "O + t D", "none: it lies behind"),
    };
}

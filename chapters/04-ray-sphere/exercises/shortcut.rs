//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Ray3, Span};

use crate::{Sphere, shortcut::shortcut};

/// The scalar shortcut for the ray `p`, `d` and the sphere `c`, `r`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let ray = Ray3::<f64>::new(case.point("p").into(), case.point("d").into());
    let sphere = Sphere::<f64> { center: case.point("c").into(), radius: case.number("r") };
    let work = shortcut(&ray, &sphere);
    steps
        .vector("L", "c − p_r", work.l)
        .number("t_close", "how long L's shadow is on the ray", work.t_close)
        .number("d²", "of the center from the ray", work.d_squared)
        .number("a²", "of half the chord", work.a_squared)
        .maybe("a", "half the chord", work.a, "none: a miss");
    let Some(roots) = work.roots() else { return };
    steps.numbers("t", "enters, leaves", &[roots.near, roots.far]);
    match work.hit(Span::ahead()) {
        Ok(Some(hit)) => steps.vector("x_hit", "p_r + t D", hit.point),
        _ => steps.text("x_hit", "p_r + t D", "none: it lies behind"),
    };
}

//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Ray3, Span};

use crate::{Sphere, closest_approach::closest_approach};

/// House's method for the ray `o`, `d` and the sphere `c`, `r`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let ray = Ray3::<f64>::new(case.point("o").into(), case.point("d").into());
    let sphere = Sphere::<f64> { center: case.point("c").into(), radius: case.number("r") };
    let work = closest_approach(&ray, &sphere);
    steps
        .vector("u_r", "D / ‖D‖", work.u_r)
        .number("t_close", "the shadow of c − p_r on the ray", work.t_close)
        .vector("x_close", "p_r + t_close u_r", work.x_close)
        .number("d", "‖x_close − c‖", work.d)
        .maybe("a", "from x_close to the surface", work.a, "none: a miss");
    let Some(distances) = work.distances() else { return };
    steps.numbers("t", "enters, leaves", &[distances.near, distances.far]);
    match work.hit(Span::ahead()) {
        Ok(Some(hit)) => steps.vector("x_hit", "p_r + t u_r", hit.point),
        _ => steps.text("x_hit", "p_r + t u_r", "none: it lies behind"),
    };
}

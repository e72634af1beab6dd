//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Parallel, Ray3, Span};

use crate::{Meeting, Plane, notes::notes};

/// The ray `p`, `u` and the plane through `p0` with the normal `n`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let ray = Ray3::<f64>::new(case.point("p").into(), case.point("u").into());
    let plane = Plane::<f64> { point: case.point("p0").into(), normal: case.point("n").into() };
    let work = notes(&ray, &plane);
    steps
        .vector("from_plane", "from p_0 to p_r", work.from_plane)
        .number("n_dot_p", "how far p_r is above the plane, times ‖n‖", work.n_dot_p)
        .number("n_dot_u", "how fast the ray leaves it, times ‖n‖", work.n_dot_u);
    match work.meeting() {
        Meeting::At(t) if t.is_infinite() => steps.text("t", "Eq. 4.2", "infinite"),
        Meeting::At(t) => steps.number("t", "Eq. 4.2", t),
        Meeting::Never(Parallel::Apart) => steps.text("t", "Eq. 4.2", "none: parallel, apart"),
        Meeting::Never(Parallel::Within) => steps.text("t", "Eq. 4.2", "none: parallel, within"),
    };
    match work.hit(Span::ahead()) {
        Ok(Some(hit)) => steps.vector("x_hit", "p_r + t u_r", hit.point),
        _ => steps.text("x_hit", "p_r + t u_r", "none: a miss"),
    };
}

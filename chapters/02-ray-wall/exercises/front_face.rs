//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::Ray2;

use crate::{Wall, notes::notes};

/// The ray `p`, `u` and the faces of the wall from `front` to `back`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let ray = Ray2::<f64>::new(case.point2("p").into(), case.point2("u").into());
    let wall = Wall::<f64> { front: case.number("front"), back: case.number("back") };
    let work = notes(&ray, &wall);
    let [front, back] = [work.t_front, work.t_back].map(|t| ray.at(t));
    steps
        .number("t_front", "where x is front", work.t_front)
        .number("t_back", "where x is back", work.t_back)
        .numbers("x(t_front)", "p_r + t_front u_r", &[front.x, front.y])
        .numbers("x(t_back)", "p_r + t_back u_r", &[back.x, back.y]);
}

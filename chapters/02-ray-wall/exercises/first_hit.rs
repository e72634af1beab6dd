//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Ray2, Span};

use crate::{Crossing, Wall, notes::notes};

/// What the ray `p`, `u` hits of the wall from `front` to `back`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let ray = Ray2::<f64>::new(case.point2("p").into(), case.point2("u").into());
    let wall = Wall::<f64> { front: case.number("front"), back: case.number("back") };
    let work = notes(&ray, &wall);
    match work.crossing() {
        Crossing::Through(roots) => steps.numbers("t", "enters, leaves", &[roots.near, roots.far]),
        Crossing::Along(_) => steps.text("t", "enters, leaves", "neither: it runs along the wall"),
    };
    let hit = work.hit(Span::ahead()).ok().flatten();
    steps.maybe("t_hit", "the first one ahead", hit.map(|hit| hit.t), "none: a miss");
    if let Some(hit) = hit {
        steps.numbers("n", "out of the wall", &[hit.normal.x, hit.normal.y]);
    }
}

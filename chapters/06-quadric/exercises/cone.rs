//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Ray3, Span};

use crate::notes::{Test, notes};
use crate::{Part, Shape};

/// The unit cone and the ray `a`, `d`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let work = notes(&Ray3::<f64>::new(case.point("a").into(), case.point("d").into()), Shape::Cone);
    steps.number("A", "what is before λ²", work.a).number("B", "half of what is before λ", work.b).number(
        "C",
        "what is left",
        work.c,
    );
    let on = |part: Part| work.candidates().iter().filter(move |candidate| candidate.part == part);
    let mut walls: Vec<f64> = on(Part::Wall).filter_map(|candidate| candidate.lambda).collect();
    walls.sort_by(f64::total_cmp);
    if walls.is_empty() {
        steps.text("λ wall", "(−B ± √D) / A", "none");
    } else {
        steps.numbers("λ wall", "(−B ± √D) / A", &walls);
    }
    for base in on(Part::Base) {
        steps.maybe("λ base", "where z = 0", base.lambda, "none: the ray is level");
        if base.lambda.is_some() {
            let meaning = if base.test == Test::OnSurface { "on the base" } else { "beyond the rim" };
            steps.text("point", "of the base?", meaning);
        }
    }
    match work.hit(Span::ahead()) {
        Ok(Some(hit)) => steps.number("λ*", "the nearest", hit.t).vector("p(λ*)", "a + λ* d", hit.point),
        _ => steps.text("λ*", "the nearest", "none: a miss"),
    };
}

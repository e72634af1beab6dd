//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Ray3, Real};

use crate::notes::{Test, notes};
use crate::{Part, Shape};

/// The wall of the unit cylinder and the ray `a`, `d`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let work = notes(&Ray3::<f64>::new(case.point("a").into(), case.point("d").into()), Shape::Cylinder);
    steps
        .number("A", "what is before λ²", work.a)
        .number("B", "half of what is before λ", work.b)
        .number("C", "what is left", work.c)
        .number("D", "the discriminant", work.d);
    let mut met: Vec<(f64, f64, Test)> = Vec::new();
    for candidate in work.candidates().iter().filter(|candidate| candidate.part == Part::Wall) {
        met.extend(candidate.lambda.map(|lambda| (lambda, f64::xyz(candidate.point)[2], candidate.test)));
    }
    met.sort_by(|one, other| one.0.total_cmp(&other.0));
    if met.is_empty() {
        steps.text("λ", "the solutions", "none: a miss");
        return;
    }
    steps.numbers("λ", "the solutions", &met.iter().map(|&(lambda, ..)| lambda).collect::<Vec<_>>());
    for (_, z, test) in met {
        let meaning = if test == Test::OnSurface { "on the cylinder" } else { "above or below it" };
        steps.number("z", "of a + λ d", z).text("point", "one of the cylinder?", meaning);
    }
}

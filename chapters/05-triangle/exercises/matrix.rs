//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Ray3, Span};

use crate::{Triangle, matrix::matrix};

/// The second way for the ray `a`, `d` and the triangle `p1`, `p2`, `p3`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let [a, d, p1, p2, p3] = ["a", "d", "p1", "p2", "p3"].map(|name| case.point(name).into());
    let work = matrix(&Ray3::<f64>::new(a, d), &Triangle { p1, p2, p3 });
    steps
        .vector("M_α", "the column of α", work.m[0])
        .vector("M_β", "the column of β", work.m[1])
        .vector("M_λ", "the column of λ", work.m[2])
        .vector("right", "p̄1 − ā", work.to_p1)
        .number("det", "of M", work.det)
        .number("det_α", "the determinant for α", work.det_alpha)
        .number("det_β", "the determinant for β", work.det_beta)
        .number("det_λ", "the determinant for λ", work.det_lambda);
    if work.parallel().is_some() {
        steps.text("α, β, λ", "the solution", "none: the ray runs along the plane");
        return;
    }
    steps.numbers("α, β, λ", "the solution", &[work.alpha, work.beta, work.lambda]).text(
        "point",
        "in the triangle?",
        if work.is_inside() { "inside" } else { "outside" },
    );
    match work.hit(Span::ahead()) {
        Ok(Some(hit)) => steps.vector("hit", "ā + λ d", hit.point),
        _ => steps.text("hit", "ā + λ d", "none"),
    };
}

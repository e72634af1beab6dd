//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::Ray3;

use crate::{Triangle, half_planes::half_planes};

/// The first way for the ray `a`, `d` and the triangle `p1`, `p2`, `p3`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let [a, d, p1, p2, p3] = ["a", "d", "p1", "p2", "p3"].map(|name| case.point(name).into());
    let work = half_planes(&Ray3::<f64>::new(a, d), &Triangle { p1, p2, p3 });
    steps
        .vector("n", "(p̄2 − p̄1) × (p̄3 − p̄1)", work.n)
        .number("λ*", "(p̄1 − ā) · n / d · n", work.lambda)
        .vector("x", "ā + λ* d", work.x)
        .numbers("sides", "of p̄1 p̄2, of p̄2 p̄3, of p̄3 p̄1", &work.sides)
        .text("x is", "in which half-planes?", if work.is_inside() { "inside" } else { "outside" });
    match work.alpha_beta() {
        Some((alpha, beta)) => steps.numbers("α, β", "the shares of p̄2 and p̄3", &[alpha, beta]),
        None => steps.text("α, β", "the shares of p̄2 and p̄3", "none"),
    };
}

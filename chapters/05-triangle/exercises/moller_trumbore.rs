//! What is looked at, in the order of the method.

use exercise::{Case, Steps};
use math::{Ray3, Span};

use crate::{Triangle, moller_trumbore::moller_trumbore};

/// Möller and Trumbore's method for the ray `a`, `d` and the triangle `p1`, `p2`, `p3`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let [a, d, p1, p2, p3] = ["a", "d", "p1", "p2", "p3"].map(|name| case.point(name).into());
    let work = moller_trumbore(&Ray3::<f64>::new(a, d), &Triangle { p1, p2, p3 });
    steps
        .vector("e1", "p̄2 − p̄1", work.e1)
        .vector("e2", "p̄3 − p̄1", work.e2)
        .vector("s", "ā − p̄1", work.s)
        .vector("P", "d × e2", work.p)
        .vector("Q", "s × e1", work.q)
        .number("det", "of the three equations", work.det)
        .number("det_α", "the determinant for α", work.det_alpha)
        .number("det_β", "the determinant for β", work.det_beta)
        .number("det_λ", "the determinant for λ", work.det_lambda)
        .numbers("α, β, λ", "the solution", &work.solution());
    match work.hit(Span::ahead()) {
        Ok(Some(hit)) => {
            steps.number("t", "of the hit", hit.t).vector("x", "the point", hit.point).vector(
                "n",
                "the unit normal",
                hit.normal,
            );
        }
        _ => {
            steps.text("t", "of the hit", "none");
        }
    }
}

//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Ray3, Span};

use crate::notes::notes;
use crate::{Affine, Deformed, Matrix3, Object};

/// The unit sphere, deformed by the matrix with the rows `A1`, `A2`, `A3` and moved by `t`, and the ray `a`,
/// `d`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let a = Matrix3::<f64>::from_rows(["A1", "A2", "A3"].map(|row| case.point(row)));
    let ray = Ray3::new(case.point("a").into(), case.point("d").into());
    let Ok(deformed) = Deformed::new(Object::Sphere, Affine { a, t: case.point("t").into() }) else {
        steps.text("A⁻¹", "the inverse", "none");
        return;
    };
    let work = notes(&ray, &deformed);
    steps
        .vector("a − t", "before A⁻¹", work.a_minus_t)
        .vector("a′", "the origin in the sphere's space", work.ray_prime.origin)
        .vector("d′", "the direction there", work.ray_prime.direction);
    match work.undeformed.hit(Span::ahead()) {
        Some(hit) => {
            steps.number("λ*", "where ‖a′ + λ d′‖ = 1", hit.t).vector("r(λ*)", "a + λ* d", ray.at(hit.t))
        }
        None => steps.text("λ*", "where ‖a′ + λ d′‖ = 1", "none: a miss"),
    };
}

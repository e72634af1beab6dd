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
    let Ok(Some(found)) = notes(&ray, &deformed).found(Span::ahead()) else {
        steps.text("λ*", "the hit", "none");
        return;
    };
    steps
        .number("λ*", "the hit", found.lambda)
        .vector("n", "at p, on the sphere", found.n)
        .vector("A⁻ᵀ n", "at right angles to A v", found.a_inverse_transposed_n)
        .vector("normal", "the same with length 1", found.normal());
    let both = found.verify(&ray, &deformed);
    steps.vector("r(λ*)", "a + λ* d", both.along_the_ray).vector(
        "A p + t",
        "where p is sent",
        both.through_the_object,
    );
}

//! What is looked at, in the order of the page.

use exercise::{Case, Steps};

use crate::normal::{Smooth, by_gradient, by_tangents};

/// The normal at the point `p` of one of three surfaces: by the gradient (`way` 1) or by tangents (2).
pub fn probe(case: &Case, steps: &mut Steps) {
    let (shape, name) = match case.number("surface").round() as u32 {
        0 => (Smooth::Sphere, "0: the sphere"),
        1 => (Smooth::Cylinder, "1: the cylinder"),
        _ => (Smooth::Cone, "2: the cone"),
    };
    let p = case.point("p").into();
    steps.text("surface", "of the three", name);
    if case.number("way").round() == 1.0 {
        let work = by_gradient::<f64>(shape, p);
        steps.vector("∇f", "(∂f/∂x, ∂f/∂y, ∂f/∂z)", work.gradient).vector("n", "the unit normal", work.n);
    } else {
        let work = by_tangents::<f64>(shape, p);
        steps
            .vector("∂s/∂α", "the tangent along α", work.along_alpha)
            .vector("∂s/∂β", "the tangent along β", work.along_beta)
            .vector("n", "the outward unit normal", work.n);
    }
}

//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Real, Vector};

use crate::refract::refract;

/// A ray along `d` at a surface with the normal `n`, both of any length, from the index `n1` into `n2`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let unit = |name| -> <f64 as Real>::Vec3 { Vector::normalized(case.point(name).into()) };
    let work = refract::<f64>(unit("d"), unit("n"), case.number("n1"), case.number("n2"));
    steps
        .number("cos θ1", "the angle before", work.cos_theta1)
        .vector("tangent", "what of d goes along the surface", work.tangent)
        .number("sin² θ2", "by Snell's law", work.sin2_theta2);
    match work.t {
        Some(t) => steps.vector("t", "the refracted direction", t),
        None => steps.text("t", "the refracted direction", "none: total internal reflection"),
    };
}

//! What is looked at.

use exercise::{Case, Steps};
use math::{Real, Vector};
use ray_sphere::{Sphere, robust};
use signature::{Method, Shape};

use crate::{Landing, Start, Starts};

/// The ray from `p`, on its own ball, to the light `l`, with another ball `c`, `r` somewhere.
pub fn probe(case: &Case, steps: &mut Steps) {
    let point = |name| -> <f64 as Real>::Vec3 { case.point(name).into() };
    let (p, l) = (point("p"), point("l"));
    let own = Sphere::<f64> { center: point("own_c"), radius: case.number("own_r") };
    let other = Sphere::<f64> { center: point("c"), radius: case.number("r") };
    let normal = (p - own.center).normalized();
    let landing =
        Landing { object: 0, part: 0, lambda: 1.0, point: p, face_normal: normal, normal, alpha_beta: None };
    let starts = Starts::of(Start::None, Method::Robust, &Shape::Sphere(own), None, &landing);
    let query = starts.to(l, l - p);
    steps.vector("d", "toward the light", query.ray.direction);
    let met = |ball| robust(&query.ray, ball).hit(query.span).ok().flatten().map(|hit| hit.t);
    let (own, other) = (met(&own), met(&other));
    let in_shadow = own.or(other).is_some();
    steps
        .maybe("λ*", "on its own ball, on the way to the light", own, "none")
        .maybe("λ*", "on the other ball", other, "none")
        .text("V", "does p see the light?", if in_shadow { "0: it is in shadow" } else { "1: it does" });
}

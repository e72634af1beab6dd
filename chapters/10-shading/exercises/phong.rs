//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Real, Vector};

use crate::phong::phong;
use crate::{Material, Rgb};

/// What a light at `l` adds at the point `p` with the normal `n`, seen from `e`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let point = |name| -> <f64 as Real>::Vec3 { case.point(name).into() };
    let p = point("p");
    let (n, c) = (point("n").normalized(), (point("e") - p).normalized());
    let color = Rgb(case.point("C"));
    let [diffuse, specular, shininess] = ["r_d", "r_s", "alpha"].map(|name| case.number(name));
    let material = Material { color, ambient: 0.0, diffuse, specular, shininess };
    let light = phong::<f64>(&material, color, Rgb(case.point("I")), n, point("l") - p, c);
    steps
        .vector("s", "toward the light", light.s)
        .number("n·s", "its cosine with the normal", light.n_dot_s)
        .vector("m", "where a mirror would send the light", light.m)
        .number("c·m", "its cosine with the way to the eye", light.c_dot_m)
        .vector("diffuse", "r_d I C max(0, n·s)", light.diffuse.0)
        .vector("specular", "r_s I max(0, c·m)^α", light.specular.0);
}

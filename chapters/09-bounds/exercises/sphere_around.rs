//! What is looked at.

use exercise::{Case, Steps};

use crate::Box3;
use crate::around::sphere_around;

/// The sphere around the box from `low` to `high`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let [low, high] = ["low", "high"].map(|corner| case.point(corner).map(|x| x as f32));
    let Some(sphere) = sphere_around::<f64>(&Box3 { low, high }) else {
        steps.text("c", "the center", "none: it is no sphere");
        return;
    };
    let corners = (0..8).map(|corner| {
        let of = |axis: usize| f64::from(if corner >> axis & 1 == 0 { low[axis] } else { high[axis] });
        let corner: [f64; 3] = [of(0), of(1), of(2)];
        (0..3).map(|axis| (corner[axis] - sphere.center[axis]).powi(2)).sum::<f64>().sqrt()
    });
    let within = corners.filter(|away| *away <= sphere.radius * (1.0 + 1e-9)).count();
    steps.vector("c", "the center", sphere.center).number("r", "the radius", sphere.radius).text(
        "holds",
        "how many of the corners",
        format!("{within} of 8"),
    );
}

//! What is looked at, in the order of the page.

use exercise::{Case, Steps};

use crate::{Plane, signed_distance::signed_distance};

/// The point `x` and the plane through `p0` with the normal `n`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let plane = Plane::<f64> { point: case.point("p0").into(), normal: case.point("n").into() };
    let distance = signed_distance(case.point("x").into(), &plane);
    steps
        .vector("from_plane", "from p_0 to x", distance.from_plane)
        .number("d", "how far above the plane", distance.d)
        .text("x is", "what the sign of d says", distance.side().name());
}

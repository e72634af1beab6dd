//! The cone as printed beside the true one (slip 13).

use math::{Ray3, Real, Span};
use stage::{Transcript, Value};

use crate::printed::{self, printed_radius, radius};
use crate::{Shape, notes};

/// Radii at some heights by both formulas, and what the explained ray meets.
pub(crate) fn as_printed<R: Real>(transcript: &mut Transcript, ray: &Ray3<R>) {
    let rows = [1.0, 0.75, 0.5, 0.25, 0.0].map(|z| {
        let z = R::from(z);
        [z, radius(z), printed_radius(z)].map(Value::number).to_vec()
    });
    let lambda = |hit: Option<crate::Hit3<R>>| Value::maybe(hit.map(|hit| hit.t));
    let cone = notes(ray, Shape::Cone).hit(Span::ahead()).ok().flatten();
    let ellipsoid = printed::hit(ray, Span::ahead()).ok().flatten();
    transcript
        .section("The cone as printed is half an ellipsoid", "CSC418 11.3.5")
        .step("λ*", "x² + y² = ¼(1 − z)²", lambda(cone))
        .note("the true cone, the ray explained")
        .step("λ*", "x² + y² = ¼(1 − z²)", lambda(ellipsoid))
        .note("as printed, the same ray")
        .table(&["z", "radius ½(1 − z)", "as printed ½√(1 − z²)"], rows.to_vec())
        .remark("They agree at the apex and at the base only. A cone's radius falls evenly with z.");
}

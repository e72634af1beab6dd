//! Where second rays start from the point, by every method.

use bounds::Leaves;
use math::Real;
use stage::{Transcript, Value};

use crate::start::foot::{self, Foot};
use crate::{Lighting, Point, Start, Starts};

/// The parts of `bound`, then all of them on the side of the viewer.
pub(super) fn explain<R: Real>(transcript: &mut Transcript, lighting: &Lighting<'_, R>, point: &Point<R>) {
    let landing = &point.landing;
    let (parts, formulas) = (lighting.bounded.all_parts(), lighting.bounded.formulas());
    let (shape, face) = (parts.shape(landing.part), parts.face(landing.part));
    let foot: Foot<R> = foot::of(formulas, shape, face, landing);
    let section = transcript.section("Where a second ray starts, on the side of the viewer", "CSC418 11.7.4");
    section
        .step("q̄", "p̄ put back on its surface, in f64", Value::Array(foot.point.map(Value::number).to_vec()))
        .number("error", "how far q̄ is from the surface at most", foot.error)
        .number("rounding", "u Σ |n_i q_i|", foot.rounding)
        .note(format!("what it may cost to write it down in {}", R::NAME))
        .number("offset", "error + rounding", foot.offset())
        .note("along n⃗: bound starts there, outside in any case");
    let side = usize::from(!point.turned.from_outside);
    let all = [Start::None, Start::Fixed, Start::Scaled, Start::Exclude, Start::Bound];
    let rows = all.into_iter().map(|start| {
        let starts = Starts::of(start, formulas, shape, face, landing);
        let without =
            if starts.leaves[side] != Leaves::Unknown { "the part that it is on" } else { "nothing" };
        vec![
            Value::text(start.name()),
            Value::vector::<R>(starts.origins[side]),
            Value::number(starts.skipped),
            Value::text(without),
        ]
    });
    section.table(&["method", "starts at", "skips", "does not count"], rows.collect());
}

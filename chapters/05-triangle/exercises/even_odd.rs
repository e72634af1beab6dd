//! What is looked at, in the order of the page.

use exercise::{Case, Steps};

use crate::polygon::crossing::{Relation, Way, relation};
use crate::polygon::even_odd::even_odd;

/// The even-odd rule for the polygon `p1` to `p5` and the point `x`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let (outline, x) = (["p1", "p2", "p3", "p4", "p5"].map(|name| case.point2(name)), case.point2("x"));
    for side in 0..5 {
        let next = (side + 1) % 5;
        let meaning = match relation::<f64>(outline[side], outline[next], x) {
            Relation::Apart => "is not crossed",
            Relation::Crosses(Way::Up) => "is crossed upward",
            Relation::Crosses(Way::Down) => "is crossed downward",
            Relation::OnSide => "holds x",
        };
        steps.text(&format!("p̄{} p̄{}", side + 1, next + 1), "by s(t), t > 0", meaning);
    }
    let work = even_odd(&outline, x);
    let meaning = if work.is_inside() { "inside" } else { "outside" };
    steps.number("crossings", "their number", work.crossings.len() as f64).text(
        "x is",
        "even or odd?",
        meaning,
    );
}

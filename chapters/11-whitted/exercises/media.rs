//! What is looked at, surface by surface, and then back.

use exercise::{Case, Steps};

use crate::media::Media;

/// A ray goes through up to four surfaces: `pass_1` = 2 enters solid 2, −2 leaves it. `index_2` is its index.
/// With `back` = 1 all is undone afterwards.
pub fn probe(case: &Case, steps: &mut Steps) {
    let index = |solid: Option<usize>| solid.map_or(1.0, |solid| case.number(&format!("index_{solid}")));
    let list = |media: &Media| match media.solids() {
        [] => "air".to_string(),
        solids => solids.iter().map(usize::to_string).collect::<Vec<_>>().join(", "),
    };
    let (mut media, mut passes) = (Media::default(), Vec::new());
    for number in 1..=4 {
        let pass = case.number(&format!("pass_{number}")).round() as i64;
        if pass == 0 {
            continue;
        }
        let (solid, enters) = (pass.unsigned_abs() as usize, pass > 0);
        let does = format!("surface {number}, {} {solid}", if enters { "into" } else { "out of" });
        let before = index(media.top());
        passes.push((does.clone(), media.pass(solid, enters)));
        steps.numbers("n1, n2", &does, &[before, index(media.top())]).text("in", &does, list(&media));
    }
    if case.number("back").round() == 0.0 {
        return;
    }
    while let Some((does, undo)) = passes.pop() {
        media.undo(undo);
        steps.text("in", &format!("{does}, undone"), list(&media));
    }
}

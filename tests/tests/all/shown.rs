//! What every stage shows of its worked example, worked out once for all the tests that look at it.

use std::sync::LazyLock;

use rayon::prelude::*;
use stage::{Ask, Precision, Shown, Stage};
use tests::STAGES;

/// A stage, a request that differs from the default one in method or precision only, and the answer.
pub(crate) type Answer = (&'static dyn Stage, Ask, Shown);

/// The answers of every stage by every method at both precisions. A chapter that draws whole scenes draws its own size by
/// default only, and else a small one.
pub(crate) static SHOWN: LazyLock<Vec<Answer>> = LazyLock::new(|| {
    let all = STAGES.iter().flat_map(|stage| requests(*stage).map(move |ask| (*stage, in_size(*stage, ask))));
    let all: Vec<_> = all.collect();
    all.into_par_iter().map(|(stage, ask)| (stage, ask.clone(), stage.show(&ask).unwrap())).collect()
});

/// A request for a picture that is a quarter as wide and high where there are many to draw, and each is a scene.
fn in_size(stage: &dyn Stage, ask: Ask) -> Ask {
    let about = stage.about();
    let (width, height) = about.size;
    let is_small = about.number >= 8 && ask != Ask::default();
    Ask { size: is_small.then_some((width / 4, height / 4)), ..ask }
}

/// Every request of a stage that differs from the default one in method or precision only.
pub(crate) fn requests(stage: &dyn Stage) -> impl Iterator<Item = Ask> + use<> {
    (0..stage.about().methods.len())
        .flat_map(|method| Precision::ALL.map(|precision| Ask { method, precision, ..Ask::default() }))
}

/// The answer to a stage's default request.
pub(crate) fn by_default(stage: &dyn Stage) -> &'static Shown {
    let name = stage.about().name;
    let it = SHOWN.iter().find(|(stage, ask, _)| stage.about().name == name && *ask == Ask::default());
    &it.unwrap_or_else(|| panic!("{name} was not asked")).2
}

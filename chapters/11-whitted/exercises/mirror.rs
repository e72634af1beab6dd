//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Real, Vector};

use crate::mirror::mirror;

/// The mirror direction of `d` at the normal `n`, of whatever length.
pub fn probe(case: &Case, steps: &mut Steps) {
    let n: <f64 as Real>::Vec3 = case.point("n").into();
    let work = mirror::<f64>(case.point("d").into(), n.normalized());
    steps.number("d·n", "how much of d goes along n", work.d_dot_n).vector(
        "m_s",
        "the mirror direction",
        work.m_s,
    );
}

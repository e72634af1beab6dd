//! What is true of a case, before anything is rounded.

use math::Parallel;
use stage::Precision;

use super::stretch::Stretch;
use super::{Dyadic, ExactRoot};
use crate::Truth;

/// The exact answer to a case: a [`Truth`] whose roots are not written down yet.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// A question without an answer, with the reason that a result row gives.
    Invalid(&'static str),
    /// A miss, with the reason that a result row gives; mostly empty.
    Miss(&'static str),
    /// A hit.
    Hit {
        /// The smallest root ≥ 0.
        t: ExactRoot,
        /// Where the line leaves a wall or a sphere; `None` for everything else, which has no t_out.
        out: Option<ExactRoot>,
    },
}

impl Verdict {
    /// A line that enters a body at one root and leaves it at the other, seen from t = 0: it hits where
    /// it enters, or where it leaves if it starts inside.
    pub(super) fn through([near, far]: [ExactRoot; 2]) -> Verdict {
        if near.is_ahead() {
            Verdict::Hit { t: near, out: Some(far) }
        } else if far.is_ahead() {
            Verdict::Hit { t: far.clone(), out: Some(far) }
        } else {
            Verdict::Miss("")
        }
    }

    /// A line that meets a surface without an inside at one root.
    pub(super) fn at(t: ExactRoot) -> Verdict {
        if t.is_ahead() { Verdict::Hit { t, out: None } } else { Verdict::Miss("") }
    }

    /// A line that runs in a closed convex solid along a stretch, and what of the solid's boundary it meets
    /// first: where it enters, the origin if that is on the boundary, or else where it leaves.
    pub(super) fn boundary(stretch: Option<Stretch>, starts_strictly_inside: bool) -> Verdict {
        let Some([near, far]) = stretch.map(Stretch::ends) else {
            return Verdict::Miss("");
        };
        if near.is_ahead() {
            Verdict::Hit { t: near, out: None }
        } else if !far.is_ahead() {
            Verdict::Miss("")
        } else if starts_strictly_inside {
            Verdict::Hit { t: far, out: None }
        } else {
            let [zero, one] = [0.0, 1.0].map(Dyadic::of);
            Verdict::Hit { t: ExactRoot::quotient(zero, one), out: None }
        }
    }

    /// A line along a plane, in it or not: a miss either way.
    pub(super) fn along(within: bool) -> Verdict {
        let parallel = if within { Parallel::Within } else { Parallel::Apart };
        Verdict::Miss(parallel.reason())
    }

    /// With its roots written down.
    pub fn written(&self, precision: Precision) -> Truth {
        match self {
            Verdict::Invalid(reason) => Truth::Invalid(reason),
            Verdict::Miss(reason) => Truth::Miss(reason),
            Verdict::Hit { t, out } => {
                Truth::Hit { t: t.written(precision), out: out.as_ref().map(|out| out.written(precision)) }
            }
        }
    }
}

//! What a chapter hands to the lab.

use math::{Degenerate, Hit, Real};
use stage::{About, Precision};

use crate::{Regime, Truth};

/// A concept whose methods can be judged and timed. N is the number of input columns of its stage; a
/// case is those numbers in their order.
pub trait Subject<const N: usize>: Sync {
    /// What the stage says of itself: its name, its columns, its methods.
    fn about(&self) -> About;

    /// The method whose time is 1, by its place among the methods.
    fn baseline(&self) -> usize;

    /// The kinds of case, the ordinary one first.
    fn regimes(&self) -> Vec<Regime<N>>;

    /// What is true of a case; it comes from the oracle.
    fn truth(&self, case: [f64; N], precision: Precision) -> Truth;

    /// What a method answers to a case, by its place among the methods.
    fn answer<R: Real>(&self, method: usize, case: [R; N]) -> Answer;

    /// What putting a method's hit back into the question shows, where the truth is a hit too. `None` where
    /// the method finds none.
    fn quality<R: Real>(&self, method: usize, case: [R; N], truth: &Truth) -> Option<Quality>;

    /// For every method in its order, a runner over these cases, to be timed.
    fn runners<'a, R: Real>(&self, cases: &'a [[R; N]]) -> Vec<Runner<'a>>;
}

/// A method's answer to a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Answer {
    /// It refuses the question.
    Invalid,
    /// It finds no hit.
    Miss,
    /// It finds a hit, at this t.
    Hit(f64),
}

impl Answer {
    /// What `.hit(span)` returned.
    pub fn of<R: Real, V>(outcome: &Outcome<R, V>) -> Answer {
        match outcome {
            Err(_) => Answer::Invalid,
            Ok(None) => Answer::Miss,
            Ok(Some(hit)) => Answer::Hit(hit.t.into()),
        }
    }
}

/// How good the point and the normal of a hit are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// How far the point is from the surface, in units of the numbers' own size: of the radius, of the
    /// distance.
    pub residual: f64,
    /// The angle between the normal and the true one in radians; `None` where there is nothing to compare.
    pub normal_angle: Option<f64>,
}

/// One way to go through all cases of a regime once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Each by itself: the processor may work on several at once.
    Throughput,
    /// The next only when the last is answered: which one it is depends on the last t.
    Latency,
}

/// A method with its cases, ready to be timed: one call is one pass over the first of them, as many as is
/// said or all there are. It returns how many it took.
pub type Runner<'a> = Box<dyn FnMut(Pass, usize) -> usize + 'a>;

/// What `.hit(span)` of every method returns.
pub type Outcome<R, V> = Result<Option<Hit<R, V>>, Degenerate>;

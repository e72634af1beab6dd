//! The judge of any answer to any case: what is out of order in it, and what the oracle knows to be untrue.
//!
//! There is one of it, for the sweep of the tests and for the fuzzers: a case that a fuzzer finds is judged
//! by a test in the same way.

mod near;
mod pixel;

use std::cell::OnceCell;

use lab::oracle::{ExactRoot, Verdict};
use stage::{About, Precision};

use crate::{Bars, Record, exact_verdict, number};

pub use near::is_within;

/// One case of a stage, whose answers are judged.
pub struct Judge<'a> {
    about: &'a About,
    precision: Precision,
    case: &'a [f64],
    /// Asked for only once: it is most of what judging costs.
    exact: OnceCell<Verdict>,
}

impl Judge<'_> {
    /// Of a case whose numbers stand in the order of the stage's columns, a word being its place.
    pub fn of<'a>(about: &'a About, precision: Precision, case: &'a [f64]) -> Judge<'a> {
        Judge { about, precision, case, exact: OnceCell::new() }
    }

    /// What the oracle says. Panics where the stage has no oracle.
    pub fn verdict(&self) -> &Verdict {
        self.exact.get_or_init(|| exact_verdict(self.about.name, self.case))
    }

    /// What is wrong with a method's answer, whatever it is: out of order, or of `robust` untrue.
    pub fn fault(&self, method: &str, got: &Record) -> Option<String> {
        let untrue = || (method == "robust").then(|| self.untrue(got)).flatten();
        self.disorder(method, got).or_else(untrue)
    }

    /// What no method may answer: NaN, a t behind the origin, an answer to what is no question, or fields
    /// that do not go with the verdict.
    pub fn disorder(&self, method: &str, got: &Record) -> Option<String> {
        disorder(got).or_else(|| match self.about.name {
            "pinhole" => pixel::wrong_reason(got, method, self.case, self.precision),
            _ => self.wrong_hit(got),
        })
    }

    /// A row with a verdict is `invalid` exactly where the case is, and has the fields of its verdict.
    fn wrong_hit(&self, got: &Record) -> Option<String> {
        let (hit, reason) = (got.text("hit"), got.text("reason"));
        let invalid = self.is_invalid();
        if invalid != (hit == "invalid") {
            let case = if invalid { "invalid" } else { "valid" };
            return Some(format!("hit = {hit}, yet the case is {case}"));
        }
        let has = |column: &str| !got.text(column).is_empty();
        let [t, reason] = [has("t"), !reason.is_empty()];
        let right = match hit {
            "1" => t && has("x") && has("y") && !reason,
            "0" => !t && !has("t_out") && !has("x"),
            "invalid" => !t && !has("t_out") && !has("x") && !has("distance") && reason,
            _ => false,
        };
        (!right).then(|| format!("hit = {hit} with fields that do not go with it"))
    }

    /// The contract: a number that is not finite, a zero direction or normal, r ≤ 0, front > back; a
    /// triangle without area and a singular matrix, which the oracle knows.
    fn is_invalid(&self) -> bool {
        let Judge { about, case, .. } = self;
        if ["triangle", "affine"].contains(&about.name) {
            return matches!(self.verdict(), Verdict::Invalid(_));
        }
        let value =
            |name: &str| about.inputs.iter().position(|column| *column == name).map(|place| case[place]);
        let is_zero = |vector: &str| {
            let components: Vec<f64> =
                ["x", "y", "z"].iter().filter_map(|axis| value(&format!("{vector}{axis}"))).collect();
            !components.is_empty() && components.iter().all(|component| *component == 0.0)
        };
        !case.iter().all(|number| number.is_finite())
            || is_zero("d")
            || is_zero("n")
            || value("r").is_some_and(|r| r <= 0.0)
            || value("front").zip(value("back")).is_some_and(|(front, back)| front > back)
    }

    /// What the answer of `robust` says that is not true: another verdict than the oracle's, a t that is
    /// farther off than the method promises, or what is out of its range.
    pub fn untrue(&self, got: &Record) -> Option<String> {
        let bar = Bars::of(self.about.name).promised(self.precision);
        let said = |column: &str| got.text(column);
        let off = |column: &str, root: &ExactRoot| {
            let near = is_within(bar, root, number(said(column), self.precision), self.precision);
            (!near).then(|| format!("{column} = {} is more than {bar} ulps off", said(column)))
        };
        match self.verdict() {
            Verdict::Hit { .. } if said("hit") != "1" => Some(format!("hit: want 1, got {}", said("hit"))),
            Verdict::Hit { t, out } => {
                off("t", t).or_else(|| off("t_out", out.as_ref()?)).or_else(|| out_of_range(got))
            }
            Verdict::Miss(reason) => differs(["0", reason], ["hit", "reason"].map(said)),
            Verdict::Invalid(reason) => differs(["invalid", reason], ["hit", "reason"].map(said)),
        }
    }
}

/// A normal that is no unit vector, or a point outside its triangle. Whatever the rounding, the largest
/// component of a unit vector lies between 1/2 and 3/2, and a rounded number between 0 and 1 does so still.
fn out_of_range(got: &Record) -> Option<String> {
    let numbers = |columns: &[&str]| -> Vec<f64> {
        columns.iter().filter_map(|column| got.text(column).parse().ok()).collect()
    };
    let normal = numbers(&["nx", "ny", "nz"]);
    let largest = normal.iter().copied().map(f64::abs).fold(0.0, f64::max);
    if !normal.is_empty() && !(0.5..=1.5).contains(&largest) {
        return Some(format!("the normal is {normal:?}"));
    }
    let shares = numbers(&["alpha", "beta"]);
    let outside = shares.iter().any(|share| !(0.0..=1.0).contains(share));
    outside.then(|| format!("alpha and beta are {shares:?}"))
}

/// NaN anywhere, or a parameter behind the origin.
pub(crate) fn disorder(got: &Record) -> Option<String> {
    let behind = ["t", "t_out"].into_iter().filter(|column| got.text(column).starts_with('-'));
    let columns: Vec<&str> = behind.chain(got.nan_columns()).collect();
    let shown = columns.first().map(|column| got.text(column));
    shown.map(|text| format!("{text} in {columns:?}"))
}

/// `hit` and `reason` are not as they should be.
fn differs(want: [&str; 2], got: [&str; 2]) -> Option<String> {
    (want != got).then(|| format!("hit and reason: want {want:?}, got {got:?}"))
}

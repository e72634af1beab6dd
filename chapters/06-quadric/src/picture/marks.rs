//! What a method looks at along a ray: every candidate for the page's, the one that is met for the robust one.

use math::{Real, Span};

use crate::notes::{Fate, Test};
use crate::{Part, Working};

/// A candidate as it is drawn and listed.
pub(crate) struct Mark<R: Real> {
    /// Which part it is of.
    pub(crate) part: Part,
    /// λ; `None` where there is no such point.
    pub(crate) lambda: Option<R>,
    /// Where it is.
    pub(crate) point: R::Vec3,
    /// What became of it.
    pub(crate) word: &'static str,
    /// The one that was kept.
    pub(crate) is_hit: bool,
}

/// The candidates in the order of λ; those that are no point at all come last.
pub(crate) fn marks<R: Real>(work: &Working<R>) -> Vec<Mark<R>> {
    match work {
        Working::Notes(work) => {
            let fates = (0..).map(|place| work.fate(place, Span::ahead()));
            let mark = |(candidate, fate): (&crate::notes::Candidate<R>, Fate)| Mark {
                part: candidate.part,
                lambda: candidate.lambda,
                point: candidate.point,
                word: word(fate),
                is_hit: fate == Fate::Nearest,
            };
            let mut marks: Vec<_> = work.candidates().iter().zip(fates).map(mark).collect();
            let key = |mark: &Mark<R>| mark.lambda.map_or(f64::INFINITY, Into::into);
            marks.sort_by(|a, b| key(a).total_cmp(&key(b)));
            marks
        }
        Working::Robust(work) => {
            let (Some(part), Ok(Some(hit))) = (work.verdict.part(), work.hit(Span::ahead())) else {
                return Vec::new();
            };
            vec![Mark { part, lambda: Some(hit.t), point: hit.point, word: "", is_hit: true }]
        }
    }
}

/// Its fate in a word or two.
fn word(fate: Fate) -> &'static str {
    match fate {
        Fate::Dropped(Test::NoPoint) => "no such point",
        Fate::Dropped(Test::ZOutside) => "z is outside",
        Fate::Dropped(Test::BeyondRim) => "beyond the rim",
        // (A point of the surface is not dropped.)
        Fate::OutsideSpan | Fate::Dropped(Test::OnSurface) => "behind",
        Fate::Farther => "farther",
        Fate::Nearest => "kept",
    }
}

/// A number in a few digits, for a drawing.
pub(crate) fn short(x: f64) -> String {
    if x.abs() >= 1e4 {
        return format!("{x:.1e}").replace('-', "−");
    }
    let digits = format!("{x:.3}");
    let digits = digits.trim_end_matches('0').trim_end_matches('.');
    if digits == "-0" { "0".to_string() } else { digits.replace('-', "−") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_short() {
        let said = [0.0, -0.0001, 2.5, 100.0, -1.0 / 3.0, 1.25e7, -2e-300].map(short);
        assert_eq!(said, ["0", "0", "2.5", "100", "−0.333", "1.2e7", "0"]);
    }
}

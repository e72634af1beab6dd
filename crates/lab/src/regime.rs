//! A regime: one kind of question, as many of it as one likes.

use stage::Precision;

use crate::Draw;

/// A named kind of case. N is the number of input columns of its stage.
#[derive(Clone, Copy, Debug)]
pub struct Regime<const N: usize> {
    /// Its name, in the trade's table and for `--regime`: `far-1e4`.
    pub name: &'static str,
    /// What its cases are, in half a sentence.
    pub what: &'static str,
    /// Draws one case: the input columns of the stage in their order. The lab rounds it to the precision.
    pub draw: fn(&mut Draw) -> [f64; N],
    /// What the notes' methods lose here.
    pub notes: Notes,
}

impl<const N: usize> Regime<N> {
    /// Its cases from a seed, as many as one takes, every number rounded to the precision.
    pub fn cases(&self, seed: u64, precision: Precision) -> impl Iterator<Item = [f64; N]> {
        let (mut source, draw) = (Draw::new(seed, self.name, precision), self.draw);
        std::iter::repeat_with(move || {
            let case = draw(&mut source);
            case.map(|number| source.rounded(number))
        })
    }
}

/// What becomes of the notes' methods in a regime; a test holds them to it. What is said of one precision
/// leaves the other open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notes {
    /// This method of the notes decides wrongly about hit or miss, at this precision.
    Misjudge(&'static str, Precision),
    /// This method of the notes has the verdict, but loses more than a hundred ulps of t somewhere.
    LoseDigits(&'static str, Precision),
    /// None fails, and why.
    Hold(&'static str),
}

//! A line of an OBJ file.

use crate::source::{Source, Spot};
use crate::toml::shown;
use crate::word::{Word, Words};
use crate::{Error, Place};

/// A statement: its keyword, and the words after it one by one.
pub(super) struct Line<'t> {
    pub(super) keyword: Word<'t>,
    words: Words<'t>,
    asked: Option<Spot<'t>>,
}

/// The lines that say something. A line that ends with a backslash goes on in the next one.
pub(super) fn lines<'t>(source: &'t Source, asked: Option<Spot<'t>>) -> impl Iterator<Item = Line<'t>> {
    let mut start = 0;
    let stretches = std::iter::from_fn(move || {
        let rest = source.text.get(start..).filter(|rest| !rest.is_empty())?;
        let mut ends = rest.match_indices('\n').map(|(end, _)| end);
        let last =
            ends.find(|&end| !rest[..end].trim_end_matches('\r').ends_with('\\')).unwrap_or(rest.len());
        let spot = source.spot(start..start + last);
        start += last + 1;
        Some(spot)
    });
    stretches.filter_map(move |spot| {
        let mut words = Words::of(spot);
        words.next().map(|keyword| Line { keyword, words, asked })
    })
}

impl<'t> Line<'t> {
    /// The next word; `None` at the end of the line.
    pub(super) fn next(&mut self) -> Option<Word<'t>> {
        loop {
            let word = self.words.next()?;
            let text = word.text.trim_end_matches('\\');
            if !text.is_empty() {
                return Some(Word { text, spot: word.spot });
            }
        }
    }

    /// Three finite numbers. What may follow, a weight or a color, is left.
    pub(super) fn point(&mut self) -> Result<[f64; 3], Error> {
        let mut point = [0.0; 3];
        for number in &mut point {
            *number = self.number()?;
        }
        Ok(point)
    }

    fn number(&mut self) -> Result<f64, Error> {
        let remedy = format!("write for example `{} 0.0 1.0 0.0`", self.keyword.text);
        let Some(word) = self.next() else {
            let problem = format!("`{}` must have 3 numbers", self.keyword.text);
            return Err(self.fault(self.place(), &problem, &remedy));
        };
        match word.text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) => Err(self.fault(
                word.spot,
                &format!("a number must be finite, and this is {}", shown(word.text)),
                &remedy,
            )),
            Err(_) => Err(self.fault(word.spot, &format!("{} is no number", shown(word.text)), &remedy)),
        }
    }

    /// From the keyword to the last word that was read.
    pub(super) fn place(&self) -> Spot<'t> {
        let start = self.keyword.spot.place.start;
        self.words.source.spot(Place { start, end: self.words.end })
    }

    /// An error that points into the line, and at where the scene names the file.
    pub(super) fn fault(&self, spot: Spot, problem: &str, remedy: &str) -> Error {
        spot.asked_fault(problem, remedy, self.asked)
    }
}

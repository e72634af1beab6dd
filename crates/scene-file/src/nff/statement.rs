//! A keyword and what follows it.

use crate::source::Spot;
use crate::toml::shown;
use crate::word::{Word, Words};
use crate::{At, Error, Place};

/// The statements: a keyword and what follows it. `N` is a count, `…` as many of the same as it says.
pub(super) const STATEMENTS: &[&str] = &[
    "b r g b",
    "v",
    "l x y z [r g b]",
    "f r g b Kd Ks shine T ior",
    "s x y z radius",
    "c x y z radius x y z radius",
    "p N x y z …",
    "pp N x y z nx ny nz …",
];

/// What follows `v`.
pub(super) const VIEW: &[&str] =
    &["from x y z", "at x y z", "up x y z", "angle degrees", "hither distance", "resolution columns rows"];

/// A keyword whose numbers are read one after another.
pub(super) struct Statement<'a, 't> {
    pub(super) keyword: Word<'t>,
    form: &'static str,
    /// How many words of it were read.
    read: usize,
    pub(super) words: &'a mut Words<'t>,
}

impl<'a, 't> Statement<'a, 't> {
    /// What the next word begins, if it is the keyword of one of the forms; else it stays the next word.
    pub(super) fn begin(words: &'a mut Words<'t>, forms: &[&'static str]) -> Option<Statement<'a, 't>> {
        let keyword = words.peek()?;
        let form = forms.iter().find(|form| form.split(' ').next() == Some(keyword.text))?;
        words.next();
        Some(Statement { keyword, form, read: 0, words })
    }

    /// The keyword.
    pub(super) fn name(&self) -> &'t str {
        self.keyword.text
    }

    /// From the keyword to the last word that was read.
    pub(super) fn place(&self) -> Place {
        Place { start: self.keyword.spot.place.start, end: self.words.end }
    }

    /// The next word as a finite number.
    pub(super) fn number(&mut self) -> Result<At<f64>, Error> {
        let word = self.word("a number")?;
        match word.text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(At { value, place: word.spot.place }),
            Ok(_) => Err(self.impossible(word.spot.place, "must be finite")),
            Err(_) => Err(self.no("a number", word)),
        }
    }

    /// The next word as a whole number, 0 or more.
    pub(super) fn count(&mut self) -> Result<At<u64>, Error> {
        let word = self.word("a whole number")?;
        match word.text.parse() {
            Ok(value) => Ok(At { value, place: word.spot.place }),
            Err(_) => Err(self.no("a whole number", word)),
        }
    }

    /// A point, or a vector.
    pub(super) fn point(&mut self) -> Result<At<[f64; 3]>, Error> {
        let [x, y, z] = [self.number()?, self.number()?, self.number()?];
        let place = Place { start: x.place.start, end: z.place.end };
        Ok(At { value: [x.value, y.value, z.value], place })
    }

    /// A number from 0 up.
    pub(super) fn not_negative(&mut self) -> Result<f64, Error> {
        let At { value, place } = self.number()?;
        if value >= 0.0 { Ok(value) } else { Err(self.impossible(place, "must not be below 0")) }
    }

    /// A number from 0 to 1.
    pub(super) fn fraction(&mut self) -> Result<f64, Error> {
        let At { value, place } = self.number()?;
        let fits = (0.0..=1.0).contains(&value);
        if fits { Ok(value) } else { Err(self.impossible(place, "must be 0 to 1")) }
    }

    /// Linear RGB, from 0 up.
    pub(super) fn radiance(&mut self) -> Result<[f64; 3], Error> {
        Ok([self.not_negative()?, self.not_negative()?, self.not_negative()?])
    }

    /// An error for the number that was just read.
    pub(super) fn impossible(&self, place: Place, why: &str) -> Error {
        self.refused(place, &format!("`{}` {why}", self.part_name()))
    }

    /// An error for something that cannot be.
    pub(super) fn refused(&self, place: Place, problem: &str) -> Error {
        let spot = self.words.source.spot(place);
        spot.fault(&format!("{problem}: {}", shown(spot.text())), &self.remedy())
    }

    fn word(&mut self, wanted: &str) -> Result<Word<'t>, Error> {
        self.read += 1;
        self.words.next().ok_or_else(|| self.unexpected("the file ends", self.words.here(), wanted))
    }

    fn unexpected(&self, found: &str, spot: Spot, wanted: &str) -> Error {
        let problem = format!("{found} where `{}` wants {wanted}, `{}`", self.name(), self.part_name());
        spot.clash(&problem, &self.remedy(), self.keyword.spot, "what it belongs to")
    }

    fn no(&self, wanted: &str, word: Word) -> Error {
        self.unexpected(&format!("{} stands", shown(word.text)), word.spot, wanted)
    }

    fn remedy(&self) -> String {
        format!("write `{}`", self.form)
    }

    /// What the word that was last read is in the form.
    fn part_name(&self) -> &'static str {
        let parts: Vec<&str> = self.form.split([' ', '[', ']']).filter(|part| !part.is_empty()).collect();
        match parts[1..] {
            // After a count the same names come again and again.
            ["N", ref names @ .., "…"] if self.read > 1 => names[(self.read - 2) % names.len()],
            ref names => names.get(self.read - 1).copied().unwrap_or_default(),
        }
    }
}

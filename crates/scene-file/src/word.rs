//! The words of a file that is written in words.

use crate::Place;
use crate::source::{Source, Spot};

/// A word and where it stands.
#[derive(Clone, Copy)]
pub(crate) struct Word<'t> {
    pub(crate) text: &'t str,
    pub(crate) spot: Spot<'t>,
}

/// The words of a stretch of a file one after another. A `#` where a word could start begins a comment, up to the end
/// of the line.
pub(crate) struct Words<'t> {
    pub(crate) source: &'t Source,
    /// Where the last word ended.
    pub(crate) end: usize,
    /// Where the stretch ends.
    stop: usize,
}

impl<'t> Words<'t> {
    /// The words of a place.
    pub(crate) fn of(spot: Spot<'t>) -> Words<'t> {
        Words { source: spot.source, end: spot.place.start, stop: spot.place.end }
    }

    /// The next word; `None` at the end.
    pub(crate) fn next(&mut self) -> Option<Word<'t>> {
        let word = self.peek()?;
        self.end = word.spot.place.end;
        Some(word)
    }

    /// The next word, which stays the next.
    pub(crate) fn peek(&self) -> Option<Word<'t>> {
        let mut rest = self.rest().trim_ascii_start();
        while rest.starts_with('#') {
            rest = rest.find('\n').map_or("", |end| &rest[end..]).trim_ascii_start();
        }
        let text = rest.split_ascii_whitespace().next()?;
        let start = self.stop - rest.len();
        Some(Word { text, spot: self.source.spot(start..start + text.len()) })
    }

    /// What comes after the last word.
    pub(crate) fn rest(&self) -> &'t str {
        &self.source.text[self.end..self.stop]
    }

    /// The place after the last word.
    pub(crate) fn here(&self) -> Spot<'t> {
        self.source.spot(Place { start: self.end, end: self.end })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_split_at_blanks_and_comments_are_none() {
        let source = Source::new("a", "# a # comment\r\n s\t1 2#3\n#end\r\n\u{b}4 #");
        let mut words = Words::of(source.spot(0..source.text.len()));
        let texts: Vec<_> = std::iter::from_fn(|| words.next().map(|word| word.text)).collect();
        assert_eq!(texts, ["s", "1", "2#3", "\u{b}4"]);
        assert_eq!(words.next().map(|word| word.text), None);
    }
}

//! The text of a file, its lines and its columns.

use std::fmt;

use crate::{Error, Place};

/// A file that was read, or a text that stands for one.
pub(crate) struct Source {
    /// The name that errors give.
    pub(crate) name: String,
    /// All of it, without a byte order mark.
    pub(crate) text: String,
}

/// A place in a file.
#[derive(Clone, Copy)]
pub(crate) struct Spot<'a> {
    pub(crate) source: &'a Source,
    pub(crate) place: Place,
}

impl Source {
    /// A file of that name and content. A byte order mark at its start is left out.
    pub(crate) fn new(name: impl Into<String>, text: impl Into<String>) -> Source {
        let mut text = text.into();
        if text.starts_with('\u{feff}') {
            text.drain(..'\u{feff}'.len_utf8());
        }
        Source { name: name.into(), text }
    }

    /// A file of that name and content. `asked` is where a scene names it.
    ///
    /// An error at the first byte that is no UTF-8.
    pub(crate) fn from_bytes(name: String, bytes: Vec<u8>, asked: Option<Spot>) -> Result<Source, Error> {
        let zipped = bytes.starts_with(b"\x1f\x8b");
        String::from_utf8(bytes).map(|text| Source::new(&*name, text)).map_err(|error| {
            let bad = error.utf8_error().valid_up_to();
            let source = Source::new(name, String::from_utf8_lossy(error.as_bytes()));
            let bad = source.text.find(char::REPLACEMENT_CHARACTER).unwrap_or(bad);
            let remedy = if zipped { "unpack it with gunzip" } else { "save the file as UTF-8 text" };
            source.spot(bad..bad + 1).asked_fault("a byte that is no UTF-8", remedy, asked)
        })
    }

    /// A place in this file.
    pub(crate) fn spot(&self, place: impl Into<Place>) -> Spot<'_> {
        Spot { source: self, place: place.into() }
    }

    /// The line of a byte, from 1.
    pub(crate) fn line(&self, byte: usize) -> usize {
        self.before(byte).bytes().filter(|&byte| byte == b'\n').count() + 1
    }

    /// The column of a byte in its line, in characters from 1.
    pub(crate) fn column(&self, byte: usize) -> usize {
        let before = self.before(byte);
        before[line_start(before)..].chars().count() + 1
    }

    /// The text before a byte, or before the character that it is in the middle of.
    pub(crate) fn before(&self, byte: usize) -> &str {
        &self.text[..boundary(&self.text, byte)]
    }
}

impl<'a> Spot<'a> {
    /// The line, from 1.
    pub(crate) fn line(self) -> usize {
        self.source.line(self.place.start)
    }

    /// What stands there, cut where its first line ends.
    pub(crate) fn text(self) -> &'a str {
        let Spot { source, place } = self;
        let start = source.before(place.start).len();
        let end = source.before(place.end).len().max(start);
        first_line(&source.text[start..end])
    }

    /// An error that points there.
    pub(crate) fn fault(self, problem: &str, remedy: &str) -> Error {
        Error::at(self, problem, remedy, None)
    }

    /// An error that points there, and at where a scene names the file.
    pub(crate) fn asked_fault(self, problem: &str, remedy: &str, asked: Option<Spot>) -> Error {
        Error::at(self, problem, remedy, asked.map(|asked| (asked, "the scene asks for it here")))
    }

    /// An error that points there, and elsewhere.
    pub(crate) fn clash(self, problem: &str, remedy: &str, other: Spot, label: &str) -> Error {
        Error::at(self, problem, remedy, Some((other, label)))
    }
}

/// The last byte at or before `byte` at which a text can be cut.
pub(crate) fn boundary(text: &str, byte: usize) -> usize {
    (0..=byte.min(text.len())).rev().find(|&byte| text.is_char_boundary(byte)).unwrap_or(0)
}

/// A text up to where its first line ends.
pub(crate) fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

/// Where the last line of a text starts.
pub(crate) fn line_start(text: &str) -> usize {
    text.rfind('\n').map_or(0, |end| end + 1)
}

/// A file may be long: its name is enough.
impl fmt::Debug for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Source({:?})", self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_from_1_and_columns_in_characters() {
        let source = Source::new("a", "\u{feff}eins\r\nzwölf = é\n");
        let place = |byte| (source.line(byte), source.column(byte));
        assert_eq!([place(0), place(3), place(6)], [(1, 1), (1, 4), (2, 1)]);
        let e = source.text.find('é').unwrap();
        assert_eq!([place(e), place(e + 1), place(e + 2)], [(2, 9), (2, 9), (2, 10)]);
        assert_eq!(place(1000), (3, 1));
    }

    #[test]
    fn a_place_of_several_lines_is_shown_by_its_first() {
        let source = Source::new("a", "one\r\ntwo");
        assert_eq!(source.spot(1..7).text(), "ne");
        assert_eq!(source.spot(Place { start: 5, end: 3 }).text(), "");
    }
}

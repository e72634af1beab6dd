//! How much memory the tree of a text takes at most, before it is built.

use toml_parser::lexer::TokenKind;

use crate::Error;
use crate::limits::{TREE_BYTES, TREE_BYTES_A_BYTE};
use crate::source::Source;

/// What the tree keeps for a table: room for eleven keys, though it has one.
const TABLE: usize = 1200;
/// What it keeps for a list: room for four values.
const LIST: usize = 360;

/// Refuses a text that is made of little more than the brackets and dots that begin tables and lists.
///
/// An error at the first of them for which there is no room any more.
pub(super) fn check(source: &Source) -> Result<(), Error> {
    let room = TREE_BYTES + TREE_BYTES_A_BYTE * source.text.len();
    match first_beyond(room, &source.text) {
        None => Ok(()),
        Some(at) => {
            let remedy =
                "write fewer of them, with more in each: an object, a material or a light takes one to three";
            Err(source
                .spot(at..at + 1)
                .fault("more tables and lists than a text of this length may hold", remedy))
        }
    }
}

/// The place of the token with which tables and lists take more than `room` bytes.
///
/// A dot begins a table where an equals sign or the end of a header follows; before a comma it is a number's.
fn first_beyond(room: usize, text: &str) -> Option<usize> {
    let (mut taken, mut dots) = (0, 0);
    let (mut is_header, mut before) = (false, TokenKind::Newline);
    for token in toml_parser::Source::new(text).lex() {
        match token.kind() {
            TokenKind::Dot => dots += 1,
            TokenKind::Equals => taken += std::mem::take(&mut dots) * TABLE,
            TokenKind::RightSquareBracket if std::mem::take(&mut is_header) => {
                taken += std::mem::take(&mut dots) * TABLE;
            }
            TokenKind::LeftCurlyBracket => taken += TABLE,
            // an empty one has no room for keys yet
            TokenKind::RightCurlyBracket if before == TokenKind::LeftCurlyBracket => taken -= TABLE,
            TokenKind::LeftSquareBracket if before == TokenKind::Newline => {
                taken += TABLE;
                (is_header, dots) = (true, 0);
            }
            TokenKind::LeftSquareBracket => {
                taken += LIST;
                dots = 0;
            }
            TokenKind::Comma | TokenKind::Newline => (is_header, dots) = (false, 0),
            _ => {}
        }
        if taken > room {
            return Some(token.span().start());
        }
        if token.kind() != TokenKind::Whitespace {
            before = token.kind();
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a text takes, found by trying.
    fn taken(text: &str) -> usize {
        (0..100 * TABLE).find(|&room| first_beyond(room, text).is_none()).unwrap()
    }

    #[test]
    fn what_begins_a_table_or_a_list() {
        for (text, tables, lists) in [
            ("", 0, 0),
            ("a = 0.5\nb = 1.5 # c.d.e = {[\nf = \"{.=[\"\n", 0, 0),
            ("[a]\nb = 1\n", 1, 0),
            ("  [[a]]\n", 1, 1),
            ("[a.b.c]\n", 3, 0),
            ("a.b.c = 1.5\n", 2, 0),
            ("a = {b = {c.d = 0.5, e = 1.5}}\n", 3, 0),
            ("a = [0.5, 1.5, [2.5]]\n", 0, 2),
            ("a = [{}, { }, {b = 1}]\n", 1, 1),
        ] {
            assert_eq!(taken(text), tables * TABLE + lists * LIST, "{text}");
        }
    }

    #[test]
    fn the_first_without_room_is_told() {
        let text = "a = 1\nb = {c = 1}\nd.e = 2\n";
        assert_eq!(first_beyond(TABLE - 1, text), Some(10));
        // an equals sign tells that the dot before it was a key's
        assert_eq!(first_beyond(TABLE, text), text.rfind('='));
        assert_eq!(first_beyond(2 * TABLE, text), None);
    }
}

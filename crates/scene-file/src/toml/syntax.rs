//! What is no TOML at all.

use ::toml::de::DeTable;

use super::size;
use super::value::one_line;
use crate::Error;
use crate::source::Source;

const VALUE: &str = "write a number, a string in quotes, `true` or `false`, a list such as `[1, 2]` with its commas, \
     or a table such as `{ key = 1 }`";

/// How the TOML reader's message begins, what is wrong in our words, and what would be right.
const MESSAGES: &[(&str, &str, &str)] = &[
    ("string values must be quoted", "this is no value", VALUE),
    ("invalid boolean", "this is no value", VALUE),
    (
        "duplicate key",
        "this key is there already",
        "keep one of the two; what may come more than once has two brackets: `[[object]]`, `[[light]]`",
    ),
    ("key with no value", "a key without a value", "write `key = value`, or `#` before a comment"),
    (
        "unexpected key or value",
        "the line goes on after its value",
        "begin a new line, or write `#` before a comment",
    ),
    (
        "missing comma between array elements",
        "the list goes on without a comma",
        "write `,` before this, or `]` where the list ends",
    ),
    (
        "missing comma between key-value pairs",
        "the table goes on without a comma",
        "write `,` before this, or `}` where the table ends",
    ),
    ("missing escaped value", "a backslash that escapes nothing", "write `\\\\`, or `/` between folders"),
    ("invalid basic string", "a string without an end", "close it with `\"`"),
    ("invalid literal string", "a string without an end", "close it with `'`"),
    ("invalid mantissa", "a number without a digit before its dot", "write `0.5` for `.5`"),
    ("invalid fraction", "a number without a digit after its dot", "write `5.0` or `5` for `5.`"),
    ("invalid exponent", "a number without a digit after its e", "write for example `1e-3`"),
    ("invalid unquoted key", "this cannot stand in a key", "write letters from a to z, digits, `-` and `_`"),
    (
        "integers with a radix cannot be signed",
        "a sign before `0x`, `0o` or `0b`",
        "write the number in decimal",
    ),
    ("unexpected leading zero", "a number that begins with 0", "leave the 0 out"),
    ("`_` may only go between digits", "`_` may only stand between digits", "leave it out"),
    ("recursion limit", "keys nested too deeply", "write fewer dots: no scene needs more than three"),
    (
        "cannot recurse further",
        "values nested too deeply",
        "write fewer brackets: no scene needs more than four",
    ),
];

/// The tree of a text.
///
/// An error at the first place that is no TOML, and for a tree that is much larger than its text.
pub(super) fn parse(source: &Source) -> Result<DeTable<'_>, Error> {
    size::check(source)?;
    DeTable::parse(&source.text).map(|document| document.into_inner()).map_err(|error| {
        let message = one_line(error.message());
        let ours = MESSAGES.iter().find(|(begins, ..)| message.starts_with(begins));
        let (problem, remedy) = match (ours, message.split_once(", expected ")) {
            (Some((_, problem, remedy)), _) => (*problem, remedy.to_string()),
            (None, Some((problem, expected))) => (problem, format!("write {expected}")),
            (None, None) => (&*message, "see https://toml.io for how TOML is written".to_string()),
        };
        source.spot(error.span().unwrap_or(0..0)).fault(problem, &remedy)
    })
}

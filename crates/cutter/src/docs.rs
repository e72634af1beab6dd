//! What a hand-out says of its items, where the chapter's own words are the answer.

use std::collections::BTreeMap;
use std::ops::Range;

use syn::spanned::Spanned;
use syn::{Attribute, Fields, ImplItem, Item, TraitItem};

/// The name for what a file says of itself, in `//!`.
pub const FILE: &str = "file";

/// The text with other words for the named items, fields, variants and functions. `Err` names one that is not there.
pub fn reworded(text: &str, words: &BTreeMap<String, String>) -> Result<String, String> {
    if words.is_empty() {
        return Ok(text.to_string());
    }
    let file = syn::parse_file(text).map_err(|error| error.to_string())?;
    let mut said: Vec<(String, Range<usize>)> = Vec::new();
    let mut note = |name: String, attributes: &[Attribute]| {
        let docs = attributes.iter().filter(|it| it.path().is_ident("doc"));
        let ranges: Vec<Range<usize>> = docs.map(|it| it.span().byte_range()).collect();
        if let (Some(first), Some(last)) = (ranges.first(), ranges.last()) {
            said.push((name, first.start..last.end));
        }
    };
    note(FILE.to_string(), &file.attrs);
    for item in &file.items {
        match item {
            Item::Struct(it) => {
                note(it.ident.to_string(), &it.attrs);
                fields(&it.fields, &mut note);
            }
            Item::Enum(it) => {
                note(it.ident.to_string(), &it.attrs);
                for variant in &it.variants {
                    note(variant.ident.to_string(), &variant.attrs);
                    fields(&variant.fields, &mut note);
                }
            }
            Item::Fn(it) => note(it.sig.ident.to_string(), &it.attrs),
            Item::Const(it) => note(it.ident.to_string(), &it.attrs),
            Item::Trait(it) => {
                note(it.ident.to_string(), &it.attrs);
                for item in &it.items {
                    if let TraitItem::Fn(it) = item {
                        note(it.sig.ident.to_string(), &it.attrs);
                    }
                }
            }
            Item::Impl(it) => {
                for item in &it.items {
                    if let ImplItem::Fn(it) = item {
                        note(it.sig.ident.to_string(), &it.attrs);
                    }
                }
            }
            _ => {}
        }
    }
    if let Some(name) = words.keys().find(|&name| said.iter().all(|(said, _)| said != name)) {
        return Err(format!("nothing is said of {name}"));
    }
    said.sort_by_key(|(_, range)| range.start);
    let (mut result, mut from) = (String::new(), 0);
    for (name, range) in said {
        let Some(words) = words.get(&name) else { continue };
        let sign = if name == FILE { "//!" } else { "///" };
        let indent = &text[text[..range.start].rfind('\n').map_or(0, |at| at + 1)..range.start];
        let lines: Vec<String> =
            words.lines().map(|line| format!("{sign} {line}").trim_end().to_string()).collect();
        result += &text[from..range.start];
        result += &lines.join(&format!("\n{indent}"));
        from = range.end;
    }
    Ok(result + &text[from..])
}

fn fields(fields: &Fields, note: &mut impl FnMut(String, &[Attribute])) {
    for field in fields {
        note(field.ident.as_ref().map(ToString::to_string).unwrap_or_default(), &field.attrs);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "//! Twice: y = 2 x.\n//!\n//! More.\n\n/// A.\n#[derive(Clone)]\nstruct A {\n    /// y = 2 x\n    \
                        /// for every x\n    #[allow(unused)]\n    pub y: f64,\n    /// z\n    z: f64,\n}\n\nimpl A {\n    \
                        /// 2 x.\n    fn twice() {}\n}\n";

    fn said(words: &[(&str, &str)]) -> Result<String, String> {
        reworded(TEXT, &words.iter().map(|(name, words)| (name.to_string(), words.to_string())).collect())
    }

    #[test]
    fn only_what_is_named_is_said_in_other_words() {
        let text =
            said(&[("file", "Twice.\n\nNo more."), ("y", "Twice x."), ("twice", "How much?")]).unwrap();
        let expected = "//! Twice.\n//!\n//! No more.\n\n/// A.\n#[derive(Clone)]\nstruct A {\n    /// Twice x.\n    \
                        #[allow(unused)]\n    pub y: f64,\n    /// z\n    z: f64,\n}\n\nimpl A {\n    \
                        /// How much?\n    fn twice() {}\n}\n";
        assert_eq!(text, expected);
        assert_eq!(said(&[]).unwrap(), TEXT);
        assert_eq!(said(&[("x", "")]).unwrap_err(), "nothing is said of x");
    }
}

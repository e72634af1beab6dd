//! What a hand-out says of its items, where the chapter's own words are the answer.

use std::collections::BTreeMap;
use std::ops::Range;

use syn::spanned::Spanned;
use syn::{Attribute, Fields, ImplItem, Item, TraitItem};

/// The name for what a file says of itself, in `//!`.
pub const FILE: &str = "file";

/// The text with other words for the named items, fields, variants and functions. What has the name of
/// something else in the file goes by its owner's too: `Media::pass`. `Err` names one that is not there, or
/// is twice.
pub fn reworded(text: &str, words: &BTreeMap<String, String>) -> Result<String, String> {
    if words.is_empty() {
        return Ok(text.to_string());
    }
    let mut said = said(&syn::parse_file(text).map_err(|error| error.to_string())?);
    for name in words.keys() {
        match said.iter().filter(|it| it.goes_by(name)).count() {
            0 => return Err(format!("nothing is said of {name}")),
            1 => {}
            _ => return Err(format!("there are several {name}: name it with its owner, as `Owner::{name}`")),
        }
    }
    said.sort_by_key(|it| it.range.start);
    let (mut result, mut from) = (String::new(), 0);
    for it in said {
        let Some((_, words)) = words.iter().find(|(name, _)| it.goes_by(name)) else { continue };
        let sign = if it.name == FILE { "//!" } else { "///" };
        let indent = &text[text[..it.range.start].rfind('\n').map_or(0, |at| at + 1)..it.range.start];
        let lines: Vec<String> =
            words.lines().map(|line| format!("{sign} {line}").trim_end().to_string()).collect();
        result += &text[from..it.range.start];
        result += &lines.join(&format!("\n{indent}"));
        from = it.range.end;
    }
    Ok(result + &text[from..])
}

/// What a file says of the items that `words` has other words for, in its own: what a hand-out leaves unsaid.
pub fn unsaid(text: &str, words: &BTreeMap<String, String>) -> Result<String, String> {
    let said = said(&syn::parse_file(text).map_err(|error| error.to_string())?);
    let named = said.iter().filter(|it| words.keys().any(|name| it.goes_by(name)));
    Ok(named.map(|it| format!("{}\n\n", &text[it.range.clone()])).collect())
}

/// What is said of something, and where.
struct Said {
    owner: String,
    name: String,
    range: Range<usize>,
}

impl Said {
    fn goes_by(&self, name: &str) -> bool {
        match name.split_once("::") {
            Some((owner, name)) => self.owner == owner && self.name == name,
            None => self.name == name,
        }
    }
}

/// Everything that a file says of its items.
fn said(file: &syn::File) -> Vec<Said> {
    let mut said: Vec<Said> = Vec::new();
    let mut note = |owner: &str, name: String, attributes: &[Attribute]| {
        let docs = attributes.iter().filter(|it| it.path().is_ident("doc"));
        let ranges: Vec<Range<usize>> = docs.map(|it| it.span().byte_range()).collect();
        if let (Some(first), Some(last)) = (ranges.first(), ranges.last()) {
            said.push(Said { owner: owner.to_string(), name, range: first.start..last.end });
        }
    };
    note("", FILE.to_string(), &file.attrs);
    for item in &file.items {
        match item {
            Item::Struct(it) => {
                note("", it.ident.to_string(), &it.attrs);
                fields(&it.ident.to_string(), &it.fields, &mut note);
            }
            Item::Enum(it) => {
                let owner = it.ident.to_string();
                note("", owner.clone(), &it.attrs);
                for variant in &it.variants {
                    note(&owner, variant.ident.to_string(), &variant.attrs);
                    fields(&variant.ident.to_string(), &variant.fields, &mut note);
                }
            }
            Item::Fn(it) => note("", it.sig.ident.to_string(), &it.attrs),
            Item::Const(it) => note("", it.ident.to_string(), &it.attrs),
            Item::Trait(it) => {
                let owner = it.ident.to_string();
                note("", owner.clone(), &it.attrs);
                for item in &it.items {
                    if let TraitItem::Fn(it) = item {
                        note(&owner, it.sig.ident.to_string(), &it.attrs);
                    }
                }
            }
            Item::Impl(it) => {
                let owner = crate::slice::type_name(&it.self_ty).unwrap_or_default();
                for item in &it.items {
                    if let ImplItem::Fn(it) = item {
                        note(&owner, it.sig.ident.to_string(), &it.attrs);
                    }
                }
            }
            _ => {}
        }
    }
    said
}

fn fields(owner: &str, fields: &Fields, note: &mut impl FnMut(&str, String, &[Attribute])) {
    for field in fields {
        note(owner, field.ident.as_ref().map(ToString::to_string).unwrap_or_default(), &field.attrs);
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

    /// A field and a function may share a name.
    #[test]
    fn what_has_a_name_twice_goes_by_its_owner() {
        let text =
            "struct A {\n    /// One.\n    x: f64,\n}\n\nimpl B<f64> {\n    /// Two.\n    fn x() {}\n}\n";
        let said =
            |name: &str| reworded(text, &[(name.to_string(), "Other.".to_string())].into_iter().collect());
        assert_eq!(said("A::x").unwrap(), text.replace("One.", "Other."));
        assert_eq!(said("B::x").unwrap(), text.replace("Two.", "Other."));
        assert!(said("x").unwrap_err().contains("`Owner::x`"));
        assert_eq!(said("C::x").unwrap_err(), "nothing is said of C::x");
    }
}

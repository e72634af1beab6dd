//! Items of a source file, by name: the anchors of the book.

use std::path::Path;

use syn::spanned::Spanned;
use syn::{ImplItem, Item, TraitItem};

/// The items of a file with these names, one below the other, as they stand in it.
///
/// A name is that of a function, a type, a constant, a trait, `Type::method`, or `impl Type` for all that is implemented
/// for it. Documentation comes along. What the exercises mark in the code, and `#[inline]`, does not.
/// The error says which name is missing, and which there are.
pub(crate) fn items(root: &Path, file: &str, names: &[&str]) -> Result<String, String> {
    let text = std::fs::read_to_string(root.join(file)).map_err(|error| format!("{file}: {error}"))?;
    let parsed = syn::parse_file(&text).map_err(|error| format!("{file}: {error}"))?;
    let found = places(&parsed.items);
    let mut parts = Vec::new();
    for name in names {
        let mut here = found.iter().filter(|(it, _)| it == name).peekable();
        if here.peek().is_none() {
            let there: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
            return Err(format!("{file} has no `{name}`; it has {}", there.join(", ")));
        }
        parts.extend(here.map(|(_, lines)| tidy(&text, *lines)));
    }
    Ok(parts.join("\n"))
}

/// The first and the last line of an item, from 1.
type Lines = (usize, usize);

/// Every item that can be named, and where it stands.
fn places(items: &[Item]) -> Vec<(String, Lines)> {
    let mut found = Vec::new();
    for item in items {
        let whole = lines(item);
        match item {
            Item::Fn(it) => found.push((it.sig.ident.to_string(), whole)),
            Item::Struct(it) => found.push((it.ident.to_string(), whole)),
            Item::Enum(it) => found.push((it.ident.to_string(), whole)),
            Item::Const(it) => found.push((it.ident.to_string(), whole)),
            Item::Static(it) => found.push((it.ident.to_string(), whole)),
            Item::Type(it) => found.push((it.ident.to_string(), whole)),
            Item::Trait(it) => {
                found.push((it.ident.to_string(), whole));
                for part in &it.items {
                    if let TraitItem::Fn(function) = part {
                        found.push((format!("{}::{}", it.ident, function.sig.ident), lines(part)));
                    }
                }
            }
            Item::Impl(it) => {
                let syn::Type::Path(path) = &*it.self_ty else { continue };
                let Some(last) = path.path.segments.last() else { continue };
                found.push((format!("impl {}", last.ident), whole));
                for part in &it.items {
                    if let ImplItem::Fn(function) = part {
                        found.push((format!("{}::{}", last.ident, function.sig.ident), lines(part)));
                    }
                }
            }
            _ => {}
        }
    }
    found
}

/// Where an item stands, its documentation included.
fn lines(item: &impl Spanned) -> Lines {
    let span = item.span();
    (span.start().line, span.end().line)
}

/// The lines from the first to the last, moved to the left as far as they go together.
fn tidy(text: &str, (first, last): Lines) -> String {
    let is_mark = |line: &str| {
        let line = line.trim_start();
        line.starts_with("// exercise ") || line.starts_with("// end ") || line.starts_with("#[inline")
    };
    let lines = text.lines().skip(first - 1).take(last + 1 - first);
    let lines: Vec<&str> = lines.filter(|line| !is_mark(line)).collect();
    let indent = |line: &&str| line.len() - line.trim_start().len();
    let common = lines.iter().filter(|line| !line.is_empty()).map(indent).min().unwrap_or(0);
    let mut result = String::new();
    for line in lines {
        result += line.get(common..).unwrap_or_default();
        result.push('\n');
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "/// One.\n#[derive(Clone)]\npub struct One(u8);\n\nimpl One {\n    /// Its f.\n    #[inline]\n    \
                        pub fn f(&self) -> u8 {\n        // exercise f: What is f?\n        self.0\n        \
                        // end f\n    }\n}\n\nfn two() {}\n";

    fn cut(names: &[&str]) -> Result<String, String> {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.rs"), FILE).unwrap();
        items(folder.path(), "a.rs", names)
    }

    #[test]
    fn an_item_comes_with_its_documentation_and_without_marks() {
        assert_eq!(cut(&["One"]).unwrap(), "/// One.\n#[derive(Clone)]\npub struct One(u8);\n");
        assert_eq!(cut(&["One::f"]).unwrap(), "/// Its f.\npub fn f(&self) -> u8 {\n    self.0\n}\n");
        assert!(cut(&["impl One"]).unwrap().starts_with("impl One {\n    /// Its f.\n"));
        assert_eq!(cut(&["two", "One"]).unwrap().lines().next(), Some("fn two() {}"));
    }

    #[test]
    fn a_name_that_is_not_there_is_told_with_those_that_are() {
        assert_eq!(cut(&["three"]).unwrap_err(), "a.rs has no `three`; it has One, impl One, One::f, two");
        assert!(items(Path::new("/nowhere"), "a.rs", &[]).unwrap_err().starts_with("a.rs: "));
    }
}

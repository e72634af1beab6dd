//! The same library as a module among others of one crate.

use proc_macro2::{TokenStream, TokenTree};
use syn::Item;
use syn::spanned::Spanned;

use crate::manifest::Fillings;
use crate::source::{Files, below};
use crate::{Manifest, Source};

/// Solutions of exercises as modules of one crate, written when that is built.
#[derive(Clone, Debug)]
pub struct Solutions {
    at: String,
    count: usize,
    /// The text of all modules.
    pub text: String,
}

impl Solutions {
    /// None yet. `at` is the module of the crate that will have them.
    pub fn at(at: &str) -> Solutions {
        Solutions { at: at.to_string(), count: 0, text: String::new() }
    }

    /// Adds an exercise's library with these fillings. The path of its probe from [`Solutions::at`].
    pub fn add(
        &mut self,
        source: &Source,
        exercise: &Manifest,
        fillings: &Fillings,
    ) -> Result<String, String> {
        self.count += 1;
        let module = format!("s{}", self.count);
        let files = exercise.library(source, fillings)?;
        let text = inline(&files, &format!("{}::{module}", self.at));
        self.text += &text.map_err(|error| format!("{}: {error}", exercise.name))?;
        Ok(format!("{module}::probe::probe"))
    }
}

/// The files of a library as one module: `pub mod NAME { … }`. `path` is where the module stands in its
/// crate, its own name included: `crate::path` of the library becomes `crate::PATH::path`.
pub fn inline(files: &Files, path: &str) -> Result<String, String> {
    let name = path.rsplit("::").next().unwrap_or_default();
    let text = module(files, "lib.rs", path)?;
    Ok(format!("pub mod {name} {{\n{text}}}\n"))
}

fn module(files: &Files, file: &str, path: &str) -> Result<String, String> {
    let text = files.get(file).ok_or(format!("{file} is declared, and not there"))?;
    let parsed = syn::parse_file(text).map_err(|error| format!("{file}: {error}"))?;
    let mut changes: Vec<(std::ops::Range<usize>, String)> = Vec::new();
    for item in &parsed.items {
        if let Item::Mod(syn::ItemMod { ident, semi: Some(semi), .. }) = item {
            let below = module(files, &below(file, &ident.to_string()), path)?;
            changes.push((semi.span().byte_range(), format!(" {{\n{below}}}")));
        }
    }
    let tokens: TokenStream = text.parse().map_err(|error| format!("{file}: {error}"))?;
    roots(tokens, &mut |after_crate| changes.push((after_crate..after_crate, format!("::{path}"))));
    changes.sort_by_key(|(range, _)| range.start);
    let (mut result, mut from) = (String::new(), 0);
    for (range, new) in changes {
        result += &text[from..range.start];
        result += &new;
        from = range.end;
    }
    Ok(result + &text[from..])
}

/// Says where `crate` ends in each `crate::`.
fn roots(tokens: TokenStream, say: &mut dyn FnMut(usize)) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Ident(ident) if ident == "crate" => {
                if matches!(tokens.peek(), Some(TokenTree::Punct(it)) if it.as_char() == ':') {
                    say(ident.span().byte_range().end);
                }
            }
            TokenTree::Group(group) => roots(group.stream(), say),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_stand_where_they_were_declared_and_find_each_other() {
        let files = [
            ("lib.rs", "pub mod a;\npub use a::A;\n"),
            ("a.rs", "//! A.\nmod b;\nuse crate::{A};\npub(crate) fn f() -> crate::A { g!(crate::A) }\n"),
            ("a/b.rs", "//! B.\n"),
        ];
        let files = files.iter().map(|(name, text)| (name.to_string(), text.to_string())).collect();
        let text = inline(&files, "all::one").unwrap();
        let expected = "pub mod one {\npub mod a {\n//! A.\nmod b {\n//! B.\n}\nuse crate::all::one::{A};\n\
                        pub(crate) fn f() -> crate::all::one::A { g!(crate::all::one::A) }\n}\npub use a::A;\n}\n";
        assert_eq!(text, expected);
    }
}

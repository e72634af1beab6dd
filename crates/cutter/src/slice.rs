//! What of a file comes along: all of it but its tests and its stage, or some of its items.

use std::collections::BTreeMap;

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{Attribute, Item, Meta, UseTree};

/// How much of a file comes along.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// Everything that is there without its tests and its stage.
    All,
    /// The items with these names, what is implemented for them, and the imports from outside.
    Items(Vec<String>),
}

/// A part of a file, and the modules that it declares.
#[derive(Clone, Debug, PartialEq)]
pub struct Slice {
    /// The text.
    pub text: String,
    /// The names of the modules that are in files of their own, in order.
    pub modules: Vec<String>,
}

/// Everything but the tests, the stage, and the modules that `keeps` does not want.
pub fn without_tests(text: &str, keeps: impl Fn(&str) -> bool) -> Result<Slice, String> {
    let file = parse(text)?;
    let mut slice = Slice { text: String::new(), modules: Vec::new() };
    let mut from = 0;
    for item in &file.items {
        let module = module(item);
        let wanted = is_built(attributes(item)) && module.as_deref().is_none_or(&keeps);
        if wanted {
            slice.modules.extend(module);
        } else {
            let range = lines(text, item.span());
            slice.text += &text[from..range.start];
            from = range.end;
        }
    }
    slice.text += &text[from..];
    Ok(slice)
}

/// The modules that a file declares and that come along, by name, and how much of each.
pub type Modules = BTreeMap<String, Part>;

/// The items with these names in the file's order, what is implemented for them, imports from outside, and of
/// `modules` their declarations and what is taken from them, as far as it is there. `Err` where there is no
/// item of a name.
pub fn items(text: &str, names: &[String], modules: &Modules) -> Result<Slice, String> {
    let file = parse(text)?;
    let every = file.items.iter().filter_map(module).collect::<Vec<_>>();
    let mut slice = Slice { text: String::new(), modules: Vec::new() };
    let mut missing: Vec<&String> = names.iter().collect();
    let mut before = None;
    for item in file.items.iter().filter(|item| is_built(attributes(item))) {
        let name = name(item);
        let whole = || text[lines(text, item.span())].trim_start_matches('\n').to_string();
        let wanted = match item {
            Item::Use(it) => {
                let from = first_of(&it.tree);
                match modules.get(&from) {
                    Some(Part::Items(there)) => taken(text, it, there),
                    Some(Part::All) => Some(whole()),
                    None => (from != "crate" && !every.contains(&from)).then(whole),
                }
            }
            Item::Mod(it) if it.content.is_none() => modules.contains_key(&it.ident.to_string()).then(whole),
            _ => name.as_ref().is_some_and(|name| names.contains(name)).then(whole),
        };
        if let Some(wanted) = wanted {
            missing.retain(|&missing| Some(missing) != name.as_ref());
            slice.modules.extend(module(item));
            let kind = std::mem::discriminant(item);
            let together = matches!(item, Item::Use(_) | Item::Mod(_)) && before.is_none_or(|it| it == kind);
            slice.text += if together { "" } else { "\n" };
            slice.text += &wanted;
            before = Some(kind);
        }
    }
    match missing.first() {
        Some(name) => Err(format!("there is no item {name}")),
        None => Ok(slice),
    }
}

/// Everything but one module, and what is taken from it. `Err` where there is no such module.
pub fn without_module(text: &str, module: &str) -> Result<String, String> {
    let (mut result, mut from, mut found) = (String::new(), 0, false);
    for item in &parse(text)?.items {
        let of_it = match item {
            Item::Mod(it) => it.ident == module,
            Item::Use(it) => first_of(&it.tree) == module,
            _ => false,
        };
        if of_it {
            let range = lines(text, item.span());
            result += &text[from..range.start];
            (from, found) = (range.end, true);
        }
    }
    if found { Ok(result + &text[from..]) } else { Err(format!("there is no module {module}")) }
}

fn parse(text: &str) -> Result<syn::File, String> {
    syn::parse_file(text).map_err(|error| {
        let at = error.span().start();
        format!("line {}, column {}: {error}", at.line, at.column + 1)
    })
}

/// The name of a module in a file of its own.
fn module(item: &Item) -> Option<String> {
    match item {
        Item::Mod(it) if it.content.is_none() => Some(it.ident.to_string()),
        _ => None,
    }
}

/// The name by which an item is asked for: an implementation goes by its type.
fn name(item: &Item) -> Option<String> {
    Some(match item {
        Item::Const(it) => it.ident.to_string(),
        Item::Enum(it) => it.ident.to_string(),
        Item::Fn(it) => it.sig.ident.to_string(),
        Item::Static(it) => it.ident.to_string(),
        Item::Struct(it) => it.ident.to_string(),
        Item::Trait(it) => it.ident.to_string(),
        Item::Type(it) => it.ident.to_string(),
        Item::Impl(it) => type_name(&it.self_ty)?,
        _ => return None,
    })
}

/// The name of a type, without its parameters.
pub(crate) fn type_name(of: &syn::Type) -> Option<String> {
    match of {
        syn::Type::Path(path) => Some(path.path.segments.last()?.ident.to_string()),
        _ => None,
    }
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(it) => &it.attrs,
        Item::Enum(it) => &it.attrs,
        Item::Fn(it) => &it.attrs,
        Item::Impl(it) => &it.attrs,
        Item::Mod(it) => &it.attrs,
        Item::Static(it) => &it.attrs,
        Item::Struct(it) => &it.attrs,
        Item::Trait(it) => &it.attrs,
        Item::Type(it) => &it.attrs,
        Item::Use(it) => &it.attrs,
        _ => &[],
    }
}

/// Whether the library alone has it: no test, and not for the stage.
fn is_built(attributes: &[Attribute]) -> bool {
    let cfgs = attributes.iter().filter(|it| it.path().is_ident("cfg"));
    cfgs.filter_map(|it| it.parse_args::<Meta>().ok()).all(|meta| holds(&meta))
}

/// Whether a condition may hold where neither `test` nor a feature is there.
fn holds(condition: &Meta) -> bool {
    let parts = |list: &syn::MetaList| {
        let parser = syn::punctuated::Punctuated::<Meta, syn::Token![,]>::parse_terminated;
        list.parse_args_with(parser)
            .map(|parts| parts.iter().map(holds).collect::<Vec<_>>())
            .unwrap_or_default()
    };
    match condition {
        Meta::Path(path) => !path.is_ident("test"),
        Meta::NameValue(pair) => !pair.path.is_ident("feature"),
        Meta::List(list) if list.path.is_ident("not") => !parts(list).contains(&true),
        Meta::List(list) if list.path.is_ident("any") => parts(list).contains(&true),
        Meta::List(list) => !parts(list).contains(&false),
    }
}

/// An import of some names from a module, of those that are there; `None` where none is.
fn taken(text: &str, import: &syn::ItemUse, there: &[String]) -> Option<String> {
    let UseTree::Path(path) = &import.tree else { return None };
    let name = |tree: &UseTree| match tree {
        UseTree::Name(it) => Some(it.ident.to_string()).filter(|name| there.contains(name)),
        _ => None,
    };
    let names: Vec<String> = match &*path.tree {
        UseTree::Group(group) => group.items.iter().filter_map(name).collect(),
        tree => name(tree).into_iter().collect(),
    };
    let before = &text[import.span().byte_range().start..import.tree.span().byte_range().start];
    let list = names.join(", ");
    match names.len() {
        0 => None,
        1 => Some(format!("{before}{}::{list};\n", path.ident)),
        _ => Some(format!("{before}{}::{{{list}}};\n", path.ident)),
    }
}

fn first_of(tree: &UseTree) -> String {
    match tree {
        UseTree::Path(it) => it.ident.to_string(),
        UseTree::Name(it) => it.ident.to_string(),
        UseTree::Rename(it) => it.ident.to_string(),
        _ => String::new(),
    }
}

/// The lines of an item, to the end of its last one, and an empty one before it.
fn lines(text: &str, span: Span) -> std::ops::Range<usize> {
    let range = span.byte_range();
    let start = text[..range.start].rfind('\n').map_or(0, |at| at + 1);
    let start = if text[..start].ends_with("\n\n") { start - 1 } else { start };
    let end = text[range.end..].find('\n').map_or(text.len(), |at| range.end + at + 1);
    start..end
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "//! About.\n\nmod a;\n#[cfg(feature = \"stage\")]\nmod b;\n\nuse math::Real;\npub use a::A;\n\
                        pub use b::B;\n\n/// One.\n#[derive(Clone)]\npub struct One<R>(R);\n\nimpl<R> One<R> {\n    \
                        fn f() {}\n}\n\n/// Two.\npub fn two() {}\n\n#[cfg(all(test, feature = \"stage\"))]\n\
                        mod tests {\n    use super::*;\n}\n";

    #[test]
    fn tests_and_the_stage_stay_behind() {
        let slice = without_tests(TEXT, |_| true).unwrap();
        assert_eq!(slice.modules, ["a"]);
        for gone in ["tests", "mod b", "cfg"] {
            assert!(!slice.text.contains(gone), "{gone} in\n{}", slice.text);
        }
        assert!(slice.text.starts_with("//! About.\n\nmod a;\n\nuse math::Real;\n"), "{}", slice.text);
        assert!(slice.text.ends_with("/// Two.\npub fn two() {}\n"), "{}", slice.text);
    }

    #[test]
    fn items_come_with_what_is_implemented_for_them() {
        let modules = Modules::from([("a".to_string(), Part::All)]);
        let slice = items(TEXT, &["One".into()], &modules).unwrap();
        let expected = "mod a;\n\nuse math::Real;\npub use a::A;\n\n/// One.\n#[derive(Clone)]\n\
                        pub struct One<R>(R);\n\nimpl<R> One<R> {\n    fn f() {}\n}\n";
        assert_eq!(slice.text, expected);
        assert_eq!(items(TEXT, &["Three".into()], &modules).unwrap_err(), "there is no item Three");
    }

    #[test]
    fn nothing_is_imported_that_stayed_behind() {
        let some = |there: &[&str]| {
            let part = Part::Items(there.iter().map(|name| name.to_string()).collect());
            let text = "mod a;\npub(crate) use a::{A, b, C};\npub use a::D;\n";
            items(text, &[], &Modules::from([("a".to_string(), part)])).unwrap().text
        };
        assert_eq!(some(&["C", "A"]), "mod a;\n\npub(crate) use a::{A, C};\n");
        assert_eq!(some(&["b", "D"]), "mod a;\n\npub(crate) use a::b;\npub use a::D;\n");
        assert_eq!(some(&[]), "mod a;\n");
    }

    #[test]
    fn a_module_stays_behind_with_what_is_taken_from_it() {
        let text = without_module(TEXT, "a").unwrap();
        assert!(!text.contains("mod a;") && !text.contains("a::A"), "{text}");
        assert!(text.contains("use math::Real;\npub use b::B;\n"), "{text}");
        assert_eq!(without_module(TEXT, "c").unwrap_err(), "there is no module c");
    }

    #[test]
    fn conditions_are_weighed() {
        let built = |text: &str| is_built(&syn::parse_str::<syn::ItemFn>(text).unwrap().attrs);
        assert!(built("#[cfg(not(test))] fn f() {}"));
        assert!(!built("#[cfg(any(test, feature = \"stage\"))] fn f() {}"));
        assert!(built("#[cfg(target_arch = \"x86_64\")] fn f() {}"));
        assert!(!built("#[cfg(all(target_arch = \"x86_64\", test))] fn f() {}"));
    }
}

//! Tests and functions that a table names: whether they are there.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The sources of the project's crates, by the crate's name.
pub struct Sources(BTreeMap<String, Vec<Module>>);

/// A file, and the modules that lead to it from the root of its crate.
struct Module {
    path: Vec<String>,
    text: String,
}

/// What can be declared under a name.
const KINDS: [&str; 7] = ["fn", "struct", "enum", "const", "trait", "type", "mod"];

impl Sources {
    /// Reads them all, of the project at `root`. The error names what cannot be read.
    pub fn read(root: &Path) -> Result<Sources, String> {
        let mut found = BTreeMap::new();
        for group in ["chapters", "crates"] {
            for folder in folders(&root.join(group))? {
                let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
                // a chapter's folder has its number before its name
                let name =
                    name.trim_start_matches(|sign: char| sign.is_ascii_digit()).trim_start_matches('-');
                found.insert(name.to_string(), modules(&folder.join("src"))?);
            }
        }
        let mut of_tests = modules(&root.join("tests/src"))?;
        of_tests.extend(modules(&root.join("tests/tests"))?);
        found.insert("tests".to_string(), of_tests);
        Ok(Sources(found))
    }

    /// What is wrong with a cell of names in backquotes: a crate, then what it has, `module::function` or
    /// `module::tests::name`, several where they are separated. A function in a module named `tests` has to be a test.
    pub fn faults(&self, cell: &str) -> Vec<String> {
        let (mut faults, mut of_crate) = (Vec::new(), None);
        for name in names(cell) {
            if let Some(modules) = self.0.get(name) {
                of_crate = Some((name, modules));
                continue;
            }
            match of_crate {
                None => faults.push(format!("`{name}` stands after no crate of the project")),
                Some((of, modules)) if !modules.iter().any(|module| module.has(name)) => {
                    faults.push(format!("`{name}` is not in `{of}`"));
                }
                Some(_) => {}
            }
        }
        faults
    }

    /// Whether a cell names a test: one of its names is that of a function marked `#[test]`.
    pub fn name_a_test(&self, cell: &str) -> bool {
        let is_test = |module: &Module, name: &str| {
            module.has(name) && module.is_test(name.rsplit("::").next().unwrap_or(name))
        };
        names(cell).any(|name| self.0.values().flatten().any(|module| is_test(module, name)))
    }
}

/// The names in a cell: what stands in backquotes.
fn names(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

/// Whether a name promises a test: `module::tests::name`.
fn promises_a_test(name: &str) -> bool {
    name.rsplit_once("::").is_some_and(|(before, _)| before.split("::").any(|part| part == "tests"))
}

impl Module {
    /// Whether what is named `a::b::c` is declared here: the first parts are the last modules on the way to this file,
    /// the next ones modules or types in it. What begins with a type may stand in any file, as types are known at the
    /// root of their crate.
    fn has(&self, name: &str) -> bool {
        let parts: Vec<&str> = name.split("::").collect();
        let Some((last, before)) = parts.split_last() else { return false };
        (0..=before.len()).any(|of_path| {
            let (outside, inside) = before.split_at(of_path);
            let is_here = match outside {
                [] => self.path.is_empty() || parts.len() > 1 && is_type(parts[0]),
                _ => self.path.ends_with(&owned(outside)),
            };
            let is_in_it = |part: &&str| self.declares(part) || is_type(part) && self.has_methods_of(part);
            is_here && inside.iter().all(is_in_it) && self.is_as_named(name, last)
        })
    }

    fn is_as_named(&self, name: &str, last: &str) -> bool {
        let is_function = self.places("fn", last).next().is_some();
        self.declares(last) && (!is_function || !promises_a_test(name) || self.is_test(last))
    }

    fn has_methods_of(&self, name: &str) -> bool {
        let mut impls = self.text.lines().filter(|line| line.starts_with("impl"));
        impls.any(|line| {
            line.split(|sign: char| !sign.is_alphanumeric() && sign != '_').any(|word| word == name)
        })
    }

    fn declares(&self, name: &str) -> bool {
        KINDS.iter().any(|kind| self.places(kind, name).next().is_some())
    }

    /// A line before the function says `#[test]`, with nothing but attributes and comments between.
    fn is_test(&self, name: &str) -> bool {
        self.places("fn", name).any(|at| {
            let mut before = self.text[..at].lines().rev().skip_while(|line| line.trim().is_empty());
            let goes_on = |line: &&str| line.trim().starts_with("#[") || line.trim().starts_with("//");
            before.by_ref().take_while(goes_on).any(|line| line.trim() == "#[test]")
        })
    }

    /// Where something of a kind is declared by a name, not in a comment.
    fn places<'a>(&'a self, kind: &str, name: &str) -> impl Iterator<Item = usize> + use<'a> {
        let declared = format!("{kind} {name}");
        let length = declared.len();
        let found: Vec<usize> = self.text.match_indices(&declared).map(|(at, _)| at).collect();
        found.into_iter().filter(move |&at| {
            let start = self.text[..at].rfind('\n').map_or(0, |end| end + 1);
            let before = &self.text[start..at];
            let ends =
                !self.text[at + length..].starts_with(|sign: char| sign.is_alphanumeric() || sign == '_');
            ends && !before.contains("//") && (before.is_empty() || before.ends_with(' '))
        })
    }
}

/// Whether a name is written as those of types are.
fn is_type(name: &str) -> bool {
    name.starts_with(char::is_uppercase)
}

fn owned(parts: &[&str]) -> Vec<String> {
    parts.iter().map(ToString::to_string).collect()
}

fn folders(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut all: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    all.retain(|path| path.is_dir());
    all.sort();
    Ok(all)
}

/// All Rust files below a folder.
fn modules(folder: &Path) -> Result<Vec<Module>, String> {
    let (mut found, mut open) = (Vec::new(), vec![folder.to_path_buf()]);
    while let Some(path) = open.pop() {
        let trouble = |error: std::io::Error| format!("{}: {error}", path.display());
        if path.is_dir() {
            open.extend(fs::read_dir(&path).map_err(trouble)?.filter_map(|entry| Some(entry.ok()?.path())));
        } else if path.extension().is_some_and(|it| it == "rs") {
            let way = path.strip_prefix(folder).unwrap_or(&path).with_extension("");
            let mut way: Vec<String> = way.iter().map(|part| part.to_string_lossy().into_owned()).collect();
            if way.last().is_some_and(|last| ["lib", "main", "mod"].contains(&last.as_str())) {
                way.pop();
            }
            found.push(Module { path: way, text: fs::read_to_string(&path).map_err(trouble)? });
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sources() -> Sources {
        let module = |path: &[&str], text: &str| Module { path: owned(path), text: text.to_string() };
        let notes = "pub fn hit() {}\nimpl Notes {\n    fn at() {}\n}\nstruct Notes;\nmod tests {\n    /// By hand.\n    \
                     #[test]\n    fn a_hit() {}\n    fn helper() {}\n}\n// fn lost()\n";
        let all = vec![module(&[], "mod notes;\npub struct Wall;"), module(&["notes"], notes)];
        Sources(BTreeMap::from([("ray-wall".to_string(), all)]))
    }

    #[test]
    fn what_is_there() {
        for cell in [
            "`ray-wall`, `notes::hit`; and more",
            "`ray-wall`, `notes::tests::a_hit`, `Wall`",
            "`ray-wall`, `notes::Notes::at`, `Notes::at`",
            "– (no number depends on it)",
        ] {
            assert_eq!(sources().faults(cell), [""; 0], "{cell}");
        }
    }

    #[test]
    fn a_test_is_told_from_a_function() {
        assert!(sources().name_a_test("`ray-wall`, `notes::hit`, `notes::tests::a_hit`"));
        assert!(!sources().name_a_test("`ray-wall`, `notes::hit`") && !sources().name_a_test("–"));
    }

    #[test]
    fn what_is_not_there() {
        for name in [
            "notes::hi",
            "robust::hit",
            "hit",
            "notes::tests::helper",
            "notes::lost",
            "Notes::hi",
            "Wall::at",
            "notes::tests::a_hi",
        ] {
            assert_eq!(
                sources().faults(&format!("`ray-wall`, `{name}`")),
                [format!("`{name}` is not in `ray-wall`")]
            );
        }
        assert_eq!(sources().faults("`notes::hit`"), ["`notes::hit` stands after no crate of the project"]);
    }
}

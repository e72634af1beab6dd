//! Tests and functions that a table names: whether they are there.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The sources of the project's crates, by the crate's name.
pub(crate) struct Sources(BTreeMap<String, String>);

impl Sources {
    /// Reads them all.
    pub(crate) fn read(root: &Path) -> Result<Sources, String> {
        let mut found = BTreeMap::new();
        for group in ["chapters", "crates"] {
            for folder in folders(&root.join(group))? {
                let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
                // a chapter's folder has its number before its name
                let name =
                    name.trim_start_matches(|sign: char| sign.is_ascii_digit()).trim_start_matches('-');
                found.insert(name.to_string(), text_of(&folder.join("src"))?);
            }
        }
        found.insert("tests".to_string(), text_of(&root.join("tests/tests"))?);
        Ok(Sources(found))
    }

    /// What is wrong with a cell of names in backquotes: a crate, then what it has, `module::function` or
    /// `module::tests::name`, several where they are separated.
    pub(crate) fn faults(&self, cell: &str) -> Vec<String> {
        let (mut faults, mut of_crate) = (Vec::new(), None);
        for name in cell.split('`').skip(1).step_by(2) {
            if let Some(text) = self.0.get(name) {
                of_crate = Some((name, text));
                continue;
            }
            let Some((of, text)) = of_crate else {
                faults.push(format!("`{name}` stands after no crate of the project"));
                continue;
            };
            let last = name.rsplit("::").next().unwrap_or(name);
            let kinds = ["fn", "struct", "enum", "const", "trait", "type", "mod"];
            let is_there = |kind: &str| {
                let declared = format!("{kind} {last}");
                let ends = |rest: &str| !rest.starts_with(|sign: char| sign.is_alphanumeric() || sign == '_');
                text.match_indices(&declared).any(|(at, _)| ends(&text[at + declared.len()..]))
            };
            if !kinds.iter().any(|kind| is_there(kind)) {
                faults.push(format!("`{name}` is not in `{of}`"));
            }
        }
        faults
    }
}

fn folders(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut all: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    all.retain(|path| path.is_dir());
    all.sort();
    Ok(all)
}

/// All Rust files below a folder, in one text.
fn text_of(folder: &Path) -> Result<String, String> {
    let (mut text, mut open) = (String::new(), vec![folder.to_path_buf()]);
    while let Some(path) = open.pop() {
        let trouble = |error: std::io::Error| format!("{}: {error}", path.display());
        if path.is_dir() {
            open.extend(fs::read_dir(&path).map_err(trouble)?.filter_map(|entry| Some(entry.ok()?.path())));
        } else if path.extension().is_some_and(|it| it == "rs") {
            text += &fs::read_to_string(&path).map_err(trouble)?;
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_there_and_what_is_not() {
        let sources =
            Sources(BTreeMap::from([("ray-wall".to_string(), "pub fn hit() {}\nmod notes;".to_string())]));
        assert!(sources.faults("`ray-wall`, `notes::hit`; and more").is_empty());
        assert_eq!(sources.faults("`ray-wall`, `notes::hi`"), ["`notes::hi` is not in `ray-wall`"]);
        assert_eq!(sources.faults("`notes::hit`"), ["`notes::hit` stands after no crate of the project"]);
        assert!(sources.faults("– (no number depends on it)").is_empty());
    }
}

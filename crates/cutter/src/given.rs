//! What earlier chapters taught, solved: their bare libraries, and the math core.

use std::collections::BTreeMap;

use toml::{Table, Value};

use crate::source::Files;
use crate::{Source, slice};

/// The crates that a chapter's bare library stands on.
#[derive(Clone, Debug)]
pub struct Given {
    /// Those of this workspace, each with its folder, by name.
    pub folders: BTreeMap<String, String>,
    /// Of these and the chapter itself, what each needs directly.
    pub needs: BTreeMap<String, Vec<String>>,
    /// Those from elsewhere, each as the workspace asks for it.
    pub outside: BTreeMap<String, Value>,
}

/// What the bare library of the crate in `folder` stands on, and what those stand on.
pub fn given(source: &Source, folder: &str) -> Result<Given, String> {
    let workspace = table(source, "Cargo.toml")?;
    let known = workspace.get("workspace").and_then(|it| it.get("dependencies")).and_then(Value::as_table);
    let known = known.ok_or("Cargo.toml has no workspace.dependencies")?;
    let (folders, needs, outside) = Default::default();
    let mut given = Given { folders, needs, outside };
    let mut open = vec![folder.to_string()];
    while let Some(folder) = open.pop() {
        let cargo = table(source, &format!("{folder}/Cargo.toml"))?;
        let name =
            cargo.get("package").and_then(|it| it.get("name")).and_then(Value::as_str).unwrap_or_default();
        let empty = Table::new();
        let wanted = cargo.get("dependencies").and_then(Value::as_table).unwrap_or(&empty);
        let optional = |value: &Value| value.get("optional").and_then(Value::as_bool) == Some(true);
        let wanted: Vec<&String> =
            wanted.iter().filter(|(_, it)| !optional(it)).map(|(name, _)| name).collect();
        for &need in &wanted {
            let asked =
                known.get(need).ok_or(format!("{folder}/Cargo.toml: {need} is not the workspace's"))?;
            match asked.get("path").and_then(Value::as_str) {
                Some(path) if !given.folders.contains_key(need) => {
                    given.folders.insert(need.clone(), path.to_string());
                    open.push(path.to_string());
                }
                Some(_) => {}
                None => {
                    given.outside.insert(need.clone(), asked.clone());
                }
            }
        }
        given.needs.insert(name.to_string(), wanted.into_iter().cloned().collect());
    }
    Ok(given)
}

fn table(source: &Source, path: &str) -> Result<Table, String> {
    source.read(path)?.parse().map_err(|error| format!("{path}: {error}"))
}

impl Given {
    /// The lines of `[dependencies]` for a crate, `to` being where the given ones are from there, with a
    /// slash at its end; none for a crate that is not among [`Given::needs`].
    pub fn dependencies(&self, name: &str, to: &str) -> String {
        let line = |need: &String| match self.outside.get(need) {
            Some(asked) => format!("{need} = {asked}\n"),
            None => format!("{need} = {{ path = \"{to}{need}\" }}\n"),
        };
        self.needs.get(name).map(|needs| needs.iter().map(line).collect()).unwrap_or_default()
    }

    /// The given crates as files, a folder each, but for modules that stay behind: `math/grid`.
    pub fn files(&self, source: &Source, without: &[String]) -> Result<Files, String> {
        let mut files = Files::new();
        for (name, folder) in &self.folders {
            let cargo = format!(
                "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\npublish = false\n\n\
                 [dependencies]\n{}\n[lints.rust]\n{QUIET}",
                self.dependencies(name, "../")
            );
            files.insert(format!("{name}/Cargo.toml"), cargo);
            for (file, text) in source.whole(&format!("{folder}/src"), "lib.rs")? {
                files.insert(format!("{name}/src/{file}"), text);
            }
        }
        for path in without {
            let (name, module) = path.split_once('/').ok_or(format!("{path} is no module of a crate"))?;
            let behind = [format!("{name}/src/{module}.rs"), format!("{name}/src/{module}/")];
            let lib = files.get_mut(&format!("{name}/src/lib.rs"));
            let lib = lib.ok_or(format!("{path} is not given"))?;
            *lib = slice::without_module(lib, module)?;
            files.retain(|file, _| *file != behind[0] && !file.starts_with(&behind[1]));
        }
        Ok(files)
    }
}

/// Parts of a chapter may be without use where the rest stayed behind, or where a question is in the way.
pub(crate) const QUIET: &str = "dead_code = \"allow\"\nunexpected_cfgs = \"allow\"\nunreachable_code = \"allow\"\n\
                                unused_assignments = \"allow\"\nunused_imports = \"allow\"\nunused_mut = \"allow\"\n\
                                unused_variables = \"allow\"\n";

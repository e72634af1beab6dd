//! The checkout that everything is cut from.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::slice::{self, Modules, Part, Slice};
use crate::{Filling, cut};

/// A checkout of this workspace.
#[derive(Clone, Debug)]
pub struct Source {
    root: PathBuf,
}

/// Files by their path, from the folder that they are in.
pub type Files = BTreeMap<String, String>;

impl Source {
    /// The checkout at a folder.
    pub fn at(root: impl Into<PathBuf>) -> Source {
        Source { root: root.into() }
    }

    /// Its folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The text of a file, by its path from the checkout's folder.
    pub fn read(&self, path: &str) -> Result<String, String> {
        let path = self.root.join(path);
        fs::read_to_string(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))
    }

    /// The names in a folder that end like this, in order; none where there is no such folder.
    pub fn list(&self, folder: &str, ending: &str) -> Result<Vec<String>, String> {
        let path = self.root.join(folder);
        if !path.is_dir() {
            return Ok(Vec::new());
        }
        let failed = |error| format!("cannot list {}: {error}", path.display());
        let mut names = Vec::new();
        for entry in fs::read_dir(&path).map_err(failed)? {
            let name = entry.map_err(failed)?.file_name().to_string_lossy().into_owned();
            if name.ends_with(ending) {
                names.push(name);
            }
        }
        names.sort();
        Ok(names)
    }

    /// A chapter's folder: `chapters/04-ray-sphere` for `ray-sphere`. `Err` where there is no such chapter.
    pub fn chapter(&self, name: &str) -> Result<String, String> {
        let of_this_name = |folder: &String| folder.get(3..) == Some(name);
        let folder = self.list("chapters", "")?.into_iter().find(of_this_name);
        folder.map(|folder| format!("chapters/{folder}")).ok_or(format!("there is no chapter {name}"))
    }

    /// A file of a library and all the modules below it, without tests and stage and marks. `folder` is the
    /// library's `src`, `file` the path of the file in it.
    pub fn whole(&self, folder: &str, file: &str) -> Result<Files, String> {
        let mut files = Files::new();
        self.add(folder, file, &Part::All, &Modules::new(), &BTreeMap::new(), &mut files)?;
        Ok(files)
    }

    /// Adds a part of a file, with some of its regions filled. All of a file has the modules below it with
    /// it; some of its items have only the declarations of `modules`, which are to be added too.
    pub(crate) fn add(
        &self,
        folder: &str,
        file: &str,
        part: &Part,
        modules: &Modules,
        fillings: &BTreeMap<String, Filling>,
        files: &mut Files,
    ) -> Result<(), String> {
        let path = format!("{folder}/{file}");
        let said = |error| format!("{path}: {error}");
        let text = cut(&self.read(&path)?, fillings).map_err(said)?;
        let text = match part {
            Part::All => {
                let Slice { text, modules } = slice::without_tests(&text, |_| true).map_err(said)?;
                for module in &modules {
                    self.add(
                        folder,
                        &below(file, module),
                        &Part::All,
                        &Modules::new(),
                        &BTreeMap::new(),
                        files,
                    )?;
                }
                text
            }
            Part::Items(names) => slice::items(&text, names, modules).map_err(said)?.text,
        };
        files.insert(file.to_string(), text);
        Ok(())
    }
}

/// The file of a module that another file declares.
pub(crate) fn below(file: &str, module: &str) -> String {
    match file {
        "lib.rs" => format!("{module}.rs"),
        _ => format!("{}/{module}.rs", file.trim_end_matches(".rs")),
    }
}

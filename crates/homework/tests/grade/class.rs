//! A class: folders with submissions, and their grades.

use std::fs;
use std::path::{Path, PathBuf};

use homework::{Catalog, GradeAsk, GradeFormat, grade};
use serde_json::Value;

pub(crate) const EXERCISE: &str = "ray-sphere/closest-approach";
const FILE: &str = "src/closest_approach.rs";
/// What a submission does when it is asked for the first time.
const ENTRY: &str = "let length = ray.direction.length();";

/// Submissions in a folder that is removed at the end.
pub(crate) struct Class {
    folder: tempfile::TempDir,
    solution: String,
}

impl Class {
    pub(crate) fn new() -> Class {
        let catalog = Catalog::read().unwrap();
        let manifest = &catalog.find(EXERCISE).unwrap().manifest;
        let solution =
            manifest.library(&catalog.source, &Default::default()).unwrap()[&manifest.file].clone();
        assert!(solution.contains(ENTRY));
        Class { folder: tempfile::tempdir().unwrap(), solution }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// A submission that is right; its folder.
    pub(crate) fn right(&self, name: &str) -> PathBuf {
        self.with(name, |solution| solution.to_string())
    }

    /// The solution, changed.
    pub(crate) fn with(&self, name: &str, change: impl Fn(&str) -> String) -> PathBuf {
        let folder = self.path(name);
        fs::create_dir_all(folder.join("src")).unwrap();
        fs::write(folder.join("expected.txt"), format!("exercise\t{EXERCISE}\n")).unwrap();
        fs::write(folder.join(FILE), change(&self.solution)).unwrap();
        folder
    }

    /// The solution that does something before it answers.
    pub(crate) fn that(&self, name: &str, does: &str) -> PathBuf {
        self.with(name, |solution| solution.replace(ENTRY, &format!("{{ {does} }}\n    {ENTRY}")))
    }

    /// The solution with items added to it.
    pub(crate) fn with_items(&self, name: &str, items: &str) -> PathBuf {
        self.with(name, |solution| format!("{solution}\n{items}\n"))
    }

    /// The grades of all of them by name; `None`, and a word, where there is no sandbox.
    pub(crate) fn grades(&self) -> Option<Grades> {
        self.graded(false)
    }

    pub(crate) fn graded(&self, unsandboxed: bool) -> Option<Grades> {
        let output = self.printed(GradeFormat::Json, unsandboxed)?;
        Some(Grades(serde_json::from_str(&output).unwrap()))
    }

    /// What is printed of all of them.
    pub(crate) fn printed(&self, format: GradeFormat, unsandboxed: bool) -> Option<String> {
        let mut folders: Vec<PathBuf> =
            fs::read_dir(self.folder.path()).unwrap().map(|entry| entry.unwrap().path()).collect();
        folders.sort();
        let ask = GradeAsk { folders, exercise: None, format, jobs: Some(3), unsandboxed };
        let mut output = Vec::new();
        match grade(&ask, &mut output) {
            Ok(()) => Some(String::from_utf8(output).unwrap()),
            Err(error) if error.to_string().contains("no sandbox") => {
                assert!(std::env::var_os("SANDBOX").is_none(), "{error}");
                eprintln!("skipped: {error}");
                None
            }
            Err(error) => panic!("{error}"),
        }
    }
}

pub(crate) struct Grades(Vec<Value>);

impl Grades {
    pub(crate) fn of(&self, name: &str) -> &Value {
        self.0.iter().find(|it| it["student"] == name).unwrap_or_else(|| panic!("{name}: {:#?}", self.0))
    }

    /// It earned so much of 9, and what is said of it contains this.
    pub(crate) fn says(&self, name: &str, score: u32, status: &str, words: &str) {
        let it = self.of(name);
        let said = it["output"].as_str().unwrap();
        assert_eq!((&it["score"], &it["status"]), (&score.into(), &status.into()), "{it:#}");
        assert!(said.contains(words), "{words:?} is not in {it:#}");
    }

    pub(crate) fn said(&self, name: &str) -> &str {
        self.of(name)["output"].as_str().unwrap()
    }
}

/// A path as a text in Rust.
pub(crate) fn quoted(path: &Path) -> String {
    format!("{:?}", path.to_str().unwrap())
}

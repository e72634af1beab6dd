//! What was handed in: folders that may hold anything.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use cutter::source::Files;
use stage::Error;

use crate::report::one_line;
use crate::{Catalog, Exercise, folder};

/// A folder that was handed in.
#[derive(Clone, Debug)]
pub(crate) struct Submission {
    /// The folder's name, or its path where another one has the same name; fit for a terminal.
    pub(crate) student: String,
    /// Where it is.
    pub(crate) folder: PathBuf,
}

/// What is taken of it.
#[derive(Debug)]
pub(crate) struct Taken<'a> {
    /// The exercise that it is for.
    pub(crate) exercise: &'a Exercise,
    /// The student's own files of `src`.
    pub(crate) files: Files,
}

/// So much of a student's name is shown.
const LONGEST_NAME: usize = 200;

impl Submission {
    /// The submission in a folder, whatever is in it.
    pub(crate) fn at(folder: &Path) -> Submission {
        let named = folder.file_name().map(OsStr::to_os_string);
        // . and .. have no name of their own
        let named = named.or_else(|| folder.canonicalize().ok()?.file_name().map(OsStr::to_os_string));
        let student = named.unwrap_or_else(|| folder.into());
        let student = one_line(&student.to_string_lossy(), LONGEST_NAME);
        Submission { student, folder: folder.to_path_buf() }
    }

    /// The submissions in some folders, each with a name of its own; what a file system or a packer leaves
    /// beside them is passed over.
    pub(crate) fn all(folders: &[PathBuf]) -> Vec<Submission> {
        let left =
            |it: &PathBuf| it.file_name().is_some_and(|name| name == "__MACOSX" || name == ".DS_Store");
        let work = folders.iter().filter(|it| !left(it));
        let mut all: Vec<Submission> = work.map(|it| Submission::at(it)).collect();
        let twice = |all: &[Submission]| {
            let mut count = BTreeMap::<String, usize>::new();
            all.iter().for_each(|it| *count.entry(it.student.clone()).or_default() += 1);
            move |it: &Submission| count.get(&it.student).is_some_and(|&count| count > 1)
        };
        let by_name = twice(&all);
        for it in all.iter_mut().filter(|it| by_name(it)) {
            it.student = one_line(&it.folder.display().to_string(), LONGEST_NAME);
        }
        let by_path = twice(&all);
        for (number, it) in all.iter_mut().enumerate().filter(|(_, it)| by_path(it)) {
            it.student += &format!(" ({})", number + 1);
        }
        all
    }

    /// Reads it; `asked` is the exercise that it has to be for, if one was named. `Err` says why it is none.
    pub(crate) fn take<'a>(
        &self,
        catalog: &'a Catalog,
        asked: Option<&'a Exercise>,
    ) -> Result<Taken<'a>, Error> {
        let folder = self.project();
        let said = folder::exercise_of(&folder);
        let exercise = match (asked, said) {
            (None, said) => catalog.find(&said?)?,
            (Some(asked), Ok(said)) if said != asked.manifest.name && catalog.find(&said).is_ok() => {
                let why = format!("it is for {said}, and {} was set", asked.manifest.name);
                return Err(Error::Request(why));
            }
            (Some(asked), _) => asked,
        };
        let files = folder::students(&folder)?;
        exercise.has_part(catalog, &files)?;
        Ok(Taken { exercise, files })
    }

    /// The folder itself, or, where something that unpacked it put it into another one, its only folder.
    fn project(&self) -> PathBuf {
        match inner(&self.folder).as_slice() {
            [only] if !is_there(&self.folder.join("src")) && is_folder(&only.join("src")) => only.clone(),
            _ => self.folder.clone(),
        }
    }

    /// How many submissions are in the folder, where it is none itself.
    pub(crate) fn holds(&self) -> usize {
        let is_one = |it: &Submission| {
            let project = it.project();
            is_there(&project.join("src")) || is_there(&project.join("expected.txt"))
        };
        match is_one(self) {
            true => 0,
            false => inner(&self.folder).iter().filter(|it| is_one(&Submission::at(it))).count(),
        }
    }
}

impl Exercise {
    /// `Err` where none of the files is there in which the student's part belongs.
    pub(crate) fn has_part(&self, catalog: &Catalog, students: &Files) -> Result<(), Error> {
        let asks = self.manifest.asks(&catalog.source).map_err(Error::Failed)?;
        if asks.iter().any(|(file, _)| students.contains_key(file)) {
            return Ok(());
        }
        let files: Vec<String> = asks.iter().map(|(file, _)| format!("src/{file}")).collect();
        let why = "it is not there: is this the hand-out of another exercise?";
        Err(Error::Request(format!(
            "{} is where the part for {} belongs, and {why}",
            files.join(" or "),
            self.manifest.name
        )))
    }
}

fn is_folder(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|it| it.is_dir())
}

fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// The first folders in a folder, in order.
fn inner(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().take(1000).flatten();
    let entries = entries.filter(|it| !is_no_work(&it.file_name())).map(|it| it.path());
    let mut folders: Vec<PathBuf> = entries.filter(|it| is_folder(it)).collect();
    folders.sort();
    folders
}

/// Whether a name is one of those that a file system or a packer leaves: `__MACOSX`, `.DS_Store`, `.git`.
fn is_no_work(name: &OsStr) -> bool {
    name == "__MACOSX" || name.as_encoded_bytes().starts_with(b".")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_has_a_name_of_its_own_that_a_terminal_can_bear() {
        let folders = ["a/ada", "b/ada", "b/bob", "b/bob", "b/c\u{1b}[2J\n", "b/__MACOSX", "b/.DS_Store"];
        let all = Submission::all(&folders.map(PathBuf::from));
        let names: Vec<&str> = all.iter().map(|it| it.student.as_str()).collect();
        assert_eq!(names, ["a/ada", "b/ada", "b/bob (3)", "b/bob (4)", "c\u{fffd}[2J "]);
    }

    #[test]
    fn a_folder_of_submissions_is_told_from_a_submission() {
        let class = tempfile::tempdir().unwrap();
        for name in ["ada/src", "bob/hand-out/src", "__MACOSX/src", "notes"] {
            fs::create_dir_all(class.path().join(name)).unwrap();
        }
        let at = |name: &str| Submission::at(&class.path().join(name));
        assert_eq!(Submission::at(class.path()).holds(), 2);
        assert_eq!(
            (at("ada").holds(), at("bob").holds(), at("notes").holds(), at("gone").holds()),
            (0, 0, 0, 0)
        );
        assert_eq!(at("bob").project(), class.path().join("bob/hand-out"));
        fs::create_dir_all(class.path().join("bob/__MACOSX/src")).unwrap();
        assert_eq!(at("bob").project(), class.path().join("bob/hand-out"));
    }
}

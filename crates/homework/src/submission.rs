//! What was handed in: folders that may hold anything.

use std::fs;
use std::path::{Path, PathBuf};

use cutter::source::Files;
use stage::Error;

use crate::folder;

/// A folder that was handed in.
#[derive(Clone, Debug)]
pub(crate) struct Submission {
    /// The folder's name.
    pub(crate) student: String,
    /// Where it is.
    pub(crate) folder: PathBuf,
}

/// What is taken of it.
#[derive(Debug)]
pub(crate) struct Taken {
    /// The exercise that it says it is for.
    pub(crate) exercise: String,
    /// The student's own files of `src`.
    pub(crate) files: Files,
}

impl Submission {
    /// The submission in a folder, whatever is in it.
    pub(crate) fn at(folder: &Path) -> Submission {
        let named = folder.file_name().map(|name| name.to_os_string());
        // . and .. have no name of their own
        let named = named.or_else(|| folder.canonicalize().ok()?.file_name().map(|name| name.to_os_string()));
        let student = named.unwrap_or_else(|| folder.into()).to_string_lossy().into_owned();
        Submission { student, folder: folder.to_path_buf() }
    }

    /// Reads it; `asked` is the exercise that it has to be for, if one was named. `Err` says why it is none.
    pub(crate) fn take(&self, asked: Option<&str>) -> Result<Taken, Error> {
        let folder = self.project();
        let exercise = match asked {
            Some(name) => name.to_string(),
            None => folder::exercise_of(&folder)?,
        };
        Ok(Taken { exercise, files: folder::students(&folder)? })
    }

    /// The folder itself, or, where something that unpacked it put it into another one, its only folder.
    fn project(&self) -> PathBuf {
        let is_folder = |path: &Path| fs::symlink_metadata(path).is_ok_and(|it| it.is_dir());
        if fs::symlink_metadata(self.folder.join("src")).is_err()
            && let Ok(entries) = fs::read_dir(&self.folder)
        {
            let inner: Vec<PathBuf> =
                entries.take(100).flatten().map(|it| it.path()).filter(|it| is_folder(it)).collect();
            if let [only] = inner.as_slice()
                && is_folder(&only.join("src"))
            {
                return only.clone();
            }
        }
        self.folder.clone()
    }
}

//! Hands an exercise out.

use std::env;
use std::fs;
use std::io::Write;
use std::path::{self, Path};

use cutter::source::Files;
use exercise::Sheet;
use stage::{Error, Scratch};

use crate::{Catalog, Exercise, folder};

/// Writes a hand-out to a new folder, or into an empty one: whole or, where it fails or is interrupted, not
/// at all. Then says on `output` where it is and what to do next.
///
/// [`Error::Request`] where there is no exercise of that name; [`Error::Failed`] where [`Catalog::read`]
/// fails, where something is in the folder already, or a file cannot be written; [`Error::PipeClosed`] where
/// nobody reads the output.
pub fn start(name: &str, into: &Path, output: &mut dyn Write) -> Result<(), Error> {
    let catalog = Catalog::read()?;
    let exercise = catalog.find(name)?;
    folder::new(into)?;
    put(&hand_out(&catalog, exercise)?, into)?;
    let manifest = &exercise.manifest;
    let (into, here) = (into.display(), into.canonicalize().ok() == env::current_dir().ok());
    let go = if here { String::new() } else { format!("cd {} && ", as_a_word(&into.to_string())) };
    let said = format!(
        "{}: {}\nIt is in {into}, about {} minutes.",
        manifest.name, manifest.title, manifest.minutes
    );
    writeln!(output, "{said} Read README.md there, then:\n  {go}cargo run").map_err(Error::from_output)
}

/// As a shell reads one word, whatever is in it.
fn as_a_word(text: &str) -> String {
    let is_plain = |sign: char| sign.is_alphanumeric() || "/._-+:,@".contains(sign);
    if text.chars().all(is_plain) { text.to_string() } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

/// Writes files beside a folder first, and then gives them its name.
fn put(files: &Files, into: &Path) -> Result<(), Error> {
    let failed = |error| folder::failed("make", into, error);
    let whole = path::absolute(into).map_err(failed)?;
    let is_there = whole.is_dir();
    // what is there may be a link, or the root of a disk: it is filled, and all others are made
    let parent = if is_there { &whole } else { whole.parent().unwrap_or(&whole) };
    fs::create_dir_all(parent).map_err(failed)?;
    let new = || Ok(tempfile::Builder::new().prefix(".hand-out-").tempdir_in(parent)?.keep());
    let beside = Scratch::new(new).map_err(failed)?;
    // whoever may read such a folder is not for tempfile to say
    let ready = beside.path().join("ready");
    let into_place = || {
        // its name until it is whole is nobody's business
        folder::put(files, &ready).map_err(|(_, error)| error)?;
        if !is_there {
            return fs::rename(&ready, &whole);
        }
        for entry in fs::read_dir(&ready)? {
            let entry = entry?;
            fs::rename(entry.path(), whole.join(entry.file_name()))?;
        }
        Ok(())
    };
    beside.uninterrupted(into_place).map_err(failed)
}

/// The files of a hand-out, by their paths in its folder. [`Error::Failed`] where it cannot be cut from the
/// checkout.
pub fn hand_out(catalog: &Catalog, exercise: &Exercise) -> Result<Files, Error> {
    let shown = exercise.shown();
    let files = cutter::hand_out(&exercise.manifest, &catalog.source, shown.to_text(), &transcript(&shown));
    files.map_err(Error::Failed)
}

/// What a sheet expects, for reading.
fn transcript(sheet: &Sheet) -> String {
    let mut text = String::new();
    for (number, row) in sheet.rows.iter().enumerate() {
        text += &format!("{}\n  given {}\n", sheet.properties[row.property].name, sheet.case(number));
        text += &exercise::lines(&row.steps.0);
        text += "\n";
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shell_reads_a_path_as_one_word() {
        for (path, word) in
            [("a/b-2.x", "a/b-2.x"), ("a b/ü x", "'a b/ü x'"), ("it's", "'it'\\''s'"), ("a$b", "'a$b'")]
        {
            assert_eq!(as_a_word(path), word);
        }
    }

    #[test]
    fn a_folder_is_whole_or_not_there() {
        let folder = tempfile::tempdir().unwrap();
        let files = Files::from([("src/a.rs".to_string(), "a".to_string())]);
        let names = |path: &Path| -> Vec<_> {
            fs::read_dir(path).unwrap().map(|entry| entry.unwrap().file_name()).collect()
        };
        let (new, empty) = (folder.path().join("far/new"), folder.path().join("empty"));
        fs::create_dir(&empty).unwrap();
        for into in [&new, &empty] {
            put(&files, into).unwrap();
            assert_eq!(fs::read_to_string(into.join("src/a.rs")).unwrap(), "a");
            assert_eq!(names(into), ["src"]);
        }
        assert_eq!(names(&folder.path().join("far")), ["new"], "nothing is left beside it");

        // "src" is a file and cannot be a folder: nothing of it is left
        let both =
            Files::from([("src", "a"), ("src/a.rs", "a")].map(|(a, b)| (a.to_string(), b.to_string())));
        let into = folder.path().join("far/other");
        assert!(put(&both, &into).is_err());
        assert_eq!(names(&folder.path().join("far")), ["new"]);
    }
}

//! Folders of an exercise: what is written there, and what of a student's is taken.

use std::fs;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};

use cutter::source::Files;
use stage::Error;

/// These files of `src` are the exercise's own, and a student's are not looked at.
const GIVEN: [&str; 3] = ["lib.rs", "main.rs", "probe.rs"];
/// More files than this, or larger ones, no solution has.
const MOST_FILES: usize = 64;
const MOST_BYTES: u64 = 1 << 20;

/// Writes files into a folder, making it and those below it.
pub(crate) fn write(files: &Files, folder: &Path) -> Result<(), Error> {
    for (path, text) in files {
        let path = folder.join(path);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all);
        // a file that is as it should be keeps its date, so that nothing is built twice
        let same = fs::read_to_string(&path).is_ok_and(|old| old == *text);
        if !same {
            made.and_then(|()| fs::write(&path, text)).map_err(|error| failed("write", &path, error))?;
        }
    }
    Ok(())
}

/// The student's own files of `src`, by their path there. Links are refused, for they may lead out of the folder.
pub(crate) fn students(folder: &Path) -> Result<Files, Error> {
    let mut files = Files::new();
    let src = folder.join("src");
    let mut open = vec![(src.clone(), String::new())];
    while let Some((path, name)) = open.pop() {
        let entries = fs::read_dir(&path).map_err(|error| failed("list", &path, error))?;
        for entry in entries {
            let entry = entry.map_err(|error| failed("list", &path, error))?;
            let name = format!("{name}{}", entry.file_name().to_string_lossy());
            let kind = entry.file_type().map_err(|error| failed("look at", &entry.path(), error))?;
            match () {
                _ if kind.is_dir() => open.push((entry.path(), format!("{name}/"))),
                _ if GIVEN.contains(&name.as_str()) || !name.ends_with(".rs") => {}
                _ if !kind.is_file() => {
                    let why = "it is a link or no file: only files are taken";
                    return Err(Error::Request(format!("{}: {why}", entry.path().display())));
                }
                _ => {
                    let text = text(&entry.path())?;
                    files.insert(name, text);
                }
            }
            if files.len() > MOST_FILES || open.len() > MOST_FILES {
                return Err(Error::Request(format!("{}: more than {MOST_FILES} files", src.display())));
            }
        }
    }
    Ok(files)
}

/// A text of a student's, which may be anything.
pub(crate) fn text(path: &Path) -> Result<String, Error> {
    let mut bytes = Vec::new();
    let file = fs::File::open(path).map_err(|error| failed("read", path, error))?;
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(|error| failed("read", path, error))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(Error::Request(format!("{}: it has more than a million bytes", path.display())));
    }
    String::from_utf8(bytes)
        .map_err(|_| Error::Request(format!("{}: it is no text in UTF-8", path.display())))
}

/// The name of the exercise that a folder was handed out for.
pub(crate) fn exercise_of(folder: &Path) -> Result<String, Error> {
    let path = folder.join("expected.txt");
    if !path.exists() {
        let why = "it is no hand-out, for it has no expected.txt; name the folder that `exercise start` made";
        return Err(Error::Request(format!("{}: {why}", folder.display())));
    }
    let text = text(&path)?;
    let name = text.lines().next().and_then(|line| line.strip_prefix("exercise\t"));
    let why = || Error::Request(format!("{}, line 1: it should name the exercise", path.display()));
    name.map(String::from).ok_or_else(why)
}

/// A new folder for a hand-out: it must not be there yet, or be empty.
pub(crate) fn new(folder: &Path) -> Result<PathBuf, Error> {
    let empty = match fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) if error.kind() == ErrorKind::NotFound => true,
        Err(error) => return Err(failed("look into", folder, error)),
    };
    match empty {
        true => Ok(folder.to_path_buf()),
        false => {
            let why = "there is something in it already; name a new folder with --into";
            Err(Error::Failed(format!("{}: {why}", folder.display())))
        }
    }
}

pub(crate) fn failed(what: &str, path: &Path, error: io::Error) -> Error {
    Error::Failed(format!("cannot {what} {}: {error}", path.display()))
}

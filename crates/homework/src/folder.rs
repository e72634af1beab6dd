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
const MOST_ENTRIES: usize = 1000;
const MOST_BYTES: u64 = 1 << 20;

/// Writes files into a folder, making it and those below it.
pub(crate) fn write(files: &Files, folder: &Path) -> Result<(), Error> {
    put(files, folder).map_err(|(path, error)| failed("write", &path, error))
}

/// The same; the error has the file that could not be written, for whoever knows it by another name.
pub(crate) fn put(files: &Files, folder: &Path) -> Result<(), (PathBuf, io::Error)> {
    for (path, text) in files {
        let path = folder.join(path);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all);
        // a file that is as it should be keeps its date, so that nothing is built twice
        let same = fs::read_to_string(&path).is_ok_and(|old| old == *text);
        if !same {
            made.and_then(|()| fs::write(&path, text)).map_err(|error| (path, error))?;
        }
    }
    Ok(())
}

/// The student's own files of `src`, by their path there. Links are refused, for they may lead out of the
/// folder.
pub(crate) fn students(folder: &Path) -> Result<Files, Error> {
    let mut files = Files::new();
    let src = folder.join("src");
    let kind = fs::symlink_metadata(&src).map_err(|error| match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => {
            let why = "it has no folder src, where the student's files belong";
            Error::Request(format!("{}: {why}", folder.display()))
        }
        _ => failed("look into", &src, error),
    })?;
    if !kind.is_dir() {
        return Err(Error::Request(format!(
            "{}: it is a link or no folder: only folders are taken",
            src.display()
        )));
    }
    let (mut entries_seen, mut bytes) = (0, 0);
    let mut open = vec![(src.clone(), String::new())];
    while let Some((path, name)) = open.pop() {
        let entries = fs::read_dir(&path).map_err(|error| failed("list", &path, error))?;
        for entry in entries {
            let entry = entry.map_err(|error| failed("list", &path, error))?;
            let name = format!("{name}{}", entry.file_name().to_string_lossy());
            let kind = entry.file_type().map_err(|error| failed("look at", &entry.path(), error))?;
            match () {
                // what a file system leaves beside a file, as `._quadratic.rs`, is nobody's work
                _ if entry.file_name().to_string_lossy().starts_with('.') => {}
                _ if kind.is_dir() => open.push((entry.path(), format!("{name}/"))),
                _ if GIVEN.contains(&name.as_str()) || !name.ends_with(".rs") => {}
                _ if !kind.is_file() => {
                    let why = "it is a link or no file: only files are taken";
                    return Err(Error::Request(format!("{}: {why}", entry.path().display())));
                }
                _ if entry.file_name().to_str().is_none() => {
                    let why = "its name is no text in UTF-8";
                    return Err(Error::Request(format!("{}: {why}", entry.path().display())));
                }
                _ => {
                    let text = text(&entry.path())?;
                    bytes += text.len() as u64;
                    files.insert(name, text);
                }
            }
            entries_seen += 1;
            let too_much = match () {
                _ if files.len() > MOST_FILES => format!("more than {MOST_FILES} files"),
                _ if entries_seen > MOST_ENTRIES => format!("more than {MOST_ENTRIES} files and folders"),
                _ if bytes > MOST_BYTES => "more than a million bytes in all".to_string(),
                _ => continue,
            };
            return Err(Error::Request(format!("{}: {too_much}", src.display())));
        }
    }
    Ok(files)
}

/// A text of a student's, which may be anything: what is no file is not opened, for a pipe would be waited
/// for.
pub(crate) fn text(path: &Path) -> Result<String, Error> {
    let kind = fs::symlink_metadata(path).map_err(|error| failed("read", path, error))?;
    if !kind.is_file() {
        return Err(Error::Request(format!(
            "{}: it is a link or no file: only files are taken",
            path.display()
        )));
    }
    let bytes = first(path, MOST_BYTES + 1).map_err(|error| failed("read", path, error))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(Error::Request(format!("{}: it has more than a million bytes", path.display())));
    }
    String::from_utf8(bytes)
        .map_err(|_| Error::Request(format!("{}: it is no text in UTF-8", path.display())))
}

/// The first bytes of a file; of what is no file, none.
pub(crate) fn first(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    if fs::symlink_metadata(path)?.is_file() {
        fs::File::open(path)?.take(most).read_to_end(&mut bytes)?;
    }
    Ok(bytes)
}

/// The name of the exercise that a folder was handed out for.
pub(crate) fn exercise_of(folder: &Path) -> Result<String, Error> {
    let path = folder.join("expected.txt");
    match fs::metadata(folder) {
        Ok(kind) if kind.is_dir() => {}
        Ok(_) => {
            let why = "it is no folder; what is packed has to be unpacked first";
            return Err(Error::Request(format!("{}: {why}", folder.display())));
        }
        Err(_) => return Err(Error::Request(format!("{}: there is no such folder", folder.display()))),
    }
    if fs::symlink_metadata(&path).is_err() {
        let why = "it is no hand-out, for it has no expected.txt; name the folder that `exercise start` made";
        return Err(Error::Request(format!("{}: {why}", folder.display())));
    }
    let text = text(&path)?;
    let name = text.lines().next().and_then(|line| line.strip_prefix("exercise\t"));
    let why = || Error::Request(format!("{}, line 1: it should name the exercise", path.display()));
    name.map(String::from).ok_or_else(why)
}

/// A new folder for a hand-out: it must not be there yet, or be empty.
pub(crate) fn new(folder: &Path) -> Result<(), Error> {
    let empty = match fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) if error.kind() == ErrorKind::NotFound => true,
        Err(error) => return Err(failed("look into", folder, error)),
    };
    match empty {
        true => Ok(()),
        false => {
            let why = "there is something in it already; name a new folder with --into";
            Err(Error::Failed(format!("{}: {why}", folder.display())))
        }
    }
}

pub(crate) fn failed(what: &str, path: &Path, error: io::Error) -> Error {
    let remedy = match error.kind() {
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
            "; copy the folder to where you may write"
        }
        ErrorKind::StorageFull => "; free some space",
        ErrorKind::FileTooLarge => "; it is larger than a file may be here, see ulimit -f",
        ErrorKind::NotADirectory => "; name a folder",
        _ => "",
    };
    Error::Failed(format!("cannot {what} {}: {error}{remedy}", path.display()))
}

#[cfg(all(test, unix))]
mod tests {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    use std::os::unix::fs::symlink;

    use super::*;

    fn attempt() -> tempfile::TempDir {
        let attempt = tempfile::tempdir().unwrap();
        fs::create_dir_all(attempt.path().join("src/deep")).unwrap();
        fs::write(attempt.path().join("src/a.rs"), "a").unwrap();
        fs::write(attempt.path().join("src/deep/b.rs"), "b").unwrap();
        attempt
    }

    #[test]
    fn only_the_students_own_files_are_taken() {
        let attempt = attempt();
        for name in ["src/lib.rs", "src/main.rs", "src/probe.rs", "src/notes.txt", "build.rs", "Cargo.toml"] {
            fs::write(attempt.path().join(name), "not taken").unwrap();
        }
        symlink("/etc/passwd", attempt.path().join("src/notes")).unwrap();
        let files = students(attempt.path()).unwrap();
        assert_eq!(
            files.into_iter().collect::<Vec<_>>(),
            [("a.rs", "a"), ("deep/b.rs", "b")].map(|(name, text)| (name.to_string(), text.to_string()))
        );
    }

    #[test]
    fn links_pipes_and_what_is_no_text_are_refused() {
        let refused = |name: &[u8], make: &dyn Fn(&Path), why: &str| {
            let attempt = attempt();
            let path = attempt.path().join(OsStr::from_bytes(name));
            make(&path);
            let error = students(attempt.path()).unwrap_err().to_string();
            assert!(error.contains(why), "{error}");
        };
        refused(b"src/c.rs", &|path| symlink("/etc/passwd", path).unwrap(), "only files are taken");
        let pipe = |path: &Path| {
            assert!(std::process::Command::new("mkfifo").arg(path).status().unwrap().success());
        };
        refused(b"src/c.rs", &pipe, "only files are taken");
        refused(b"src/c.rs", &|path| fs::write(path, b"\xff\xfe").unwrap(), "no text in UTF-8");
        refused(b"src/\xff.rs", &|path| fs::write(path, b"a").unwrap(), "its name is no text in UTF-8");
        refused(
            b"src/c.rs",
            &|path| fs::write(path, vec![b' '; 2 << 20]).unwrap(),
            "more than a million bytes",
        );
        let many = |path: &Path| {
            fs::create_dir(path).unwrap();
            (0..100).for_each(|number| fs::write(path.join(format!("{number}.rs")), "").unwrap());
        };
        refused(b"src/many", &many, "more than 64 files");
    }

    #[test]
    fn a_folder_that_is_a_link_is_not_followed() {
        let (one, other) = (attempt(), tempfile::tempdir().unwrap());
        symlink(one.path().join("src"), other.path().join("src")).unwrap();
        assert!(students(other.path()).unwrap_err().to_string().contains("only folders are taken"));
        symlink(one.path().join("src/a.rs"), other.path().join("expected.txt")).unwrap();
        assert!(exercise_of(other.path()).unwrap_err().to_string().contains("only files are taken"));
    }
}

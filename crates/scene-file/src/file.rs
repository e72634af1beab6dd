//! Files, as far as they are files and not too long.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// Why a file was not read.
#[derive(Debug, PartialEq)]
pub(crate) struct Unread {
    /// Whether another file would do; else the machine is to blame.
    pub(crate) wrong_file: bool,
    pub(crate) problem: String,
}

/// All bytes of a file of at most `limit` bytes. What is no regular file (a folder, a pipe, a device) is not
/// even opened: it might never end, or never begin.
pub(crate) fn bytes_of(path: &Path, limit: u64) -> Result<Vec<u8>, Unread> {
    let about = fs::metadata(path).map_err(|error| unopened(&error))?;
    if about.is_dir() {
        return Err(wrong("it is a folder"));
    }
    if !about.is_file() {
        return Err(wrong("it is not a regular file but a device or a pipe"));
    }
    let too_long = || wrong(&format!("it is longer than {} MiB", limit >> 20));
    if about.len() > limit {
        return Err(too_long());
    }
    let file = File::open(path).map_err(|error| unopened(&error))?;
    let mut bytes = Vec::new();
    // Whatever the length was a moment ago, and the files that say 0 (as in /proc), no more than this is read.
    let read = file.take(limit + 1).read_to_end(&mut bytes);
    read.map_err(|error| Unread { wrong_file: false, problem: error.to_string() })?;
    if bytes.len() as u64 > limit { Err(too_long()) } else { Ok(bytes) }
}

fn unopened(error: &io::Error) -> Unread {
    match error.kind() {
        io::ErrorKind::NotFound => wrong("there is no such file"),
        _ => wrong(&error.to_string()),
    }
}

fn wrong(problem: &str) -> Unread {
    Unread { wrong_file: true, problem: problem.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(path: &str) -> String {
        let unread = bytes_of(Path::new(path), 1 << 20).unwrap_err();
        assert!(unread.wrong_file);
        unread.problem
    }

    #[test]
    fn what_is_no_file_is_not_read() {
        assert_eq!(problem("nowhere/at/all"), "there is no such file");
        assert_eq!(problem("src"), "it is a folder");
        assert_eq!(problem("src\0"), "file name contained an unexpected NUL byte");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_without_an_end_is_not_read() {
        assert_eq!(problem("/dev/zero"), "it is not a regular file but a device or a pipe");
    }

    #[test]
    fn a_file_may_be_as_long_as_the_limit() {
        let path = std::env::temp_dir().join(format!("scene-file-limit-{}", std::process::id()));
        fs::write(&path, vec![b' '; 2 << 20]).unwrap();
        assert_eq!(bytes_of(&path, 2 << 20).unwrap().len(), 2 << 20);
        assert_eq!(bytes_of(&path, 1 << 20).unwrap_err().problem, "it is longer than 1 MiB");
        fs::remove_file(path).unwrap();
    }
}

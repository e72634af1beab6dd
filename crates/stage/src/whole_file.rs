//! Files that appear whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError};

use crate::interrupt::{UNFINISHED, Unfinished};
use crate::{Canvas, Error};

/// Writes a picture as a PNG of 8 bits a channel.
///
/// [`Error::Failed`] where the file cannot be written, with the reason; then the file is what it was
/// before.
pub fn write_picture(picture: &Canvas, path: &Path) -> Result<(), Error> {
    let (width, height) = picture.size();
    let pixels = picture.to_rgb()?;
    write_whole(path, |file| {
        PngEncoder::new_with_quality(file, CompressionType::Fast, FilterType::Adaptive)
            .write_image(&pixels, width, height, ExtendedColorType::Rgb8)
            .map_err(|error| match error {
                ImageError::IoError(error) => error,
                other => io::Error::other(other),
            })
    })
}

/// Writes a file under another name in the same folder and renames it when it is complete, so that whoever
/// looks sees the old file or the new one, whole. A program that is interrupted leaves the old one and
/// nothing else, see [`clean_up_when_interrupted`](crate::clean_up_when_interrupted); one that is killed leaves
/// a hidden file besides, `.PID-N.part`, which nobody minds and anybody may remove. Where `path` is a
/// symbolic link to a file, that file is replaced. What is there and is no file (a folder, a device, a pipe)
/// is left alone: [`Error::Failed`].
pub fn write_whole(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Error> {
    let failed = |error: io::Error| {
        Error::Failed(format!("cannot write {}: {}", path.display(), reason(path, &error)))
    };
    free_for_a_file(path)?;
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    // Where an error ends this, the unfinished file is removed.
    let (unfinished, file) = begin_beside(&target).map_err(failed)?;
    let mut buffer = BufWriter::new(Remembering { file, failed: None });
    let written = write(&mut buffer).and_then(|()| buffer.flush());
    written.map_err(|error| failed(buffer.get_mut().failed.take().unwrap_or(error)))?;
    drop(buffer);
    unfinished.finish(&target).map_err(failed)
}

/// A file that remembers why it could not be written: the encoder of pictures hands on a text alone.
struct Remembering {
    file: File,
    failed: Option<io::Error>,
}

impl Write for Remembering {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes);
        if let Err(error) = &written {
            self.failed = error.raw_os_error().map(io::Error::from_raw_os_error);
        }
        written
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Nothing stands at `path` that a file cannot take the place of.
fn free_for_a_file(path: &Path) -> Result<(), Error> {
    let reason = if path.is_dir() {
        reason(path, &io::ErrorKind::IsADirectory.into())
    } else if path.exists() && !path.is_file() {
        "something that is not a file stands there; write elsewhere".to_string()
    } else {
        return Ok(());
    };
    Err(Error::Failed(format!("cannot write {}: {reason}", path.display())))
}

/// Whether a file can be written at `path`, as far as can be known without writing it: for what comes before it. Nothing
/// is left behind.
///
/// [`Error::Failed`] as [`write_whole`] would give it.
pub(crate) fn try_at(path: &Path) -> Result<(), Error> {
    free_for_a_file(path)?;
    try_beside(&fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf()))
}

/// Whether files can be written beside `path`: for a long task, to find out before it is done. Nothing is
/// left behind.
///
/// [`Error::Failed`] where they cannot. What stands at `path` itself is not looked at, and a symbolic link
/// there is not followed: [`write_whole`] may refuse it still.
pub fn try_beside(path: &Path) -> Result<(), Error> {
    let tried = begin_beside(path).and_then(|(unfinished, _)| unfinished.discard());
    tried.map_err(|error| Error::Failed(format!("cannot write {}: {}", path.display(), reason(path, &error))))
}

/// An empty file beside `path` that nobody else writes. Two runs in containers that share the folder may have
/// the same PID, and so may a run that was killed: their files are left alone.
fn begin_beside(path: &Path) -> io::Result<(Unfinished<'static>, File)> {
    loop {
        match UNFINISHED.begin(unfinished_name(path)) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            begun => return begun,
        }
    }
}

/// `.PID-N.part` beside the file: hidden, and another one each time.
fn unfinished_name(path: &Path) -> PathBuf {
    static WRITTEN: AtomicU32 = AtomicU32::new(0);
    let number = WRITTEN.fetch_add(1, Ordering::Relaxed);
    path.with_file_name(format!(".{}-{number}.part", std::process::id()))
}

/// What went wrong, and what would help.
fn reason(path: &Path, error: &io::Error) -> String {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder.display().to_string(),
        _ => ".".to_string(),
    };
    match error.kind() {
        io::ErrorKind::NotFound if !Path::new(&folder).is_dir() => {
            format!("there is no folder {folder}; create it, or write elsewhere")
        }
        io::ErrorKind::NotFound => {
            format!("the folder {folder}, or what was begun in it, was removed meanwhile; write elsewhere")
        }
        io::ErrorKind::NotADirectory => format!("{folder} is not a folder; write elsewhere"),
        io::ErrorKind::IsADirectory => "it is a folder; name a file".to_string(),
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            format!("the folder {folder} may not be written to; write elsewhere")
        }
        io::ErrorKind::StorageFull => "the disk is full; free some space, or write elsewhere".to_string(),
        io::ErrorKind::FileTooLarge => "it is larger than a file may be here, see ulimit -f".to_string(),
        _ => format!("{error}; write elsewhere"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("whole-file-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn a_failed_write_leaves_the_old_file_and_nothing_else() {
        let folder = folder("old");
        let path = folder.join("a.txt");
        fs::write(&path, "old").unwrap();
        let result = write_whole(&path, |file| {
            file.write_all(b"half of the ne")?;
            Err(io::ErrorKind::StorageFull.into())
        });
        assert!(result.unwrap_err().to_string().contains("the disk is full"));
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn trying_leaves_nothing() {
        let folder = folder("tried");
        try_beside(&folder.join("a.txt")).unwrap();
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
        let error = try_beside(&folder.join("nowhere/a.txt")).unwrap_err();
        assert!(error.to_string().contains("there is no folder"), "{error}");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_another_began_is_left_alone() {
        let folder = folder("begun");
        // the next names of this process, whatever else is tried at the time
        let begun: Vec<PathBuf> = (0..3).map(|_| unfinished_name(&folder.join("a.txt"))).collect();
        let number = |path: &Path| path.to_str().unwrap().rsplit(['-', '.']).nth(1).unwrap().to_string();
        let last: u32 = number(&begun[2]).parse().unwrap();
        let next: Vec<PathBuf> = (1..100)
            .map(|ahead| folder.join(format!(".{}-{}.part", std::process::id(), last + ahead)))
            .collect();
        next.iter().for_each(|path| fs::write(path, "another's").unwrap());
        write_whole(&folder.join("a.txt"), |file| file.write_all(b"new")).unwrap();
        assert_eq!(fs::read_to_string(folder.join("a.txt")).unwrap(), "new");
        assert!(next.iter().all(|path| fs::read_to_string(path).is_ok_and(|text| text == "another's")));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_missing_folder_is_named() {
        let folder = folder("missing");
        let error = write_whole(&folder.join("nowhere/a.txt"), |_| Ok(())).unwrap_err();
        assert_eq!(error.status(), 1);
        assert!(error.to_string().contains("there is no folder"), "{error}");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_finished_file_is_there_under_its_name_alone() {
        let folder = folder("new");
        write_whole(&folder.join("a.txt"), |file| file.write_all(b"new")).unwrap();
        let names: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(names, ["a.txt"]);
        fs::remove_dir_all(folder).unwrap();
    }
}

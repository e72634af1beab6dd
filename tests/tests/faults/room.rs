//! Rooms with a disk of their own, for one command each: by bubblewrap.

use std::path::Path;
use std::process::{Command, Stdio};

use tests::{Folder, Run};

use crate::command::{Through, command};
use crate::files::Files;

/// Sees all that there is, and may change nothing of it.
const READ_ONLY: [&str; 7] = ["bwrap", "--die-with-parent", "--ro-bind", "/", "/", "--dev", "/dev"];

/// A word where there are no rooms.
pub(crate) fn no_rooms() -> bool {
    let tried = Command::new("bwrap").args(["--ro-bind", "/", "/", "true"]).stderr(Stdio::null()).status();
    missing(tried.is_ok_and(|status| status.success()), "bubblewrap does not work here")
}

/// A word where something is missing, but not where it has to be there.
pub(crate) fn missing(is_there: bool, what: &str) -> bool {
    if !is_there {
        assert!(std::env::var_os("FAULTS").is_none(), "{what}");
        eprintln!("skipped: {what}");
    }
    !is_there
}

/// Runs a command in `folder`, which may not be written to.
pub(crate) fn run_read_only(folder: &Path, args: &[&str]) -> Run {
    Run::to_end(command(folder, &READ_ONLY, args))
}

/// Runs a command in `folder`, whose permissions count for root as well.
pub(crate) fn run_without_rights(folder: &Path, args: &[&str]) -> Run {
    let room = ["bwrap", "--die-with-parent", "--bind", "/", "/", "--dev", "/dev", "--cap-drop", "ALL"];
    Run::to_end(command(folder, &room, args))
}

/// What a command in a container would be started with, which is the second process there, as all are: its
/// folder is the real one.
pub(crate) fn container() -> Through<'static> {
    &["bwrap", "--die-with-parent", "--bind", "/", "/", "--dev", "/dev", "--unshare-pid", "--proc", "/proc"]
}

/// Runs a command on a disk that has these files and `spare` pages of 4096 bytes; what is left in the end.
pub(crate) fn run_on_small_disk(files: &Files, spare: usize, args: &[&str]) -> (Run, Folder) {
    let (before, left, disk) = (Folder::new(), Folder::new(), Folder::new());
    files.put_old_ones(before.path());
    let path = |folder: &Folder| folder.path().to_str().expect("a path in UTF-8").to_string();
    let size = ((files.count() + spare) * 4096).to_string();
    let script = format!(
        "cp -a {}/. {disk} && cd {disk} && \"$@\"; status=$?; cp -a {disk}/. {}; exit $status",
        path(&before),
        path(&left),
        disk = path(&disk)
    );
    let (disk, kept) = (path(&disk), path(&left));
    let own = ["--size", &size, "--tmpfs", &disk, "--bind", &kept, &kept, "sh", "-c", &script, "sh"];
    (Run::to_end(command(before.path(), &[&READ_ONLY, &own[..]].concat(), args)), left)
}

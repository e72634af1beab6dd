//! A folder that may not be written to: on a file system that is read only, and by its permissions.

use std::fs::{Permissions, set_permissions};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

use tests::Folder;

use crate::command::{DRAWINGS, GALLERY, HAND_OUT, PAGES, PICTURES, WHOLE_GALLERY, Writer};
use crate::files::Files;
use crate::room::{no_rooms, run_read_only, run_without_rights};

/// All that was there stays, and nothing else is.
fn assert_nothing_changes(writer: &Writer) {
    let folder = writer.folder_of_old_files();
    let cause = "may not be written to; write elsewhere";
    writer.assert_failed(&run_read_only(folder.path(), &writer.args()), folder.path(), cause);
    let run = without_rights(folder.path(), || run_without_rights(folder.path(), &writer.args()));
    writer.assert_failed(&run, folder.path(), cause);
}

/// Does something while a folder may be read only.
fn without_rights<T>(folder: &Path, does: impl FnOnce() -> T) -> T {
    let allow =
        |mode| set_permissions(folder, Permissions::from_mode(mode)).expect("the folder is the test's own");
    allow(0o555);
    let done = does();
    allow(0o755);
    done
}

#[test]
fn the_old_files_stay() {
    if no_rooms() {
        return;
    }
    PICTURES.iter().chain(&*PAGES).chain([&*GALLERY]).for_each(assert_nothing_changes);
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn the_old_drawings_and_the_whole_gallery_stay() {
    if no_rooms() {
        return;
    }
    DRAWINGS.iter().for_each(assert_nothing_changes);
    let (writer, folder) = (&*WHOLE_GALLERY, Folder::new());
    writer.files.put_old_ones(folder.path());
    let run = run_read_only(folder.path(), &writer.args());
    writer.assert_failed(&run, folder.path(), "may not be written to; write elsewhere");
}

#[test]
fn what_cannot_be_made_is_named() {
    if no_rooms() {
        return;
    }
    let folder = Folder::new();
    for (args, cause) in [
        (&["ray-sphere"][..], "error: cannot make the folder out: "),
        (&["ray-sphere", "trade", "--quick"], "error: cannot make the folder out: "),
        (&["workbench", "run", "ray-sphere"], "error: cannot write into out: "),
        (&HAND_OUT.args(), "error: cannot make attempt: "),
    ] {
        let read_only = run_read_only(folder.path(), args);
        let no_rights = without_rights(folder.path(), || run_without_rights(folder.path(), args));
        for run in [read_only, no_rights] {
            assert!(run.status == 1 && run.errors.starts_with(cause), "{args:?}: {run:?}");
        }
        assert_eq!(Files::in_folder(folder.path()), Files::none());
    }
}

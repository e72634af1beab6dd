//! Two runs at once, into the same folder and the same files.

use std::path::Path;

use tests::{Folder, Run, STAGES};

use crate::command::{GALLERY, HAND_OUT, Through, WHOLE_GALLERY, Writer, command};
use crate::files::Files;
use crate::room::{container, no_rooms};

/// Runs all of them at once.
fn run_at_once(folder: &Path, through: Through<'_>, all: &[Vec<&str>]) -> Vec<Run> {
    let start =
        |args: &Vec<&str>| command(folder, through, args).spawn().expect("the program can be started");
    let started: Vec<_> = all.iter().map(start).collect();
    started.into_iter().map(|child| Run::of(child.wait_with_output().expect("it ends"))).collect()
}

/// Each file that is there in the end is whole, and one that one of them would have written.
fn assert_one_of_each(writers: &[&Writer], through: Through<'_>) {
    let folder = writers[0].folder_of_old_files();
    let all: Vec<Vec<&str>> = writers.iter().map(|writer| writer.args()).collect();
    for run in run_at_once(folder.path(), through, &all) {
        assert_eq!(run.status, 0, "{writers:?}: {run:?}");
    }
    let left = Files::in_folder(folder.path());
    assert!(left.names().eq(writers[0].files.names()), "{:?}", left.names().collect::<Vec<_>>());
    for name in left.names() {
        let is_whole = writers.iter().any(|writer| writer.files.content(name) == left.content(name));
        assert!(is_whole, "{writers:?}: {name} is neither");
    }
}

/// The same picture with another pixel explained, and so another picture.
fn pictures_of_two_pixels(name: &str, size: &str, more: &[&str]) -> [Writer; 2] {
    ["1,1", "20,15"].map(|pixel| {
        Writer::new(&[&[name, "--size", size, "--pixel", pixel, "--out", "picture.png"], more].concat())
    })
}

#[test]
fn the_picture_is_one_of_the_two() {
    for name in ["ray-wall", "ray-sphere", "shading"] {
        let two = pictures_of_two_pixels(name, "240x180", &[]);
        (0..2).for_each(|_| assert_one_of_each(&[&two[0], &two[1]], &[]));
    }
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn every_picture_is_one_of_the_two() {
    for stage in STAGES {
        let two = pictures_of_two_pixels(stage.about().name, "640x480", &[]);
        (0..3).for_each(|_| assert_one_of_each(&[&two[0], &two[1]], &[]));
    }
}

/// Containers that share a folder give their processes the same numbers.
#[test]
fn in_two_containers_the_page_is_one_of_the_two() {
    if no_rooms() {
        return;
    }
    let two = pictures_of_two_pixels("ray-sphere", "64x48", &["--inspect", "page.html"]);
    (0..3).for_each(|_| assert_one_of_each(&[&two[0], &two[1]], container()));
}

/// Times differ, so that nobody knows what is drawn; but it is drawn to its end.
#[test]
fn the_drawings_are_whole() {
    let args =
        ["ray-wall", "trade", "--quick", "--cases", "1", "--regime", "ordinary", "--out", "measured.png"];
    let folder = Folder::new();
    for run in run_at_once(folder.path(), &[], &vec![args.to_vec(); 2]) {
        assert_eq!((run.status, run.errors.as_str()), (0, ""));
    }
    let left = Files::in_folder(folder.path());
    assert!(left.count() > 0);
    left.assert_whole(false);
}

#[test]
fn the_gallery_of_some_stages_is_that_of_one() {
    assert_one_of_each(&[&*GALLERY, &*GALLERY], &[]);
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn the_whole_gallery_is_that_of_one() {
    assert_one_of_each(&[&*WHOLE_GALLERY, &*WHOLE_GALLERY], &[]);
}

/// One of them makes the folder; the other may find it too late, and says so.
#[test]
fn one_hand_out_is_made() {
    for _ in 0..5 {
        let folder = Folder::new();
        let runs = run_at_once(folder.path(), &[], &vec![HAND_OUT.args(); 2]);
        assert!(runs.iter().any(|run| run.status == 0), "{runs:?}");
        assert!(runs.iter().all(|run| run.status == 0 || run.errors.contains("attempt")), "{runs:?}");
        assert_eq!(Files::in_folder(folder.path()), HAND_OUT.files);
    }
}

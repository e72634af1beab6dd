//! A folder that is removed while something is on its way into it.

use std::fs;
use std::path::Path;
use std::time::Duration;

use tests::{Folder, Run};

use crate::command::Writer;
use crate::files::{Files, OLD, is_whole};
use crate::started::Started;

/// A picture that takes long enough for a folder to be removed.
const PICTURE: [&str; 9] =
    ["whitted", "--threads", "1", "--samples", "2", "--size", "240x180", "--out", "to/picture.png"];
/// A page, of which half is written by then.
const PAGE: [&str; 7] =
    ["ray-sphere", "--size", "96x72", "--out", "picture.png", "--inspect", "to/page.html"];

/// Removes the folder `to` when `middle` says, and makes it again where that is asked for.
fn run(args: &[&str], middle: impl Fn(&mut Started, &Path), again: bool) -> (Run, Folder) {
    let folder = Folder::new();
    let to = folder.path().join("to");
    fs::create_dir(&to).unwrap();
    fs::write(to.join("picture.png"), OLD).unwrap();
    let mut started = Started::new(folder.path(), args);
    middle(&mut started, &to);
    fs::remove_dir_all(&to).unwrap();
    if again {
        fs::create_dir(&to).unwrap();
    }
    assert!(started.is_running(), "it was done before the folder went");
    (started.run(), folder)
}

fn at_work(started: &mut Started, _: &Path) {
    started.work_for(Duration::from_millis(100));
}

#[test]
fn a_folder_that_is_gone_is_named() {
    let (picture, left) = run(&PICTURE, at_work, false);
    assert_eq!(picture.status, 1, "{picture:?}");
    let told = "error: cannot write to/picture.png: there is no folder to; create it, or write elsewhere\n";
    assert_eq!(picture.errors, told);
    assert!(left.names().is_empty());

    let (page, left) = run(&PAGE, |started, to| started.write_into(to), false);
    assert_eq!(page.status, 1, "{page:?}");
    assert!(page.errors.starts_with("error: cannot write to/page.html: there is no folder to; "), "{page:?}");
    assert_eq!(left.names(), ["picture.png"]);
}

#[test]
fn a_folder_that_is_made_again_gets_the_picture() {
    let (picture, left) = run(&PICTURE, at_work, true);
    assert_eq!((picture.status, picture.errors.as_str()), (0, ""));
    assert!(is_whole("picture.png", Files::in_folder(left.path()).content("to/picture.png")));

    let (page, left) = run(&PAGE, |started, to| started.write_into(to), true);
    assert_eq!(page.status, 1, "{page:?}");
    let told = "or what was begun in it, was removed meanwhile; write elsewhere\n";
    assert!(page.errors.starts_with("error: cannot write to/page.html: the folder to, "), "{page:?}");
    assert!(page.errors.ends_with(told), "{page:?}");
    assert_eq!(Files::in_folder(left.path()).names().collect::<Vec<_>>(), ["picture.png"]);
}

/// The folder where the program was started: it cannot be found any more, and it cannot be made again.
#[test]
fn the_own_folder_is_gone() {
    for out in [&["--out", "picture.png"][..], &[]] {
        let folder = Folder::new();
        let args = [&["whitted", "--threads", "1", "--samples", "2", "--size", "240x180"], out].concat();
        let mut started = Started::new(folder.path(), &args);
        at_work(&mut started, folder.path());
        fs::remove_dir_all(folder.path()).unwrap();
        assert!(started.is_running(), "it was done before the folder went");
        let run = started.run();
        assert!(run.status == 1 && run.errors.starts_with("error: cannot "), "{run:?}");
        assert_eq!(run.errors.lines().count(), 1, "{run:?}");
    }
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn a_gallery_whose_folder_is_gone_is_a_failure() {
    let whole = Writer::new(&["workbench"]);
    for times in 1..12 {
        let folder = Folder::new();
        fs::create_dir(folder.path().join("out")).unwrap();
        let mut started = Started::new(folder.path(), &whole.args());
        std::thread::sleep(Duration::from_millis(100) * times);
        if !started.is_running() {
            break;
        }
        let _ = fs::remove_dir_all(folder.path().join("out"));
        let run = started.run();
        // what comes later may make its own folder
        assert!(run.status <= 1, "{run:?}");
        assert!(run.status == 0 || run.errors.contains("error: cannot "), "{run:?}");
        Files::in_folder(folder.path()).assert_whole(false);
    }
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn drawings_whose_folder_is_gone_are_a_failure_but_the_numbers_are_there() {
    let args = ["ray-sphere", "trade", "--quick", "--out", "to/measured.png"];
    let (run, left) = run(&args, at_work, false);
    assert!(run.status == 1 && run.output.contains("What to take"), "{run:?}");
    assert!(run.errors.starts_with("error: cannot write to/measured-"), "{run:?}");
    assert!(left.names().is_empty());
}

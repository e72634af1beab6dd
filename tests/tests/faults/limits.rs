//! Limits of the system: how large a file may be, how many may be open, how many threads there are.

use std::fs::{self, Permissions, set_permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::Path;
use std::process::Command;

use tests::{Folder, Run, command_in};

use crate::command::{DRAWINGS, GALLERY, HAND_OUT, PAGES, PICTURES, Through, Writer, command};
use crate::files::Files;
use crate::room::missing;

/// Runs a command through `prlimit` and the like.
fn run_under(folder: &Folder, through: Through<'_>, writer: &Writer) -> Run {
    Run::to_end(command(folder.path(), through, &writer.args()))
}

/// It is done, or it failed with a line of cause and all that is there is old or whole.
fn assert_done_or_told(writer: &Writer, run: &Run, left: &Folder) {
    let files = Files::in_folder(left.path());
    files.assert_whole(false);
    assert!(files.names().eq(writer.files.names()), "{writer:?}: {:?}", files.names().collect::<Vec<_>>());
    let told = run.errors.lines().filter(|line| line.starts_with("error: ")).count();
    assert!((run.status == 0 && told == 0) || (run.status == 1 && told == 1), "{writer:?}: {run:?}");
}

/// Without more ado the system ends a program that writes beyond the limit.
#[test]
fn a_file_that_is_too_large_is_a_failure() {
    for writer in PICTURES.iter().chain(&*PAGES).chain([&*GALLERY]) {
        let folder = writer.folder_of_old_files();
        let run = run_under(&folder, &["prlimit", "--fsize=128", "--"], writer);
        writer.assert_failed(&run, folder.path(), "it is larger than a file may be here, see ulimit -f");
    }
}

#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn a_drawing_that_is_too_large_is_a_failure() {
    for writer in &*DRAWINGS {
        let folder = writer.folder_of_old_files();
        let run = run_under(&folder, &["prlimit", "--fsize=128", "--"], writer);
        writer.assert_failed(&run, folder.path(), "it is larger than a file may be here, see ulimit -f");
    }
}

#[test]
fn a_hand_out_that_is_too_large_is_not_there() {
    let folder = Folder::new();
    let run = run_under(&folder, &["prlimit", "--fsize=128", "--"], &HAND_OUT);
    let told = run.errors.starts_with("error: cannot make attempt: ") && run.errors.contains("ulimit -f");
    assert!(run.status == 1 && told, "{run:?}");
    assert_eq!(Files::in_folder(folder.path()), Files::none());
}

/// Answers that go into a file.
#[test]
fn answers_that_are_too_many_for_a_file_are_a_failure() {
    let folder = Folder::new();
    let stage = tests::stage_named("ray-wall").unwrap();
    let rows = format!("{}\n", tests::plain_row(stage)).repeat(1000);
    folder.put("cases.csv", format!("{}\n{rows}", tests::header(stage)));
    let eval = ["ray-wall", "eval", "--cases", "cases.csv"];
    let mut limited = command(folder.path(), &["prlimit", "--fsize=4096", "--"], &eval);
    limited.stdout(fs::File::create(folder.path().join("answers.csv")).unwrap());
    let run = Run::to_end(limited);
    let told = run.errors.starts_with("error: cannot write to standard output: File too large");
    assert!(run.status == 1 && told, "{run:?}");
}

/// From so few that hardly anything can be opened to as many as it takes.
#[test]
fn files_that_cannot_be_opened_are_a_failure() {
    let pictures = [
        Writer::new(&["ray-sphere", "--size", "64x48", "--out", "picture.png"]),
        Writer::new(&["signature", "--out", "picture.png", "--size", "16x12", "--inspect", "page.html"]),
    ];
    for writer in pictures.iter().chain([&*GALLERY]) {
        for open_files in [3, 4, 5, 6, 8, 10] {
            let folder = writer.folder_of_old_files();
            let through = [&format!("--nofile={open_files}")[..], "--"];
            let run = run_under(&folder, &[&["prlimit"], &through[..]].concat(), writer);
            // with fewer the system cannot start a program
            if run.status != 127 {
                assert_done_or_told(writer, &run, &folder);
            }
        }
    }
}

/// A user for whom the limit counts, and who may have one process without threads: another than root, for
/// whom the program has to lie where everybody can read it.
struct Alone {
    program: Folder,
}

impl Alone {
    /// Where there can be such a user.
    fn new() -> Option<Alone> {
        let program = Folder::new();
        fs::copy(env!("CARGO_BIN_EXE_any-stage"), program.path().join("any-stage")).expect("a copy");
        let alone = Alone { program };
        let can = |program: &str, args: &[&str]| {
            alone
                .started(alone.program.path(), program, args)
                .output()
                .is_ok_and(|ended| ended.status.success())
        };
        let any_stage = alone.any_stage();
        let is_alone = can(&any_stage, &["ray-wall", "--help"]) && !can("sh", &["-c", "true & wait $!"]);
        is_alone.then_some(alone)
    }

    fn any_stage(&self) -> String {
        self.program.path().join("any-stage").to_str().expect("a path in UTF-8").to_string()
    }

    /// A program in a folder.
    fn started(&self, folder: &Path, program: &str, args: &[&str]) -> Command {
        let nobody = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"];
        let is_root = fs::metadata("/proc/self").is_ok_and(|own| own.uid() == 0);
        let one_process = ["prlimit", "--nproc=1", "--", program];
        let words = [if is_root { &nobody[..] } else { &[] }, &one_process, args].concat();
        command_in(folder, words[0], &words[1..])
    }

    /// Runs what writes something in a folder of old files.
    fn assert_done_or_told(&self, writer: &Writer) {
        let folder = writer.folder_of_old_files();
        for path in [folder.path().to_path_buf(), folder.path().join("trade")] {
            let _ = set_permissions(path, Permissions::from_mode(0o777));
        }
        let run = Run::to_end(self.started(folder.path(), &self.any_stage(), &writer.args()));
        assert_done_or_told(writer, &run, &folder);
    }
}

fn assert_threads_are_a_failure_or_no_matter<'a>(writers: impl Iterator<Item = &'a Writer>) {
    let alone = Alone::new();
    if !missing(alone.is_some(), "there is no user whose processes can be limited") {
        writers.for_each(|writer| alone.iter().for_each(|alone| alone.assert_done_or_told(writer)));
    }
}

#[test]
fn threads_that_cannot_be_had_are_a_failure_or_no_matter() {
    assert_threads_are_a_failure_or_no_matter(PICTURES.iter().chain(&*PAGES).chain([&*GALLERY]));
}

#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn a_trade_without_threads_is_a_failure_or_no_matter() {
    assert_threads_are_a_failure_or_no_matter(DRAWINGS.iter());
}

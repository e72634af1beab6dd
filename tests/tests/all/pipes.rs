//! Output that nobody reads, or that does not fit.

use std::fs::File;
use std::io::{Write, pipe};
use std::process::{Command, Stdio};

use stage::Stage;
use tests::{Folder, STAGES, with_cases};

use crate::cases::{header, plain_row};
use crate::process::{Run, command};

/// These requests, and `eval` over the cases of a stage that answers any.
fn with_eval<'a>(stage: &dyn Stage, requests: &[&'a [&'a str]]) -> Vec<&'a [&'a str]> {
    let eval: &[&str] = &["eval", "--cases", "cases.csv"];
    let has_cases = !stage.about().inputs.is_empty();
    requests.iter().copied().chain(has_cases.then_some(eval)).collect()
}

/// Runs a command whose standard output was closed by its reader before it began.
fn run_unread(mut command: Command) -> Run {
    let (reader, writer) = pipe().unwrap();
    drop(reader);
    Run::of(command.stdout(writer).output().unwrap())
}

/// A `trade` of one method over one case of one regime.
fn small_trade(stage: &dyn Stage) -> Vec<&'static str> {
    let about = stage.about();
    let what = ["--regime", about.regimes[0].0, "--method", about.methods[0], "--precision", "f64"];
    [&["trade", "--quick", "--cases", "1", "--out", "measured.png"], &what[..]].concat()
}

/// More rows than any buffer holds.
fn many_cases(stage: &dyn Stage) -> String {
    format!("{}\n{}", header(stage), format!("{}\n", plain_row(stage)).repeat(20_000))
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    for stage in STAGES {
        let (folder, name) = (Folder::new(), stage.about().name);
        folder.put("cases.csv", many_cases(*stage));
        for args in with_eval(
            *stage,
            &[
                &["--size", "64x48", "--out", "picture.png"],
                &["--size", "64x48", "--out", "picture.png", "--format", "json"],
                &small_trade(*stage),
                &["--help"],
            ],
        ) {
            let run = run_unread(command(folder.path(), name, args));
            assert_eq!((run.status, run.errors.as_str()), (0, ""), "{name} {args:?}");
        }
        let (drawings, others): (Vec<String>, Vec<String>) =
            folder.names().into_iter().partition(|name| name.starts_with("measured-"));
        assert!(drawings.contains(&"measured-trade.svg".to_string()), "{drawings:?}");
        assert_eq!(others, ["cases.csv", "picture.png"]);
        assert!(image::open(folder.path().join("picture.png")).is_ok(), "the picture is whole");
    }
}

#[test]
fn a_reader_that_goes_away_half_way_is_no_error() {
    for stage in with_cases() {
        let (folder, name) = (Folder::new(), stage.about().name);
        let mut child = command(folder.path(), name, &["eval"]).stdin(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        // The stage stops reading as soon as it finds out.
        let _ = child.stdin.take().unwrap().write_all(many_cases(stage).as_bytes());
        let run = Run::of(child.wait_with_output().unwrap());
        assert_eq!((run.status, run.errors.as_str()), (0, ""), "{name}");
    }
}

#[test]
fn an_error_is_an_error_even_if_nobody_reads_the_output() {
    for stage in STAGES {
        let (folder, name) = (Folder::new(), stage.about().name);
        let run = run_unread(command(folder.path(), name, &["--size", "0x0"]));
        assert_eq!(run.status, 2);
        let run = run_unread(command(folder.path(), name, &["--out", "missing/picture.png"]));
        assert_eq!(run.status, 1);
        std::fs::create_dir(folder.path().join("measured-trade.svg")).unwrap();
        let run = run_unread(command(folder.path(), name, &small_trade(*stage)));
        assert_eq!(run.status, 1);
        assert!(run.errors.starts_with("error: cannot write measured-trade.svg: "), "{}", run.errors);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn output_that_does_not_fit_is_a_failure() {
    for stage in STAGES {
        let (folder, name) = (Folder::new(), stage.about().name);
        folder.put("cases.csv", many_cases(*stage));
        for args in with_eval(*stage, &[&["--size", "64x48", "--out", "picture.png"], &small_trade(*stage)]) {
            let full = File::options().write(true).open("/dev/full").unwrap();
            let run = Run::of(command(folder.path(), name, args).stdout(full).output().unwrap());
            assert_eq!(run.status, 1, "{name} {args:?}");
            assert!(run.errors.starts_with("error: cannot write to standard output: "), "{}", run.errors);
        }
    }
}

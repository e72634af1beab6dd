//! Runs a stage as a process of its own.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// How a run ended and what it said.
pub(crate) struct Run {
    /// The exit status.
    pub(crate) status: i32,
    /// What it wrote to standard output.
    pub(crate) output: String,
    /// What it wrote to standard error.
    pub(crate) errors: String,
}

impl Run {
    /// Reads a run's end. Panics where it was killed, or where it panicked itself.
    pub(crate) fn of(ended: Output) -> Run {
        let [output, errors] =
            [ended.stdout, ended.stderr].map(|bytes| String::from_utf8(bytes).expect("a run prints UTF-8"));
        assert!(!errors.contains("panicked"), "{errors}");
        let status = ended.status.code().unwrap_or_else(|| panic!("{}: {errors}", ended.status));
        Run { status, output, errors }
    }
}

/// The command `STAGE ARGS…` in a folder, with nothing on its standard input.
pub(crate) fn command(folder: &Path, stage: &str, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_any-stage"));
    command.current_dir(folder).arg(stage).args(args);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Runs `STAGE ARGS…` in a folder.
pub(crate) fn run(folder: &Path, stage: &str, args: &[&str]) -> Run {
    Run::of(command(folder, stage, args).output().expect("any-stage can be started"))
}

/// Runs `STAGE ARGS…` in a folder with a text coming through a pipe.
pub(crate) fn run_with_input(folder: &Path, stage: &str, args: &[&str], input: &[u8]) -> Run {
    let mut child =
        command(folder, stage, args).stdin(Stdio::piped()).spawn().expect("any-stage can be started");
    let mut pipe = child.stdin.take().expect("standard input is a pipe");
    std::thread::scope(|scope| {
        // A stage that refuses its input stops reading it.
        scope.spawn(move || pipe.write_all(input));
        Run::of(child.wait_with_output().expect("the run ends"))
    })
}

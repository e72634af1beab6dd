//! Programs that are run as a reader runs them.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// How a run ended and what it said.
#[derive(Debug)]
pub struct Run {
    /// The exit status.
    pub status: i32,
    /// What it wrote to standard output.
    pub output: String,
    /// What it wrote to standard error.
    pub errors: String,
}

impl Run {
    /// Runs a command to its end.
    pub fn to_end(mut command: Command) -> Run {
        Run::of(command.output().expect("the program can be started"))
    }

    /// Runs a command with a text coming through a pipe.
    pub fn with_input(mut command: Command, input: &[u8]) -> Run {
        let mut child = command.stdin(Stdio::piped()).spawn().expect("the program can be started");
        let mut pipe = child.stdin.take().expect("standard input is a pipe");
        std::thread::scope(|scope| {
            // A stage that refuses its input stops reading it.
            scope.spawn(move || pipe.write_all(input));
            Run::of(child.wait_with_output().expect("the run ends"))
        })
    }

    /// Reads a run's end. Panics where it was killed, or where it panicked itself.
    pub fn of(ended: Output) -> Run {
        let [output, errors] =
            [ended.stdout, ended.stderr].map(|bytes| String::from_utf8(bytes).expect("a run prints UTF-8"));
        assert!(!errors.contains("panicked"), "{errors}");
        let status = ended.status.code().unwrap_or_else(|| panic!("{}: {errors}", ended.status));
        Run { status, output, errors }
    }
}

/// The command `PROGRAM ARGS…` in a folder, with nothing on its standard input, what it says being kept.
pub fn command_in(folder: &Path, program: &str, args: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.current_dir(folder).args(args);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

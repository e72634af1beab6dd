//! Runs a stage as a process of its own.

use std::path::Path;
use std::process::Command;

pub(crate) use tests::Run;
use tests::command_in;

/// The command `STAGE ARGS…` in a folder, with nothing on its standard input.
pub(crate) fn command(folder: &Path, stage: &str, args: &[&str]) -> Command {
    command_in(folder, env!("CARGO_BIN_EXE_any-stage"), &[&[stage], args].concat())
}

/// Runs `STAGE ARGS…` in a folder.
pub(crate) fn run(folder: &Path, stage: &str, args: &[&str]) -> Run {
    Run::to_end(command(folder, stage, args))
}

/// Runs `STAGE ARGS…` in a folder with a text coming through a pipe.
pub(crate) fn run_with_input(folder: &Path, stage: &str, args: &[&str], input: &[u8]) -> Run {
    Run::with_input(command(folder, stage, args), input)
}

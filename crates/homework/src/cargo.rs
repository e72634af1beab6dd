//! Cargo, run for a hand-out and not for this workbench.

use std::path::{Path, PathBuf};
use std::process::Command;

use stage::Error;

/// Cargo in a folder.
pub(crate) fn cargo(folder: &Path, verb: &str) -> Command {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.arg(verb).current_dir(folder);
    // what cargo says of this workbench is not said of the hand-out
    for name in ["CARGO_MANIFEST_DIR", "CARGO_TARGET_DIR", "RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS"] {
        cargo.env_remove(name);
    }
    cargo
}

/// Cargo did not start.
pub(crate) fn missing(error: std::io::Error) -> Error {
    Error::Failed(format!(
        "cannot run cargo: {error}; install Rust from https://rustup.rs, \
         or say where cargo is with CARGO=PATH"
    ))
}

/// Runs cargo to the end. [`Error::Failed`] has its own words.
pub(crate) fn run(command: &mut Command, what: &str) -> Result<Vec<u8>, Error> {
    let output = command.output().map_err(missing)?;
    let said = String::from_utf8_lossy(&output.stderr);
    let failed = || Error::Failed(format!("cannot {what}:\n{}", said.trim_end()));
    if output.status.success() { Ok(output.stdout) } else { Err(failed()) }
}

/// Where the compiler and its libraries are.
pub(crate) fn toolchain(folder: &Path) -> Result<PathBuf, Error> {
    let mut rustc = Command::new("rustc");
    let output = run(rustc.args(["--print", "sysroot"]).current_dir(folder), "ask rustc where it is")?;
    Ok(PathBuf::from(String::from_utf8_lossy(&output).trim()))
}

//! Cargo, run for a hand-out and not for this workbench.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use stage::Error;

/// Cargo for the project in a folder. It works from the root of the file system, and without what the
/// environment says of a build: of all settings only the user's own count, not those of a
/// `.cargo/config.toml` or a `rust-toolchain.toml` that lies in or above the folder.
pub(crate) fn cargo(folder: &Path, verb: &str) -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    let folder = whole(folder);
    cargo.arg(verb).arg("--manifest-path").arg(folder.join("Cargo.toml")).current_dir(top(&folder));
    for (name, _) in env::vars_os().filter(|(name, _)| name.to_str().is_some_and(is_of_a_build)) {
        cargo.env_remove(name);
    }
    cargo
}

/// Whether a variable says how something is built: not where cargo's home is, and how it reaches the network.
fn is_of_a_build(name: &str) -> bool {
    let kept = ["HOME", "HTTP_", "NET_", "REGISTR", "SOURCE_", "TERM_"];
    match name.strip_prefix("CARGO_") {
        Some(rest) => !kept.iter().any(|kept| rest.starts_with(kept)),
        None => name.starts_with("RUSTC_") || name == "RUSTFLAGS" || name == "RUSTDOCFLAGS",
    }
}

/// A path from the root.
pub(crate) fn whole(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf())
}

fn top(folder: &Path) -> &Path {
    folder.ancestors().last().unwrap_or(folder)
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
    let output = run(rustc.args(["--print", "sysroot"]).current_dir(top(folder)), "ask rustc where it is")?;
    Ok(PathBuf::from(String::from_utf8_lossy(&output).trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_environment_says_of_a_build_is_left_out() {
        for name in [
            "CARGO_BUILD_TARGET",
            "CARGO_TARGET_DIR",
            "CARGO_PROFILE_DEV_OPT_LEVEL",
            "CARGO_ENCODED_RUSTFLAGS",
            "CARGO_MANIFEST_DIR",
            "RUSTC_WRAPPER",
            "RUSTFLAGS",
        ] {
            assert!(is_of_a_build(name), "{name}");
        }
        for name in
            ["CARGO", "CARGO_HOME", "CARGO_HTTP_PROXY", "CARGO_REGISTRIES_A_TOKEN", "RUSTUP_HOME", "PATH"]
        {
            assert!(!is_of_a_build(name), "{name}");
        }
        let cargo = cargo(Path::new("a"), "build");
        // where the tests themselves are run by cargo, it says this
        let name = "CARGO_MANIFEST_DIR";
        let removed = cargo.get_envs().any(|(it, value)| it == name && value.is_none());
        assert_eq!(removed, env::var_os(name).is_some());
        assert!(cargo.get_current_dir().is_some_and(|it| it.parent().is_none()));
    }
}

//! The interactive figures: a chapter's own Rust as a module in its page.

use std::cell::OnceCell;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use stage::Packed;

use crate::pictures;

/// What the modules are built for.
const TARGET: &str = "wasm32-unknown-unknown";

/// The modules of all figures, built once, when the first page asks for one.
pub(crate) struct Figures {
    root: PathBuf,
    /// Whether this machine can build them.
    is_possible: bool,
    /// The folder of the modules.
    built: OnceCell<Result<PathBuf, String>>,
}

impl Figures {
    /// Those of the project at `root`. Where the target is missing, says so, with the command that adds it:
    /// pages then show the still picture.
    pub(crate) fn of(root: &Path) -> Figures {
        let is_possible = has_target(root);
        if !is_possible {
            eprintln!(
                "figures: still pictures only, as Rust has no {TARGET} here; rustup target add {TARGET}"
            );
        }
        Figures { root: root.to_path_buf(), is_possible, built: OnceCell::new() }
    }

    /// None, as on a machine without the target.
    #[cfg(test)]
    pub(crate) fn none(root: &Path) -> Figures {
        Figures { root: root.to_path_buf(), is_possible: false, built: OnceCell::new() }
    }

    /// The lines that show a chapter's figure. Until its module runs, and where there is none, the stage's
    /// picture stands there.
    pub(crate) fn markdown(&self, name: &str) -> Result<String, String> {
        let still = pictures::markdown(name)?;
        if !self.root.join("book/figures/examples").join(format!("{name}-figure.rs")).is_file() {
            return Err(format!("there is no figure {name}: see book/figures/examples"));
        }
        if !self.is_possible {
            return Ok(format!("<div class=\"interactive\">\n{still}</div>\n"));
        }
        let folder = self.built.get_or_init(|| build(&self.root)).as_ref().map_err(Clone::clone)?;
        let place = folder.join(format!("{}_figure.wasm", name.replace('-', "_")));
        let module = fs::read(&place).map_err(|error| format!("{}: {error}", place.display()))?;
        let packed = packed(&module).map_err(|error| error.to_string())?;
        Ok(format!(
            "<div class=\"interactive\" data-figure=\"{name}\">\n{still}\
             <script type=\"text/plain\" class=\"module\">{packed}</script>\n</div>\n"
        ))
    }
}

/// Whether Rust can build for [`TARGET`] here: its library is there.
fn has_target(root: &Path) -> bool {
    let mut rustc = Command::new("rustc");
    rustc.args(["--print", "target-libdir", "--target", TARGET]).current_dir(root).stderr(Stdio::null());
    let said = rustc.output().map(|output| String::from_utf8_lossy(&output.stdout).trim().to_string());
    said.is_ok_and(|folder| !folder.is_empty() && Path::new(&folder).is_dir())
}

/// Builds all modules beside what else is built; gives their folder.
fn build(root: &Path) -> Result<PathBuf, String> {
    let own = || root.join("target");
    let folder = std::env::var_os("CARGO_TARGET_DIR").map_or_else(own, PathBuf::from).join("figures");
    let folder = std::path::absolute(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut cargo = Command::new("cargo");
    cargo.args(["build", "--locked", "--quiet", "--profile", "figures", "--target", TARGET]);
    cargo.args(["-p", "figures", "--examples", "--target-dir"]).arg(&folder).current_dir(root);
    // flags for this machine are none for a browser
    cargo.env_remove("RUSTFLAGS");
    let output = cargo.output().map_err(|error| format!("cargo does not start: {error}"))?;
    if !output.status.success() {
        return Err(format!("the figures do not build:\n{}", String::from_utf8_lossy(&output.stderr)));
    }
    Ok(folder.join(TARGET).join("figures/examples"))
}

/// A module as a page can hold it.
fn packed(module: &[u8]) -> std::io::Result<String> {
    let mut letters = Vec::new();
    let mut packed = Packed::new(&mut letters);
    packed.write_all(module)?;
    packed.finish()?;
    Ok(String::from_utf8_lossy(&letters).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root() -> &'static Path {
        Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
    }

    #[test]
    fn without_the_target_the_still_picture_is_there() {
        let text = Figures::none(root()).markdown("ray-wall").unwrap();
        assert!(text.contains("pictures/ray-wall.png") && !text.contains("<script"), "{text}");
    }

    #[test]
    fn a_figure_that_is_not_there_is_a_fault() {
        for name in ["bounds", "ray-ball"] {
            assert!(Figures::none(root()).markdown(name).is_err(), "{name}");
        }
    }
}

//! What a user meets: scenes that read, and what is said of those that do not.

mod bad_nff;
mod bad_obj;
mod bad_toml;
mod corpus;
mod files;
mod good;
mod nff;

use std::path::{Path, PathBuf};

use scene_file::{Error, Scene};

/// Compares a text with the committed `snapshots/NAME.snap`.
///
/// `INSTA_UPDATE=always cargo test -p scene-file` accepts what came; then read it.
fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// A scene in TOML without files.
fn toml(text: &str) -> Result<Scene, Error> {
    Scene::from_toml("scene.toml", text, Path::new("nowhere"))
}

/// A folder that is removed in the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let folder = std::env::temp_dir().join(format!("scene-file-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        Folder(folder)
    }

    /// Writes a file and gives its path.
    fn put(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, content).unwrap();
        path
    }

    /// A message without the name of the folder, which differs from run to run.
    fn without(&self, error: &Error) -> String {
        error.to_string().replace(&format!("{}/", self.0.display()), "")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

//! A folder for one test.

use std::fs;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};

/// An empty folder of its own, which goes when the value goes.
pub struct Folder(PathBuf);

impl Folder {
    /// Makes the folder among the system's temporary files. Panics where that is not possible.
    #[expect(clippy::new_without_default, reason = "a folder on the disk is not a default value")]
    pub fn new() -> Folder {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("first-hit-{}-{count}", process::id()));
        fs::create_dir_all(&path).expect("a folder among the temporary files");
        Folder(path)
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Puts a file into it.
    pub fn put(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), content).expect("a file in the test's own folder");
    }

    /// What is in it, hidden files too, in the order of the alphabet.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("the test's own folder");
        let mut names: Vec<String> = entries
            .map(|entry| entry.expect("an entry of the folder").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // A folder that cannot be removed is no reason for a test to fail.
        let _ = fs::remove_dir_all(&self.0);
    }
}

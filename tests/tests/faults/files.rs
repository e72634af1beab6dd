//! The files of a folder.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// What stands in an old file.
pub(crate) const OLD: &str = "an old file";

/// The files of a folder and of those below it, by their paths from there. Folders count as well where they
/// are hidden, for none of those is anybody's wish.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Files(BTreeMap<String, Vec<u8>>);

impl Files {
    /// Those that are in a folder now; in one that is gone there are none.
    pub(crate) fn in_folder(folder: &Path) -> Files {
        let mut files = BTreeMap::new();
        let mut open = vec![(folder.to_path_buf(), String::new())];
        while let Some((folder, before)) = open.pop() {
            for entry in fs::read_dir(folder).into_iter().flatten() {
                let path = entry.expect("an entry of the folder").path();
                let own = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                let name = format!("{before}{own}");
                match fs::read(&path) {
                    Ok(content) => drop(files.insert(name, content)),
                    // a folder, or a file that has gone since
                    Err(_) => {
                        if own.starts_with('.') && path.exists() {
                            files.insert(name.clone(), Vec::new());
                        }
                        open.push((path, name + "/"));
                    }
                }
            }
        }
        Files(files)
    }

    /// No files.
    pub(crate) fn none() -> Files {
        Files(BTreeMap::new())
    }

    /// Their names, in the order of the alphabet.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// What is in them, in that order.
    pub(crate) fn contents(&self) -> impl Iterator<Item = &[u8]> {
        self.0.values().map(Vec::as_slice)
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.0.len()
    }

    /// What is in the one of this name; nothing where it is missing.
    pub(crate) fn content(&self, name: &str) -> &[u8] {
        self.0.get(name).map_or(&[], Vec::as_slice)
    }

    /// Puts an old file into a folder for each of them.
    pub(crate) fn put_old_ones(&self, folder: &Path) {
        for name in self.names() {
            let path = folder.join(name);
            fs::create_dir_all(path.parent().expect("it is in a folder"))
                .expect("a folder of the test's own");
            fs::write(path, OLD).expect("a file of the test's own");
        }
    }

    /// Each of them is an old one, or whole; those that were unfinished when a run was killed may be left
    /// out.
    pub(crate) fn assert_whole(&self, unfinished_too: bool) {
        for (name, content) in &self.0 {
            let hidden = name.split('/').any(|part| part.starts_with('.'));
            assert!(!hidden || unfinished_too || is_of_a_hand_out(name), "{name} was left behind");
            assert!(hidden || content == OLD.as_bytes() || is_whole(name, content), "{name} is not whole");
        }
    }
}

/// A hand-out has a hidden file of its own.
fn is_of_a_hand_out(name: &str) -> bool {
    name.ends_with("/.gitignore")
}

/// Whether a file has its end.
pub(crate) fn is_whole(name: &str, content: &[u8]) -> bool {
    let end: &[u8] = match name.rsplit('.').next() {
        // its checksums are right as well
        Some("png") => return image::load_from_memory(content).is_ok(),
        Some("svg") => b"</svg>",
        Some("html") => b"</html>",
        _ => return !content.is_empty(),
    };
    content.trim_ascii_end().ends_with(end)
}

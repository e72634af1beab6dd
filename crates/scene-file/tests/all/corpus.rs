//! What the fuzzers start from and what they once broke: every text is read, or refused with a message that can be
//! shown.

use std::path::Path;

use scene_file::{Error, Mesh, Scene};

use crate::toml;

/// Reads every file of a corpus; bytes that are no UTF-8 are what a file may hold and a text may not.
fn replay(corpus: &str, read: impl Fn(&str) -> Result<(), Error>) {
    let folder = Path::new("corpus").join(corpus);
    let mut count = 0;
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        let text = String::from_utf8_lossy(&std::fs::read(&path).unwrap()).into_owned();
        if let Err(error) = read(&text) {
            assert_eq!(error.status(), 2, "{}", path.display());
            assert!(error.line().is_some() && !error.remedy().is_empty(), "{}: {error}", path.display());
        }
        count += 1;
    }
    assert!(count > 5, "{count} files in {}", folder.display());
}

#[test]
fn toml_corpus() {
    replay("toml", |text| toml(text).map(drop));
}

#[test]
fn nff_corpus() {
    replay("nff", |text| Scene::from_nff("scene.nff", text).map(drop));
}

#[test]
fn obj_corpus() {
    replay("obj", |text| Mesh::from_obj("mesh.obj", text).map(drop));
}

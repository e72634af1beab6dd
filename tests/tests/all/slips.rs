//! Every test that the list of slips names is there.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The sources of a crate, in one text.
fn sources(name: &str) -> String {
    let folders = ["chapters", "crates"].map(|folder| fs::read_dir(root().join(folder)).unwrap());
    let mut folders = folders.into_iter().flatten().map(|entry| entry.unwrap().path());
    // a chapter's folder has its number before its name
    let is_named = |path: &PathBuf| {
        let folder = path.file_name().unwrap().to_str().unwrap();
        folder.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start_matches('-') == name
    };
    let folder = folders.find(is_named).unwrap_or_else(|| panic!("no crate {name}"));
    let (mut text, mut open) = (String::new(), vec![folder.join("src")]);
    while let Some(path) = open.pop() {
        if path.is_dir() {
            open.extend(fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()));
        } else {
            text.push_str(&fs::read_to_string(path).unwrap());
        }
    }
    text
}

#[test]
fn every_test_that_a_slip_names_is_there() {
    let page = fs::read_to_string(root().join("book/src/slips.md")).unwrap();
    let mut count = 0;
    let rows = page.lines().filter(|line| line.starts_with('|') && line.contains("::"));
    for row in rows {
        let shown_by = row.trim_end_matches([' ', '|']).rsplit('|').next().unwrap();
        let mut of_crate = String::new();
        for name in shown_by.split('`').skip(1).step_by(2) {
            match name.rsplit_once("::") {
                Some((_, test)) => {
                    assert!(of_crate.contains(&format!("fn {test}()")), "{name}, in\n{row}");
                    count += 1;
                }
                None => of_crate = sources(name),
            }
        }
    }
    assert!(count > 30, "{count}");
}

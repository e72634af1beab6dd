//! Every function and test that the tables of two pages name is there: the slips of the notes, and their coverage.

use std::fs;
use std::path::Path;

use cutter::named::Sources;

#[test]
fn every_name_in_the_tables_is_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let sources = Sources::read(&root).unwrap();
    for (page, least) in [("slips.md", 25), ("coverage.md", 60)] {
        let text = fs::read_to_string(root.join("book/src").join(page)).unwrap();
        let rows: Vec<&str> =
            text.lines().filter(|line| line.starts_with('|') && line.contains("::")).collect();
        assert!(rows.len() >= least, "{page}: {} rows", rows.len());
        for row in rows {
            let named = row.trim_end_matches([' ', '|']).rsplit('|').next().unwrap();
            assert_eq!(sources.faults(named), [""; 0], "{page}: {row}");
        }
    }
}

//! The case files that the book's pages ask for: each is answered, and the answers are those that were read beside
//! the page's own words. What `show` prints there is fetched when the book is built.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use tests::Folder;

use crate::assert_snapshot;
use crate::readme::{blocks, printed};

#[test]
fn what_a_page_evaluates_is_what_it_says() {
    let pages = Path::new(env!("CARGO_MANIFEST_DIR")).join("../book/src");
    let mut names: Vec<_> = fs::read_dir(&pages).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    let mut said = String::new();
    for name in names.iter().filter_map(|name| name.to_str()).filter(|name| name.ends_with(".md")) {
        let (page, folder) = (fs::read_to_string(pages.join(name)).unwrap(), Folder::new());
        let blocks = blocks(&page);
        if let Some((_, cases)) = blocks.iter().find(|(language, _)| *language == "csv") {
            folder.put("cases.csv", cases);
        }
        let lines =
            blocks.iter().filter(|(language, _)| *language == "sh").flat_map(|(_, text)| text.lines());
        for line in lines.filter(|line| line.starts_with("printf '") || line.contains(" eval ")) {
            let answer = printed(line, &folder).expect("a command that is done");
            if !answer.is_empty() {
                writeln!(said, "{name}: {line}\n{answer}").unwrap();
            }
        }
    }
    assert!(said.lines().count() > 20, "{said}");
    assert_snapshot("book.eval", &said);
}

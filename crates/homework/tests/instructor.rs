//! The lecturer's page in the book is what the exercises say.

use homework::{ListFormat, list};

#[test]
fn the_page_is_up_to_date() {
    let mut page = Vec::new();
    list(ListFormat::Instructor, &mut page).unwrap();
    let place = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/instructor.md");
    let there = std::fs::read_to_string(place).unwrap_or_default();
    let renew = "cargo run -- exercise list --format instructor > book/src/instructor.md";
    assert!(
        there.as_bytes() == page,
        "book/src/instructor.md is not what the exercises say; renew it:\n  {renew}"
    );
}

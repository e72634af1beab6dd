//! The class whose grades the book shows.

use std::fs;
use std::path::Path;

use homework::GradeFormat;

use crate::class::Class;

/// What the book prints is what is printed: one is right, one mistaken, one does not compile, one does not end.
#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn the_class_of_the_book() {
    let class = Class::new();
    class.right("ada");
    class.with("bob", |solution| solution.replace("u_r.dot(c - p_r)", "u_r.dot(c)"));
    class.with("eve", |solution| solution.replace("let d = (", "let d = true * ("));
    class.that("mallory", "loop { std::hint::spin_loop(); }");
    let Some(printed) = class.printed(GradeFormat::Text, false) else { return };
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/class.txt");
    if std::env::var_os("UPDATE_CLASS").is_some() {
        fs::write(&page, &printed).unwrap();
    }
    assert_eq!(fs::read_to_string(page).unwrap(), printed, "UPDATE_CLASS=1 writes it");
}

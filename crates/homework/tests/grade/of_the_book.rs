//! The class whose grades the book shows.

use std::fs;
use std::path::Path;

use homework::GradeFormat;

use crate::class::Class;

/// What the book prints is what is printed: one is right, one mistaken, one does not compile, one does not end.
#[test]
#[ignore = "it compiles and runs submissions in the sandbox, half a minute: .ci/full runs it"]
fn the_class_of_the_book() {
    let class = Class::new();
    class.right("ada");
    add_bob(&class);
    class.with("eve", |solution| solution.replace("let d = (", "let d = true * ("));
    class.that("mallory", "loop { std::hint::spin_loop(); }");
    is_in_the_book(&class, GradeFormat::Text, "grades.txt");
}

/// One of them, as other programs read it.
#[test]
#[ignore = "it compiles and runs submissions in the sandbox, half a minute: .ci/full runs it"]
fn one_of_the_class_for_programs() {
    let class = Class::new();
    add_bob(&class);
    is_in_the_book(&class, GradeFormat::Json, "bob.json");
    is_in_the_book(&class, GradeFormat::Csv, "bob.csv");
    is_in_the_book(&class, GradeFormat::Gradescope, "bob-gradescope.json");
}

/// He takes the world's origin for the ray's.
fn add_bob(class: &Class) {
    class.with("bob", |solution| solution.replace("u_r.dot(c - p_r)", "u_r.dot(c)"));
}

fn is_in_the_book(class: &Class, format: GradeFormat, name: &str) {
    let Some(printed) = class.printed(format, false) else { return };
    let printed = printed.replace(class.path("").to_str().unwrap(), "submissions/");
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/class").join(name);
    if std::env::var_os("UPDATE_CLASS").is_some() {
        fs::write(&page, &printed).unwrap();
    }
    assert_eq!(fs::read_to_string(page).unwrap(), printed, "UPDATE_CLASS=1 writes it");
}

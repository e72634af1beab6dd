//! The exercises of a chapter, as their own files say them.

use std::path::Path;

use cutter::{Manifest, Source};

/// The exercises of the chapter of that name as a table; an error where there is none.
pub(crate) fn markdown(root: &Path, chapter: &str) -> Result<String, String> {
    let all = Manifest::all(&Source::at(root.to_path_buf()))?;
    let here: Vec<&Manifest> =
        all.iter().filter(|exercise| exercise.name.split('/').next() == Some(chapter)).collect();
    let first = here.first().ok_or_else(|| format!("there is no exercise of a chapter {chapter}"))?;
    let mut table = "| exercise | what it teaches | minutes |\n| --- | --- | --- |\n".to_string();
    for exercise in &here {
        let (name, title) = (&exercise.name, exercise.title.replace('|', "\\|"));
        let teaches = exercise.teaches.replace('|', "\\|").replace('\n', " ");
        table += &format!("| {title}<br>`{name}` | {} | {} |\n", teaches.trim(), exercise.minutes);
    }
    let start = format!(
        "cargo run --release -- exercise start {} --into DIR\ncargo run --release -- check DIR",
        first.name
    );
    let then = "`DIR` is then a cargo project of its own. Its README names the files with the holes, each of which asks a \
                question; `cargo run` in it prints your values up to the first that is wrong, and says what to do \
                next; `cargo test` tries each property by itself.";
    Ok(format!("{table}\n```sh\n{start}\n```\n\n{then}\n"))
}

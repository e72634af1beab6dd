//! What exercises there are.

use std::io::Write;

use serde_json::json;
use stage::Error;

use crate::Catalog;
use crate::instructor::page;

/// How exercises are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListFormat {
    /// A line each.
    Text,
    /// For other programs.
    Json,
    /// A page for the lecturer, with the answers.
    Instructor,
}

/// Lists every exercise, in the order of the book.
///
/// [`Error::Failed`] as [`Catalog::read`] says, and where the output cannot be written; [`Error::PipeClosed`]
/// where nobody reads it.
pub fn list(format: ListFormat, output: &mut dyn Write) -> Result<(), Error> {
    let catalog = Catalog::read()?;
    let said = match format {
        ListFormat::Text => as_text(&catalog, output),
        ListFormat::Json => as_json(&catalog, output),
        ListFormat::Instructor => output.write_all(page(&catalog).as_bytes()),
    };
    said.map_err(Error::from_output)
}

fn as_text(catalog: &Catalog, output: &mut dyn Write) -> std::io::Result<()> {
    let widest = catalog.exercises.iter().map(|it| it.manifest.name.len()).max().unwrap_or(0);
    for exercise in &catalog.exercises {
        let it = &exercise.manifest;
        writeln!(output, "{:widest$}  {:3} min  {}  ({})", it.name, it.minutes, it.title, it.page)?;
    }
    let minutes: u32 = catalog.exercises.iter().map(|it| it.manifest.minutes).sum();
    writeln!(
        output,
        "\n{} exercises, {} hours. To begin one:",
        catalog.exercises.len(),
        minutes.div_ceil(60)
    )?;
    writeln!(output, "  cargo run --release -- exercise start ray-sphere/closest-approach --into FOLDER")
}

fn as_json(catalog: &Catalog, output: &mut dyn Write) -> std::io::Result<()> {
    let entry = |exercise: &crate::Exercise| {
        let it = &exercise.manifest;
        let property = |it: &cutter::manifest::Asked| json!({ "name": it.name, "points": it.points });
        json!({
            "name": it.name, "title": it.title, "page": it.page, "minutes": it.minutes, "teaches": it.teaches,
            "points": exercise.points(), "properties": it.properties.iter().map(property).collect::<Vec<_>>(),
        })
    };
    let all: Vec<_> = catalog.exercises.iter().map(entry).collect();
    serde_json::to_writer_pretty(&mut *output, &all)?;
    writeln!(output)
}

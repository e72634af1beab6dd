//! What exercises there are.

use std::io::Write;

use serde_json::json;
use stage::Error;

use crate::Catalog;

/// Lists every exercise, as text or as JSON.
pub fn list(json: bool, output: &mut dyn Write) -> Result<(), Error> {
    let catalog = Catalog::read()?;
    let said = if json { as_json(&catalog, output) } else { as_text(&catalog, output) };
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

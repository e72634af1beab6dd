//! Hands an exercise out.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use exercise::Sheet;
use stage::Error;

use crate::{Catalog, Exercise, folder};

/// Writes a hand-out to a new folder, whole or not at all.
pub fn start(name: &str, into: &Path, output: &mut dyn Write) -> Result<(), Error> {
    let catalog = Catalog::read()?;
    let exercise = catalog.find(name)?;
    let into = folder::new(into)?;
    let files = hand_out(&catalog, exercise)?;
    let beside = beside(&into);
    let done = folder::write(&files, &beside).and_then(|()| {
        // an empty folder may be there
        let _ = fs::remove_dir(&into);
        fs::rename(&beside, &into).map_err(|error| folder::failed("make", &into, error))
    });
    if done.is_err() {
        let _ = fs::remove_dir_all(&beside);
    }
    done?;
    let manifest = &exercise.manifest;
    writeln!(
        output,
        "{}: {}\nIt is in {}, about {} minutes. Read README.md there, then:\n  cd {} && cargo run",
        manifest.name,
        manifest.title,
        into.display(),
        manifest.minutes,
        into.display()
    )
    .map_err(Error::from_output)
}

/// The files of a hand-out.
pub fn hand_out(catalog: &Catalog, exercise: &Exercise) -> Result<cutter::source::Files, Error> {
    let shown = exercise.shown();
    let files = cutter::hand_out(&exercise.manifest, &catalog.source, shown.to_text(), &transcript(&shown));
    files.map_err(Error::Failed)
}

/// What a sheet expects, for reading.
fn transcript(sheet: &Sheet) -> String {
    let mut text = String::new();
    for (number, row) in sheet.rows.iter().enumerate() {
        text += &format!("{}\n  given {}\n", sheet.properties[row.property].name, sheet.case(number));
        text += &exercise::lines(&row.steps.0);
        text += "\n";
    }
    text
}

/// A name beside a folder, for what is not whole yet.
fn beside(folder: &Path) -> PathBuf {
    let name = folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    folder.with_file_name(format!(".{name}.{}", std::process::id()))
}

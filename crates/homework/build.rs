//! Cuts the reference solution and each known mistake of every exercise from the chapters' files.

use std::path::PathBuf;

use cutter::{Manifest, Source, manifest::Fillings, modules};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let root = PathBuf::from(std::env::var("CARGO_MANIFEST_DIR")?).join("../..");
    println!("cargo::rerun-if-changed=../../chapters");
    let source = Source::at(root);
    let (mut text, mut references, mut mistakes) = (String::new(), String::new(), String::new());
    for (number, exercise) in Manifest::all(&source)?.iter().enumerate() {
        let name = &exercise.name;
        let mut solution = |label: &str, fillings: &Fillings| -> Result<String, String> {
            let files = exercise.library(&source, fillings)?;
            let path = format!("solutions::e{number}_{label}");
            text += &modules::inline(&files, &path).map_err(|error| format!("{name}: {error}"))?;
            Ok(format!("e{number}_{label}::probe::probe"))
        };
        let probe = solution("reference", &Fillings::new())?;
        references += &format!("    ({name:?}, {probe}),\n");
        for (number, mistake) in exercise.mistakes.iter().enumerate() {
            let probe = solution(&format!("mistake_{number}"), &mistake.model)?;
            mistakes += &format!("    ({name:?}, {:?}, {probe}),\n", mistake.name);
        }
    }
    text += &format!("pub(crate) static REFERENCES: &[(&str, exercise::Probe)] = &[\n{references}];\n");
    text += &format!("pub(crate) static MISTAKES: &[(&str, &str, exercise::Probe)] = &[\n{mistakes}];\n");
    std::fs::write(PathBuf::from(std::env::var("OUT_DIR")?).join("solutions.rs"), text)?;
    Ok(())
}

//! Cuts the reference solution and each known mistake of every exercise from the chapters' files.

use std::path::PathBuf;

use cutter::{Manifest, Source, manifest::Fillings, modules::Solutions};

#[path = "src/state.rs"]
mod state;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let root = PathBuf::from(std::env::var("CARGO_MANIFEST_DIR")?).join("../..");
    println!("cargo::rerun-if-changed=../../chapters");
    println!("cargo::rustc-env=CHAPTERS={}", state::state(&root.join("chapters"))?);
    let source = Source::at(root);
    let mut solutions = Solutions::at("solutions");
    let (mut references, mut mistakes) = (String::new(), String::new());
    for exercise in &Manifest::all(&source)? {
        let name = &exercise.name;
        let probe = solutions.add(&source, exercise, &Fillings::new())?;
        references += &format!("    ({name:?}, {probe}),\n");
        for mistake in &exercise.mistakes {
            let probe = solutions.add(&source, exercise, &mistake.model)?;
            mistakes += &format!("    ({name:?}, {:?}, {probe}),\n", mistake.name);
        }
    }
    let text = format!(
        "{}pub(crate) static REFERENCES: &[(&str, exercise::Probe)] = &[\n{references}];\n\
         pub(crate) static MISTAKES: &[(&str, &str, exercise::Probe)] = &[\n{mistakes}];\n",
        solutions.text
    );
    std::fs::write(PathBuf::from(std::env::var("OUT_DIR")?).join("solutions.rs"), text)?;
    Ok(())
}

//! Cuts every attempt of every exercise from the chapters' files, each a module.

use std::path::PathBuf;

use cutter::{Manifest, Source, manifest::Fillings, modules::Solutions};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let root = PathBuf::from(std::env::var("CARGO_MANIFEST_DIR")?).join("../..");
    println!("cargo::rerun-if-changed=../../chapters");
    let source = Source::at(root);
    let (mut solutions, mut table) = (Solutions::at("attempts"), String::new());
    for exercise in &Manifest::all(&source)? {
        let name = &exercise.name;
        let mut attempt = |fillings: &Fillings, kind: String| -> Result<(), String> {
            // as a student has it: without what is another exercise's
            let fillings = exercise.hidden().into_iter().chain(fillings.clone()).collect();
            let probe = solutions.add(&source, exercise, &fillings)?;
            table += &format!("    ({name:?}, Kind::{kind}, {probe}),\n");
            Ok(())
        };
        attempt(&exercise.questions(), "Untouched".into())?;
        for (other, fillings) in exercise.others.iter().enumerate() {
            attempt(fillings, format!("Right({other})"))?;
        }
        for mistake in &exercise.mistakes {
            for (again, fillings) in mistake.again.iter().enumerate() {
                attempt(fillings, format!("Wrong({:?}, {again})", mistake.name))?;
            }
        }
    }
    let text = format!(
        "use crate::Kind;\n{}pub(crate) static ALL: &[(&str, Kind, exercise::Probe)] = &[\n{table}];\n",
        solutions.text
    );
    std::fs::write(PathBuf::from(std::env::var("OUT_DIR")?).join("attempts.rs"), text)?;
    Ok(())
}

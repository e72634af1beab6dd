//! Cuts every attempt of every exercise from the chapters' files, each a module.

use std::path::PathBuf;

use cutter::{Manifest, Source, manifest::Fillings, modules};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let root = PathBuf::from(std::env::var("CARGO_MANIFEST_DIR")?).join("../..");
    println!("cargo::rerun-if-changed=../../chapters");
    let source = Source::at(root);
    let (mut text, mut table) = (String::new(), String::new());
    for (number, exercise) in Manifest::all(&source)?.iter().enumerate() {
        let name = &exercise.name;
        let mut count = 0;
        let mut attempt = |fillings: &Fillings, kind: String| -> Result<(), String> {
            count += 1;
            let module = format!("e{number}_{count}");
            let files = exercise.library(&source, fillings)?;
            let inlined = modules::inline(&files, &format!("attempts::{module}"));
            text += &inlined.map_err(|error| format!("{name}: {error}"))?;
            table += &format!("    ({name:?}, Kind::{kind}, {module}::probe::probe),\n");
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
    text += &format!("pub(crate) static ALL: &[(&str, crate::Kind, exercise::Probe)] = &[\n{table}];\n");
    text = format!("use crate::Kind;\n{text}");
    std::fs::write(PathBuf::from(std::env::var("OUT_DIR")?).join("attempts.rs"), text)?;
    Ok(())
}

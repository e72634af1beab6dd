//! `cargo run -p book`: the book, into `out/book`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Arg, Command, value_parser};
use stage::{clean_up_when_interrupted, large_files_are_errors};

fn main() -> ExitCode {
    let command = Command::new("book")
        .about("Build the book from its pages, the chapters' own code, and what the stages print and draw")
        .arg(
            Arg::new("out")
                .long("out")
                .value_name("FOLDER")
                .value_parser(value_parser!(PathBuf))
                .help("Where to put the book; default out/book, where the gallery looks for it"),
        );
    let matches = match command.try_get_matches() {
        Ok(matches) => matches,
        Err(usage) => return stage::refuse(&usage),
    };
    clean_up_when_interrupted();
    large_files_are_errors();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
    let out = matches.get_one::<PathBuf>("out").cloned().unwrap_or_else(|| root.join("out/book"));
    match book::build(root, &out) {
        Ok(()) => {
            println!("the book: {}", out.join("index.html").display());
            ExitCode::SUCCESS
        }
        Err(faults) => {
            for fault in &faults {
                eprintln!("error: {fault}");
            }
            ExitCode::FAILURE
        }
    }
}

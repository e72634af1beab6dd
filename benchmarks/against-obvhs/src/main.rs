//! The trees of chapter 09 against going through all objects, and against obvhs, on the same rays.
//!
//! ```sh
//! cargo run --release -p against-obvhs               # everything: some minutes
//! cargo run --release -p against-obvhs -- balls      # or some of: balls bunny torus build
//! cargo run --release -p against-obvhs -- --scenes ../shared/scenes
//! ```
//!
//! Hits come first, then times: one thread, everything that is compared in turns, medians over the rounds, in
//! seconds that the thread has had a processor for. obvhs has its triangles made for tracing and in the order
//! of its tree, as its documentation advises, and of its presets the one that is fastest for the rays at
//! hand. Both get a ray as origin and direction. obvhs is compiled as `cargo run --release` compiles it; with
//! `RUSTFLAGS="-C target-cpu=native"` it has wider instructions too.

mod balls;
mod build;
mod meshes;
mod peer;
mod rays;
mod scenes;
mod turns;

use std::path::Path;
use std::process::ExitCode;

const PARTS: [&str; 4] = ["balls", "bunny", "torus", "build"];

fn main() -> ExitCode {
    let (mut directory, mut parts) = (String::from("../shared/scenes"), Vec::new());
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--scenes" => directory = words.next().unwrap_or_default(),
            part if PARTS.contains(&part) => parts.push(word),
            _ => {
                eprintln!("{word}: expected --scenes DIRECTORY, or some of {}", PARTS.join(", "));
                return ExitCode::from(2);
            }
        }
    }
    let wanted = |part: &str| parts.is_empty() || parts.iter().any(|wanted| wanted == part);
    match run(Path::new(&directory), wanted) {
        Ok(()) => ExitCode::SUCCESS,
        Err(cause) => {
            eprintln!("{cause}");
            ExitCode::FAILURE
        }
    }
}

fn run(directory: &Path, wanted: impl Fn(&str) -> bool) -> Result<(), String> {
    if wanted("balls") {
        balls::report(&scenes::balls(&directory.join("nff-default/balls.nff.gz"))?);
    }
    if wanted("bunny") {
        meshes::report(&scenes::bunny(&directory.join("obj/bunny.obj"))?, 7);
    }
    if wanted("torus") {
        meshes::report(&scenes::torus(), 5);
    }
    if wanted("build") {
        build::report(&scenes::torus(), 5);
    }
    Ok(())
}

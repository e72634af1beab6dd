//! `rates FOLDER…`: the tables of what the script `run` measured, a folder a scene. The scenes whose folder's
//! name ends in `.nff` are in the geometric mean.

use std::path::Path;
use std::process::ExitCode;

use against_povray::{Measured, counts, rates};

fn main() -> ExitCode {
    let folders: Vec<String> = std::env::args().skip(1).collect();
    if folders.is_empty() {
        eprintln!("usage: rates FOLDER…");
        return ExitCode::from(2);
    }
    let scenes: Result<Vec<Measured>, String> =
        folders.iter().map(|folder| Measured::read(Path::new(folder))).collect();
    match scenes {
        Ok(scenes) => {
            let is_nff = |it: &Measured| it.name.ends_with(".nff");
            println!("{}\n{}", counts(&scenes), rates(&scenes, is_nff));
            ExitCode::SUCCESS
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

//! Writes one of Haines's scenes: `cargo run -p whitted --example haines -- balls 4 > balls.nff`.
//!
//! They are worked out from their geometry, to the same digits as his own programs print ("A Proposal for
//! Standard Graphics Environments", IEEE Computer Graphics and Applications 7 (11), 1987).

#[path = "../tests/haines/balls.rs"]
mod balls;
#[path = "../tests/haines/mount.rs"]
mod mount;
#[path = "../tests/haines/nff.rs"]
mod nff;
#[path = "../tests/haines/rings.rs"]
mod rings;
#[path = "../tests/haines/tetra.rs"]
mod tetra;
#[path = "../tests/haines/tree.rs"]
mod tree;
#[path = "../tests/haines/turn.rs"]
mod turn;

use std::io::Write;
use std::process::ExitCode;

/// A scene's name, Haines's own size, the largest that is written (more would take too much memory), and how
/// it is made.
type Maker = (&'static str, u32, u32, fn(u32) -> String);

fn main() -> ExitCode {
    let mut words = std::env::args().skip(1);
    let (name, level) = (words.next().unwrap_or_default(), words.next());
    let scenes: [Maker; 5] = [
        ("balls", 4, 6, balls::balls),
        ("tetra", 6, 10, tetra::tetra),
        ("rings", 7, 30, rings::rings),
        ("mount", 6, 7, mount::mount),
        ("tree", 11, 18, tree::tree),
    ];
    let Some((_, own, most, scene)) = scenes.into_iter().find(|(known, ..)| *known == name) else {
        eprintln!(
            "which of balls, tetra, rings, mount, tree? `haines balls 4`; without a size, Haines's own"
        );
        return ExitCode::from(2);
    };
    let level = match level.as_deref().map_or(Ok(own), str::parse) {
        Ok(level) if (1..=most).contains(&level) => level,
        _ => {
            eprintln!("the size of {name} is a number from 1 to {most}; {own} is Haines's own");
            return ExitCode::from(2);
        }
    };
    match std::io::stdout().write_all(scene(level).as_bytes()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("cannot write the scene: {error}");
            ExitCode::FAILURE
        }
    }
}

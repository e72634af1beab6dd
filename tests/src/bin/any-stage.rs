//! `any-stage NAME [ARGS…]` is the binary of the stage NAME, with these arguments.

use std::process::ExitCode;

fn main() -> ExitCode {
    let name = std::env::args().nth(1).unwrap_or_default();
    match tests::stage_named(&name) {
        // The stage's name takes the place of the program's.
        Some(stage) => stage::main_from(stage, std::env::args_os().skip(1)),
        None => {
            eprintln!("error: there is no stage `{name}`");
            ExitCode::from(2)
        }
    }
}

//! `any-stage NAME [ARGS…]` is the binary of the stage NAME, or the workbench, with these arguments.

use std::process::ExitCode;

fn main() -> ExitCode {
    let name = std::env::args().nth(1).unwrap_or_default();
    // The name takes the place of the program's.
    let args = std::env::args_os().skip(1);
    match tests::stage_named(&name) {
        Some(stage) => stage::main_from(stage, args),
        None if name == "workbench" => workbench::main_from(args),
        None => {
            eprintln!("error: there is no stage `{name}`");
            ExitCode::from(2)
        }
    }
}

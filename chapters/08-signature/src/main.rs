//! `cargo run -p signature`: see [`signature::stage`].

fn main() -> std::process::ExitCode {
    stage::main(signature::stage::STAGE)
}

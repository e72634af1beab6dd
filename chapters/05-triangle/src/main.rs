//! `cargo run -p triangle`: see [`triangle::stage`].

fn main() -> std::process::ExitCode {
    stage::main(triangle::stage::STAGE)
}

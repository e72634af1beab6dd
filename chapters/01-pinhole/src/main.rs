//! `cargo run -p pinhole`: see [`pinhole::stage`].

fn main() -> std::process::ExitCode {
    stage::main(pinhole::stage::STAGE)
}

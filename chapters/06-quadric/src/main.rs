//! `cargo run -p quadric`: see [`quadric::stage`].

fn main() -> std::process::ExitCode {
    stage::main(quadric::stage::STAGE)
}

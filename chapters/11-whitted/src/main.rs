//! `cargo run -p whitted`: see [`whitted::stage`].

fn main() -> std::process::ExitCode {
    stage::main(whitted::stage::STAGE)
}

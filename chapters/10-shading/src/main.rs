//! `cargo run -p shading`: see [`shading::stage`].

fn main() -> std::process::ExitCode {
    stage::main(shading::stage::STAGE)
}

//! `cargo run -p bounds`: see [`bounds::stage`].

fn main() -> std::process::ExitCode {
    stage::main(bounds::stage::STAGE)
}

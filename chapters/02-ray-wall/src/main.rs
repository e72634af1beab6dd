//! `cargo run -p ray-wall`: see [`ray_wall::stage`].

fn main() -> std::process::ExitCode {
    stage::main(ray_wall::stage::STAGE)
}

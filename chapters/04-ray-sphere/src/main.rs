//! `cargo run -p ray-sphere`: see [`ray_sphere::stage`].

fn main() -> std::process::ExitCode {
    stage::main(ray_sphere::stage::STAGE)
}

//! `cargo run -p ray-plane`: see [`ray_plane::stage`].

fn main() -> std::process::ExitCode {
    stage::main(ray_plane::stage::STAGE)
}

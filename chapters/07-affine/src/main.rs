//! `cargo run -p affine`: see [`affine::stage`].

fn main() -> std::process::ExitCode {
    stage::main(affine::stage::STAGE)
}

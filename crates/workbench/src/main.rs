//! `cargo run --release`: see [`workbench`].

fn main() -> std::process::ExitCode {
    workbench::main()
}

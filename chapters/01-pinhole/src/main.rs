//! `cargo run -p pinhole`: see [`pinhole::stage`].

fn main() {}

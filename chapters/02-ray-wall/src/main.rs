//! `cargo run -p ray-wall`: see [`ray_wall::stage`].

fn main() {}

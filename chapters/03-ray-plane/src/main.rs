//! `cargo run -p ray-plane`: see [`ray_plane::stage`].

fn main() {}

//! The stage `shading`: see the library.

fn main() {}

//! What is looked at, in the order of the page.

use exercise::{Case, Steps};

use crate::Rgb;
use crate::texture::{Mapping, Texture, Textured};

/// The color at the point `p` of the plane through `o` with the normal `n`, in squares of side `scale`, and
/// what is around it.
pub fn probe(case: &Case, steps: &mut Steps) {
    let scale = case.number("scale");
    let mapping = Mapping::plane(case.point("o"), case.point("n"), None);
    let (u, v) = mapping.uv(case.point("p"), None);
    steps.numbers("u, v", "how far along the axes", &[u, v]);
    let colors = [Rgb::WHITE, Rgb::BLACK];
    let floor = Textured { mapping, texture: Texture::Checker { colors, scale } };
    let color = |u, v| if floor.color(u, v) == colors[0] { "□" } else { "■" };
    steps.text("color", "at (u, v)", if color(u, v) == "□" { "□, the first" } else { "■, the second" });
    let along = |step: fn(f64) -> (f64, f64)| {
        let next = |half: u32| {
            let (du, dv) = step(f64::from(half) / 2.0);
            color(u + du * scale, v + dv * scale)
        };
        (0..10).map(next).collect::<Vec<_>>().join(" ")
    };
    steps.text("row", "from there along u, half a square at a time", along(|half| (half, 0.0))).text(
        "column",
        "from there along v",
        along(|half| (0.0, half)),
    );
}

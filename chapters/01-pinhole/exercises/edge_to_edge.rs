//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::{Camera, Window};

use crate::csc418::csc418_pixel;

/// CSC418's pixel (`i`, `j`) of `nc` by `nr` in the window from `wl` to `wr` and from `wb` to `wt`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let [left, right, bottom, top] = ["wl", "wr", "wb", "wt"].map(|name| case.number(name));
    let [n_c, n_r, i, j] = ["nc", "nr", "i", "j"].map(|name| case.number(name).round() as u32);
    // the world's axes, with the eye at its origin, looking down −z
    let [e, u, v, w] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]].map(Into::into);
    let window = Window { left, right, bottom, top };
    let camera = Camera::<f64> { e, u, v, w, f: case.number("f"), window };
    let Ok(pixel) = csc418_pixel(&camera, (n_c, n_r), (i, j)) else { return };
    steps
        .number("Δu", "one pixel to the right", pixel.delta_u)
        .number("Δv", "one pixel down", pixel.delta_v)
        .vector("p_C", "where pixel (i, j) is", pixel.p_camera);
}

//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::Window;

use crate::gambetta::{canvas_coordinates, canvas_to_viewport};

/// Gambetta's point of a viewport `Vw` by `Vh` at distance `d` for a pixel of a canvas of `Cw` by `Ch`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let [v_w, v_h] = ["Vw", "Vh"].map(|name| case.number(name));
    let [c_w, c_h, col, row] = ["Cw", "Ch", "col", "row"].map(|name| case.number(name).round() as u32);
    let viewport = Window { left: -v_w / 2.0, right: v_w / 2.0, bottom: -v_h / 2.0, top: v_h / 2.0 };
    let (c_x, c_y) = canvas_coordinates::<f64>((c_w, c_h), (col, row));
    steps.numbers("C", "from the middle to the right, and up", &[c_x, c_y]);
    let v = canvas_to_viewport::<f64>(&viewport, case.number("d"), (c_w, c_h), (c_x, c_y)).v;
    steps.vector("V", "the same point of the viewport", v);
}

//! What is looked at.

use exercise::{Case, Steps};
use math::{Camera, Grid, Handedness, Window};
use signature::Scene;

use crate::Box3;
use crate::projected::rectangle;

/// The rectangles of two corners alone and of the box from `low` to `high`, seen from the origin along z: 20
/// × 10 pixels on a window of 4 × 2 at the distance `f`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let [low, high] = ["low", "high"].map(|corner| case.point(corner).map(|x| x as f32));
    let window = Window { left: -2.0, right: 2.0, bottom: -1.0, top: 1.0 };
    let (eye, forward, up) = ([0.0; 3].into(), [0.0, 0.0, 1.0].into(), [0.0, 1.0, 0.0].into());
    let camera = Camera::looking(eye, forward, up, Handedness::Left, case.number("f"), window);
    let camera = camera.expect("it looks along z");
    let scene = Scene::<f64> { camera, grid: Grid::Centers, size: (20, 10), objects: Vec::new() };
    let mut seen = |symbol, low, high| {
        let text = match rectangle(&scene, &Box3 { low, high }) {
            Some(it) => {
                let [cols, rows] = [&it.cols, &it.rows].map(|it| format!("{} to {}", it.start(), it.end()));
                format!("columns {cols}, rows {rows}")
            }
            None => "no pixel".to_string(),
        };
        steps.text(symbol, "where it may be seen", text);
    };
    seen("low", low, low);
    seen("high", high, high);
    seen("box", low, high);
}

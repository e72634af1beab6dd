//! What is looked at, axis by axis.

use exercise::{Case, Steps};
use math::Ray3;

use crate::Box3;
use crate::slab::{Reach, Slabs};

/// Where the ray `o`, `d` enters the box from `low` to `high`: first with the faces of x alone, then with
/// those of y and of z.
pub fn probe(case: &Case, steps: &mut Steps) {
    let ray = Ray3::<f64>::new(case.point("o").into(), case.point("d").into());
    let [low, high] = ["low", "high"].map(|corner| case.point(corner).map(|x| x as f32));
    let reach = Reach { min: 0.0, max: case.number("t_max") as f32 };
    let slabs = Slabs::new(&ray);
    for (axis, formula) in ["between the x faces", "and the y faces", "and the z faces"].iter().enumerate() {
        // the other faces are far away
        let mut bounds = Box3 { low: [-4000.0, -4000.0, -1000.0], high: [4000.0, 4000.0, 1000.0] };
        bounds.low[..=axis].copy_from_slice(&low[..=axis]);
        bounds.high[..=axis].copy_from_slice(&high[..=axis]);
        // the faces are f32, and a little farther out than they should be: three digits are enough
        let rounded = |t: f32| (f64::from(t) * 1000.0).round() / 1000.0;
        steps.maybe("t", formula, slabs.enter(&bounds, reach).map(rounded), "none: it passes");
    }
}

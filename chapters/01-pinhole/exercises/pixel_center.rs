//! What is looked at, in the order of the page.

use exercise::{Case, Steps};
use math::Window;

use crate::house::house_pixel;

/// House's ray through pixel (`i`, `j`) of `M` rows by `N` columns, on a screen `w` by `h` about `c`.
pub fn probe(case: &Case, steps: &mut Steps) {
    let [w, h, c_x, c_y] = ["w", "h", "cx", "cy"].map(|name| case.number(name));
    let [n, m, i, j] = ["N", "M", "i", "j"].map(|name| case.number(name).round() as u32);
    let (left, bottom) = (c_x - w / 2.0, c_y - h / 2.0);
    let window = Window { left, right: left + w, bottom, top: bottom + h };
    let pixel = house_pixel::<f64>(&window, case.number("zp"), (n, m), (i, j));
    steps
        .number("pixheight", "the height of a pixel", pixel.pixheight)
        .number("pixwidth", "the width of a pixel", pixel.pixwidth)
        .number("p_y", "the middle of row i", pixel.p.y)
        .number("p_x", "the middle of column j", pixel.p.x)
        .vector("u_r", "from the eye to p", pixel.u_r);
}

//! Gambetta, "Canvas to Viewport": canvas coordinates about the center, scaled.

use math::grid::lattice;
use math::{Real, Window};

/// Every number on the way to Gambetta's ray through a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GambettaPixel<R: Real> {
    /// C_x = col − C_w/2, from the center of the canvas to the right.
    pub c_x: R,
    /// C_y = C_h/2 − row, from the center up.
    pub c_y: R,
    /// V = (C_x V_w/C_w, C_y V_h/C_h, d), on the viewport. O is the origin, so this is D = V − O, too.
    pub v: R::Vec3,
}

/// The ray through pixel (col, row) of a canvas of `size` pixels (row 0 on top) to a viewport at
/// distance `d`: `CanvasToViewport` (Listing 2-3).
pub fn gambetta_pixel<R: Real>(
    window: &Window<R>,
    d: R,
    size: (u32, u32),
    pixel: (u32, u32),
) -> GambettaPixel<R> {
    let [width, height, col, row] = [size.0, size.1, pixel.0, pixel.1].map(|n| R::round_from(f64::from(n)));
    let half = R::from(0.5);
    let (v_x, v_y) = lattice(window, size, pixel);
    GambettaPixel { c_x: col - width * half, c_y: height * half - row, v: R::vec3(v_x, v_y, d) }
}

/// Listing 2-2: for x = −C_w/2 to C_w/2, for y = −C_h/2 to C_h/2, put a pixel.
///
/// `put_pixel(x, y, pixel)` takes canvas coordinates and the (col, row) they belong to. With both
/// ends the loop would visit C_w + 1 columns; the left and top ends stay, the right and bottom ones go.
pub fn main_method((columns, rows): (u32, u32), mut put_pixel: impl FnMut(f64, f64, (u32, u32))) {
    let (c_w, c_h) = (f64::from(columns), f64::from(rows));
    for col in 0..columns {
        let x = -c_w / 2.0 + f64::from(col);
        // y grows upward: from the bottom, one above −C_h/2, to the top.
        for row in (0..rows).rev() {
            let y = c_h / 2.0 - f64::from(row);
            put_pixel(x, y, (col, row));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    const VIEWPORT: Window<f64> = Window { left: -0.5, right: 0.5, bottom: -0.5, top: 0.5 };

    #[test]
    fn canvas_to_viewport() {
        // Listing 2-3 by hand, V_w = V_h = d = 1 on a canvas of 4 × 4
        let pixel = gambetta_pixel(&VIEWPORT, 1.0, (4, 4), (3, 1));
        assert_eq!((pixel.c_x, pixel.c_y), (1.0, 1.0));
        assert_eq!(pixel.v, DVec3::new(0.25, 0.25, 1.0));
        assert_eq!(gambetta_pixel(&VIEWPORT, 1.0, (4, 4), (2, 2)).v, DVec3::new(0.0, 0.0, 1.0), "the center");
    }

    /// `for x = -Cw/2 to Cw/2` with both ends visits one column too many (slip 8).
    #[test]
    fn as_printed_there_are_five_columns_on_a_canvas_of_four() {
        let as_printed = (-2..=2).count();
        assert_eq!(as_printed, 5);
        let mut columns: Vec<f64> = Vec::new();
        main_method((4, 4), |x, _, _| columns.push(x));
        columns.dedup();
        assert_eq!(columns, [-2.0, -1.0, 0.0, 1.0]);
    }

    /// House's loop and Gambetta's visit the same pixels, each once, in different orders.
    #[test]
    fn both_loops_visit_the_same_pixels() {
        let size = (5, 3);
        let (mut house, mut gambetta) = (Vec::new(), Vec::new());
        crate::house::raycast(size, |_, j, row| house.push((j, row)));
        main_method(size, |_, _, pixel| gambetta.push(pixel));
        assert_ne!(house, gambetta, "House goes row by row, Gambetta column by column");
        house.sort_unstable();
        gambetta.sort_unstable();
        assert_eq!(house, gambetta);
        house.dedup();
        assert_eq!(house.len(), 15);
    }

    /// x right, y up, z into the screen is a left-handed frame; House's is right-handed (slip 11).
    #[test]
    fn his_axes_are_left_handed() {
        let (right, up, forward) = (DVec3::X, DVec3::Y, DVec3::Z);
        assert_eq!(right.cross(up).dot(forward), 1.0, "u × v points along the view");
        let (right, up, forward) = (DVec3::X, DVec3::Y, -DVec3::Z);
        assert_eq!(right.cross(up).dot(forward), -1.0, "House: u × v points back at the eye");
    }
}

//! Gambetta, "Canvas to Viewport": canvas coordinates about the center, scaled.

use math::{Real, Window};

/// Every number on the way to Gambetta's ray through a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GambettaPixel<R: Real> {
    /// C_w and C_h, the canvas in pixels.
    pub canvas: (R, R),
    /// V_w and V_h, the viewport in units of the scene.
    pub viewport: (R, R),
    /// C_x, in pixels from the center of the canvas to the right.
    pub c_x: R,
    /// C_y, in pixels from the center up.
    pub c_y: R,
    /// V = (V_x, V_y, d), on the viewport, in his axes: x right, y up, z into the screen. O is the origin,
    /// so this is D = V − O, too: not normalized, and t = 1 on the viewport.
    pub v: R::Vec3,
}

/// `CanvasToViewport(x, y)` (Listing 2-3): V_x = C_x V_w/C_w, V_y = C_y V_h/C_h, V_z = d.
///
/// `window` is the viewport, at the distance `d`, both in units of the scene, and (C_x, C_y) is in pixels,
/// as [`canvas_coordinates`] has it. Neither C_w nor C_h may be 0. His viewport lies about the axis;
/// one that does not is shifted by its center.
pub fn canvas_to_viewport<R: Real>(
    window: &Window<R>,
    d: R,
    (columns, rows): (u32, u32),
    (c_x, c_y): (R, R),
) -> GambettaPixel<R> {
    let [c_w, c_h] = [columns, rows].map(|number| R::round_from(f64::from(number)));
    let (v_w, v_h) = (window.right - window.left, window.top - window.bottom);
    let (center_x, center_y) = window.center();

    // exercise scale: How far on the viewport is one pixel to the right, and how far one pixel up?
    let v_x = c_x * v_w / c_w;
    let v_y = c_y * v_h / c_h;
    // end scale
    let v = R::vec3(center_x + v_x, center_y + v_y, d);

    GambettaPixel { canvas: (c_w, c_h), viewport: (v_w, v_h), c_x, c_y, v }
}

/// The canvas coordinates of pixel (col, row), row 0 on top: x = col − C_w/2, y = C_h/2 − row, in pixels.
/// The halves are real quotients: an odd canvas has coordinates …, −0.5, 0.5, …. A pixel outside the
/// canvas continues them.
pub fn canvas_coordinates<R: Real>((columns, rows): (u32, u32), (col, row): (u32, u32)) -> (R, R) {
    let [c_w, c_h, col, row] = [columns, rows, col, row].map(|number| R::round_from(f64::from(number)));
    let half = R::from(0.5);
    // exercise coordinates: From the center of the canvas, x right and y up: where is column col, row row?
    (col - c_w * half, c_h * half - row)
    // end coordinates
}

/// `PutPixel`'s other way round: the column and row of canvas coordinates that lie on the canvas, which is
/// for −C_w/2 ≤ x < C_w/2 and −C_h/2 < y ≤ C_h/2.
///
/// What lies off it to the left or above has column or row 0, what lies off it to the right or below has one
/// that the canvas lacks.
pub fn canvas_pixel<R: Real>((columns, rows): (u32, u32), (x, y): (R, R)) -> (u32, u32) {
    let (x, y): (f64, f64) = (x.into(), y.into());
    ((f64::from(columns) / 2.0 + x) as u32, (f64::from(rows) / 2.0 - y) as u32)
}

/// The main method (Listing 2-2): for x = −C_w/2 to C_w/2, for y = −C_h/2 to C_h/2, trace the ray and
/// put the pixel.
///
/// `window` and `d` are those of [`canvas_to_viewport`], `canvas` is columns and rows. `trace_ray` returns
/// the color that the ray from O along D sees, where D is not normalized; `put_pixel` takes canvas
/// coordinates. With both ends the loop would visit C_w + 1 columns: the left and top ends stay, the
/// right and bottom ones go.
pub fn main_method<R: Real, C>(
    window: &Window<R>,
    d: R,
    canvas: (u32, u32),
    trace_ray: impl Fn(R::Vec3) -> C,
    mut put_pixel: impl FnMut((R, R), C),
) {
    for col in 0..canvas.0 {
        // y grows upward: from the bottom, one above −C_h/2, to the top.
        for row in (0..canvas.1).rev() {
            let (x, y) = canvas_coordinates(canvas, (col, row));
            let direction = canvas_to_viewport(window, d, canvas, (x, y)).v;
            let color = trace_ray(direction);
            put_pixel((x, y), color);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use math::grid::lattice;
    use math::{Camera, Handedness};

    const VIEWPORT: Window<f64> = Window { left: -0.5, right: 0.5, bottom: -0.5, top: 0.5 };

    fn visited(canvas: (u32, u32)) -> Vec<(f64, f64)> {
        let mut visited = Vec::new();
        main_method(&VIEWPORT, 1.0, canvas, |_: DVec3| (), |place, ()| visited.push(place));
        visited
    }

    #[test]
    fn listing_2_3() {
        // by hand, V_w = V_h = d = 1 on a canvas of 4 × 4
        let pixel = canvas_to_viewport(&VIEWPORT, 1.0, (4, 4), (1.0, -2.0));
        assert_eq!(pixel.v, DVec3::new(0.25, -0.5, 1.0));
        assert_eq!(canvas_coordinates::<f64>((4, 4), (3, 1)), (1.0, 1.0));
        assert_eq!(canvas_coordinates::<f64>((5, 3), (0, 0)), (-2.5, 1.5));
    }

    /// `for x = -Cw/2 to Cw/2` with both ends visits one column too many (slip 8).
    #[test]
    fn as_printed_there_are_five_columns_on_a_canvas_of_four() {
        let as_printed = (-2..=2).count();
        assert_eq!(as_printed, 5);
        let mut columns: Vec<f64> = visited((4, 4)).into_iter().map(|(x, _)| x).collect();
        columns.dedup();
        assert_eq!(columns, [-2.0, -1.0, 0.0, 1.0]);
    }

    #[test]
    fn every_pixel_is_put_once() {
        let canvas = (5, 3);
        let mut pixels: Vec<_> =
            visited(canvas).into_iter().map(|place| canvas_pixel(canvas, place)).collect();
        pixels.sort_unstable();
        let all: Vec<_> = (0..5).flat_map(|col| (0..3).map(move |row| (col, row))).collect();
        assert_eq!(pixels, all);
    }

    #[test]
    fn the_listing_is_the_grid() {
        let window = Window { left: -0.3, right: 0.9, bottom: -0.7, top: 0.1 };
        for (col, row) in (0..7).flat_map(|col| (0..9).map(move |row| (col, row))) {
            let v: DVec3 = canvas_to_viewport(&window, 1.0, (7, 9), canvas_coordinates((7, 9), (col, row))).v;
            assert_eq!((v.x, v.y), lattice(&window, (7, 9), (col, row)));
        }
    }

    /// x right, y up, z into the screen is a left-handed frame; House's is right-handed (slip 11).
    #[test]
    fn his_axes_are_left_handed() {
        let right = |forward, handedness| {
            Camera::<f64>::looking(DVec3::ZERO, forward, DVec3::Y, handedness, 1.0, VIEWPORT).unwrap().u
        };
        assert_eq!(right(DVec3::Z, Handedness::Left), DVec3::X, "Gambetta");
        assert_eq!(right(-DVec3::Z, Handedness::Right), DVec3::X, "House");
        assert_eq!(right(DVec3::Z, Handedness::Right), -DVec3::X, "mixed, the picture is mirrored");
    }
}

//! House 4.1: through the center of each pixel.

use math::grid::centers;
use math::{Real, Vector, Window};

/// Every number on the way to House's ray through pixel (i, j).
///
/// Coordinates are the camera's: x right, y up, z into the scene. (House looks down −z; his third
/// coordinate is the negative of this one.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HousePixel<R: Real> {
    /// The row, counted from the bottom.
    pub i: u32,
    /// The column.
    pub j: u32,
    /// w / N, the width of one pixel.
    pub pixwidth: R,
    /// h / M, the height of one pixel.
    pub pixheight: R,
    /// p, the center of the pixel on the view plane.
    pub p: R::Vec3,
    /// p / ‖p‖, the unit vector of the ray.
    pub u_r: R::Vec3,
}

/// The ray through the center of pixel (col, row) of a picture of `size` pixels (row 0 on top) in a
/// window at distance `z_p`.
///
/// The page's row i grows with y, so its row 0 is the bottom one: i = M − 1 − row.
pub fn house_pixel<R: Real>(
    window: &Window<R>,
    z_p: R,
    size: (u32, u32),
    pixel: (u32, u32),
) -> HousePixel<R> {
    let (columns, rows) = size;
    let (p_x, p_y) = centers(window, size, pixel);
    let p = R::vec3(p_x, p_y, z_p);
    HousePixel {
        i: rows.saturating_sub(1 + pixel.1),
        j: pixel.0,
        pixwidth: (window.right - window.left) / R::round_from(f64::from(columns)),
        pixheight: (window.top - window.bottom) / R::round_from(f64::from(rows)),
        p,
        u_r: p / p.length(),
    }
}

/// House's loop over an image of M rows and N columns: for each row i, for each column j, shoot a ray
/// and shade what it hits.
///
/// `paint(i, j, row)` stands for `image[i][j] = shade(shoot(u_r))`; `row` is where row i belongs in
/// a picture file, whose row 0 is the top. With `image[i]` written out as it stands, the picture is on
/// its head.
pub fn raycast((columns, rows): (u32, u32), mut paint: impl FnMut(u32, u32, u32)) {
    for i in 0..rows {
        for j in 0..columns {
            paint(i, j, rows - 1 - i);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    const WINDOW: Window<f64> = Window { left: -2.5, right: 2.5, bottom: -1.5, top: 1.5 };

    /// The page's code, typed from its formulas: p_y = c_y − h/2 + pixheight (i + 0.5), and so on.
    fn as_printed(i: u32, j: u32) -> (f64, f64) {
        let (w, h, m, n) = (5.0, 3.0, 3.0, 5.0);
        (-w / 2.0 + w / n * (f64::from(j) + 0.5), -h / 2.0 + h / m * (f64::from(i) + 0.5))
    }

    #[test]
    fn the_first_pixel_of_the_picture_is_in_the_pages_last_row() {
        let pixel = house_pixel(&WINDOW, 2.0, (5, 3), (0, 0));
        assert_eq!((pixel.i, pixel.j), (2, 0));
        assert_eq!(as_printed(2, 0), (-2.0, 1.0));
        // ‖(−2, 1, 2)‖ = 3
        assert_eq!(pixel.p, DVec3::new(-2.0, 1.0, 2.0));
        assert_eq!(pixel.u_r, DVec3::new(-2.0, 1.0, 2.0) / 3.0);
    }

    /// Row i grows with y, so row 0 is at the bottom; a picture file's row 0 is its top (slip 4).
    #[test]
    fn as_printed_the_picture_stands_on_its_head() {
        let mut heights_as_printed = Vec::new();
        let mut heights = [0.0; 3];
        raycast((5, 3), |i, j, row| {
            if j == 0 {
                heights_as_printed.push(as_printed(i, j).1); // image[i] is the i-th row of the file
                heights[row as usize] = as_printed(i, j).1;
            }
        });
        assert_eq!(heights_as_printed, [-1.0, 0.0, 1.0], "as printed, the top row looks down");
        assert_eq!(heights, [1.0, 0.0, -1.0], "the top row looks up");
    }

    #[test]
    fn every_pixel_agrees_with_the_page() {
        raycast((5, 3), |i, j, row| {
            let pixel = house_pixel(&WINDOW, 2.0, (5, 3), (j, row));
            assert_eq!((pixel.i, pixel.p.x, pixel.p.y), (i, as_printed(i, j).0, as_printed(i, j).1));
        });
    }
}

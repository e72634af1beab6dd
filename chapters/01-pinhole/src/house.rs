//! House 4.1: through the center of each pixel.

use math::{Real, Vector, Window};

/// Every number on the way to House's ray through pixel (i, j), in his coordinates: the camera is at
/// the origin and aimed down the negative z axis. (In camera coordinates z points into the scene: see
/// [`in_camera`].)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HousePixel<R: Real> {
    /// The row, counted from the bottom.
    pub i: u32,
    /// The column.
    pub j: u32,
    /// w and h, the width and height of the viewscreen, in units of the scene.
    pub screen: (R, R),
    /// c = (c_x, c_y, −z_p), the center of the screen.
    pub c: R::Vec3,
    /// w / N, the width of one pixel.
    pub pixwidth: R,
    /// h / M, the height of one pixel.
    pub pixheight: R,
    /// p, the center of the pixel on the view plane.
    pub p: R::Vec3,
    /// p / ‖p‖, the unit vector of the ray.
    pub u_r: R::Vec3,
}

/// House 4.1: the ray through the center of pixel (i, j) of a picture of N columns and M rows, in a window at
/// distance `z_p` (above zero), both in units of the scene.
///
/// As on the page i is the row, counted from the bottom ([`house_row`]), and j the column, the other way
/// round than (columns, rows). Neither N nor M may be 0. Pixels outside it continue the grid.
pub fn house_pixel<R: Real>(
    window: &Window<R>,
    z_p: R,
    (columns, rows): (u32, u32),
    (i, j): (u32, u32),
) -> HousePixel<R> {
    let [n, m, row, column] = [columns, rows, i, j].map(|number| R::round_from(f64::from(number)));
    let (two, half) = (R::from(2.0), R::from(0.5));
    let (w, h) = (window.right - window.left, window.top - window.bottom);
    let (c_x, c_y) = window.center();

    // exercise size: How high is a row of the screen, and how wide a column, in units of the scene?
    let pixheight = h / m;
    let pixwidth = w / n;
    // end size
    // exercise center: At which height is the middle of row i, and how far to the right that of column j?
    let p_y = c_y - h / two + pixheight * (row + half);
    let p_x = c_x - w / two + pixwidth * (column + half);
    // end center
    let p_z = -z_p;
    let p = R::vec3(p_x, p_y, p_z);
    // exercise u_r: Which vector of length 1 points from the eye to p?
    let u_r = p / p.length();
    // end u_r

    let c = R::vec3(c_x, c_y, p_z);
    HousePixel { i, j, screen: (w, h), c, pixwidth, pixheight, p, u_r }
}

/// A point or direction of House's in camera coordinates: x right, y up, z into the scene. The same leads
/// back.
pub fn in_camera<R: Real>(v: R::Vec3) -> R::Vec3 {
    R::vec3(v.x(), v.y(), -v.components()[2])
}

/// House's row of a row of a picture file of `rows` rows, `row` < `rows`: his row 0 is the bottom one,
/// since i grows with y.
pub fn house_row(rows: u32, row: u32) -> u32 {
    rows.saturating_sub(1).saturating_sub(row)
}

/// House's algorithm (4.1): for each row, for each column, shoot a ray and shade what it hits.
///
/// `window`, `z_p` and the size are those of [`house_pixel`]. `shoot` returns the position of the first hit
/// of the ray from the eye along the unit vector u_r, in House's coordinates, or `None` where there is
/// none; `shade` returns the color for it. The image comes back as the page has it, `image[i][j]` with
/// row 0 at the bottom; written to a file like that, it stands on its head.
pub fn raycast<R: Real, C>(
    window: &Window<R>,
    z_p: R,
    (columns, rows): (u32, u32),
    shoot: impl Fn(R::Vec3) -> Option<R::Vec3>,
    shade: impl Fn(Option<R::Vec3>) -> C,
) -> Vec<Vec<C>> {
    let mut image = Vec::new();
    for i in 0..rows {
        let mut line = Vec::new();
        for j in 0..columns {
            let u_r = house_pixel(window, z_p, (columns, rows), (i, j)).u_r;
            let x = shoot(u_r);
            line.push(shade(x));
        }
        image.push(line);
    }
    image
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use math::grid::centers;

    const WINDOW: Window<f64> = Window { left: -2.5, right: 2.5, bottom: -1.5, top: 1.5 };

    #[test]
    fn the_first_pixel_of_the_picture_is_in_the_pages_last_row() {
        let pixel = house_pixel(&WINDOW, 2.0, (5, 3), (house_row(3, 0), 0));
        // by hand: −2.5 + 0.5 and −1.5 + 2.5; ‖(−2, 1, −2)‖ = 3
        assert_eq!((pixel.i, pixel.p), (2, DVec3::new(-2.0, 1.0, -2.0)));
        assert_eq!(pixel.u_r, DVec3::new(-2.0, 1.0, -2.0) / 3.0);
        // the page looks along −z
        assert_eq!(in_camera::<f64>(pixel.p), DVec3::new(-2.0, 1.0, 2.0));
    }

    /// Row i grows with y, so row 0 is at the bottom; a picture file's row 0 is its top (slip 4).
    #[test]
    fn as_printed_the_picture_stands_on_its_head() {
        let heights: Vec<f64> = raycast(&WINDOW, 2.0, (5, 3), |u_r: DVec3| Some(u_r), |x| x.unwrap().y)
            .into_iter()
            .map(|line| line[2] * 2.0)
            .collect();
        assert!(heights[0] < 0.0 && heights[2] > 0.0, "as printed, the top row looks down: {heights:?}");
        let file: Vec<f64> = (0..3).map(|row| heights[house_row(3, row) as usize]).collect();
        assert!(file[0] > 0.0 && file[2] < 0.0, "the top row looks up: {file:?}");
    }

    /// Counted from the bottom or from the top, the centers are the same points.
    #[test]
    fn the_pages_formula_is_the_grid() {
        let window = Window { left: -0.3, right: 0.9, bottom: -0.7, top: 0.1 };
        let size = (7, 9);
        for (row, col) in (0..9).flat_map(|row| (0..7).map(move |col| (row, col))) {
            let (x, y) = centers(&window, size, (col, row));
            let p: DVec3 = house_pixel(&window, 1.0, size, (house_row(9, row), col)).p;
            // half a dozen roundings of numbers below 2
            assert!((p.x - x).abs().max((p.y - y).abs()) < 6.0 * f64::EPSILON, "{p} {x} {y}");
        }
    }
}

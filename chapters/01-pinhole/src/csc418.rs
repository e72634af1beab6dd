//! CSC418 11.2: from edge to edge of the window, for a camera anywhere.

use math::{Camera, NoGrid, Real, Vector};

/// Every number on the way to CSC418's ray through pixel (i, j), column i, row j, (0, 0) on top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Csc418Pixel<R: Real> {
    /// The column.
    pub i: u32,
    /// The row.
    pub j: u32,
    /// Δu = (w_r − w_l) / (n_c − 1), in units of the scene.
    pub delta_u: R,
    /// Δv = (w_b − w_t) / (n_r − 1), negative: rows go down.
    pub delta_v: R,
    /// p̄_C = (w_l + i Δu, w_t + j Δv, f), in camera coordinates.
    pub p_camera: R::Vec3,
    /// p̄_W, the same point in world coordinates: the columns u⃗, v⃗, w⃗ times p̄_C, plus ē.
    pub p_world: R::Vec3,
    /// d⃗ = p̄_W − ē, not normalized. The ray p̄_W + λ d⃗ starts on the view plane; the eye is at λ = −1.
    pub d: R::Vec3,
}

/// CSC418 11.2: the ray of pixel (i, j), column i, row j, of a viewport of n_c `columns` and n_r `rows`,
/// row 0 on top. Pixels outside the viewport continue the grid.
///
/// [`NoGrid`] with fewer than two columns or rows: the page divides by n_c − 1 and n_r − 1.
pub fn csc418_pixel<R: Real>(
    camera: &Camera<R>,
    (columns, rows): (u32, u32),
    (i, j): (u32, u32),
) -> Result<Csc418Pixel<R>, NoGrid> {
    if columns < 2 || rows < 2 {
        return Err(NoGrid);
    }
    let [n_c, n_r, column, row] = [columns, rows, i, j].map(|number| R::round_from(f64::from(number)));
    let one = R::from(1.0);
    let window = camera.window;

    // exercise steps: How far, and which way, is the next pixel on the right, and the next one below?
    let delta_u = (window.right - window.left) / (n_c - one);
    let delta_v = (window.bottom - window.top) / (n_r - one);
    // end steps
    // exercise camera: Where in the window is pixel (0, 0), and where, from there, is pixel (i, j)?
    let (x, y) = (window.left + column * delta_u, window.top + row * delta_v);
    // end camera
    let p_camera = R::vec3(x, y, camera.f);

    let p_world = camera.u * x + camera.v * y + camera.w * camera.f + camera.e;
    let d = p_world - camera.e;

    Ok(Csc418Pixel { i, j, delta_u, delta_v, p_camera, p_world, d })
}

/// The signed distance of a point in world coordinates from the image plane (p̄ − r̄) · w⃗ = 0, where
/// r̄ = ē + f w⃗: above zero beyond the plane, below zero on the eye's side.
pub fn off_image_plane<R: Real>(camera: &Camera<R>, point: R::Vec3) -> R {
    let r = camera.view_plane((R::from(0.0), R::from(0.0)));
    (point - r).dot(camera.w)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use math::grid::edges;
    use math::{Handedness, Window};

    fn camera() -> Camera<f64> {
        let window = Window { left: -2.5, right: 2.5, bottom: -1.5, top: 1.5 };
        let (eye, forward) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, 0.0, -1.0));
        Camera::looking(eye, forward, DVec3::Y, Handedness::Right, 2.0, window).unwrap()
    }

    #[test]
    fn corners_lie_on_the_edges_of_the_window() {
        // by hand: (−2.5, 1.5) and (2.5, −1.5) in front of the eye at (1, 2, 3), looking down −z
        let first = csc418_pixel(&camera(), (5, 3), (0, 0)).unwrap();
        assert_eq!((first.delta_u, first.delta_v), (1.25, -1.5));
        assert_eq!(first.p_world, DVec3::new(-1.5, 3.5, 1.0));
        let last = csc418_pixel(&camera(), (5, 3), (4, 2)).unwrap();
        assert_eq!(last.p_world, DVec3::new(3.5, 0.5, 1.0));
        assert_eq!(last.d, DVec3::new(2.5, -1.5, -2.0));
    }

    #[test]
    fn pixels_lie_on_the_image_plane() {
        for (col, row) in [(0, 0), (2, 1), (4, 2)] {
            let pixel = csc418_pixel(&camera(), (5, 3), (col, row)).unwrap();
            assert_eq!(off_image_plane(&camera(), pixel.p_world), 0.0);
        }
    }

    #[test]
    fn the_pages_formula_is_the_grid() {
        let window = Window { left: -0.3, right: 0.9, bottom: -0.7, top: 0.1 };
        let camera = Camera { window, ..camera() };
        for (col, row) in (0..7).flat_map(|col| (0..9).map(move |row| (col, row))) {
            let (x, y) = edges(&window, (7, 9), (col, row)).unwrap();
            let p = csc418_pixel(&camera, (7, 9), (col, row)).unwrap().p_camera;
            // a handful of roundings of numbers below 2
            assert!((p.x - x).abs().max((p.y - y).abs()) < 6.0 * f64::EPSILON, "{p} {x} {y}");
        }
    }

    /// With one column Δu divides by zero (slip 15).
    #[test]
    fn as_printed_one_column_has_no_grid() {
        let Window { left, right, .. } = camera().window;
        let as_printed = |n_c: f64, i: f64| left + i * ((right - left) / (n_c - 1.0));
        assert!(as_printed(5.0, 0.0) == left && as_printed(1.0, 0.0).is_nan(), "0 · ∞");
        assert_eq!(csc418_pixel(&camera(), (1, 3), (0, 0)), Err(NoGrid));
        assert_eq!(csc418_pixel(&camera(), (3, 1), (0, 0)), Err(NoGrid));
        assert_eq!(csc418_pixel(&camera(), (3, 0), (0, 0)), Err(NoGrid));
        // two columns and two rows are the corners
        let corner = csc418_pixel(&camera(), (2, 2), (1, 1)).unwrap();
        assert_eq!(corner.p_camera, DVec3::new(2.5, -1.5, 2.0));
    }

    /// A ray from p̄_ij with λ > 0 does not see what stands between eye and view plane (slip 22):
    /// Gambetta's t > 1 says it aloud.
    #[test]
    fn lambda_counts_from_the_view_plane() {
        let pixel = csc418_pixel(&camera(), (5, 3), (3, 1)).unwrap();
        let from_plane = math::Ray3::<f64>::new(pixel.p_world, pixel.d);
        let from_eye = math::Ray3::<f64>::new(camera().e, pixel.d);
        for lambda in [-1.0, -0.5, 0.0, 2.0] {
            let t = lambda + 1.0;
            assert_eq!(from_plane.at(lambda), from_eye.at(t));
        }
        assert_eq!(from_plane.at(-1.0), camera().e, "the eye itself is at λ = −1, behind the ray");
    }
}

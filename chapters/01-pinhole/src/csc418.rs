//! CSC418 11.2: from edge to edge of the window, for a camera anywhere.

use math::grid::edges;
use math::{Camera, NoGrid, Real, Vector};

/// Every number on the way to CSC418's ray through pixel (i, j), column i, row j, (0, 0) on top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Csc418Pixel<R: Real> {
    /// Δu = (w_r − w_l) / (n_c − 1)
    pub delta_u: R,
    /// Δv = (w_b − w_t) / (n_r − 1), negative: rows go down.
    pub delta_v: R,
    /// p̄_C = (w_l + i Δu, w_t + j Δv, f), in camera coordinates.
    pub p_camera: R::Vec3,
    /// p̄_W, the same point in world coordinates: the columns u, v, w times p̄_C, plus ē.
    pub p_world: R::Vec3,
    /// d⃗ = p̄_W − ē. The ray p̄_W + λ d⃗ starts on the view plane.
    pub d: R::Vec3,
}

/// The ray of pixel (i, j) of a viewport of `size` = (n_c, n_r) pixels.
///
/// [`NoGrid`] with one column or one row: the page divides by n_c − 1 and n_r − 1.
pub fn csc418_pixel<R: Real>(
    camera: &Camera<R>,
    size: (u32, u32),
    pixel: (u32, u32),
) -> Result<Csc418Pixel<R>, NoGrid> {
    let window = camera.window;
    let (x, y) = edges(&window, size, pixel)?;
    let [columns, rows] = [size.0 - 1, size.1 - 1].map(|n| R::round_from(f64::from(n)));
    let p_world = camera.view_plane((x, y));
    Ok(Csc418Pixel {
        delta_u: (window.right - window.left) / columns,
        delta_v: (window.bottom - window.top) / rows,
        p_camera: R::vec3(x, y, camera.f),
        p_world,
        d: p_world - camera.e,
    })
}

/// A ray from p̄_ij on the view plane, with λ > 0, cannot see what stands before the view plane; in
/// lengths of d⃗ from the eye it starts at t = 1.
pub fn t_from_eye<R: Real>(lambda: R) -> R {
    lambda + R::from(1.0)
}

/// The distance of a point from the image plane (p̄ − r̄) · w⃗ = 0, where r̄ = ē + f w⃗.
pub fn off_image_plane<R: Real>(camera: &Camera<R>, point: R::Vec3) -> R {
    let r = camera.e + camera.w * camera.f;
    (point - r).dot(camera.w)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
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

    /// With one column Δu divides by zero (slip 15).
    #[test]
    fn as_printed_one_column_has_no_grid() {
        let window = camera().window;
        let as_printed = (window.right - window.left) / (1.0 - 1.0);
        assert_eq!(as_printed, f64::INFINITY);
        assert_eq!(csc418_pixel(&camera(), (1, 3), (0, 0)), Err(NoGrid));
    }

    /// A ray from p̄_ij with λ > 0 does not see what stands between eye and view plane (slip 22):
    /// Gambetta's t > 1 says it aloud.
    #[test]
    fn lambda_counts_from_the_view_plane() {
        let pixel = csc418_pixel(&camera(), (5, 3), (3, 1)).unwrap();
        let from_plane = math::Ray3::<f64>::new(pixel.p_world, pixel.d);
        let from_eye = math::Ray3::<f64>::new(camera().e, pixel.d);
        for lambda in [-1.0, -0.5, 0.0, 2.0] {
            assert_eq!(from_plane.at(lambda), from_eye.at(t_from_eye(lambda)));
        }
        assert_eq!(from_plane.at(-1.0), camera().e, "the eye itself is at λ = −1, behind the ray");
    }
}

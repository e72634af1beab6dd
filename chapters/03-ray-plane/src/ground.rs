//! The chapter's scene: a checkered ground plane seen from a height of 1.

use math::grid::centers;
use math::{Camera, Degenerate, Handedness, Ray3, Real, Vector, Window};

use crate::Plane;

/// How much of the window of [`camera`], which is 1 high, is above the horizon.
pub const SKY: f64 = 0.25;

/// The ground: y = 0, its normal up.
pub fn ground<R: Real>() -> Plane<R> {
    let (zero, one) = (R::from(0.0), R::from(1.0));
    Plane { point: R::vec3(zero, zero, zero), normal: R::vec3(zero, one, zero) }
}

/// An eye at (0, 1, 0) looking along −z, House's way, at a window of height 1 whose upper quarter is
/// above the horizon, at distance 1. `size` is the picture's, in pixels.
///
/// [`Degenerate::NotFinite`] for a picture without rows.
pub fn camera<R: Real>(size: (u32, u32)) -> Result<Camera<R>, Degenerate> {
    let (zero, one) = (R::from(0.0), R::from(1.0));
    let window = Window {
        bottom: R::round_from(SKY - 1.0),
        top: R::round_from(SKY),
        ..Window::around_axis(one, size)
    };
    let (eye, forward, up) = (R::vec3(zero, one, zero), R::vec3(zero, zero, -one), R::vec3(zero, one, zero));
    Camera::looking(eye, forward, up, Handedness::Right, one, window)
}

/// The ray of a pixel (column, row), row 0 on top, through its center (House 4.1). The direction is not
/// normalized: for the camera of this scene it has z = −1, so t is the depth.
pub fn pixel_ray<R: Real>(camera: &Camera<R>, size: (u32, u32), pixel: (u32, u32)) -> Ray3<R> {
    camera.ray(centers(&camera.window, size, pixel))
}

/// Whether the tile of side 1 under a point of the ground is one of the dark ones: the parity of
/// ⌊x⌋ + ⌊z⌋.
pub fn is_dark<R: Real>(point: R::Vec3) -> bool {
    let [x, z]: [f64; 2] = [point.components()[0].into(), point.components()[2].into()];
    (x.floor() + z.floor()).rem_euclid(2.0) == 1.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn the_row_of_the_horizon_is_exactly_parallel() {
        // by hand: row 100 of 402 lies at 0.25 − 100.5/402 = 0
        let size = (640, 402);
        let camera = camera::<f64>(size).unwrap();
        for col in [0, 320, 639] {
            assert_eq!(pixel_ray(&camera, size, (col, 100)).direction.y, 0.0);
            assert!(pixel_ray(&camera, size, (col, 99)).direction.y > 0.0);
            assert!(pixel_ray(&camera, size, (col, 101)).direction.y < 0.0);
        }
    }

    #[test]
    fn the_eye_looks_along_minus_z_at_a_window_at_depth_1() {
        // by hand: pixels of ¼, the lower left one around (−⅜, −⅝)
        let size = (4, 4);
        let ray = pixel_ray(&camera::<f64>(size).unwrap(), size, (0, 3));
        assert_eq!((ray.origin, ray.direction), (DVec3::Y, DVec3::new(-0.375, -0.625, -1.0)));
        assert_eq!(ground::<f64>(), Plane { point: DVec3::ZERO, normal: DVec3::Y });
    }

    #[test]
    fn tiles_alternate_across_zero() {
        let dark = |x, z| is_dark::<f64>(DVec3::new(x, 0.0, z));
        assert_eq!(
            [dark(0.5, 0.5), dark(-0.5, 0.5), dark(-0.5, -0.5), dark(1.5, 0.5)],
            [false, true, false, true]
        );
    }
}

//! The camera: an eye, a frame, and a window on the view plane.

use crate::{Degenerate, Ray3, Real, Vector, portable};

/// The window on the view plane, in camera coordinates (x right, y up): CSC418's w_l, w_r, w_b, w_t.
///
/// `left` < `right` and `bottom` < `top`, in the units of the scene at the view plane's distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window<R> {
    /// w_l
    pub left: R,
    /// w_r
    pub right: R,
    /// w_b
    pub bottom: R,
    /// w_t
    pub top: R,
}

impl<R: Real> Window<R> {
    /// A window of height `height` about the axis, as wide as a picture of `size` pixels needs so
    /// that pixels are square. Height 1 at distance 1 and a square picture: Gambetta's viewport. Neither
    /// number of `size` may be 0.
    pub fn around_axis(height: R, size: (u32, u32)) -> Self {
        let half = R::from(0.5);
        let top = height * half;
        let right = top * R::round_from(f64::from(size.0) / f64::from(size.1));
        Window { left: -right, right, bottom: -top, top }
    }

    /// The point halfway between the edges: zero for a window about the axis.
    pub fn center(&self) -> (R, R) {
        let half = R::from(0.5);
        ((self.left + self.right) * half, (self.bottom + self.top) * half)
    }
}

/// Which way "right" is when one looks along w with up above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handedness {
    /// right = forward × up: House's axes, x right, y up, looking down −z.
    Right,
    /// right = up × forward: Gambetta's axes, x right, y up, z into the screen.
    Left,
}

/// The general camera of CSC418 11.2: the image plane is e + a u + b v + f w.
///
/// u, v and w are unit vectors at right angles in world space: u points right in the picture, v up,
/// and w away from the eye into the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<R: Real> {
    /// The eye, or pinhole.
    pub e: R::Vec3,
    /// Right.
    pub u: R::Vec3,
    /// Up.
    pub v: R::Vec3,
    /// Into the scene.
    pub w: R::Vec3,
    /// The distance from the eye to the view plane, above zero, in units of the scene.
    pub f: R,
    /// The window on the view plane.
    pub window: Window<R>,
}

impl<R: Real> Camera<R> {
    /// A camera at `e` looking along `forward`, with `up` pointing up in the picture, `f` (above zero, in
    /// units of the scene) from the view plane.
    ///
    /// `forward` and `up` may have any length but zero, and any angle but 0° and 180°:
    /// [`Degenerate::ZeroDirection`] where one of them is zero or `up` runs along `forward` or against it, as
    /// far as can be told from numbers that were rounded, [`Degenerate::NotFinite`] where a number of any
    /// argument is infinite or NaN.
    pub fn looking(
        e: R::Vec3,
        forward: R::Vec3,
        up: R::Vec3,
        handedness: Handedness,
        f: R,
        window: Window<R>,
    ) -> Result<Self, Degenerate> {
        let Window { left, right, bottom, top } = window;
        let finite = [f, left, right, bottom, top].iter().all(|number| number.is_finite());
        if !finite || ![e, forward, up].iter().all(|vector| vector.is_finite()) {
            return Err(Degenerate::NotFinite);
        }
        if forward.is_zero() || up.is_zero() {
            return Err(Degenerate::ZeroDirection);
        }
        let (w, up) = (forward.normalized(), up.normalized());
        let across = match handedness {
            Handedness::Right => R::cross(w, up),
            Handedness::Left => R::cross(up, w),
        };
        // ‖w × up‖ is the sine of the angle between them. Each is rounded three times, when it is written down
        // and by two divisions; two products and their difference add as much as two more. A sine of no more
        // than those eight roundings may be zero in truth.
        let eight_roundings = R::from(8.0 / (1_u64 << R::DIGITS) as f32);
        if across.length() <= eight_roundings {
            return Err(Degenerate::ZeroDirection);
        }
        let u = across.normalized();
        let v = match handedness {
            Handedness::Right => R::cross(u, w),
            Handedness::Left => R::cross(w, u),
        };
        Ok(Camera { e, u, v, w, f, window })
    }

    /// The point (x, y, f) of the view plane in world coordinates: e + x u + y v + f w.
    pub fn view_plane(&self, (x, y): (R, R)) -> R::Vec3 {
        self.e + self.u * x + self.v * y + self.w * self.f
    }

    /// The ray, in world coordinates, from the eye through the point (x, y) of the view plane: t = 0 at the
    /// eye, t = 1 on the plane. Its direction x u + y v + f w is not normalized.
    pub fn ray(&self, (x, y): (R, R)) -> Ray3<R> {
        Ray3::new(self.e, self.u * x + self.v * y + self.w * self.f)
    }

    /// The horizontal field of view in degrees: the angle between the window's left and right edges
    /// as seen from the eye. Gambetta's V_w = V_h = d = 1 gives 53.13°.
    pub fn field_of_view(&self) -> f64 {
        let f: f64 = self.f.into();
        let angle = |edge: R| portable::atan(edge.into() / f);
        (angle(self.window.right) - angle(self.window.left)).to_degrees()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    const UNIT: Window<f64> = Window { left: -0.5, right: 0.5, bottom: -0.5, top: 0.5 };

    #[test]
    fn gambettas_viewport_spans_53_degrees() {
        let camera =
            Camera::<f64>::looking(DVec3::ZERO, DVec3::Z, DVec3::Y, Handedness::Left, 1.0, UNIT).unwrap();
        // 2 atan(1/2) = 53.130102354155978…° (the angle of a 3-4-5 triangle, acos(3/5))
        assert!((camera.field_of_view() - 53.130_102_354_155_98).abs() < 1e-13);
        assert_eq!((camera.u, camera.v, camera.w), (DVec3::X, DVec3::Y, DVec3::Z));
    }

    #[test]
    fn house_looks_down_minus_z() {
        let camera =
            Camera::<f64>::looking(DVec3::ZERO, -DVec3::Z, DVec3::Y, Handedness::Right, 1.0, UNIT).unwrap();
        assert_eq!((camera.u, camera.v, camera.w), (DVec3::X, DVec3::Y, -DVec3::Z));
    }

    #[test]
    fn lengths_do_not_matter() {
        let looking = |forward, up| {
            Camera::<f64>::looking(DVec3::ZERO, forward, up, Handedness::Right, 1.0, UNIT).unwrap()
        };
        let usual = looking(DVec3::new(1.0, -2.0, -2.0), DVec3::Y);
        for length in [1e300, 1e-300] {
            assert_eq!(looking(DVec3::new(1.0, -2.0, -2.0) * length, DVec3::Y * length), usual);
        }
    }

    #[test]
    fn up_along_forward_is_no_frame() {
        let looking =
            |forward, up| Camera::<f64>::looking(DVec3::ZERO, forward, up, Handedness::Right, 1.0, UNIT);
        assert_eq!(looking(DVec3::Z, DVec3::Z * 2.0), Err(Degenerate::ZeroDirection));
        // the decimals 0.1, 0.2, 0.3 run along 1, 2, 3; the numbers nearest to them do not quite
        let [up, forward] = [DVec3::new(0.1, 0.2, 0.3), DVec3::new(1.0, 2.0, 3.0)];
        assert_ne!(up.normalize().cross(forward.normalize()), DVec3::ZERO);
        for forward in [forward, -forward, forward * 1e-300] {
            assert_eq!(looking(forward, up), Err(Degenerate::ZeroDirection));
        }
        // 0.1 f32 is farther from a tenth
        let [up, forward] = [glam::Vec3::new(0.1, 0.2, 0.3), glam::Vec3::new(1.0, 2.0, 3.0)];
        let window = Window { left: -0.5, right: 0.5, bottom: -0.5, top: 0.5 };
        let camera = Camera::<f32>::looking(glam::Vec3::ZERO, forward, up, Handedness::Left, 1.0, window);
        assert_eq!(camera, Err(Degenerate::ZeroDirection));
    }

    #[test]
    fn up_next_to_forward_is_one() {
        let up = DVec3::new(0.0, 1e-15, 1.0);
        let camera = Camera::<f64>::looking(DVec3::ZERO, DVec3::Z, up, Handedness::Left, 1.0, UNIT).unwrap();
        assert_eq!((camera.u, camera.v, camera.w), (DVec3::X, DVec3::Y, DVec3::Z));
    }
}

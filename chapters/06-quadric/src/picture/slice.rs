//! The upright plane that holds a ray: what of a solid lies in it.

use math::{Ray3, Real, Vector};

use crate::Shape;

/// The plane through a ray and the direction of z. A point of it is (u, z): u counts along the ray, from the place
/// nearest to the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slice {
    shape: Shape,
    /// The direction of u in x and y.
    along: [f64; 2],
    /// How far the plane is from the axis.
    pub(crate) beside: f64,
}

impl Slice {
    /// The plane of a ray. A ray that runs along z lies in many: the one through the axis is taken.
    pub(crate) fn of<R: Real>(ray: &Ray3<R>, shape: Shape) -> Slice {
        let ([a_x, a_y, _], [d_x, d_y, _]) = (ray.origin.in_f64::<3>(), ray.direction.in_f64::<3>());
        let along = unit([d_x, d_y]).or(unit([-a_x, -a_y])).unwrap_or([1.0, 0.0]);
        let beside = (along[0] * a_y - along[1] * a_x).abs();
        Slice { shape, along, beside }
    }

    /// Where a point or a vector of space lies in the plane, seen square on.
    pub(crate) fn flat<R: Real>(&self, v: R::Vec3) -> (f64, f64) {
        let [x, y, z] = v.in_f64::<3>();
        (self.along[0] * x + self.along[1] * y, z)
    }

    /// Half the width of the wall at a height, whatever the bounds on z; `None` where the plane passes beside it.
    pub(crate) fn half_width(&self, z: f64) -> Option<f64> {
        let squared = match self.shape {
            Shape::Cylinder => 1.0,
            Shape::Cone => 0.25 * (1.0 - z) * (1.0 - z),
        };
        let left = squared - self.beside * self.beside;
        (left >= 0.0).then(|| left.sqrt())
    }

    /// The right half of the wall from one height to another, point by point; the left half mirrors it.
    ///
    /// Two points where it is straight; else more of them where it starts, as at the vertex of a hyperbola. It may be
    /// empty: the plane passes beside the wall there.
    pub(crate) fn wall(&self, (start, end): (f64, f64)) -> Vec<(f64, f64)> {
        let is_straight = self.shape == Shape::Cylinder || self.beside == 0.0;
        let steps = if is_straight { 1 } else { 48 };
        let at = |step: u32| {
            let s = f64::from(step) / f64::from(steps);
            start + (end - start) * s * s
        };
        (0..=steps).map(at).filter_map(|z| self.half_width(z).map(|u| (u, z))).collect()
    }

    /// Up to where there is a wall: for the cone, below the apex, to the vertex of the hyperbola.
    pub(crate) fn highest(&self) -> f64 {
        match self.shape {
            Shape::Cylinder => 1.0,
            Shape::Cone => 1.0 - 2.0 * self.beside,
        }
    }
}

fn unit([x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let length = (x * x + y * y).sqrt();
    (length > 0.0).then(|| [x / length, y / length])
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_plane_beside_the_axis_cuts_a_narrower_strip() {
        // by hand: y = 0.6 leaves √(1 − 0.36) = 0.8 of the cylinder; u counts along −x
        let ray = Ray3::<f64>::new(DVec3::new(3.0, 0.6, 2.0), DVec3::new(-2.0, 0.0, -1.0));
        let slice = Slice::of(&ray, Shape::Cylinder);
        assert_eq!((slice.beside, slice.half_width(0.0)), (0.6, Some(0.8)));
        assert_eq!(slice.flat::<f64>(ray.origin), (-3.0, 2.0));
        // and the cone is wider than 0.6 nowhere
        assert_eq!(Slice::of(&ray, Shape::Cone).wall((0.0, 1.0)), []);
    }

    #[test]
    fn a_ray_along_z_is_cut_through_the_axis() {
        let ray = Ray3::<f64>::new(DVec3::new(0.0, 0.5, 2.0), DVec3::new(0.0, 0.0, -1.0));
        let slice = Slice::of(&ray, Shape::Cone);
        assert_eq!((slice.beside, slice.flat::<f64>(ray.origin)), (0.0, (-0.5, 2.0)));
        // by hand: ¼(1 − z)² at z = 0 and at z = 1
        assert_eq!((slice.half_width(0.0), slice.half_width(1.0)), (Some(0.5), Some(0.0)));
        let axis = Ray3::<f64>::new(DVec3::Z, DVec3::Z);
        assert_eq!(Slice::of(&axis, Shape::Cone).beside, 0.0);
    }
}

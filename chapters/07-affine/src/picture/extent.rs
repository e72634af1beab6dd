//! Which part of the view plane an object can be seen in at all: most pixels need not ask it. (Chapter 09 makes a
//! method of this.)

use math::{Real, Vector};

use crate::Object;
use crate::scene::{Placed, seen_at};

/// A rectangle of the view plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    left: f64,
    right: f64,
    bottom: f64,
    top: f64,
}

impl Extent {
    /// Around the eight corners of the cube |x|, |y|, |z| ≤ 1, deformed: every unit object but the plane lies in
    /// that cube. They must lie before the eye. The plane is seen everywhere.
    pub(crate) fn of<R: Real>(placed: &Placed<R>) -> Extent {
        let everywhere = f64::INFINITY;
        if placed.deformed.object == Object::Plane {
            return Extent { left: -everywhere, right: everywhere, bottom: -everywhere, top: everywhere };
        }
        let mut extent =
            Extent { left: everywhere, right: -everywhere, bottom: everywhere, top: -everywhere };
        for corner in 0_u8..8 {
            let [x, y, z] = [1, 2, 4].map(|bit| if corner & bit == 0 { R::from(-1.0) } else { R::from(1.0) });
            let (x, y) = seen_at(placed.deformed.affine.apply(R::vec3(x, y, z)).in_f64());
            extent.left = extent.left.min(x);
            extent.right = extent.right.max(x);
            extent.bottom = extent.bottom.min(y);
            extent.top = extent.top.max(y);
        }
        extent
    }

    /// Whether a point of the view plane lies in it.
    pub(crate) fn holds(&self, (x, y): (f64, f64)) -> bool {
        self.left <= x && x <= self.right && self.bottom <= y && y <= self.top
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Method;
    use crate::picture::Layout;
    use crate::scene::{camera, first, five, pixel_ray};

    /// Asked everywhere, no object is found where its extent is not.
    #[test]
    fn nothing_is_seen_outside_its_extent() {
        let size = (180, 120);
        let camera = camera::<f64>(Layout::of(size).window(size)).unwrap();
        let objects = five::<f64>().unwrap();
        let extents = objects.map(|placed| Extent::of(&placed));
        let mut left_out = 0;
        for (col, row) in (0..size.0).flat_map(|col| (0..size.1).map(move |row| (col, row))) {
            let ray = pixel_ray(&camera, size, (col, row));
            for (placed, extent) in objects.iter().zip(&extents) {
                let is_seen = first(Method::Notes, &ray, [placed]).is_some();
                let is_within = extent.holds((ray.direction.x, ray.direction.y));
                assert!(is_within || !is_seen, "{} at {col},{row}", placed.name);
                left_out += usize::from(!is_within);
            }
        }
        assert!(left_out > 0);
    }
}

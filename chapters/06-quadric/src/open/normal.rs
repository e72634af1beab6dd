//! Which way does the wall face? The side away from the axis.

use math::{Real, Vector, Wide};

use super::{End, OpenCone};

/// A gradient below this may have lost digits, where the measures are so small that their products vanish.
const SMALLEST_SAFE: f64 = 1e-280;

impl<R: Real> OpenCone<R> {
    /// The unit normal of the wall at a point of it: the gradient of f, which leads away from the axis, whichever side
    /// the ray comes from.
    ///
    /// With w = x − b, s = w·v / v·v and the radius r there, half the gradient of ‖w‖² − s² v·v − r² is
    ///
    /// ```text
    /// w − s v − r (r_a − r_b) v / v·v
    /// ```
    ///
    /// first straight out from the axis, then along it, toward the smaller end. It is zero at the tip, and
    /// [`OpenCone::tip_normal`] is given there. The point must be finite; the normal then is, too. For
    /// measures that [`OpenCone::check`] refuses it means nothing.
    #[inline(always)]
    pub fn normal(&self, point: R::Vec3) -> R::Vec3 {
        let point = point.in_f64::<3>();
        let gradient = self.in_f64().half_gradient(point);
        if is_safe(gradient) { unit::<R>(gradient) } else { self.wide_normal(point.map(Wide::from)) }
    }

    /// The same at a point that need not be a number of R, and for measures whose squares are none.
    #[cold]
    #[inline(never)]
    pub(super) fn wide_normal(&self, point: [Wide; 3]) -> R::Vec3 {
        let b = Wide::vector::<R, 3>(self.base);
        let (v, vv) = self.wide_axis();
        let w = [0, 1, 2].map(|axis| point[axis] - b[axis]);
        let s = dot(w, v) / vv;
        let k = Wide::of(self.apex_radius) - Wide::of(self.base_radius);
        let r = Wide::of(self.base_radius) + k * s;
        let along = s + r * k / vv;
        let gradient = [0, 1, 2].map(|axis| w[axis] - along * v[axis]);
        if gradient.iter().all(|component| component.is_zero()) {
            return self.tip_normal();
        }
        unit_of_wide::<R>(gradient)
    }

    /// The normal that is given at the tip, where the wall has none: along the axis, out of the cone, of
    /// length 1. For a cone without a tip it leads from the base to the apex.
    pub fn tip_normal(&self) -> R::Vec3 {
        let (v, _) = self.wide_axis();
        let out = unit_of_wide::<R>(v);
        if self.tip() == Some(End::Base) { -out } else { out }
    }

    /// v and v·v
    fn wide_axis(&self) -> ([Wide; 3], Wide) {
        let [b, apex] = [self.base, self.apex].map(Wide::vector::<R, 3>);
        let v = [0, 1, 2].map(|axis| apex[axis] - b[axis]);
        (v, dot(v, v))
    }
}

impl OpenCone<f64> {
    /// With v̂ = v / ‖v‖ and the slope κ = (r_a − r_b) / ‖v‖ no square can overflow before the gradient itself.
    #[inline(always)]
    fn half_gradient(&self, point: [f64; 3]) -> [f64; 3] {
        let [b, apex] = [self.base, self.apex].map(f64::xyz);
        let v = [0, 1, 2].map(|axis| apex[axis] - b[axis]);
        let w = [0, 1, 2].map(|axis| point[axis] - b[axis]);
        let longest = v.iter().fold(0.0, |most: f64, component| most.max(component.abs()));
        let v = v.map(|component| component / longest);
        let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
        let v = v.map(|component| component / length);
        let kappa = (self.apex_radius - self.base_radius) / longest / length;
        let height = w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
        let r = self.base_radius + kappa * height;
        let along = height + r * kappa;
        [0, 1, 2].map(|axis| w[axis] - along * v[axis])
    }
}

/// Whether all of a gradient are numbers, and not so small that they may have lost digits.
#[inline(always)]
fn is_safe(gradient: [f64; 3]) -> bool {
    let largest = gradient.into_iter().fold(0.0, |most: f64, component| most.max(component.abs()));
    gradient.iter().all(|component| component.is_finite()) && largest > SMALLEST_SAFE
}

/// a · b
fn dot(a: [Wide; 3], b: [Wide; 3]) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A vector of numbers of any size, not all zero, at length 1.
fn unit_of_wide<R: Real>(v: [Wide; 3]) -> R::Vec3 {
    let length = dot(v, v).sqrt();
    unit::<R>(v.map(|component| (component / length).to_f64()))
}

/// A vector at length 1, rounded once.
#[inline(always)]
fn unit<R: Real>([x, y, z]: [f64; 3]) -> R::Vec3 {
    let [x, y, z] = f64::xyz(f64::vec3(x, y, z).normalized()).map(R::round_from);
    R::vec3(x, y, z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// By hand: the axis is 9 long along (1, 2, 2)/3, and (2, −2, 1)/3 is at a right angle to it. At the height 3 a
    /// radius that goes from 5 to 2 is 4, and a slope of −⅓ turns the normal up by as much.
    #[test]
    fn around_a_slanted_axis() {
        let base = DVec3::new(1.0, -1.0, 2.0);
        let (up, out) = (DVec3::new(1.0, 2.0, 2.0) / 3.0, DVec3::new(2.0, -2.0, 1.0) / 3.0);
        for out in [out, -out, up.cross(out)] {
            let point = base + 3.0 * up + 4.0 * out;
            let normal = |apex_radius: f64| {
                OpenCone::<f64>::new(base, 5.0, base + 9.0 * up, apex_radius).normal(point)
            };
            let wide = |apex_radius: f64| {
                let cone = OpenCone::<f64>::new(base, 5.0, base + 9.0 * up, apex_radius);
                cone.wide_normal(point.to_array().map(Wide::from))
            };
            for normal in [normal(2.0), wide(2.0)] {
                assert!(normal.distance((out + up / 3.0).normalize()) < 8.0 * f64::EPSILON, "{normal}");
            }
            for normal in [normal(5.0), wide(5.0)] {
                assert!(normal.distance(out) < 8.0 * f64::EPSILON, "{normal}");
            }
        }
    }

    /// By hand: at the tip of a cone, and where products of measures vanish.
    #[test]
    fn where_the_gradient_says_nothing() {
        let tip = OpenCone::<f64>::new(DVec3::ZERO, 1.0, DVec3::Z, 0.0).normal(DVec3::Z);
        assert_eq!(tip, DVec3::Z);
        let tiny = 1e-300;
        let pipe = OpenCone::<f64>::new(DVec3::ZERO, tiny, DVec3::Z * tiny, tiny);
        assert_eq!(pipe.normal(DVec3::new(-tiny, 0.0, tiny / 2.0)), -DVec3::X);
    }

    /// By hand: from radius 3 to radius 1, 4 higher, κ is −½. At (2, 0, 2) the radius is 2, and the gradient 2 out from
    /// the axis and 2 · ½ up.
    #[test]
    fn half_the_gradient() {
        let cone = OpenCone::<f64>::new(DVec3::ZERO, 3.0, DVec3::Z * 4.0, 1.0);
        assert_eq!(cone.half_gradient([2.0, 0.0, 2.0]), [2.0, 0.0, 1.0]);
    }

    #[test]
    fn a_gradient_is_safe_if_it_is_finite_and_not_tiny() {
        assert!(is_safe([0.0, -1.0, 0.0]) && is_safe([SMALLEST_SAFE.next_up(), 0.0, 0.0]));
        assert!(!is_safe([0.0; 3]) && !is_safe([0.0, 0.0, -SMALLEST_SAFE]));
        assert!(!is_safe([1.0, f64::INFINITY, 0.0]) && !is_safe([1.0, f64::NAN, 0.0]));
    }
}

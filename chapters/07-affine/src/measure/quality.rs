//! What putting a hit back into the question shows: how far the point is from the surface, and what the normal
//! is off by.

use lab::{Quality, Truth, angle, dot};
use math::{Ray3, Real, Vector, Wide};

use crate::{Affine, Hit3, Object};

/// One part of the surface of a unit object, at a point of its own space: f there, and ∇f, outward.
struct Part {
    f: Wide,
    gradient: [Wide; 3],
}

/// The parts of the surface: walls, caps, bases, planes, each as if it went on for ever.
fn parts(object: Object, [x, y, z]: [Wide; 3]) -> Vec<Part> {
    let [zero, one, two, half] = [0.0, 1.0, 2.0, 0.5].map(Wide::from);
    let level = |height: Wide, up: Wide| Part { f: z - height, gradient: [zero, zero, up] };
    match object {
        Object::Sphere => {
            vec![Part { f: x * x + y * y + z * z - one, gradient: [x, y, z].map(|v| v * two) }]
        }
        Object::Cylinder => vec![
            Part { f: x * x + y * y - one, gradient: [x * two, y * two, zero] },
            level(one, one),
            level(-one, -one),
        ],
        Object::Cone => {
            let radius = half * (one - z);
            let wall = x * x + y * y - radius * radius;
            vec![Part { f: wall, gradient: [x * two, y * two, radius] }, level(zero, -one)]
        }
        Object::Plane | Object::Triangle => vec![level(zero, one)],
    }
}

/// A as it is, adj A and det A, to some hundred bits.
struct Inverse {
    adjugate: [[Wide; 3]; 3],
    det: Wide,
}

impl Inverse {
    fn of<R: Real>(affine: &Affine<R>) -> Inverse {
        let [a, b, c] = affine.a.columns.map(Wide::vector::<R, 3>);
        let adjugate = [cross(b, c), cross(c, a), cross(a, b)];
        Inverse { adjugate, det: dot(a, adjugate[0]) }
    }

    /// The root of the sum of its squares, which is not below ‖A⁻¹‖.
    fn size(&self) -> Wide {
        let [x, y, z] = self.adjugate.map(|row| dot(row, row));
        (x + y + z).sqrt() / size(self.det)
    }

    /// A⁻¹ v
    fn times(&self, v: [Wide; 3]) -> [Wide; 3] {
        self.adjugate.map(|row| dot(row, v) / self.det)
    }

    /// A⁻ᵀ n
    fn transposed_times(&self, n: [Wide; 3]) -> [Wide; 3] {
        let [x, y, z] = self.adjugate;
        [0, 1, 2].map(|axis| dot([x[axis], y[axis], z[axis]], n) / self.det)
    }
}

fn cross(a: [Wide; 3], b: [Wide; 3]) -> [Wide; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

fn size(x: Wide) -> Wide {
    if x.is_negative() { -x } else { x }
}

/// The quality of a hit, where the truth is one too.
pub(super) fn quality<R: Real>(
    hit: &Hit3<R>,
    ray: &Ray3<R>,
    object: Object,
    affine: &Affine<R>,
    truth: &Truth,
) -> Quality {
    let inverse = Inverse::of(affine);
    let residual = residual(hit, ray, object, affine, &inverse);
    Quality { residual, normal_angle: normal_angle(hit, ray, object, affine, truth, &inverse) }
}

/// The distance of the point from the nearest part of the surface, |F| / ‖∇F‖ with ∇F = A⁻ᵀ ∇f, in units of the
/// largest coordinate of a, t and the point: about 1e-16 is a rounding of `f64`.
fn residual<R: Real>(
    hit: &Hit3<R>,
    ray: &Ray3<R>,
    object: Object,
    affine: &Affine<R>,
    inverse: &Inverse,
) -> f64 {
    if !hit.point.is_finite() {
        return f64::INFINITY;
    }
    let [x, a, t]: [[Wide; 3]; 3] = [hit.point, ray.origin, affine.t].map(Wide::vector::<R, 3>);
    let p = inverse.times([0, 1, 2].map(|axis| x[axis] - t[axis]));
    let distance = |Part { f, gradient }: Part| {
        let gradient = inverse.transposed_times(gradient);
        if f.is_zero() { Wide::ZERO } else { size(f) / dot(gradient, gradient).sqrt() }
    };
    let largest = [x, a, t].into_iter().flatten().map(size).fold(Wide::ZERO, larger);
    let distances = parts(object, p).into_iter().map(distance);
    distances
        .map(|off| if off.is_zero() { 0.0 } else { (off / largest).to_f64() })
        .fold(f64::INFINITY, f64::min)
}

fn larger(a: Wide, b: Wide) -> Wide {
    if (a - b).is_negative() { b } else { a }
}

/// The angle between the normal and A⁻ᵀ ∇f at the true point; `None` where there is no true normal: at a rim, at the
/// apex, and where the true t has not digits enough to tell.
fn normal_angle<R: Real>(
    hit: &Hit3<R>,
    ray: &Ray3<R>,
    object: Object,
    affine: &Affine<R>,
    truth: &Truth,
    inverse: &Inverse,
) -> Option<f64> {
    /// What |f| is at the most where the true t puts the point on a part, and at the least beside it.
    const ON: f64 = 1e-15;
    const BESIDE: f64 = 1e-9;
    let Truth::Hit { t: lambda, .. } = truth else { return None };
    if !hit.normal.is_finite() || !lambda.nearest.is_finite() {
        return None;
    }
    let [a, d, t]: [[Wide; 3]; 3] = [ray.origin, ray.direction, affine.t].map(Wide::vector::<R, 3>);
    let a_prime = inverse.times([0, 1, 2].map(|axis| a[axis] - t[axis]));
    let way = inverse.times(d).map(|d| lambda.fine * d);
    let p = [0, 1, 2].map(|axis| a_prime[axis] + way[axis]);
    let mut parts = parts(object, p);
    parts.sort_by(|a, b| size(a.f).to_f64().total_cmp(&size(b.f).to_f64()));
    let told_apart = parts.get(1).is_none_or(|second| size(second.f).to_f64() > BESIDE);
    let Part { f, gradient } = &parts[0];
    // The true λ has some hundred binary digits: p is off by 2^−100 of the way to it, and the normal by ‖A⁻¹‖ times that.
    // Where more than half of them are lost, it is not the truth.
    let true_normal = inverse.transposed_times(*gradient);
    let off = Wide::from(1.0 / (1u64 << 48) as f64) * inverse.size();
    let is_lost =
        !object.is_flat() && (dot(true_normal, true_normal) - off * off * dot(way, way)).is_negative();
    if size(*f).to_f64() > ON || !told_apart || is_lost {
        return None;
    }
    angle(Wide::vector::<R, 3>(hit.normal), true_normal)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::question;
    use glam::DVec3;
    use std::f64::consts::FRAC_PI_4;

    /// By hand: half axes 2, 1, 4 around (1, 0, 3), and a point 1/1024 above its top (1, 0, 7), seen from z = 16.
    #[test]
    fn the_residual_is_a_distance_from_the_surface() {
        let case = |shape| {
            [
                1.0, 0.0, 16.0, 0.0, 0.0, -1.0, shape, 2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 4.0, 1.0, 0.0,
                3.0,
            ]
        };
        let above = DVec3::new(1.0, 0.0, 7.0 + 1.0 / 1024.0);
        let leaning = DVec3::new(1.0, 0.0, 1.0);
        let truth = Truth::Hit { t: lab::Root { nearest: 9.0, fine: Wide::from(9.0) }, out: None };
        for (shape, flat) in [(0.0, false), (1.0, true)] {
            let (ray, object, affine) = question::<f64>(case(shape));
            let hit = Hit3::<f64> { t: 9.0, point: above, normal: leaning };
            let Quality { residual, normal_angle } = quality(&hit, &ray, object, &affine, &truth);
            // |F| / ‖∇F‖ is the distance to the first order
            let error = (residual * 16.0 * 1024.0 - 1.0).abs();
            assert!(if flat { error == 0.0 } else { error < 1e-3 }, "{}: {residual:e}", object.name());
            assert!((normal_angle.unwrap() - FRAC_PI_4).abs() < 1e-15);
        }
    }
}

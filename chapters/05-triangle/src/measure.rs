//! How this chapter is judged and timed: what it hands to the lab.

use std::rc::Rc;

use lab::{Answer, Quality, Regime, Runner, Subject, Truth, angle, dot, oracle, runner};
use math::{Ray3, Real, Span, Vector, Wide};
use stage::{About, Chapter, Precision};

use crate::stage::RayTriangle;
use crate::{Hit3, Method, Triangle, half_planes, matrix, regimes, robust};

/// A ray and a triangle in the order of a case's columns.
pub(crate) fn question<R: Real>(case: [R; 15]) -> (Ray3<R>, Triangle<R>) {
    let v = |i: usize| R::vec3(case[i], case[i + 1], case[i + 2]);
    (Ray3::<R>::new(v(0), v(3)), Triangle { p1: v(6), p2: v(9), p3: v(12) })
}

impl Subject<15> for RayTriangle {
    fn about(&self) -> About {
        Chapter::about(self)
    }

    fn baseline(&self) -> usize {
        Method::ALL.iter().position(|&method| method == Method::Matrix).unwrap_or(0)
    }

    fn regimes(&self) -> Vec<Regime<15>> {
        regimes::regimes()
    }

    fn truth(&self, case: [f64; 15], precision: Precision) -> Truth {
        oracle::triangle(case, precision)
    }

    fn answer<R: Real>(&self, method: usize, case: [R; 15]) -> Answer {
        let (ray, triangle) = question(case);
        Answer::of(&Method::ALL[method].work(&ray, &triangle).hit(Span::ahead()))
    }

    fn quality<R: Real>(&self, method: usize, case: [R; 15], _truth: &Truth) -> Option<Quality> {
        let (ray, triangle) = question(case);
        let hit = Method::ALL[method].work(&ray, &triangle).hit(Span::ahead()).ok()??;
        let n = wide_normal(&triangle);
        let residual = n.map_or(0.0, |n| residual(&hit, &ray, &triangle, n));
        let is_number = hit.normal.is_finite();
        let normal_angle = n.filter(|_| is_number).and_then(|n| angle(Wide::vector::<R, 3>(hit.normal), n));
        Some(Quality { residual, normal_angle })
    }

    fn runners<'a, R: Real>(&self, cases: &'a [[R; 15]]) -> Vec<Runner<'a>> {
        let questions: Rc<[_]> = cases.iter().map(|&case| question(case)).collect();
        let runner_of = |method: Method| -> Runner<'a> {
            match method {
                Method::HalfPlanes => {
                    runner(&questions, |(ray, triangle)| half_planes(ray, triangle).hit(Span::ahead()))
                }
                Method::Matrix => {
                    runner(&questions, |(ray, triangle)| matrix(ray, triangle).hit(Span::ahead()))
                }
                Method::Robust => {
                    runner(&questions, |(ray, triangle)| robust(ray, triangle).hit(Span::ahead()))
                }
            }
        };
        Method::ALL.map(runner_of).into()
    }
}

/// n = (p̄2 − p̄1) × (p̄3 − p̄1) with twice the digits; `None` where a sliver is so thin that most of them cancel.
fn wide_normal<R: Real>(triangle: &Triangle<R>) -> Option<[Wide; 3]> {
    let [p1, p2, p3]: [[Wide; 3]; 3] = triangle.corners().map(Wide::vector::<R, 3>);
    let [e1, e2]: [[Wide; 3]; 2] = [p2, p3].map(|to| std::array::from_fn(|axis| to[axis] - p1[axis]));
    let minor = |i: usize, j: usize| e1[i] * e2[j] - e1[j] * e2[i];
    let n = [minor(1, 2), minor(2, 0), minor(0, 1)];
    // Of some hundred binary digits at least forty are left.
    let lost = Wide::from(1.0 / (1u64 << 60) as f64);
    let is_good = !(dot(n, n) - lost * lost * dot(e1, e1) * dot(e2, e2)).is_negative();
    is_good.then_some(n)
}

/// |n · (x − p̄1)| / ‖n‖, the distance of the point from the plane, in units of the largest coordinate of the ray's
/// origin, the corners and x: about 1e-16 is a rounding of `f64`.
fn residual<R: Real>(hit: &Hit3<R>, ray: &Ray3<R>, triangle: &Triangle<R>, n: [Wide; 3]) -> f64 {
    if !hit.point.is_finite() {
        return f64::INFINITY;
    }
    let [x, o, p1, p2, p3]: [[Wide; 3]; 5] =
        [hit.point, ray.origin, triangle.p1, triangle.p2, triangle.p3].map(Wide::vector::<R, 3>);
    let off = dot(n, std::array::from_fn(|axis| x[axis] - p1[axis]));
    if off.is_zero() {
        return 0.0;
    }
    let coordinates = [x, o, p1, p2, p3].into_iter().flatten();
    let size = coordinates.map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    (off / dot(n, n).sqrt() / Wide::from(size)).to_f64().abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A point 3 above the triangle's plane y = 2, whatever its size, and the origin at (0, 0, 12).
    #[test]
    fn the_residual_is_a_distance_from_the_plane() {
        for size in [1.0, 1e-200, 1e-300] {
            let corners = [[0.0, 2.0, 0.0], [0.0, 2.0, size], [size, 2.0, 0.0]].concat();
            let case = [vec![0.0, 0.0, 12.0, 0.0, 1.0, 0.0], corners].concat();
            let (ray, triangle) = question::<f64>(std::array::from_fn(|i| case[i]));
            let n = wide_normal(&triangle).unwrap();
            let hit = Hit3::<f64> { t: 0.0, point: glam::DVec3::new(1.0, 5.0, 0.0), normal: glam::DVec3::X };
            // by hand: 3 in units of 12, and X is at right angles to Y
            assert_eq!(residual(&hit, &ray, &triangle, n), 0.25);
            assert_eq!(angle([1.0, 0.0, 0.0].map(Wide::from), n), Some(std::f64::consts::FRAC_PI_2));
            let lost = Hit3::<f64> { point: glam::DVec3::NAN, ..hit };
            assert_eq!(residual(&lost, &ray, &triangle, n), f64::INFINITY);
        }
    }

    /// Of a sliver thinner than twice the digits can tell, no normal is said to be the true one.
    #[test]
    fn a_normal_that_cancels_is_not_judged() {
        let third = 1.0 / 3.0;
        let line = [0.0, 0.0, 0.0, third, third, third, 1e16, 1e16, f64::next_up(1e16)];
        let case = [vec![0.0; 6], line.to_vec()].concat();
        let (_, triangle) = question::<f64>(std::array::from_fn(|i| case[i]));
        assert!(wide_normal(&triangle).is_some());
        let thin = Triangle::<f64> { p3: glam::DVec3::new(1e300, 1e300, f64::next_up(1e300)), ..triangle };
        assert!(wide_normal(&thin).is_some(), "as thin as any of this kind");
    }
}

//! How this chapter is judged and timed: what it hands to the lab.

use std::rc::Rc;

use lab::{Answer, Quality, Regime, Runner, Subject, Truth, angle, dot, oracle, runner};
use math::{Ray3, Real, Span, Vector, Wide};
use stage::{About, Chapter, Precision};

use crate::stage::RayPlane;
use crate::{Hit3, Method, Plane, notes, regimes, robust};

/// A ray and a plane in the order of a case's columns.
pub(crate) fn question<R: Real>(case: [R; 12]) -> (Ray3<R>, Plane<R>) {
    let [ox, oy, oz, dx, dy, dz, px, py, pz, nx, ny, nz] = case;
    let ray = Ray3::<R>::new(R::vec3(ox, oy, oz), R::vec3(dx, dy, dz));
    (ray, Plane { point: R::vec3(px, py, pz), normal: R::vec3(nx, ny, nz) })
}

impl Subject<12> for RayPlane {
    fn about(&self) -> About {
        Chapter::about(self)
    }

    fn baseline(&self) -> usize {
        Method::ALL.iter().position(|&method| method == Method::Notes).unwrap_or(0)
    }

    fn regimes(&self) -> Vec<Regime<12>> {
        regimes::regimes()
    }

    fn truth(&self, case: [f64; 12], precision: Precision) -> Truth {
        oracle::plane(case, precision)
    }

    fn answer<R: Real>(&self, method: usize, case: [R; 12]) -> Answer {
        let (ray, plane) = question(case);
        Answer::of(&Method::ALL[method].work(&ray, &plane).hit(Span::ahead()))
    }

    fn quality<R: Real>(&self, method: usize, case: [R; 12], _truth: &Truth) -> Option<Quality> {
        let (ray, plane) = question(case);
        let hit = Method::ALL[method].work(&ray, &plane).hit(Span::ahead()).ok()??;
        let normal_angle = normal_angle(&hit, &plane);
        Some(Quality { residual: residual(&hit, &ray, &plane), normal_angle })
    }

    fn runners<'a, R: Real>(&self, cases: &'a [[R; 12]]) -> Vec<Runner<'a>> {
        let questions: Rc<[_]> = cases.iter().map(|&case| question(case)).collect();
        let runner_of = |method: Method| -> Runner<'a> {
            match method {
                Method::Notes => runner(&questions, |(ray, plane)| notes(ray, plane).hit(Span::ahead())),
                Method::Robust => runner(&questions, |(ray, plane)| robust(ray, plane).hit(Span::ahead())),
            }
        };
        Method::ALL.map(runner_of).into()
    }
}

/// |n · (x − p_0)| / ‖n‖, the distance of the point from the plane, in units of the largest coordinate
/// of p_r, p_0 and x: about 1e-16 is a rounding of `f64`. A wrong t hardly shows where the ray is all
/// but parallel, for then it moves the point along the plane.
fn residual<R: Real>(hit: &Hit3<R>, ray: &Ray3<R>, plane: &Plane<R>) -> f64 {
    if !hit.point.is_finite() {
        return f64::INFINITY;
    }
    let [x, p_r, p_0, n]: [[Wide; 3]; 4] =
        [hit.point, ray.origin, plane.point, plane.normal].map(Wide::vector::<R, 3>);
    let from_plane: [Wide; 3] = std::array::from_fn(|axis| x[axis] - p_0[axis]);
    let off = dot(n, from_plane);
    if off.is_zero() {
        return 0.0;
    }
    let coordinates = [x, p_r, p_0].into_iter().flatten();
    let size = coordinates.map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    (off / dot(n, n).sqrt() / Wide::from(size)).to_f64().abs()
}

/// The angle between the normal and n.
fn normal_angle<R: Real>(hit: &Hit3<R>, plane: &Plane<R>) -> Option<f64> {
    if !hit.normal.is_finite() {
        return None;
    }
    angle(Wide::vector::<R, 3>(hit.normal), Wide::vector::<R, 3>(plane.normal))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A point 3 above the plane y = 2, whatever the length of its normal, and the origin at (0, 0, 12).
    #[test]
    fn the_residual_is_a_distance_from_the_plane() {
        for length in [1.0, 1e-200, 1e200] {
            let (ray, plane) = question([0.0, 0.0, 12.0, 0.0, 1.0, 0.0, 7.0, 2.0, 0.0, 0.0, length, 0.0]);
            let hit = Hit3::<f64> { t: 0.0, point: glam::DVec3::new(1.0, 5.0, 0.0), normal: glam::DVec3::X };
            // by hand: 3 in units of 12, and X is at right angles to Y
            assert_eq!(residual(&hit, &ray, &plane), 0.25);
            assert_eq!(normal_angle(&hit, &plane), Some(std::f64::consts::FRAC_PI_2));
            let lost = Hit3::<f64> { point: glam::DVec3::NAN, ..hit };
            assert_eq!(residual(&lost, &ray, &plane), f64::INFINITY);
        }
    }
}

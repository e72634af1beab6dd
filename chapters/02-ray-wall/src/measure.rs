//! How this chapter is judged and timed: what it hands to the lab.

use std::rc::Rc;

use lab::{Answer, Quality, Regime, Runner, Subject, Truth, oracle, runner};
use math::{Ray2, Real, Span, Vector, Wide};
use stage::{About, Chapter, Precision};

use crate::stage::RayWall;
use crate::{Hit2, Method, Wall, notes, regimes, robust};

/// A ray and a wall in the order of a case's columns.
pub(crate) fn question<R: Real>(case: [R; 6]) -> (Ray2<R>, Wall<R>) {
    let [ox, oy, dx, dy, front, back] = case;
    (Ray2::<R>::new(R::vec2(ox, oy), R::vec2(dx, dy)), Wall { front, back })
}

impl Subject<6> for RayWall {
    fn about(&self) -> About {
        Chapter::about(self)
    }

    fn baseline(&self) -> usize {
        Method::ALL.iter().position(|&method| method == Method::Notes).unwrap_or(0)
    }

    fn regimes(&self) -> Vec<Regime<6>> {
        regimes::regimes()
    }

    fn truth(&self, case: [f64; 6], precision: Precision) -> Truth {
        oracle::wall(case, precision)
    }

    fn answer<R: Real>(&self, method: usize, case: [R; 6]) -> Answer {
        let (ray, wall) = question(case);
        Answer::of(&Method::ALL[method].work(&ray, &wall).hit(Span::ahead()))
    }

    fn quality<R: Real>(&self, method: usize, case: [R; 6], _truth: &Truth) -> Option<Quality> {
        let (ray, wall) = question(case);
        let hit = Method::ALL[method].work(&ray, &wall).hit(Span::ahead()).ok()??;
        // the normal is (±1, 0): chosen, not computed
        Some(Quality { residual: residual(&hit, &ray, &wall), normal_angle: None })
    }

    fn runners<'a, R: Real>(&self, cases: &'a [[R; 6]]) -> Vec<Runner<'a>> {
        let questions: Rc<[_]> = cases.iter().map(|&case| question(case)).collect();
        let runner_of = |method: Method| -> Runner<'a> {
            match method {
                Method::Notes => runner(&questions, |(ray, wall)| notes(ray, wall).hit(Span::ahead())),
                Method::Robust => runner(&questions, |(ray, wall)| robust(ray, wall).hit(Span::ahead())),
            }
        };
        Method::ALL.map(runner_of).into()
    }
}

/// |x − face| in units of the largest of |p_x|, |face| and |x|: about 1e-16 is a rounding of `f64`, however
/// thin the wall, for p_x and t u_x have been added; more is an error of t that shows.
fn residual<R: Real>(hit: &Hit2<R>, ray: &Ray2<R>, wall: &Wall<R>) -> f64 {
    if !hit.point.is_finite() {
        return f64::INFINITY;
    }
    let face = if hit.normal.x() < R::from(0.0) { wall.front } else { wall.back };
    let [x, p_x, face]: [f64; 3] = [hit.point.x(), ray.origin.x(), face].map(Into::into);
    let off = Wide::from(x) - Wide::from(face);
    let size = Wide::from(p_x.abs().max(face.abs()).max(x.abs()));
    if off.is_zero() { 0.0 } else { (off / size).to_f64().abs() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_residual_is_that_of_the_face_that_was_hit() {
        let (ray, wall) = question([-8.0, 0.0, 1.0, 0.0, 2.0, 4.0]);
        let hit = |x: f64, normal: f64| Hit2::<f64> {
            t: 0.0,
            point: glam::DVec2::new(x, 0.0),
            normal: glam::DVec2::new(normal, 0.0),
        };
        // by hand: 1 off the front and 1 off the back, in units of 8
        assert_eq!(residual(&hit(3.0, -1.0), &ray, &wall), 0.125);
        assert_eq!(residual(&hit(5.0, 1.0), &ray, &wall), 0.125);
        assert_eq!(residual(&hit(f64::INFINITY, 1.0), &ray, &wall), f64::INFINITY);
        let (ray, wall) = question([0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
        assert_eq!(residual(&hit(0.0, -1.0), &ray, &wall), 0.0);
    }
}

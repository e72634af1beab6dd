//! How this chapter is judged and timed: what it hands to the lab.

use std::rc::Rc;

use lab::oracle::{self, UnitObject};
use lab::{Answer, Quality, Regime, Runner, Subject, Truth, angle, runner};
use math::{Ray3, Real, Span, Vector, Wide};
use stage::{About, Chapter, Precision};

use crate::stage::Quadric;
use crate::{Hit3, Method, Shape, notes, regimes, robust};

/// A ray and a solid in the order of a case's columns; the last holds the shape's place.
pub(crate) fn question<R: Real>(case: [R; 7]) -> (Ray3<R>, Shape) {
    let [ox, oy, oz, dx, dy, dz, shape] = case;
    let ray = Ray3::<R>::new(R::vec3(ox, oy, oz), R::vec3(dx, dy, dz));
    let shape = if shape == R::from(0.0) { Shape::Cylinder } else { Shape::Cone };
    (ray, shape)
}

impl Subject<7> for Quadric {
    fn about(&self) -> About {
        Chapter::about(self)
    }

    fn baseline(&self) -> usize {
        Method::ALL.iter().position(|&method| method == Method::Notes).unwrap_or(0)
    }

    fn regimes(&self) -> Vec<Regime<7>> {
        regimes::regimes()
    }

    fn truth(&self, case: [f64; 7], precision: Precision) -> Truth {
        let (_, shape) = question(case);
        let object = match shape {
            Shape::Cylinder => UnitObject::Cylinder,
            Shape::Cone => UnitObject::Cone,
        };
        let [ox, oy, oz, dx, dy, dz, _] = case;
        oracle::quadric(object, [ox, oy, oz, dx, dy, dz], precision)
    }

    fn answer<R: Real>(&self, method: usize, case: [R; 7]) -> Answer {
        let (ray, shape) = question(case);
        Answer::of(&Method::ALL[method].work(&ray, shape).hit(Span::ahead()))
    }

    fn quality<R: Real>(&self, method: usize, case: [R; 7], truth: &Truth) -> Option<Quality> {
        let (ray, shape) = question(case);
        let hit = Method::ALL[method].work(&ray, shape).hit(Span::ahead()).ok()??;
        let normal_angle = normal_angle(&hit, &ray, shape, truth);
        Some(Quality { residual: residual(&hit, shape), normal_angle })
    }

    fn runners<'a, R: Real>(&self, cases: &'a [[R; 7]]) -> Vec<Runner<'a>> {
        let questions: Rc<[_]> = cases.iter().map(|&case| question(case)).collect();
        let runner_of = |method: Method| -> Runner<'a> {
            match method {
                Method::Notes => runner(&questions, |(ray, shape)| notes(ray, *shape).hit(Span::ahead())),
                Method::Robust => runner(&questions, |(ray, shape)| robust(ray, *shape).hit(Span::ahead())),
            }
        };
        Method::ALL.map(runner_of).into()
    }
}

/// How far a point is outside the wall and the two planes, below zero within, in numbers that neither overflow nor
/// cancel. The plane through the apex is none of the cone's; it comes to nothing there.
fn depths(shape: Shape, [x, y, z]: [Wide; 3]) -> [Wide; 3] {
    let [one, two, five] = [1.0, 2.0, 5.0].map(Wide::from);
    let rho = (x * x + y * y).sqrt();
    match shape {
        Shape::Cylinder => [rho - one, z - one, -z - one],
        // The slope of the wall is 2: its distance is that across, times the cosine 2 / √5.
        Shape::Cone => [(two * rho - (one - z)) / five.sqrt(), z - one, -z],
    }
}

/// The distance of the point from the surface, in units of the solid's own size.
fn residual<R: Real>(hit: &Hit3<R>, shape: Shape) -> f64 {
    if !hit.point.is_finite() {
        return f64::INFINITY;
    }
    let depths = depths(shape, Wide::vector::<R, 3>(hit.point)).map(Wide::to_f64);
    depths.into_iter().fold(f64::NEG_INFINITY, f64::max).abs()
}

/// Nearer than this to two parts, or to the apex, or with so many digits of o + t d lost, a point has no one true
/// normal that could be compared with.
const TOO_NEAR: f64 = 1e-12;

/// The angle between the normal and the true one, which is that of the part at o + t d with the true t; `None` where
/// there is none.
fn normal_angle<R: Real>(hit: &Hit3<R>, ray: &Ray3<R>, shape: Shape, truth: &Truth) -> Option<f64> {
    let Truth::Hit { t, .. } = truth else { return None };
    if !hit.normal.is_finite() || !t.nearest.is_finite() {
        return None;
    }
    let [o, d]: [[Wide; 3]; 2] = [ray.origin, ray.direction].map(Wide::vector::<R, 3>);
    let point: [Wide; 3] = std::array::from_fn(|axis| o[axis] + t.fine * d[axis]);
    let depth = depths(shape, point).map(Wide::to_f64);
    let outermost = depth.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // The true t has a hundred bits, 2^−100 of the way.
    let is_lost = outermost.abs() > TOO_NEAR * TOO_NEAR;
    let is_tie = depth.iter().filter(|&&depth| outermost - depth < TOO_NEAR).count() > 1;
    if is_lost || is_tie {
        return None;
    }
    let [zero, one, quarter] = [0.0, 1.0, 0.25].map(Wide::from);
    let [x, y, z] = point;
    let outward = match depth.iter().position(|&depth| depth == outermost) {
        Some(1) => [zero, zero, one],
        Some(2) => [zero, zero, -one],
        _ if shape == Shape::Cylinder => [x, y, zero],
        _ => [x, y, quarter * (one - z)],
    };
    angle(Wide::vector::<R, 3>(hit.normal), outward)
}

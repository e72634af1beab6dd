//! How this chapter is judged and timed: what it hands to the lab.

use std::rc::Rc;

use lab::{Answer, Pass, Quality, Regime, Runner, Subject, Truth, angle, dot, oracle, runner};
use math::{Ray3, Real, Span, Vector, Wide};
use stage::{About, Chapter, Precision};

use crate::batched::{Batch, Hits, Instructions};
use crate::stage::RaySphere;
use crate::{Hit3, Method, Sphere, regimes};
use crate::{batched, closest_approach, half_quadratic, quadratic, robust, shortcut};

/// A ray and a sphere in the order of a case's columns.
pub(crate) fn question<R: Real>(case: [R; 10]) -> (Ray3<R>, Sphere<R>) {
    let [ox, oy, oz, dx, dy, dz, cx, cy, cz, radius] = case;
    let ray = Ray3::<R>::new(R::vec3(ox, oy, oz), R::vec3(dx, dy, dz));
    (ray, Sphere { center: R::vec3(cx, cy, cz), radius })
}

impl Subject<10> for RaySphere {
    fn about(&self) -> About {
        Chapter::about(self)
    }

    fn baseline(&self) -> usize {
        Method::ALL.iter().position(|&method| method == Method::Quadratic).unwrap_or(0)
    }

    fn regimes(&self) -> Vec<Regime<10>> {
        regimes::regimes()
    }

    fn truth(&self, case: [f64; 10], precision: Precision) -> Truth {
        oracle::sphere(case, precision)
    }

    fn answer<R: Real>(&self, method: usize, case: [R; 10]) -> Answer {
        let (ray, sphere) = question(case);
        Answer::of(&Method::ALL[method].work(&ray, &sphere).hit(Span::ahead()))
    }

    fn quality<R: Real>(&self, method: usize, case: [R; 10], truth: &Truth) -> Option<Quality> {
        let (ray, sphere) = question(case);
        let hit = Method::ALL[method].work(&ray, &sphere).hit(Span::ahead()).ok()??;
        let normal_angle = normal_angle(&hit, &ray, &sphere, truth);
        Some(Quality { residual: residual(&hit, &sphere), normal_angle })
    }

    fn runners<'a, R: Real>(&self, cases: &'a [[R; 10]]) -> Vec<Runner<'a>> {
        let questions: Rc<[_]> = cases.iter().map(|&case| question(case)).collect();
        let runner_of = |method: Method| -> Runner<'a> {
            match method {
                Method::ClosestApproach => {
                    runner(&questions, |(ray, sphere)| closest_approach(ray, sphere).hit(Span::ahead()))
                }
                Method::Shortcut => {
                    runner(&questions, |(ray, sphere)| shortcut(ray, sphere).hit(Span::ahead()))
                }
                Method::Quadratic => {
                    runner(&questions, |(ray, sphere)| quadratic(ray, sphere).hit(Span::ahead()))
                }
                Method::HalfQuadratic => {
                    runner(&questions, |(ray, sphere)| half_quadratic(ray, sphere).hit(Span::ahead()))
                }
                Method::Batched => batch_runner(&questions),
                Method::Robust => runner(&questions, |(ray, sphere)| robust(ray, sphere).hit(Span::ahead())),
            }
        };
        Method::ALL.map(runner_of).into()
    }
}

/// A batch takes all rays at once, and they are in its columns before the clock starts. One after another each
/// is a batch of its own.
fn batch_runner<'a, R: Real>(questions: &Rc<[(Ray3<R>, Sphere<R>)]>) -> Runner<'a> {
    let batch: Batch<R> = questions.iter().copied().collect();
    let mut hits = Hits::new();
    let mut alone = runner(questions, |(ray, sphere)| batched(ray, sphere).hit(Span::ahead()));
    Box::new(move |pass, rays| match pass {
        Pass::Throughput => {
            batch.hits_into(&mut hits, Span::ahead(), Instructions::Best);
            std::hint::black_box(&hits);
            batch.len()
        }
        Pass::Latency => alone(pass, rays),
    })
}

/// |‖x − c‖² − r²| / 2r², the distance of the point from the surface in radii where it is near, in numbers
/// that neither overflow nor cancel.
fn residual<R: Real>(hit: &Hit3<R>, sphere: &Sphere<R>) -> f64 {
    if !hit.point.is_finite() {
        return f64::INFINITY;
    }
    let [x, c]: [[Wide; 3]; 2] = [hit.point, sphere.center].map(Wide::vector::<R, 3>);
    let r = Wide::of(sphere.radius);
    let from_center: [Wide; 3] = std::array::from_fn(|axis| x[axis] - c[axis]);
    let rest = dot(from_center, from_center) - r * r;
    (rest / (r * r + r * r)).to_f64().abs()
}

/// The angle between the normal and the true one, o + t d − c with the true t; `None` where there is none.
fn normal_angle<R: Real>(hit: &Hit3<R>, ray: &Ray3<R>, sphere: &Sphere<R>, truth: &Truth) -> Option<f64> {
    let Truth::Hit { t, .. } = truth else { return None };
    if !hit.normal.is_finite() || !t.nearest.is_finite() {
        return None;
    }
    let [o, d, c]: [[Wide; 3]; 3] = [ray.origin, ray.direction, sphere.center].map(Wide::vector::<R, 3>);
    let n: [Wide; 3] = Wide::vector::<R, 3>(hit.normal);
    let way: [Wide; 3] = std::array::from_fn(|axis| t.fine * d[axis]);
    let outward: [Wide; 3] = std::array::from_fn(|axis| (o[axis] - c[axis]) + way[axis]);
    // The true t has some hundred digits. Where more than half of them cancel, the rest is not the truth.
    let lost = Wide::from(1.0 / (1u64 << 60) as f64);
    if (dot(outward, outward) - lost * lost * dot(way, way)).is_negative() {
        return None;
    }
    angle(n, outward)
}

//! How this chapter is judged and timed: what it hands to the lab.

mod quality;

use std::rc::Rc;

use lab::oracle::{self, UnitObject};
use lab::{Answer, Quality, Regime, Runner, Subject, Truth, runner};
use math::{Ray3, Real, Span};
use stage::{About, Chapter, Precision};

use crate::{Affine, Deformed, Matrix3, Method, Object, notes, regimes, robust, solved};

/// A ray, an object and its deformation in the order of a case's columns.
pub(crate) fn question<R: Real>(case: [R; 19]) -> (Ray3<R>, Object, Affine<R>) {
    let [ox, oy, oz, dx, dy, dz, shape, a11, a12, a13, a21, a22, a23, a31, a32, a33, tx, ty, tz] = case;
    let ray = Ray3::<R>::new(R::vec3(ox, oy, oz), R::vec3(dx, dy, dz));
    // The column holds a word, read as its place.
    let place: f64 = shape.into();
    let object = Object::ALL.get(place as usize).copied().unwrap_or(Object::Sphere);
    let a = Matrix3::from_rows([[a11, a12, a13], [a21, a22, a23], [a31, a32, a33]]);
    (ray, object, Affine { a, t: R::vec3(tx, ty, tz) })
}

impl Subject<19> for crate::stage::Affine {
    fn about(&self) -> About {
        Chapter::about(self)
    }

    fn baseline(&self) -> usize {
        Method::ALL.iter().position(|&method| method == Method::Notes).unwrap_or(0)
    }

    fn regimes(&self) -> Vec<Regime<19>> {
        regimes::regimes()
    }

    fn truth(&self, case: [f64; 19], precision: Precision) -> Truth {
        let (_, object, _) = question(case);
        let shape = match object {
            Object::Sphere => UnitObject::Sphere,
            Object::Cylinder => UnitObject::Cylinder,
            Object::Cone => UnitObject::Cone,
            Object::Plane => UnitObject::Plane,
            Object::Triangle => UnitObject::Triangle,
        };
        // the same columns without that of the word
        let numbers = std::array::from_fn(|at| case[if at < 6 { at } else { at + 1 }]);
        oracle::affine(shape, numbers, precision)
    }

    fn answer<R: Real>(&self, method: usize, case: [R; 19]) -> Answer {
        let (ray, object, affine) = question(case);
        match Deformed::for_ray(&ray, object, affine) {
            Ok(deformed) => Answer::of(&Method::ALL[method].work(&ray, &deformed).hit(Span::ahead())),
            Err(_) => Answer::Invalid,
        }
    }

    fn quality<R: Real>(&self, method: usize, case: [R; 19], truth: &Truth) -> Option<Quality> {
        let (ray, object, affine) = question(case);
        let deformed = Deformed::for_ray(&ray, object, affine).ok()?;
        let hit = Method::ALL[method].work(&ray, &deformed).hit(Span::ahead()).ok()??;
        Some(quality::quality(&hit, &ray, object, &affine, truth))
    }

    fn runners<'a, R: Real>(&self, cases: &'a [[R; 19]]) -> Vec<Runner<'a>> {
        // The deformed objects stand ready before the clock starts.
        let questions: Rc<[_]> = cases
            .iter()
            .filter_map(|&case| {
                let (ray, object, affine) = question(case);
                Some((ray, Deformed::for_ray(&ray, object, affine).ok()?))
            })
            .collect();
        let runner_of = |method: Method| -> Runner<'a> {
            match method {
                Method::Notes => {
                    runner(&questions, |(ray, deformed)| notes(ray, deformed).hit(Span::ahead()))
                }
                Method::Solved => {
                    runner(&questions, |(ray, deformed)| solved(ray, deformed).hit(Span::ahead()))
                }
                Method::Robust => {
                    runner(&questions, |(ray, deformed)| robust(ray, deformed).hit(Span::ahead()))
                }
            }
        };
        Method::ALL.map(runner_of).into()
    }
}

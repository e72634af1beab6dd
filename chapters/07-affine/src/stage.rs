//! How this chapter shows and evaluates itself.

use math::{Ray3, Real, Span};
use stage::{
    About, Ask, Canvas, Case, Chapter, Color, Error, Row, Shown, TradeAsk, Traded, Transcript, Value,
};

use crate::measure::question;
use crate::regimes::regimes;
use crate::{Deformed, Method, Object};

/// The stage `affine`.
pub struct Affine;

impl Chapter for Affine {
    fn about(&self) -> About {
        About {
            number: 7,
            name: "affine",
            teaches: "a ray against a stretched, turned and moved object: the inverse applied to the ray",
            notes: "CSC418 11.3.4, 11.6.1",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: (720, 480),
            picture: "The unit sphere, cylinder, cone, plane and triangle, each deformed by an affine map.",
            inputs: &[
                "ox", "oy", "oz", "dx", "dy", "dz", "shape", "a11", "a12", "a13", "a21", "a22", "a23", "a31",
                "a32", "a33", "tx", "ty", "tz",
            ],
            words: &[("shape", &["sphere", "cylinder", "cone", "plane", "triangle"])],
            results: &["hit", "t", "x", "y", "z", "nx", "ny", "nz", "reason"],
            trade: "The inverse stored, the system solved for every ray, and no division at all, by the condition of \
                    the matrix: nanoseconds a ray, wrong verdicts, and how far t, the point and the normal are off.",
            regimes: regimes().iter().map(|regime| (regime.name, regime.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let method = Method::ALL[ask.method];
        let mut transcript = Transcript::new(&self.about(), ask);
        let (zero, one, two) = (R::from(0.0), R::from(1.0), R::from(2.0));
        let ray = Ray3::<R>::new(R::vec3(zero, zero, -two - two), R::vec3(zero, zero, one));
        let affine = crate::Affine {
            a: crate::Matrix3::from_rows([[two, zero, zero], [zero, one, zero], [zero, zero, one]]),
            t: R::vec3(one, zero, zero),
        };
        let found = Deformed::new(Object::Sphere, affine)
            .and_then(|deformed| method.work(&ray, &deformed).found(Span::ahead()));
        let section =
            transcript.section(format!("affine · {} · {}", method.name(), R::NAME), "CSC418 11.3.4");
        match found {
            Ok(Some(found)) => {
                section.number("λ*", "of the object's own method", found.lambda);
                section.vector::<R>("r(λ*)", "a + λ* d", found.point);
                section.vector::<R>("n", "A⁻ᵀ n / ‖A⁻ᵀ n‖", found.normal());
            }
            _ => {
                section.step("λ*", "of the object's own method", Value::text("none"));
            }
        }
        Ok(Shown { transcript, picture: Canvas::new(ask.size, Color::WHITE)? })
    }

    fn eval<R: Real>(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        let (ray, object, affine) = question(case.numbers::<R, 19>()?);
        let deformed = match Deformed::for_ray(&ray, object, affine) {
            Ok(deformed) => deformed,
            Err(degenerate) => return Ok(Row::invalid(degenerate.reason())),
        };
        let work = Method::ALL[ask.method].work(&ray, &deformed);
        Ok(match work.hit(Span::ahead()) {
            Ok(Some(hit)) => Row::hit()
                .number("t", hit.t)
                .vector(["x", "y", "z"], hit.point)
                .vector(["nx", "ny", "nz"], hit.normal),
            Ok(None) => Row::miss(work.parallel().map_or("", |how| how.reason())),
            Err(degenerate) => Row::invalid(degenerate.reason()),
        })
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        Ok(lab::measure(self, ask)?.traded("Ray against a deformed object: speed for accuracy"))
    }
}

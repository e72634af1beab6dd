//! How this chapter shows and evaluates itself.

use math::{Real, Span};
use stage::{About, Ask, Case, Chapter, Error, Row, Shown, TradeAsk, Traded, Transcript};

use crate::measure::question;
use crate::picture::Layout;
use crate::regimes::regimes;
use crate::{Deformed, Method, explain, picture, scene};

/// The stage `affine`.
pub struct Affine;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &Affine;

impl Chapter for Affine {
    fn about(&self) -> About {
        About {
            number: 7,
            name: "affine",
            teaches: "a ray against a stretched, turned and moved object: the inverse applied to the ray",
            notes: "CSC418 11.3.4, 11.6.1",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: (720, 480),
            picture: "The unit sphere, cylinder, cone, plane and triangle, each deformed; the squashed sphere cut open, \
                      with A⁻ᵀ n and A n drawn, and shaded by the one and by the other.",
            flags: &[],
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
        let size = ask.size_or(self.about().size)?;
        let method = Method::ALL[ask.method];
        let camera = scene::camera::<R>(Layout::of(size).window(size))?;
        let objects = scene::five::<R>()?;
        let ray = match ask.pixel {
            Some(pixel) => scene::pixel_ray(&camera, size, pixel),
            None => scene::worked(&camera),
        };
        // What the ray meets first, else the squashed sphere, is explained.
        let subject = scene::first(method, &ray, &objects).map_or(&objects[0], |(placed, _)| placed);

        let mut transcript = Transcript::new(&self.about(), ask);
        explain::explain(&mut transcript, method, &ray, subject);
        explain::one_ray(&mut transcript, method, &ray, &objects);
        explain::five_rays(&mut transcript, method, camera.e, &objects);
        explain::condition::<R>(&mut transcript);

        let picture = picture::draw(method, size, &camera, &objects, &ray)?;
        Ok(Shown { transcript, picture, ids: None })
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

//! How this chapter shows and evaluates itself.

use math::{Real, Span};
use stage::{About, Ask, Case, Chapter, Error, Row, Shown, TradeAsk, Traded, Transcript};

use crate::measure::question;
use crate::picture::Explained;
use crate::regimes::regimes;
use crate::{Method, Shape, explain, picture};

/// The stage `quadric`.
pub struct Quadric;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &Quadric;

impl Chapter for Quadric {
    fn about(&self) -> About {
        About {
            number: 6,
            name: "quadric",
            teaches: "a ray against a cylinder and a cone: a quadratic wall, cut off by planes",
            notes: "CSC418 11.3.5, 11.6",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: (720, 540),
            picture: "The capped cylinder and the cone, one ray a pixel, shaded by their normals; the cone as the page prints it, \
                      which is half an ellipsoid, beside the true one. Below each the upright plane of the explained ray, with its \
                      candidates kept and dropped.",
            flags: &[],
            inputs: &["ox", "oy", "oz", "dx", "dy", "dz", "shape"],
            words: &[("shape", &["cylinder", "cone"])],
            results: &["hit", "t", "x", "y", "z", "nx", "ny", "nz", "reason"],
            trade: "The page's candidates, each tested, against signs first and one root: nanoseconds a ray, wrong \
                    verdicts, and how far t, the point and the normal are off, in regimes from ordinary numbers to rims, \
                    slopes, the apex and the ends of numbers. Draws the two against each other (trade.svg).",
            regimes: regimes().iter().map(|regime| (regime.name, regime.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let size = ask.size_or(self.about().size)?;
        let method = Method::ALL[ask.method];
        let explained = Explained::<R>::new(size, ask.pixel)?;
        let mut transcript = Transcript::new(&self.about(), ask);
        // Both worked examples, or the one ray that was asked for.
        for shape in Shape::ALL {
            if explained.asked.is_none_or(|asked| asked == shape) {
                explain::explain(&mut transcript, method, explained.of(shape), shape);
            }
        }
        explain::tries::<R>(&mut transcript, ask.precision);
        explain::along_the_slope::<R>(&mut transcript);
        explain::as_printed(&mut transcript, explained.of(Shape::Cone));
        Ok(Shown { transcript, picture: picture::draw(method, size, &explained)?, ids: None })
    }

    fn eval<R: Real>(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        let (ray, shape) = question(case.numbers::<R, 7>()?);
        Ok(match Method::ALL[ask.method].work(&ray, shape).hit(Span::ahead()) {
            Ok(Some(hit)) => Row::hit()
                .number("t", hit.t)
                .vector(["x", "y", "z"], hit.point)
                .vector(["nx", "ny", "nz"], hit.normal),
            Ok(None) => Row::miss(""),
            Err(degenerate) => Row::invalid(degenerate.reason()),
        })
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        Ok(lab::measure(self, ask)?.traded("Ray against cylinder and cone: speed for accuracy"))
    }
}

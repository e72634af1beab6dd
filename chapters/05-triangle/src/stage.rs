//! How this chapter shows and evaluates itself.

use math::{Real, Span};
use stage::{About, Ask, Case, Chapter, Error, Row, Shown, TradeAsk, Traded, Transcript};

use crate::measure::question;
use crate::regimes::regimes;
use crate::{Method, explain, leaks, picture};

/// The stage `triangle`.
pub struct RayTriangle;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &RayTriangle;

impl Chapter for RayTriangle {
    fn about(&self) -> About {
        About {
            number: 5,
            name: "triangle",
            teaches: "a ray against a triangle: half-planes, a system of three equations, and no leaks; polygons and meshes",
            notes: "CSC418 11.3.1, 11.3.2, 11.6",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: (720, 540),
            picture: "A triangle in its barycentric colors; a concave star with test rays, and a pentagram by even-odd and \
                      by winding; and a closed ball shot from inside at its edges: where a ray slips through, there is \
                      a large orange dot.",
            flags: &[],
            inputs: &[
                "ox", "oy", "oz", "dx", "dy", "dz", "ax", "ay", "az", "bx", "by", "bz", "cx", "cy", "cz",
            ],
            words: &[],
            results: &["hit", "t", "alpha", "beta", "x", "y", "z", "nx", "ny", "nz", "reason"],
            trade: "The page's two ways against the one whose verdict is exact, in regimes from ordinary numbers to \
                    their ends: nanoseconds a ray, wrong verdicts, and how far t, the point and the normal are off. \
                    Draws the two against each other, a panel a regime (trade.svg), and counts the rays that leak out \
                    of a closed ball (…-leaks.png).",
            regimes: regimes().iter().map(|regime| (regime.name, regime.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let size = ask.size_or(self.about().size)?;
        let method = Method::ALL[ask.method];
        let ray = picture::ray_of::<R>(size, ask.pixel)?;
        let mut transcript = Transcript::new(&self.about(), ask);
        explain::explain(&mut transcript, method, &ray);
        Ok(Shown { transcript, picture: picture::draw::<R>(method, size, ask.pixel)?, ids: None })
    }

    fn eval<R: Real>(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        let (ray, triangle) = question(case.numbers::<R, 15>()?);
        let work = Method::ALL[ask.method].work(&ray, &triangle);
        Ok(match work.hit(Span::ahead()) {
            Ok(Some(hit)) => {
                let row = Row::hit()
                    .number("t", hit.t)
                    .vector(["x", "y", "z"], hit.point)
                    .vector(["nx", "ny", "nz"], hit.normal);
                match work.alpha_beta() {
                    // minus zero is zero
                    Some((alpha, beta)) => {
                        row.number("alpha", alpha + R::from(0.0)).number("beta", beta + R::from(0.0))
                    }
                    None => row,
                }
            }
            Ok(None) => Row::miss(work.parallel().map_or("", |how| how.reason())),
            Err(degenerate) => Row::invalid(degenerate.reason()),
        })
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        let mut traded = lab::measure(self, ask)?.traded("Ray against triangle: speed for accuracy");
        // Where a part is asked for, this would be drawn over that of the whole.
        if ask.is_for_all() {
            let volleys = leaks::volleys(ask);
            traded.text += &format!("\n{}", leaks::text(&volleys));
            traded.drawings.push(leaks::draw::draw(&volleys)?);
        }
        Ok(traded)
    }
}

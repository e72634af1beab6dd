//! How this chapter shows and measures itself.

use math::Real;
use signature::from_file;
use signature::stage::fault;
use stage::{About, Ask, Chapter, Error, Flag, Shown, TradeAsk, Traded, Transcript};

use crate::measure::{REGIMES, measure};
use crate::picture::Cost;
use crate::{Bounded, Method, explain, picture, report};

/// The stage `bounds`.
pub struct BoundsStage;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &BoundsStage;

/// The chapter's own scene, one of chapter 08's: Haines's balls, 91 spheres on a square.
const OWN: &str = "balls2";
/// The size of its picture.
const SIZE: (u32, u32) = (512, 512);
/// The pixel that is explained when none is asked for: its ray passes near many balls before it hits one.
const WORKED: (u32, u32) = (285, 190);

impl Chapter for BoundsStage {
    fn about(&self) -> About {
        About {
            number: 9,
            name: "bounds",
            teaches: "not testing what cannot be hit: spheres, boxes, extents, trees of boxes",
            notes: "CSC418 11.5",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: SIZE,
            picture: "How many tests each pixel cost, from dark (none) to bright, bounds and objects together, and for which \
                      number a color stands; the pixel that is explained is ringed. --ids writes the ids of what is seen, \
                      which are the same by every method.",
            flags: &[Flag::Scene, Flag::Ids],
            inputs: &[],
            words: &[],
            results: &[],
            trade: "Time and tests a ray against the number of objects, from 1 to a million spheres (the regimes), and in \
                    Haines's balls and the teapot; from which number on a bound pays is said and drawn (trade.svg), and \
                    the tests too (tests.svg). All see the same, which is counted.",
            regimes: REGIMES.iter().map(|regime| (regime.name, regime.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let method = Method::ALL[ask.method];
        let file = match &ask.scene {
            Some(path) => signature::stage::read(Some(path))?,
            None => signature::stage::built_in(OWN)?,
        };
        let size = ask.size_or(file.camera.size.value)?;
        let scene = from_file::scene::<R>(&file, Some(size)).map_err(fault)?;
        let own_size = ask.scene.is_none() && size == SIZE;
        let pixel = ask.pixel.unwrap_or(if own_size { WORKED } else { (size.0 / 2, size.1 / 2) });

        let bounded = Bounded::new(&scene, method);
        let cost = Cost::of(&bounded, size)?;
        let mut transcript = Transcript::new(&self.about(), ask);
        explain::explain(&mut transcript, method, &scene, &bounded, pixel);
        explain::every_method(&mut transcript, &scene, pixel);
        explain::picture(&mut transcript, &cost);
        Ok(Shown { transcript, picture: picture::draw(&cost, pixel)?, ids: Some(cost.ids(&scene)) })
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        Ok(report::traded(&measure(ask)?, ask))
    }
}

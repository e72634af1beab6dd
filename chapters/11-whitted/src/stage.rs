//! How this chapter shows and measures itself.

use std::path::Path;

use bounds::Parts;
use math::Real;
use signature::Method;
use signature::stage::fault;
use stage::{About, Ask, Chapter, Chosen, Error, Flag, Inspector, Shown, TradeAsk, Traded, Transcript};

use crate::measure::measure;
use crate::scenes::SCENES;
use crate::show::{self, Shot};
use crate::{Requirements, Tolerance, Tracer, auto, explain, from_file, inspect, picture, render, report};

/// The stage `whitted`.
pub struct Whitted;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &Whitted;

/// The size of the chapter's own picture.
const SIZE: (u32, u32) = (960, 720);
/// The pixel of it that is explained when none is asked for: through the thin ball it sees the mirror.
const WORKED: (u32, u32) = (470, 230);

impl Chapter for Whitted {
    fn about(&self) -> About {
        About {
            number: 11,
            name: "whitted",
            teaches: "the recursive ray tracer: mirrors, refraction, and only what the scene requires",
            notes: "CSC418 11.7",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: SIZE,
            picture: "The scene. Below the chapter's own scene two drawings, where there is room: the rays of the pixel that is \
                      explained, from above; and light that leaves a slower medium, at the critical angle and on both sides of it.",
            flags: &[
                Flag::Scene,
                Flag::Inspect,
                Flag::Srgb,
                Flag::Samples,
                Flag::Threads,
                Flag::Depth,
                Flag::Tolerance,
                Flag::Explain,
                Flag::Auto,
            ],
            inputs: &[],
            words: &[],
            results: &[],
            trade: "Time against error over precision, formulas, depth, tolerance and samples, in the chapter's scenes (the \
                    regimes): the root mean square and the largest difference, in linear radiance, to a picture with many \
                    samples at the scene's full depth. Draws the best that a time can buy (trade.svg).",
            regimes: SCENES.iter().map(|scene| (scene.name, scene.what)).collect(),
        }
    }

    fn precision(&self, ask: &Ask) -> Result<Chosen, Error> {
        Ok(auto::found(&read(ask.scene.as_deref())?, ask)?.chosen())
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let method = Method::ALL[ask.method];
        let file = read(ask.scene.as_deref())?;
        let size = ask.size_or(file.camera.size.value)?;
        let own = ask.scene.is_none();
        let pixel = ask.pixel.unwrap_or_else(|| worked(own, size));

        let scene = from_file::scene::<R>(&file, Some(size), ask.depth).map_err(fault)?;
        let requirements = Requirements::of(&scene, Parts::of(&scene.lit.geometry).count());
        let bounded = requirements.bounded(method, &scene.lit.geometry);
        let tolerance = ask.tolerance.map(|e| Tolerance::new(&scene, e));
        let tracer = Tracer::new(&scene, &bounded, &requirements, tolerance);
        let samples = ask.samples.unwrap_or(1);
        let tree = render::tree(&tracer, pixel, samples)?;
        let rendered = render::render(&tracer, size, samples, ask.threads, Some("whitted"))?;

        let mut transcript = Transcript::new(&self.about(), ask);
        let (names, parts) = (&show::Names::new(&file, &scene), bounded.all_parts());
        let shot = Shot { scene: &scene, parts, names, pixel, samples, srgb: ask.srgb, tree: &tree };
        show::pixel(&mut transcript, method, &shot, rendered.at(pixel));
        show::rays(&mut transcript, &shot);
        show::critical_angles(&mut transcript, &shot, own);
        show::counts(&mut transcript, &rendered, ask.tolerance);
        transcript.sections.extend(ask.why.clone());
        if ask.explain {
            explain::requirements(&mut transcript, &file, &scene, &requirements, ask.why.as_ref());
            explain::cost::<R>(&mut transcript, &file, size, method, ask.depth)?;
        }
        let (picture, is_drawn_on) = picture::draw(&rendered, &shot, own)?;
        if own && !is_drawn_on {
            picture::say_that_it_is_left_out(&mut transcript);
        }
        Ok(Shown { transcript, picture, ids: None })
    }

    fn inspect<R: Real>(&self, ask: &Ask, write: Inspector<'_>) -> Result<(), Error> {
        inspect::inspect::<R>(ask, write)
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        Ok(report::traded(&measure(ask)?, ask))
    }
}

/// The pixel that is explained when none is asked for: of the chapter's own scene the worked one, or where
/// that is in a picture of another size; else the middle.
pub(crate) fn worked(own: bool, size: (u32, u32)) -> (u32, u32) {
    let scaled = |at: u32, of: u32, to: u32| (u64::from(at) * u64::from(to) / u64::from(of)) as u32;
    match own {
        true => (scaled(WORKED.0, SIZE.0, size.0), scaled(WORKED.1, SIZE.1, size.1)),
        false => (size.0 / 2, size.1 / 2),
    }
}

/// Reads a scene file, or the chapter's own scene.
///
/// [`Error::Request`] with file, line and column where it is no scene, [`Error::Failed`] where it cannot be
/// read.
pub fn read(path: Option<&Path>) -> Result<scene_file::Scene, Error> {
    match path {
        Some(path) => scene_file::Scene::read(path).map_err(fault),
        None => SCENES[0].file(),
    }
}

#[cfg(test)]
mod tests;

//! How this chapter shows and measures itself.

use std::path::Path;

use math::Real;
use stage::{About, Ask, Chapter, Error, Flag, Inspector, Shown, TradeAsk, Traded, Transcript};

use crate::measure::{SCENES, measure};
use crate::picture::Seen;
use crate::{Method, explain, from_file, inspect, picture, report};

/// The stage `signature`.
pub struct Signature;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &Signature;

/// The pixel of the chapter's own scene that is explained when none is asked for: the cone stands before the triangle
/// there, and the ground behind it.
const WORKED: (u32, u32) = (283, 180);

impl Chapter for Signature {
    fn about(&self) -> About {
        About {
            number: 8,
            name: "signature",
            teaches: "the scene signature: which object each pixel sees first",
            notes: "CSC418 11.4; Gambetta TraceRay, Listing 2-4",
            methods: Method::ALL.map(Method::name).to_vec(),
            size: (480, 360),
            picture: "Each object in a color of its own, with its id where there is room for it; the pixel that is \
                      explained is ringed. --ids writes the ids themselves.",
            flags: &[Flag::Scene, Flag::Ids, Flag::Inspect],
            inputs: &[],
            words: &[],
            results: &[],
            trade: "The pixels in which f32, or the formulas of the notes, see another object than the robust ones at f64, \
                    in scenes from a few shapes to a mesh (the regimes), beside the time of a pixel. Draws the two \
                    against each other, a panel a scene (trade.svg).",
            regimes: SCENES.iter().map(|scene| (scene.name, scene.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let method = Method::ALL[ask.method];
        let file = read(ask.scene.as_deref())?;
        let size = ask.size_or(file.camera.size.value)?;
        let scene = from_file::scene::<R>(&file, Some(size)).map_err(fault)?;
        let pixel = ask.pixel.unwrap_or_else(|| worked(ask, size));

        let seen = Seen::of(&scene, method)?;
        let mut transcript = Transcript::new(&self.about(), ask);
        explain::explain(&mut transcript, method, &scene, pixel);
        explain::trace_ray(&mut transcript, method, &scene, pixel);
        explain::who_else_sees_what(&mut transcript, &file, size, pixel)?;
        explain::signature(&mut transcript, &scene, &seen);

        let picture = picture::draw(&seen, &scene, pixel)?;
        Ok(Shown { transcript, picture, ids: Some(seen.ids(&scene)) })
    }

    fn inspect<R: Real>(&self, ask: &Ask, write: Inspector<'_>) -> Result<(), Error> {
        inspect::inspect::<R>(ask, write)
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        Ok(report::traded(&measure(ask)?, ask.seed))
    }
}

/// The pixel that is explained when none is asked for: of the chapter's own scene the worked one, else the middle.
pub(crate) fn worked(ask: &Ask, size: (u32, u32)) -> (u32, u32) {
    let own = (480, 360);
    if ask.scene.is_none() && size == own { WORKED } else { (size.0 / 2, size.1 / 2) }
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

/// One of the chapter's own scenes, by the name that `--regime` takes.
///
/// [`Error::Request`] where there is none of that name.
pub fn built_in(name: &str) -> Result<scene_file::Scene, Error> {
    match SCENES.iter().find(|scene| scene.name == name) {
        Some(scene) => scene.file(),
        None => Err(Error::Request(format!("there is no scene `{name}` in chapter 08"))),
    }
}

/// What is wrong with a scene file, as a stage says it: [`Error::Request`] where the file is to be mended,
/// [`Error::Failed`] where it could not be read.
pub fn fault(error: scene_file::Error) -> Error {
    match error.status() {
        2 => Error::Request(error.to_string()),
        _ => Error::Failed(error.to_string()),
    }
}

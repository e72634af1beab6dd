//! How this chapter shows and measures itself.

use math::Real;
use signature::stage::read;
use stage::{About, Ask, Chapter, Error, Flag, Shown, TradeAsk, Traded, Transcript};

use crate::layout::{self, Part, SIZE, Term, What};
use crate::measure::measure;
use crate::measure::regimes::REGIMES;
use crate::{Start, explain, own, picture, report};

/// The stage `shading`.
pub struct Shading;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &Shading;

/// The pixel that is explained when none is asked for: on the ball, in both lights, and in acne where nothing
/// is done about it.
const WORKED: (u32, u32) = (110, 180);

impl Chapter for Shading {
    fn about(&self) -> About {
        About {
            number: 10,
            name: "shading",
            teaches: "the light at a point: normals, Phong's terms, textures, shadows, and where a second ray starts",
            notes: "CSC418 11.6, 11.7 local model, 11.7.2, 11.7.4",
            methods: Start::ALL.map(Start::name).to_vec(),
            size: SIZE,
            picture: "The terms of a scene one by one, its shadows, and all of it; below, a small scene at f32, a row a scale \
                      and a column a method: acne where a surface shades itself, and shadows that are gone where the ray \
                      starts too far away. Any pixel of it may be explained. With --scene the scene alone.",
            flags: &[Flag::SceneOfShow, Flag::Srgb, Flag::Samples, Flag::Threads],
            inputs: &[],
            words: &[],
            results: &[],
            trade: "Second rays that meet the surface that they leave (acne), and second rays that miss what is close above it \
                    (light leaks), for every method and precision, on shapes that stand alone at many scales and places \
                    (the regimes), beside the time of such a ray. Draws the two against each other, a panel a regime \
                    (trade.svg).",
            regimes: REGIMES.iter().map(|regime| (regime.name, regime.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let file = match &ask.scene {
            Some(path) => read(Some(path))?,
            None => own::file()?,
        };
        let size = ask.size_or(if ask.scene.is_some() { file.camera.size.value } else { SIZE })?;
        let parts = match ask.scene {
            Some(_) => vec![Part { what: What::Term(Term::All), at: (0, 0), size }],
            None => layout::parts(size),
        };
        let worked = if ask.scene.is_none() && size == SIZE { WORKED } else { (size.0 / 2, size.1 / 2) };
        let pixel = ask.pixel.unwrap_or(worked);
        let drawn = picture::all::<R>(ask, &file, &parts)?;

        let mut transcript = Transcript::new(&self.about(), ask);
        // there is always a part, and of the parts the nearest is shown
        let (part, own) = layout::shown(&parts, pixel).unwrap_or((parts[0], (0, 0)));
        explain::explain::<R>(&mut transcript, ask, &file, (part, own), pixel)?;
        if let Some((_, rendered)) = drawn.iter().find(|(it, _)| it.what == part.what) {
            explain::picture(&mut transcript, rendered);
        }
        let mut picture = picture::draw(size, &drawn)?;
        if drawn.len() > 1 {
            picture::ring(&mut picture, (part.at.0 + own.0, part.at.1 + own.1));
        }
        Ok(Shown { transcript, picture, ids: None })
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        Ok(report::traded(&measure(ask)?, ask.seed))
    }
}

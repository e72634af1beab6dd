//! `--precision auto`: f32 where nothing visible is lost, found out on some of the scene's own rays.
//!
//! Pixels drawn from all of the picture are traced in both precisions with all their second rays, and the edges beside them
//! are found to the last digits of f32 (see [`sample`]): how far off f32 puts them tells how many pixels of the picture will
//! be on the wrong side. A picture that is small is traced as a whole. f32 is taken where no traced pixel has a channel that
//! is off by more than one level of 255, and of the whole picture no pixel is expected to. By one level two radiances can
//! differ that are the same but for the last digits, where one is rounded up and the other down.
//!
//! What no sampled pixel sees is not known, and what is said is no more than what was measured.

mod rays;
mod sample;

use bounds::Parts;
use math::Real;
use signature::Method;
use signature::stage::fault;
use stage::{Ask, Color, Error, Precision, Transcript, Value, Workers, tiled};

use crate::show::whole;
use crate::{Path, Requirements, Tolerance, Tracer, from_file, render};
use rays::Rays;
use sample::{Edge, Place, Seen, SeenIn};

/// Fewer pixels than this are none, as numbers are rounded.
const NONE: f64 = 0.5;

/// What f32 would get wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Found {
    /// f32 holds the numbers of the scene; if not, nothing was traced.
    pub(crate) fits: bool,
    /// The pixels that were drawn are all of the picture.
    pub(crate) is_whole: bool,
    /// Of the pixels that were drawn.
    pub(crate) drawn: Differences,
    /// How many of them have an edge beside them.
    pub(crate) edges: u64,
    /// How many pixels of the picture are visibly others because f32 puts an edge elsewhere, as far as these edges tell.
    pub(crate) expected: f64,
}

/// What differs between the precisions, in some pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Differences {
    /// How many were traced in both.
    pub(crate) pixels: u64,
    /// Pixels with another color.
    pub(crate) colors: u64,
    /// Pixels of which a channel is off by more than one level of 255.
    pub(crate) visible: u64,
    /// Pixels whose eye ray sees another object.
    pub(crate) objects: u64,
    /// Pixels of whose rays any sees another object, another light or another color.
    pub(crate) paths: u64,
    /// The largest difference in a channel: linear, before clamping.
    pub(crate) largest: f64,
}

impl Found {
    /// What to take.
    pub(crate) fn precision(&self) -> Precision {
        let is_visible = !self.fits || self.drawn.visible > 0 || self.expected >= NONE;
        if is_visible { Precision::F64 } else { Precision::F32 }
    }

    /// What was found, in a sentence that claims no more.
    fn said(&self) -> String {
        let Differences { pixels, visible, .. } = self.drawn;
        match (self.precision(), visible) {
            (Precision::F32, _) if self.is_whole => {
                format!("f32: all {pixels} pixels were traced, and none is visibly another")
            }
            (Precision::F32, _) => format!(
                "f32: none of {pixels} pixels is visibly another: with 95 % certainty fewer than 3 in {pixels} are"
            ),
            (Precision::F64, 0) => {
                "f64: edges are so far off that some pixel will visibly be another".to_string()
            }
            (Precision::F64, visible) => {
                format!("f64: in f32 {visible} of {pixels} pixels are visibly others")
            }
        }
    }
}

impl Differences {
    /// Between the same pixels in two precisions.
    fn between(narrow: &[Seen], wide: &[Seen], srgb: bool) -> Differences {
        let mut found = Differences::default();
        for (narrow, wide) in narrow.iter().zip(wide) {
            let levels = levels(narrow, wide, srgb);
            found.pixels += 1;
            found.colors += u64::from(levels > 0);
            found.visible += u64::from(levels > 1);
            found.objects += u64::from(narrow.rays.eye != wide.rays.eye);
            found.paths += u64::from(narrow.rays.all != wide.rays.all);
            let off = |(a, b): (f64, f64)| if a == b { 0.0 } else { (a - b).abs() };
            let largest = narrow.e.0.into_iter().zip(wide.e.0).map(off).fold(0.0, f64::max);
            found.largest = found.largest.max(largest);
        }
        found
    }
}

/// By how many levels of 255 a channel is off at most.
fn levels(a: &Seen, b: &Seen, srgb: bool) -> u8 {
    let color = |seen: &Seen| match srgb {
        true => Color::from_linear_srgb(seen.e.0),
        false => Color::from_linear(seen.e.0),
    };
    let (Color(a), Color(b)) = (color(a), color(b));
    a.into_iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// Traces the sample in both precisions.
///
/// [`Error::Request`] where the scene is none in f64, or the pixel that is asked for lies outside of it.
pub(crate) fn found(file: &scene_file::Scene, ask: &Ask) -> Result<Found, Error> {
    let size = ask.size_or(file.camera.size.value)?;
    let (drawn, edges, wide) = traced::<f64, _>(file, ask, size, |seen| {
        let (drawn, edges) = sample::sample(size, seen)?;
        let found = sample::halved(&edges, seen)?;
        Ok((drawn, edges, found))
    })?;
    if from_file::scene::<f32>(file, Some(size), ask.depth).is_err() {
        return Ok(Found::default());
    }
    traced::<f32, _>(file, ask, size, |seen| {
        let narrow = sample::halved(&edges, seen)?;
        let is_visible = |edge: &Edge| levels(&edge.sides[0], &edge.sides[1], ask.srgb) > 1;
        let visible = narrow.iter().zip(&wide).filter(|(_, wide)| is_visible(wide));
        let off: f64 = visible.map(|(narrow, wide)| (narrow.at - wide.at).abs()).sum();
        let all = f64::from(size.0) * f64::from(size.1);
        Ok(Found {
            fits: true,
            is_whole: sample::is_small(size),
            drawn: Differences::between(&seen(&drawn.places)?, &drawn.seen, ask.srgb),
            edges: edges.len() as u64,
            expected: off / drawn.places.len() as f64 * all,
        })
    })
}

/// Lets `work` trace places in R.
fn traced<R: Real, T>(
    file: &scene_file::Scene,
    ask: &Ask,
    size: (u32, u32),
    work: impl FnOnce(&SeenIn) -> Result<T, Error>,
) -> Result<T, Error> {
    let scene = from_file::scene::<R>(file, Some(size), ask.depth).map_err(fault)?;
    let requirements = Requirements::of(&scene, Parts::of(&scene.lit.geometry).count());
    let bounded = requirements.bounded(Method::ALL[ask.method], &scene.lit.geometry);
    let tolerance = ask.tolerance.map(|e| Tolerance::new(&scene, e));
    let tracer = Tracer::new(&scene, &bounded, &requirements, tolerance);
    work(&|places| seen(&tracer, ask.threads, places))
}

/// What places see, as a picture of one row.
fn seen<R: Real>(
    tracer: &Tracer<'_, R>,
    threads: Option<usize>,
    places: &[Place],
) -> Result<Vec<Seen>, Error> {
    if places.is_empty() {
        return Ok(Vec::new());
    }
    let workers = Workers { threads, stack: render::stack(tracer), progress: None };
    let one = |(pixel, right): Place| {
        let mut rays = Rays::default();
        let ray = tracer.ray(pixel, (R::round_from(right), R::from(0.5)));
        Seen { e: tracer.eye_ray(&ray, &mut Path::default(), &mut rays), rays }
    };
    tiled(
        (places.len() as u32, 1),
        &workers,
        |tile, values| {
            for (col, value) in tile.cols.clone().zip(values) {
                *value = one(places[col as usize]);
            }
        },
        |()| {},
    )
}

/// Says what was found.
pub(crate) fn say(transcript: &mut Transcript, found: &Found) {
    let section = transcript.section("What f32 would get wrong", "--precision auto");
    let taken = Value::text(found.precision().name());
    if !found.fits {
        section.step("precision", "that is taken", taken);
        section.note("the scene has numbers that f32 cannot hold");
        return;
    }
    let Differences { pixels, colors, visible, objects, paths, largest } = found.drawn;
    let drawn =
        if found.is_whole { "all pixels of the picture" } else { "pixels drawn from all of the picture" };
    section
        .step("sample", &format!("{drawn}, a ray through the middle of each"), whole(pixels))
        .step("visible", "of which a channel is off by more than one level of 255", whole(visible))
        .step("colors", "with another byte at all", whole(colors))
        .step("objects", "whose eye ray sees another object", whole(objects))
        .step("paths", "of whose rays one sees another object, light or color", whole(paths))
        .number("largest", "difference in a channel, linear", largest);
    if !found.is_whole {
        let expected = Value::number((found.expected * 1e3).round() / 1e3);
        section
            .step("edges", "pixels of the sample with an edge right of their middle", whole(found.edges))
            .step("expected", "pixels of the picture visibly off by where f32 puts edges, about", expected);
    }
    section.step("precision", "that is taken", taken).note(found.said());
    if !found.is_whole {
        section.remark("What no ray of the sample sees is not known.");
    }
}

#[cfg(test)]
mod tests;

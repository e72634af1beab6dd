//! `--precision auto`: f32 where nothing visible is lost, found out on some of the scene's own rays.
//!
//! Of the picture a pixel is drawn from each of 32 × 32 fields, always the same ones, and traced in both precisions with
//! all its second rays. f32 is taken where not one of these pixels would have another color and not one eye ray
//! sees another object. What no sampled pixel sees is not known; a thousand pixels without a difference say that fewer than
//! three in a thousand have one, at 95 %.

use bounds::{Parts, Tally};
use lab::Draw;
use math::Real;
use shading::Rgb;
use shading::lighting::Point;
use signature::Method;
use signature::stage::fault;
use stage::{Ask, Color, Error, Precision, Transcript, Value, Workers, tiled};

use crate::show::whole;
use crate::{Path, Requirements, Sent, Tolerance, Tracer, Witness, from_file, render};

/// Fields of the picture across and down.
const FIELDS: u32 = 32;
/// Any number: which pixels are drawn follows from it.
const SEED: u64 = 11;

/// What f32 would get wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Found {
    /// How many pixels were traced in both precisions.
    pub(crate) pixels: u64,
    /// f32 holds the numbers of the scene; if not, nothing was traced.
    pub(crate) fits: bool,
    /// Pixels with another color.
    pub(crate) colors: u64,
    /// Pixels whose eye ray sees another object.
    pub(crate) objects: u64,
    /// Pixels of whose rays any sees another object.
    pub(crate) paths: u64,
    /// The largest difference in a channel: linear, before clamping.
    pub(crate) largest: f64,
}

impl Found {
    /// What to take.
    pub(crate) fn precision(&self) -> Precision {
        let is_visible = !self.fits || self.colors > 0 || self.objects > 0;
        if is_visible { Precision::F64 } else { Precision::F32 }
    }
}

/// Traces the sample in both precisions.
///
/// [`Error::Request`] where the scene is none in f64, or the pixel that is asked for lies outside of it.
pub(crate) fn found(file: &scene_file::Scene, ask: &Ask) -> Result<Found, Error> {
    let size = ask.size_or(file.camera.size.value)?;
    let wide = seen::<f64>(file, ask, size)?;
    if from_file::scene::<f32>(file, Some(size), ask.depth).is_err() {
        return Ok(Found::default());
    }
    let narrow = seen::<f32>(file, ask, size)?;
    let mut found = Found { fits: true, ..Found::default() };
    let color = |e: Rgb| if ask.srgb { Color::from_linear_srgb(e.0) } else { Color::from_linear(e.0) };
    for (narrow, wide) in narrow.iter().zip(&wide) {
        found.pixels += 1;
        found.colors += u64::from(color(narrow.e) != color(wide.e));
        found.objects += u64::from(narrow.rays.first != wide.rays.first);
        found.paths += u64::from(narrow.rays.all != wide.rays.all);
        let off = |(a, b): (f64, f64)| if a == b { 0.0 } else { (a - b).abs() };
        let largest = narrow.e.0.into_iter().zip(wide.e.0).map(off).fold(0.0, f64::max);
        found.largest = found.largest.max(largest);
    }
    Ok(found)
}

/// A pixel of the sample.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    e: Rgb,
    rays: Rays,
}

/// The sample in one precision.
fn seen<R: Real>(file: &scene_file::Scene, ask: &Ask, size: (u32, u32)) -> Result<Vec<Seen>, Error> {
    let scene = from_file::scene::<R>(file, Some(size), ask.depth).map_err(fault)?;
    let requirements = Requirements::of(&scene, Parts::of(&scene.lit.geometry).count());
    let bounded = requirements.bounded(Method::ALL[ask.method], &scene.lit.geometry);
    let tolerance = ask.tolerance.map(|e| Tolerance::new(&scene, e));
    let tracer = Tracer::new(&scene, &bounded, &requirements, tolerance);
    let pixels = sample(size);
    let workers = Workers { threads: ask.threads, stack: render::stack(&tracer), progress: None };
    let one = |pixel: (u32, u32)| {
        let mut rays = Rays::default();
        let e = tracer.pixel(pixel, 1, &mut Path::default(), &mut rays);
        Seen { e, rays }
    };
    // as a picture of one row
    let size = (pixels.len() as u32, 1);
    tiled(
        size,
        &workers,
        |tile, values| {
            for (col, value) in tile.cols.clone().zip(values) {
                *value = one(pixels[col as usize]);
            }
        },
        |()| {},
    )
}

/// A pixel from each field.
fn sample((width, height): (u32, u32)) -> Vec<(u32, u32)> {
    let mut draw = Draw::new(SEED, "auto", Precision::F64);
    let mut within = |field: u32, fields: u32, size: u32| {
        let edge = |field: u32| (u64::from(field) * u64::from(size) / u64::from(fields)) as u32;
        let (from, to) = (edge(field), edge(field + 1));
        from + draw.below(u64::from(to - from)) as u32
    };
    let (across, down) = (width.min(FIELDS), height.min(FIELDS));
    let fields = (0..down).flat_map(|row| (0..across).map(move |col| (col, row)));
    fields.map(|(col, row)| (within(col, across, width), within(row, down, height))).collect()
}

/// Which objects the rays of a pixel see: the eye ray's, and all of them in their order as one number (FNV-1a).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Rays {
    first: Option<usize>,
    all: u64,
    sent: u64,
}

impl Rays {
    fn mix(&mut self, word: u64) {
        self.all = (self.all ^ word).wrapping_mul(0x100_0000_01b3);
    }
}

impl Tally for Rays {
    fn boxes(&mut self, _more: usize) {}
    fn tests(&mut self, _more: usize) {}
    fn hit(&mut self) {}
}

impl<R: Real> Witness<R> for Rays {
    fn sent(&mut self, sent: &Sent<R>) {
        self.sent += 1;
        self.mix(u64::from(sent.depth) << 2 | sent.kind as u64);
    }
    fn landed(&mut self, object: usize, _lambda: R, _point: Option<&Point<R>>) {
        if self.sent == 1 {
            self.first = Some(object);
        }
        self.mix(object as u64 + 1);
    }
}

/// Says what was found.
pub(crate) fn say(transcript: &mut Transcript, found: &Found) {
    let section = transcript.section("What f32 would get wrong", "--precision auto");
    if !found.fits {
        section.step("precision", "that is taken", Value::text(found.precision().name()));
        section.note("the scene has numbers that f32 cannot hold");
        return;
    }
    section
        .step("sample", "pixels traced in both precisions, with all their rays", whole(found.pixels))
        .step("colors", "pixels with another color", whole(found.colors))
        .step("objects", "pixels that see another object first", whole(found.objects))
        .step("paths", "pixels of whose rays one sees another object", whole(found.paths))
        .number("largest", "difference in a channel, linear", found.largest)
        .step("precision", "that is taken", Value::text(found.precision().name()));
    section.note(match found.precision() {
        Precision::F32 => "f32: no color and no object that is seen would be another",
        Precision::F64 => "f64: the difference would be seen",
    });
}

#[cfg(test)]
mod tests;

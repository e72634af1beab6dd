//! `--precision auto`: f32 where nothing visible is lost, found out on some of the scene's own rays.
//!
//! Pixels drawn from all of the picture are traced in both precisions with all their rays, as many as
//! `--samples` asks for, and the edges beside them are found to the last digits of f32 (see [`sample`]): how
//! far off f32 puts them tells how many pixels of the picture will be on the wrong side (see [`edges`]). A
//! picture that is small is traced as a whole. f32 is taken where no traced pixel has a channel that is off
//! by more than one level of 255, and where of the whole picture, with 95 % certainty, so few pixels are
//! expected to be that there most likely is none. By one level two radiances can differ that are the same but
//! for the last digits, where one is rounded up and the other down.
//!
//! What no ray of the sample sees is not known, and what is said is no more than what was measured.

mod edges;
mod rays;
mod sample;

use bounds::Parts;
use math::Real;
use shading::Rgb;
use signature::Method;
use signature::stage::fault;
use stage::{Ask, Chosen, Color, Error, Precision, Section, Value, Workers, tiled};

use crate::show::whole;
use crate::{Path, Requirements, Tolerance, Tracer, from_file, render};
use edges::{Asked, FEW};
use rays::Rays;
use sample::{Place, Seen, SeenIn};

/// What f32 would get wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Found {
    /// f32 holds the numbers of the scene; if not, nothing was traced.
    pub(crate) fits: bool,
    /// The pixels that were drawn are all of the picture.
    pub(crate) is_whole: bool,
    /// Of the pixels that were drawn.
    pub(crate) drawn: Differences,
    /// How many edges are beside them, to the right and below.
    pub(crate) edges: u64,
    /// How many pixels of the picture are visibly others because f32 puts an edge elsewhere: with 95 %
    /// certainty no more than this are to be expected.
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
        let is_visible = !self.fits || self.drawn.visible > 0 || self.expected > FEW;
        if is_visible { Precision::F64 } else { Precision::F32 }
    }

    /// The same, and why.
    pub(crate) fn chosen(&self) -> Chosen {
        Chosen { precision: self.precision(), why: Some(self.section()) }
    }

    /// What was found, in a sentence that claims no more.
    fn said(&self) -> String {
        let Differences { pixels, visible, .. } = self.drawn;
        let expected = rounded(self.expected);
        match (self.precision(), visible) {
            (Precision::F64, _) if !self.fits => {
                "f64: the scene has numbers that f32 cannot hold".to_string()
            }
            (Precision::F32, _) if self.is_whole => {
                format!("f32: all {pixels} pixels were traced, and none is visibly another")
            }
            (Precision::F32, _) => format!(
                "f32: none of {pixels} pixels is visibly another, and by where its edges are {expected} of the picture: \
                 less than {FEW}"
            ),
            (Precision::F64, 0) => {
                format!(
                    "f64: by where f32 puts edges {expected} pixels may visibly be others, more than {FEW}"
                )
            }
            (Precision::F64, visible) => {
                format!("f64: in f32 {visible} of {pixels} pixels are visibly others")
            }
        }
    }
}

/// To three digits behind the point.
fn rounded(expected: f64) -> f64 {
    (expected * 1e3).ceil() / 1e3
}

impl Differences {
    /// Between the same pixels in two precisions.
    fn between(narrow: &[Seen], wide: &[Seen], srgb: bool) -> Differences {
        let mut found = Differences::default();
        for (narrow, wide) in narrow.iter().zip(wide) {
            let levels = levels(narrow.e, wide.e, srgb);
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
fn levels(a: Rgb, b: Rgb, srgb: bool) -> u8 {
    let color = if srgb { Color::from_linear_srgb } else { Color::from_linear };
    let (Color(a), Color(b)) = (color(a.0), color(b.0));
    a.into_iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// Traces the sample in both precisions.
///
/// [`Error::Request`] where the scene is none in f64, or the pixel that is asked for lies outside of it.
pub(crate) fn found(file: &scene_file::Scene, ask: &Ask) -> Result<Found, Error> {
    let size = ask.size_or(file.camera.size.value)?;
    if from_file::scene::<f32>(file, Some(size), ask.depth).is_err() {
        from_file::scene::<f64>(file, Some(size), ask.depth).map_err(fault)?;
        return Ok(Found::default());
    }
    let (drawn, edges, wide) = traced::<f64, _>(file, ask, size, |seen| {
        let (drawn, edges) = sample::sample(size, seen)?;
        let wide = sample::halved(&edges, seen)?;
        Ok((drawn, edges, wide))
    })?;
    let (drawn_narrow, narrow) =
        traced::<f32, _>(file, ask, size, |seen| Ok((seen(&drawn.places)?, sample::halved(&edges, seen)?)))?;
    let pixels = f64::from(size.0) * f64::from(size.1);
    let asked = Asked { pixels, samples: ask.samples.unwrap_or(1), srgb: ask.srgb };
    Ok(Found {
        fits: true,
        is_whole: sample::is_small(size),
        drawn: Differences::between(&drawn_narrow, &drawn.seen, ask.srgb),
        edges: edges.len() as u64,
        expected: asked.expected(drawn.places.len(), &narrow, &wide),
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
    work(&|places| seen(&tracer, ask, places))
}

/// What places see, as a picture of one row.
fn seen<R: Real>(tracer: &Tracer<'_, R>, ask: &Ask, places: &[Place]) -> Result<Vec<Seen>, Error> {
    if places.is_empty() {
        return Ok(Vec::new());
    }
    let workers = Workers { threads: ask.threads, stack: render::stack(tracer), progress: None };
    let one = |place: Place| {
        let (mut rays, mut path) = (Rays::default(), Path::default());
        let e = match place {
            Place::Pixel(pixel) => tracer.pixel(pixel, ask.samples.unwrap_or(1), &mut path, &mut rays),
            Place::Point(pixel, [x, y]) => {
                let ray = tracer.ray(pixel, (R::round_from(x), R::round_from(y)));
                tracer.eye_ray(&ray, &mut path, &mut rays)
            }
        };
        Seen { e, rays }
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

impl Found {
    /// What was found, step by step; the last says what it comes to.
    fn section(&self) -> Section {
        let mut section = Section::new("What f32 would get wrong", "--precision auto");
        if self.fits {
            self.steps(&mut section);
        }
        section.step("precision", "that is taken", Value::text(self.precision().name())).note(self.said());
        if self.fits && !self.is_whole {
            section.remark("What no ray of the sample sees is not known.");
        }
        section
    }

    fn steps(&self, section: &mut Section) {
        let Differences { pixels, colors, visible, objects, paths, largest } = self.drawn;
        let drawn =
            if self.is_whole { "all pixels of the picture" } else { "pixels drawn from all of the picture" };
        section
            .step("sample", &format!("{drawn}, all rays of each"), whole(pixels))
            .step("visible", "of which a channel is off by more than one level of 255", whole(visible))
            .step("colors", "with another byte at all", whole(colors))
            .step("objects", "whose eye rays see another object", whole(objects))
            .step("paths", "of whose rays one sees another object, light or color", whole(paths))
            .number("largest", "difference in a channel, linear", largest);
        if !self.is_whole {
            let expected = Value::number(rounded(self.expected));
            section
                .step("edges", "right of their middles and below, before the next pixel's", whole(self.edges))
                .step("expected", "pixels visibly off by where f32 puts edges, at most (95 %)", expected);
        }
    }
}

#[cfg(test)]
mod tests;

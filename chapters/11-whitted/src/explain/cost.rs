//! What it would cost to model everything instead: measured, on a small picture of the scene.

use std::hint::black_box;
use std::time::{Duration, Instant};

use bounds::{Bounded, Parts, Uncounted};
use math::Real;
use signature::Method;
use signature::stage::fault;
use stage::{Error, Transcript, Value};

use crate::{Counts, Feature, Path, Requirements, Scene, Tracer, from_file, render};

/// So many rounds, in turns; the median of them counts.
const ROUNDS: usize = 7;
/// For about so long each picture is traced.
const ONE: Duration = Duration::from_millis(40);
/// The picture has no more pixels than this.
const MOST: f64 = 160.0 * 120.0;
/// And at first no more than this, to see how long they take.
const A_FEW: f64 = 400.0;

/// The time of a ray with what the scene requires, with each feature more, and with all of them.
///
/// [`Error::Failed`] where a thread cannot be had, [`Error::Request`] where the scene is none in R.
pub(crate) fn cost<R: Real>(
    transcript: &mut Transcript,
    file: &scene_file::Scene,
    size: (u32, u32),
    method: Method,
    depth: Option<u32>,
) -> Result<(), Error> {
    let scene_of = |size| from_file::scene::<R>(file, Some(size), depth).map_err(fault);
    let few = scene_of(smaller(size, A_FEW))?;
    let required = Requirements::of(&few, Parts::of(&few.lit.geometry).count());
    let (seconds, _) = Variant { requirements: required, scene: few.clone() }.run(method)?;
    let pixels = f64::from(few.lit.geometry.size.0) * f64::from(few.lit.geometry.size.1);
    let scene = scene_of(smaller(size, MOST.min(pixels * ONE.as_secs_f64() / seconds.max(1e-9))))?;

    let more: Vec<Feature> =
        Feature::ALL.into_iter().filter(|&feature| required.and(feature) != required).collect();
    let each = more.iter().map(|&feature| required.and(feature));
    let all = std::iter::once(required).chain(each).chain([required.everything()]);
    let variants: Vec<Variant<R>> =
        all.map(|requirements| Variant::new(requirements, &scene, file)).collect();
    let mut rounds: Vec<Vec<f64>> = vec![Vec::new(); variants.len()];
    let mut counted = vec![Counts::default(); variants.len()];
    for _ in 0..ROUNDS {
        for (place, variant) in variants.iter().enumerate() {
            let (seconds, counts) = variant.run(method)?;
            rounds[place].push(seconds);
            counted[place] = counts;
        }
    }
    let medians: Vec<f64> = rounds.into_iter().map(median).collect();
    say(transcript, &more, &medians, &counted, scene.lit.geometry.size);
    Ok(())
}

/// The table.
fn say(
    transcript: &mut Transcript,
    more: &[Feature],
    medians: &[f64],
    counted: &[Counts],
    (width, height): (u32, u32),
) {
    let rays = counted[0].rays() as f64;
    let features = more.iter().map(|feature| format!("and {}", feature.name()));
    let names =
        std::iter::once("what is required".to_string()).chain(features).chain(["everything".to_string()]);
    let row = |((name, seconds), counts): ((String, &f64), &Counts)| {
        let ns = seconds * 1e9 / rays;
        let times = seconds / medians[0];
        let rounded = |x: f64, to: f64| Value::number((x * to).round() / to);
        vec![Value::text(name), rounded(ns, 10.0), rounded(times, 100.0), Value::number(counts.rays() as f64)]
    };
    let rows = names.zip(medians).zip(counted).map(row).collect();
    let section = transcript.section("What it would cost to model more", "--explain");
    section.table(&["modeled", "ns/ray", "times", "rays"], rows);
    section.remark(format!(
        "{width} × {height} pixels on one thread, the median of {ROUNDS} rounds, over the {rays} rays that are required. \
         The radiance of every pixel is the same."
    ));
}

/// A scene with more or less of it modeled.
struct Variant<R: Real> {
    requirements: Requirements,
    scene: Scene<R>,
}

impl<R: Real> Variant<R> {
    fn new(requirements: Requirements, scene: &Scene<R>, file: &scene_file::Scene) -> Variant<R> {
        let mut scene = scene.clone();
        if requirements.idle_textures {
            from_file::idle_textures(&mut scene, file);
        }
        Variant { requirements, scene }
    }

    /// Traces the picture: the seconds that took, and what it counted.
    fn run(&self, method: Method) -> Result<(f64, Counts), Error> {
        let geometry = &self.scene.lit.geometry;
        let bounded = Bounded::by(method, geometry, self.requirements.bounds());
        let tracer = Tracer::new(&self.scene, &bounded, &self.requirements, None);
        let (width, height) = geometry.size;
        let pixels = || (0..height).flat_map(|row| (0..width).map(move |col| (col, row)));
        render::with_stack(render::stack(&tracer), || {
            let mut path = Path::default();
            let start = Instant::now();
            for pixel in pixels() {
                black_box(tracer.pixel(pixel, 1, &mut path, &mut Uncounted));
            }
            let seconds = start.elapsed().as_secs_f64();
            let mut counts = Counts::default();
            for pixel in pixels() {
                tracer.pixel(pixel, 1, &mut path, &mut counts);
            }
            (seconds, counts)
        })
    }
}

/// A picture of the same shape with about so many pixels, and never more than before.
fn smaller((width, height): (u32, u32), pixels: f64) -> (u32, u32) {
    let scale = (pixels / (f64::from(width) * f64::from(height))).sqrt().min(1.0);
    let scaled = |side: u32| ((f64::from(side) * scale) as u32).max(1);
    // the grid `edges` needs two of each
    (scaled(width).max(2.min(width)), scaled(height).max(2.min(height)))
}

/// Half of them are smaller.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

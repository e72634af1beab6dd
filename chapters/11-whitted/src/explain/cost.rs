//! What it would cost to model everything instead: measured, on a small picture of the scene.

use std::hint::black_box;
use std::time::{Duration, Instant};

use bounds::{Parts, Uncounted};
use math::Real;
use signature::Method;
use signature::stage::fault;
use stage::{Error, Transcript, Value};

use crate::{Counts, Feature, Path, Requirements, Scene, Tracer, Witness, from_file, render};

/// So many rounds, in turns; the median of them counts.
const ROUNDS: usize = 5;
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
    let seconds = Variant { requirements: required, scene: few.clone() }.seconds(method)?;
    let pixels = f64::from(few.lit.geometry.size.0) * f64::from(few.lit.geometry.size.1);
    let scene = scene_of(smaller(size, MOST.min(pixels * ONE.as_secs_f64() / seconds.max(1e-9))))?;

    let more: Vec<Feature> =
        Feature::ALL.into_iter().filter(|&feature| required.and(feature) != required).collect();
    let each = more.iter().map(|&feature| required.and(feature));
    let all = std::iter::once(required).chain(each).chain([required.everything()]);
    let variants: Vec<Variant<R>> =
        all.map(|requirements| Variant::new(requirements, &scene, file)).collect();
    let counted =
        variants.iter().map(|variant| variant.counts(method)).collect::<Result<Vec<Counts>, Error>>()?;
    let mut rounds: Vec<Vec<f64>> = vec![Vec::new(); variants.len()];
    for _ in 0..ROUNDS {
        for (variant, times) in variants.iter().zip(&mut rounds) {
            times.push(variant.seconds(method)?);
        }
    }
    say(transcript, &more, &rounds, &counted, scene.lit.geometry.size);
    Ok(())
}

/// The table.
fn say(
    transcript: &mut Transcript,
    more: &[Feature],
    rounds: &[Vec<f64>],
    counted: &[Counts],
    (width, height): (u32, u32),
) {
    let rays = counted[0].rays() as f64;
    let features = more.iter().map(|feature| format!("and {}", feature.name()));
    let names =
        std::iter::once("what is required".to_string()).chain(features).chain(["everything".to_string()]);
    let rounded = |x: f64, to: f64| Value::number((x * to).round() / to);
    let row = |((name, times), counts): ((String, &Vec<f64>), &Counts)| {
        let ns = median(times.clone()) * 1e9 / rays;
        // whatever else the machine does in a round hurts both
        let ratio = median(times.iter().zip(&rounds[0]).map(|(time, required)| time / required).collect());
        vec![Value::text(name), rounded(ns, 10.0), rounded(ratio, 100.0), Value::number(counts.rays() as f64)]
    };
    let rows = names.zip(rounds).zip(counted).map(row).collect();
    let section = transcript.section("What it would cost to model more", "--explain");
    section.table(&["modeled", "ns/ray", "times", "rays"], rows);
    section.remark(format!(
        "{width} × {height} pixels on one thread, the median of {ROUNDS} rounds, over the {rays} rays that are required; \
         times: the median of the rounds' quotients, not the quotient of the medians. \
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

    /// The seconds that the picture takes.
    fn seconds(&self, method: Method) -> Result<f64, Error> {
        self.traced(method, &mut Uncounted)
    }

    /// What the picture counts.
    fn counts(&self, method: Method) -> Result<Counts, Error> {
        let mut counts = Counts::default();
        self.traced(method, &mut counts)?;
        Ok(counts)
    }

    /// Traces the picture on one thread, for somebody to watch: the seconds that takes.
    fn traced(&self, method: Method, witness: &mut (impl Witness<R> + Send)) -> Result<f64, Error> {
        let geometry = &self.scene.lit.geometry;
        let bounded = self.requirements.bounded(method, geometry);
        let tracer = Tracer::new(&self.scene, &bounded, &self.requirements, None);
        let (width, height) = geometry.size;
        render::with_stack(render::stack(&tracer), || {
            let mut path = Path::default();
            let start = Instant::now();
            for pixel in (0..height).flat_map(|row| (0..width).map(move |col| (col, row))) {
                black_box(tracer.pixel(pixel, 1, &mut path, witness));
            }
            start.elapsed().as_secs_f64()
        })
    }
}

/// A picture of the same shape with about so many pixels, and never more than before.
fn smaller((width, height): (u32, u32), pixels: f64) -> (u32, u32) {
    let scale = (pixels / (f64::from(width) * f64::from(height))).sqrt().min(1.0);
    // of a picture that is one row the row is shorter
    let scaled = |side: u32| ((f64::from(side) * scale).min(pixels) as u32).max(1);
    // the grid `edges` needs two of each
    (scaled(width).max(2.min(width)), scaled(height).max(2.min(height)))
}

/// Half of them are smaller.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smaller_picture_has_the_same_shape() {
        // √(400 / 307200) = 0.0361: 23 by 17
        assert_eq!(smaller((640, 480), 400.0), (23, 17));
        assert_eq!(smaller((16, 12), 400.0), (16, 12), "never larger");
        assert_eq!(smaller((1 << 28, 1), 400.0), (400, 1));
        assert_eq!(smaller((640, 480), 0.0), (2, 2), "two of each, where there are two");
    }

    #[test]
    fn half_of_the_times_are_shorter() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(Vec::new()), 0.0);
    }
}

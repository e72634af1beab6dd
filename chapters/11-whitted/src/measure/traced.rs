//! Pixels traced in every setting.

use std::hint::black_box;
use std::time::{Duration, Instant};

use bounds::Bounded;
use math::Real;
use scene_file::Error;
use shading::Rgb;
use signature::Method;

use super::Setting;
use crate::{Counts, Path, Requirements, Scene, Tolerance, Tracer, from_file};

/// Traces pixels: what they see, and the rays.
pub(super) type Run<'a> = Box<dyn Fn(&[(u32, u32)]) -> (Vec<Rgb>, Counts) + 'a>;

/// A scene once for each depth that is measured.
pub(super) fn scenes<R: Real>(
    file: &scene_file::Scene,
    settings: &[Setting],
) -> Result<Vec<Scene<R>>, Error> {
    let mut depths: Vec<u32> = settings.iter().map(|setting| setting.depth).collect();
    depths.sort_unstable();
    depths.dedup();
    depths.into_iter().map(|depth| from_file::scene(file, None, Some(depth))).collect()
}

/// A scene of every depth, with its bounds for the formulas of each method.
pub(super) struct Ready<'a, R: Real> {
    scenes: &'a [Scene<R>],
    bounded: Vec<(Method, Bounded<'a, R>)>,
}

impl<'a, R: Real> Ready<'a, R> {
    /// Works the bounds out; they are the same at every depth.
    pub(super) fn of(scenes: &'a [Scene<R>]) -> Ready<'a, R> {
        let geometry = &scenes[0].lit.geometry;
        let parts = Bounded::new(geometry, bounds::Method::None).parts();
        let bounds = Requirements::of(&scenes[0], parts).bounds();
        let bounded = Method::ALL.map(|method| (method, Bounded::by(method, geometry, bounds))).into();
        Ready { scenes, bounded }
    }

    /// What traces pixels in a setting, of a depth and a method that are there.
    pub(super) fn run(&'a self, setting: &Setting) -> Run<'a> {
        let scene = self.scenes.iter().find(|scene| scene.max_depth == setting.depth);
        let bounded = self.bounded.iter().find(|(method, _)| *method == setting.method);
        let (scene, (_, bounded)) = (scene.unwrap_or(&self.scenes[0]), bounded.unwrap_or(&self.bounded[0]));
        let requirements = Requirements::of(scene, bounded.parts());
        let tolerance = setting.tolerance.map(|e| Tolerance::new(scene, e));
        let tracer = Tracer::new(scene, bounded, &requirements, tolerance);
        let samples = setting.samples;
        Box::new(move |pixels| {
            let (mut path, mut counts) = (Path::default(), Counts::default());
            let see = |&pixel: &(u32, u32)| tracer.pixel(pixel, samples, &mut path, &mut counts);
            let seen = pixels.iter().map(see).collect();
            (seen, counts)
        })
    }
}

/// Pixels that are timed in one go: about a millisecond with 4 × 4 rays each, less than the time that a busy
/// machine gives to one program before it is another's turn.
const AT_ONCE: usize = 8;
/// No fewer rounds than these, if need be longer than is allowed.
const FEWEST: usize = 5;

/// Seconds that each takes for these pixels. They go through them by handfuls, in turns; of each handful the
/// median over rounds counts, at least [`FEWEST`], more within the time allowed.
pub(super) fn time(runs: &[Run<'_>], pixels: &[(u32, u32)], allowed: Duration) -> Vec<f64> {
    let handfuls: Vec<&[(u32, u32)]> = pixels.chunks(AT_ONCE).collect();
    let start = Instant::now();
    let mut rounds: Vec<Vec<Vec<f64>>> = vec![vec![Vec::new(); handfuls.len()]; runs.len()];
    for round in 0.. {
        if round >= FEWEST && start.elapsed() > allowed {
            break;
        }
        for (at, handful) in handfuls.iter().enumerate() {
            for (run, rounds) in runs.iter().zip(&mut rounds) {
                let start = Instant::now();
                black_box(run(handful));
                rounds[at].push(start.elapsed().as_secs_f64());
            }
        }
    }
    let median = |mut seconds: Vec<f64>| {
        seconds.sort_by(f64::total_cmp);
        seconds[seconds.len() / 2]
    };
    rounds.into_iter().map(|handfuls| handfuls.into_iter().map(median).sum()).collect()
}

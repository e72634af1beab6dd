//! What each bound costs and saves, against the number of objects.

use std::hint::black_box;
use std::time::Instant;

use lab::scenes::{file_named, pixels};
use lab::{Draw, Effort, Nanoseconds, Pass, Progress, Runner, asked_for, time};
use math::{Camera, Grid, Handedness, Real, Window, portable};
use ray_sphere::Sphere;
use signature::stage::{built_in, fault, read};
use signature::{Object, Scene, Shape, from_file};
use stage::{Error, Precision, TradeAsk};

use crate::{Bounded, Counts, Method, Uncounted};

/// A scene that is measured in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Regime {
    /// Its name, for `--regime`.
    pub(crate) name: &'static str,
    /// What it is, in half a sentence.
    pub(crate) what: &'static str,
    /// How many spheres; 0 for a scene file.
    spheres: usize,
}

/// From one sphere to a million, the smaller the more there are: about a half of the rays hit.
pub(crate) const REGIMES: [Regime; 12] = [
    spheres("spheres-1", "one sphere", 1),
    spheres("spheres-3", "3 spheres", 3),
    spheres("spheres-10", "10 spheres", 10),
    spheres("spheres-30", "30 spheres", 30),
    spheres("spheres-100", "100 spheres", 100),
    spheres("spheres-300", "300 spheres", 300),
    spheres("spheres-1e3", "a thousand spheres", 1_000),
    spheres("spheres-1e4", "ten thousand spheres", 10_000),
    spheres("spheres-1e5", "a hundred thousand spheres", 100_000),
    spheres("spheres-1e6", "a million spheres", 1_000_000),
    spheres("balls2", "Haines's balls: 91 spheres on a square", 0),
    spheres("teapot", "Newell's teapot, 992 triangles, on a plane", 0),
];

const fn spheres(name: &'static str, what: &'static str, spheres: usize) -> Regime {
    Regime { name, what, spheres }
}

/// From so many parts on, what tries every bound is not measured: a ray would take milliseconds.
const TOO_MANY: usize = 100_000;
/// So many tests are counted at the most, by what tries every bound.
const MOST_TESTS: usize = 20_000_000;
/// With `--quick`, larger scenes than this are measured only where they are asked for by name.
const NOT_QUICK: usize = 10_000;

/// What was measured in a scene.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    pub(crate) name: String,
    pub(crate) what: String,
    /// Whether it is one of those that differ in the number of spheres only.
    pub(crate) is_of_spheres: bool,
    /// How many objects and faces of meshes it has.
    pub(crate) parts: usize,
    pub(crate) entries: Vec<Entry>,
}

/// One method at one precision.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) method: Method,
    pub(crate) precision: Precision,
    /// Nanoseconds a ray.
    pub(crate) ns: Nanoseconds,
    /// How many rays were counted.
    pub(crate) rays: u64,
    /// What they all did together.
    pub(crate) counts: Counts,
    /// How many of them see another object than without bounds, or at another λ; `None` where that would take
    /// too long.
    pub(crate) others: Option<u64>,
    /// How long the bounds took to make, in milliseconds.
    pub(crate) built: f64,
    /// No other is faster at its precision: all are right.
    pub(crate) on_front: bool,
}

/// Measures in the chapter's own scenes, or in the file that is asked for.
///
/// [`Error::Request`] where a scene is asked for that there is not, or a file is none.
pub(crate) fn measure(ask: &TradeAsk) -> Result<Vec<Measured>, Error> {
    let mut regimes = asked_for(ask, REGIMES.to_vec(), |regime| regime.name)?;
    if let Some(path) = &ask.scene {
        let (name, what) = file_named(path);
        return Ok(vec![of_file(name, what, &read(Some(path))?, ask, Effort::of(ask, 1))?]);
    }
    if ask.quick && ask.regimes.is_empty() {
        regimes.retain(|regime| regime.spheres <= NOT_QUICK);
    }
    let effort = Effort::of(ask, regimes.len());
    let progress = Progress::new(regimes.len() as u64);
    let mut all = Vec::new();
    for Regime { name, what, spheres } in regimes {
        progress.starts(name);
        let (its_name, what) = (name.to_string(), what.to_string());
        let measured = if spheres == 0 {
            of_file(its_name, what, &built_in(name)?, ask, effort)?
        } else {
            let (single, double) = (scene_of(name, spheres, ask.seed)?, scene_of(name, spheres, ask.seed)?);
            let measured = in_scenes(its_name, what, Some(&single), &double, ask, effort);
            Measured { is_of_spheres: true, ..measured }
        };
        progress.done();
        all.push(measured);
    }
    Ok(all)
}

fn of_file(
    name: String,
    what: String,
    file: &scene_file::Scene,
    ask: &TradeAsk,
    effort: Effort,
) -> Result<Measured, Error> {
    let double = from_file::scene::<f64>(file, None).map_err(fault)?;
    // numbers that f32 cannot hold are measured at f64 alone
    let single = from_file::scene::<f32>(file, None).ok();
    Ok(in_scenes(name, what, single.as_ref(), &double, ask, effort))
}

/// Spheres anywhere in a cube of side 2, each a little more than half as wide as its share of the cube, seen
/// from the front.
fn scene_of<R: Real>(name: &str, count: usize, seed: u64) -> Result<Scene<R>, Error> {
    let mut draw = Draw::new(seed, name, Precision::F64);
    let radius = R::round_from(0.55 / portable::cbrt(count as f64));
    let mut number = || R::round_from(draw.uniform(-1.0, 1.0));
    let objects = (0..count).map(|object| {
        let center = R::vec3(number(), number(), number());
        Object { id: u16::try_from(object + 1).ok(), shape: Shape::Sphere(Sphere { center, radius }) }
    });
    let objects = objects.collect();
    let (zero, one, four) = (R::from(0.0), R::from(1.0), R::from(4.0));
    let (eye, forward, up) = (R::vec3(zero, zero, four), R::vec3(zero, zero, -one), R::vec3(zero, one, zero));
    let window = Window::around_axis(R::from(0.75), SIZE);
    let camera = Camera::looking(eye, forward, up, Handedness::Right, one, window)?;
    Ok(Scene { camera, grid: Grid::Centers, size: SIZE, objects })
}

/// The size of the picture whose rays are measured.
const SIZE: (u32, u32) = (512, 512);

fn in_scenes(
    name: String,
    what: String,
    single: Option<&Scene<f32>>,
    double: &Scene<f64>,
    ask: &TradeAsk,
    effort: Effort,
) -> Measured {
    let pixels = pixels(&name, ask.seed, double.size, effort.timed.max(effort.cases));
    let mut entries = Vec::new();
    for precision in Precision::ALL.into_iter().filter(|it| ask.wants_precision(*it)) {
        match (precision, single) {
            (Precision::F32, Some(scene)) => entries.extend(in_scene(scene, precision, &pixels, ask, effort)),
            (Precision::F32, None) => {}
            (Precision::F64, _) => entries.extend(in_scene(double, precision, &pixels, ask, effort)),
        }
    }
    Measured { name, what, is_of_spheres: false, parts: crate::Parts::of(double).count(), entries }
}

fn in_scene<R: Real>(
    scene: &Scene<R>,
    precision: Precision,
    pixels: &[(u32, u32)],
    ask: &TradeAsk,
    effort: Effort,
) -> Vec<Entry> {
    let parts = crate::Parts::of(scene).count();
    let tries_all = |method| matches!(method, Method::None | Method::Sphere | Method::Box);
    let wanted: Vec<Method> = Method::ALL
        .into_iter()
        .enumerate()
        .filter(|(place, method)| {
            ask.wants_method(*place) && (parts < TOO_MANY || !tries_all(method.or_required(parts)))
        })
        .map(|(_, method)| method)
        .collect();
    let bounded: Vec<(Bounded<'_, R>, f64)> = wanted
        .iter()
        .map(|&method| {
            let start = Instant::now();
            let bounded = Bounded::new(scene, method);
            (bounded, start.elapsed().as_secs_f64() * 1e3)
        })
        .collect();

    // what is seen without bounds, as far as that may take
    let counted = |method: Method| {
        let most = if tries_all(method.or_required(parts)) { MOST_TESTS / parts.max(1) } else { usize::MAX };
        &pixels[..effort.cases.min(most.max(100)).min(pixels.len())]
    };
    let reference: Vec<_> = if parts < TOO_MANY {
        let plain = Bounded::new(scene, Method::None);
        counted(Method::None).iter().map(|&pixel| plain.seen(pixel, &mut Uncounted)).collect()
    } else {
        Vec::new()
    };
    let found: Vec<(u64, Counts, Option<u64>)> = wanted
        .iter()
        .zip(&bounded)
        .map(|(&method, (bounded, _))| {
            let (mut counts, mut others) = (Counts::default(), 0);
            let pixels = counted(method);
            for (at, &pixel) in pixels.iter().enumerate() {
                let seen = bounded.seen(pixel, &mut counts);
                others += u64::from(reference.get(at).is_some_and(|plain| *plain != seen));
            }
            (pixels.len() as u64, counts, (!reference.is_empty()).then_some(others))
        })
        .collect();

    let mut runners: Vec<Runner<'_>> = bounded.iter().map(|(bounded, _)| runner(bounded, pixels)).collect();
    let times = time(&mut runners, Pass::Throughput, effort.timed, effort.rounds, effort.allowed);
    let fastest = times.iter().map(|ns| ns.median).fold(f64::INFINITY, f64::min);
    let all = wanted.iter().zip(&bounded).zip(times).zip(found);
    all.map(|(((&method, &(_, built)), ns), (rays, counts, others))| {
        let on_front = ns.median == fastest;
        Entry { method, precision, ns, rays, counts, others, built, on_front }
    })
    .collect()
}

/// What each pixel sees, to be timed.
fn runner<'a, R: Real>(bounded: &'a Bounded<'a, R>, pixels: &'a [(u32, u32)]) -> Runner<'a> {
    Box::new(move |_, count| {
        let pixels = &pixels[..count.min(pixels.len())];
        for &pixel in pixels {
            black_box(bounded.seen(pixel, &mut Uncounted));
        }
        pixels.len()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every kind of bound sees the same in every scene, and each saves tests.
    #[test]
    fn all_see_the_same_and_test_less() {
        for regime in ["spheres-100", "balls2"] {
            let ask = TradeAsk {
                method: None,
                precision: None,
                regimes: vec![regime.to_string()],
                cases: Some(2000),
                seed: 3,
                quick: true,
                scene: None,
            };
            let measured = measure(&ask).unwrap().remove(0);
            assert_eq!(measured.entries.len(), 14);
            for entry in &measured.entries {
                assert_eq!(entry.others, Some(0), "{entry:?}");
            }
            let tests = |method: Method| {
                measured.entries.iter().find(|entry| entry.method == method).map(|entry| entry.counts.tests)
            };
            assert!(tests(Method::Sphere) < tests(Method::None), "{regime}");
            assert!(tests(Method::Tree) < tests(Method::Box), "{regime}");
        }
    }
}

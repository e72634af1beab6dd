//! Which pixels see another object by other formulas or in less precision, and what a pixel takes.
//!
//! The reference is the robust methods at f64. Chapters 03 to 07 judge them against the exact oracle and find no
//! wrong verdict.

use std::hint::black_box;

use lab::scenes::{file_named, pixels};
use lab::{Effort, Nanoseconds, Pass, Progress, Runner, asked_for, time};
use math::{Ray3, Real, Span};
use stage::{Error, Precision, TradeAsk};

use crate::stage::{fault, read};
use crate::{Method, Scene, Shape, first_hit, from_file};

mod scenes;
pub(crate) use scenes::SCENES;

/// What was measured in a scene.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    pub(crate) name: String,
    pub(crate) what: String,
    /// How many objects it has.
    pub(crate) objects: usize,
    /// How many intersections a ray tries: a mesh is one object, and one for each of its faces.
    pub(crate) tries: usize,
    pub(crate) entries: Vec<Entry>,
}

/// One method at one precision.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) method: Method,
    pub(crate) precision: Precision,
    /// Nanoseconds a pixel.
    pub(crate) ns: Nanoseconds,
    pub(crate) off: Off,
    /// No other is at least as fast and as right, and better in one of the two.
    pub(crate) on_front: bool,
}

/// How many pixels see what they should not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Off {
    /// How many pixels there are.
    pub(crate) pixels: u64,
    /// How many see another object than the reference, or none, or one where it sees none.
    pub(crate) others: u64,
    /// How many of these see nothing at all where the reference sees an object.
    pub(crate) holes: u64,
}

impl Off {
    /// The share of pixels that see another object.
    pub(crate) fn share(&self) -> f64 {
        self.others as f64 / self.pixels.max(1) as f64
    }

    /// What these pixels see against the reference.
    fn of(seen: &[Option<usize>], reference: &[Option<usize>]) -> Off {
        let mut off = Off::default();
        for (seen, reference) in seen.iter().zip(reference) {
            off.pixels += 1;
            off.others += u64::from(seen != reference);
            off.holes += u64::from(seen.is_none() && reference.is_some());
        }
        off
    }
}

/// Measures in the chapter's own scenes, or in the file that is asked for.
///
/// [`Error::Request`] where a scene is asked for that there is not, or a file is none.
pub(crate) fn measure(ask: &TradeAsk) -> Result<Vec<Measured>, Error> {
    let own = asked_for(ask, SCENES.to_vec(), |scene| scene.name)?;
    let files: Vec<(String, String, scene_file::Scene)> = match &ask.scene {
        Some(path) => {
            let (name, what) = file_named(path);
            vec![(name, what, read(Some(path))?)]
        }
        None => {
            let read = own.iter().map(|it| Ok((it.name.to_string(), it.what.to_string(), it.file()?)));
            read.collect::<Result<_, Error>>()?
        }
    };
    let effort = Effort::of(ask, files.len());
    let progress = Progress::new(files.len() as u64);
    let mut all = Vec::new();
    for (name, what, file) in files {
        progress.starts(name.clone());
        let measured = in_scene(name, what, &file, ask, effort)?;
        progress.done();
        all.push(measured);
    }
    Ok(all)
}

fn in_scene(
    name: String,
    what: String,
    file: &scene_file::Scene,
    ask: &TradeAsk,
    effort: Effort,
) -> Result<Measured, Error> {
    let exact = from_file::scene::<f64>(file, None).map_err(fault)?;
    let compared = compared(&name, ask.seed, exact.size, effort.cases);
    let reference = seen(&exact, Method::Robust, &compared);

    let mut wanted = Vec::new();
    for precision in Precision::ALL.into_iter().filter(|it| ask.wants_precision(*it)) {
        let methods = Method::ALL.into_iter().enumerate().filter(|(place, _)| ask.wants_method(*place));
        wanted.extend(methods.map(|(_, method)| (method, precision)));
    }
    // a scene with numbers that f32 cannot hold is measured at f64 alone
    let single = from_file::scene::<f32>(file, None).ok();
    wanted.retain(|(_, precision)| *precision == Precision::F64 || single.is_some());

    let pixels = pixels(&name, ask.seed, exact.size, effort.timed);
    let mut runners = Vec::new();
    let mut offs = Vec::new();
    for &(method, precision) in &wanted {
        let (runner, seen) = match (precision, &single) {
            (Precision::F32, Some(scene)) => (runner(scene, method, &pixels), seen(scene, method, &compared)),
            _ => (runner(&exact, method, &pixels), seen(&exact, method, &compared)),
        };
        runners.push(runner);
        offs.push(Off::of(&seen, &reference));
    }
    let times = time(&mut runners, Pass::Throughput, effort.timed, effort.rounds, effort.allowed);
    let points: Vec<(f64, f64)> = times.iter().zip(&offs).map(|(ns, off)| (ns.median, off.share())).collect();
    let all = wanted.into_iter().zip(times).zip(offs).zip(lab::front(&points));
    let entry = |((((method, precision), ns), off), on_front)| Entry { method, precision, ns, off, on_front };
    Ok(Measured {
        name,
        what,
        objects: exact.objects.len(),
        tries: tries(&exact),
        entries: all.map(entry).collect(),
    })
}

/// How many intersections a ray tries.
fn tries(scene: &Scene<f64>) -> usize {
    let of_shape = |shape: &Shape<f64>| if let Shape::Mesh(mesh) = shape { mesh.faces().len() } else { 1 };
    scene.objects.iter().map(|object| of_shape(&object.shape)).sum()
}

/// The pixels that are compared: all of the picture where there are no more of them than asked for, else some of them.
fn compared(name: &str, seed: u64, size: (u32, u32), count: usize) -> Vec<(u32, u32)> {
    if u64::from(size.0) * u64::from(size.1) <= count as u64 {
        return (0..size.1).flat_map(|row| (0..size.0).map(move |col| (col, row))).collect();
    }
    pixels(name, seed, size, count)
}

/// What each of these pixels sees.
fn seen<R: Real>(scene: &Scene<R>, method: Method, pixels: &[(u32, u32)]) -> Vec<Option<usize>> {
    pixels.iter().map(|&pixel| scene.seen(method, pixel)).collect()
}

/// The first object of each pixel's ray, to be timed.
fn runner<'a, R: Real>(scene: &'a Scene<R>, method: Method, pixels: &[(u32, u32)]) -> Runner<'a> {
    let rays: Vec<Ray3<R>> = pixels.iter().map(|&pixel| scene.ray(pixel)).collect();
    Box::new(move |_, count| {
        let rays = &rays[..count.min(rays.len())];
        for ray in rays {
            black_box(first_hit(method, ray, &scene.objects, Span::ahead()));
        }
        rays.len()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_may_see_another_object_or_see_through() {
        let reference = [Some(1), Some(1), None, Some(2), None];
        let seen = [Some(1), Some(2), Some(2), None, None];
        assert_eq!(Off::of(&seen, &reference), Off { pixels: 5, others: 3, holes: 1 });
    }

    #[test]
    fn a_small_picture_is_compared_whole() {
        assert_eq!(compared("", 1, (2, 2), 5), [(0, 0), (1, 0), (0, 1), (1, 1)]);
        assert_eq!(compared("", 1, (3, 2), 5).len(), 5);
    }

    fn measured(name: &str) -> Vec<Off> {
        let ask = TradeAsk {
            method: None,
            precision: None,
            regimes: vec![name.to_string()],
            cases: Some(4800),
            seed: 1,
            quick: true,
            scene: None,
        };
        measure(&ask).unwrap().remove(0).entries.into_iter().map(|entry| entry.off).collect()
    }

    /// f64 robust is the reference; near the origin the notes at f64 see what it sees, and far away f32 by the notes'
    /// formula is blind (chapter 04: wrong from a hundred radii on).
    #[test]
    fn what_each_sees() {
        let [robust_32, notes_32, robust_64, notes_64] = measured("signature")[..] else { panic!() };
        assert_eq!((robust_64.others, notes_64.others), (0, 0));
        assert!(robust_32.others < 10 && notes_32.others < 10, "{robust_32:?} {notes_32:?}");
        let [robust_32, notes_32, robust_64, notes_64] = measured("far")[..] else { panic!() };
        assert_eq!((robust_64.others, notes_64.others), (0, 0));
        assert!(notes_32.others > 500 && robust_32.others < 100, "{robust_32:?} {notes_32:?}");
    }
}

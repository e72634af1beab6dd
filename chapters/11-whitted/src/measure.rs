//! What a picture's time buys: precision, formulas, depth, tolerance and samples against the error that they
//! leave.
//!
//! The error of a pixel is how far its linear radiance, before clamping, is from that of a reference: the
//! robust formulas at `f64`, the scene's own depth, nothing left out, 8 × 8 rays. Pixels are drawn from the
//! picture of the scene's own size, as in a smaller picture edges would count for more than they do; a whole
//! picture's time is theirs by their share of it.

use std::time::Duration;

use lab::{Progress, asked_for, scenes};
use shading::Rgb;
use signature::stage::{fault, read};
use stage::{Error, Precision, TradeAsk};

use crate::scenes::SCENES;
use crate::{Counts, render};

mod off;
mod setting;
mod traced;

pub use off::Off;
pub use setting::Setting;
use setting::{safest, settings};
use traced::{Ready, Run, time};

/// The reference's rays are so many by so many.
pub const REFERENCE: u32 = 8;

/// What was measured in a scene.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Its name.
    pub name: String,
    /// What it is, in half a sentence.
    pub what: String,
    /// Its file, to be named with `--scene`; `None` for the chapter's own.
    pub path: Option<String>,
    /// The size of its picture, columns and rows.
    pub size: (u32, u32),
    /// The scene's own depth.
    pub depth: u32,
    /// How many pixels were measured.
    pub pixels: usize,
    /// The dearest setting first.
    pub entries: Vec<Entry>,
}

/// One setting.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// What is set.
    pub setting: Setting,
    /// How many seconds a whole picture takes on one thread: the median over the rounds.
    pub seconds: f64,
    /// The rays of the pixels that were measured.
    pub counts: Counts,
    /// Against the reference.
    pub off: Off,
    /// Against the dearest setting with the same samples: what depth, tolerance, precision and formulas
    /// change.
    pub alone: Off,
    /// No other is at least as fast and as exact (RMSE), and better in one of the two.
    pub on_front: bool,
}

impl Measured {
    /// The dearest setting, against which all others are compared.
    pub fn safest(&self) -> Option<&Entry> {
        self.entries.first()
    }

    /// The fastest setting with an RMSE of at most `e`; of those that take no more than a twentieth longer,
    /// which no clock tells apart, the most exact. `None` where there is none.
    pub fn fastest_below(&self, e: f64) -> Option<&Entry> {
        let right = || self.entries.iter().filter(|entry| entry.off.rmse <= e);
        let fastest = right().map(|entry| entry.seconds).fold(f64::INFINITY, f64::min);
        // of two that are as exact the safer one is the earlier one
        right()
            .filter(|entry| entry.seconds <= 1.05 * fastest)
            .min_by(|a, b| a.off.rmse.total_cmp(&b.off.rmse))
    }
}

/// How much is measured of a scene.
#[derive(Clone, Copy, Debug)]
struct Effort {
    /// Whose errors are found.
    pixels: usize,
    /// One of so many of them is timed.
    one_of: usize,
    /// There are more rounds than the fewest within this.
    allowed: Duration,
}

/// Measures in the chapter's own scenes, or in the file that is asked for; on one thread, whatever is asked.
///
/// [`Error::Request`] where a scene is asked for that there is not, or a file is none; [`Error::Failed`]
/// where a thread with a stack for its depth cannot be had.
pub fn measure(ask: &TradeAsk) -> Result<Vec<Measured>, Error> {
    let own = asked_for(ask, SCENES.to_vec(), |scene| scene.name)?;
    let files: Vec<(String, String, Option<String>, scene_file::Scene)> = match &ask.scene {
        Some(path) => {
            let (name, shown) = scenes::file_named(path);
            vec![(name, shown.clone(), Some(shown), read(Some(path))?)]
        }
        None => {
            let own = own.iter().map(|it| {
                let path = (it.name != SCENES[0].name).then(|| it.path.to_string());
                Ok((it.name.to_string(), it.what.to_string(), path, it.file()?))
            });
            own.collect::<Result<_, Error>>()?
        }
    };
    let share = 40.0 / files.len().max(1) as f64;
    // a quick look takes as long at a scene whether it is asked for alone or with all others
    let (pixels, one_of, seconds) = if ask.quick { (60, 2, 0.3) } else { (1200, 3, share) };
    let effort = Effort {
        pixels: ask.cases.unwrap_or(pixels).max(1),
        one_of,
        allowed: Duration::from_secs_f64(seconds),
    };
    let progress = Progress::new(files.len() as u64);
    let mut all = Vec::new();
    for (name, what, path, file) in files {
        progress.starts(name.clone());
        let stack = render::stack_to(file.max_depth);
        let measured = render::with_stack(stack, || in_scene(name, what, &file, ask, effort))??;
        all.push(Measured { path, ..measured });
        progress.done();
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
    let (depth, size) = (file.max_depth, file.camera.size.value);
    let pixels = pixels(&name, ask.seed, size, effort.pixels);
    let settings = settings(ask, depth);
    // a scene with numbers that f32 cannot hold is measured at f64 alone
    let double = traced::scenes::<f64>(file, &settings).map_err(fault)?;
    let single = traced::scenes::<f32>(file, &settings).ok();
    let double = Ready::of(&double);
    let single = single.as_ref().map(|scenes| Ready::of(scenes));
    let settings: Vec<Setting> = settings
        .into_iter()
        .filter(|setting| setting.precision == Precision::F64 || single.is_some())
        .collect();

    let exact = |samples| double.run(&Setting { samples, ..safest(depth) })(&pixels).0;
    let reference = exact(REFERENCE);
    let with_samples: Vec<(u32, Vec<Rgb>)> =
        Setting::SAMPLES.iter().map(|&samples| (samples, exact(samples))).collect();

    let runs: Vec<Run<'_>> = settings
        .iter()
        .map(|setting| match (setting.precision, &single) {
            (Precision::F32, Some(single)) => single.run(setting),
            _ => double.run(setting),
        })
        .collect();
    let found: Vec<(Counts, Off, Off)> = runs
        .iter()
        .zip(&settings)
        .map(|(run, setting)| {
            let (seen, counts) = run(&pixels);
            let alike = with_samples.iter().find(|(samples, _)| *samples == setting.samples);
            let alone = alike.map_or(Off::default(), |(_, exact)| Off::of(&seen, exact));
            (counts, Off::of(&seen, &reference), alone)
        })
        .collect();
    let timed: Vec<(u32, u32)> = pixels.iter().copied().step_by(effort.one_of).collect();
    let share = timed.len() as f64 / (f64::from(size.0) * f64::from(size.1));
    let seconds = time(&runs, &timed, effort.allowed).into_iter().map(|seconds| seconds / share);
    let seconds: Vec<f64> = seconds.collect();

    let points: Vec<(f64, f64)> =
        seconds.iter().zip(&found).map(|(seconds, (_, off, _))| (*seconds, off.rmse)).collect();
    let all = settings.into_iter().zip(seconds).zip(found).zip(lab::front(&points));
    let entry = |(((setting, seconds), (counts, off, alone)), on_front)| Entry {
        setting,
        seconds,
        counts,
        off,
        alone,
        on_front,
    };
    let entries = all.map(entry).collect();
    Ok(Measured { name, what, path: None, size, depth, pixels: pixels.len(), entries })
}

/// Pixels of the picture, none likelier than another, in the order in which a picture is traced.
fn pixels(name: &str, seed: u64, size: (u32, u32), count: usize) -> Vec<(u32, u32)> {
    let mut pixels = scenes::pixels(name, seed, size, count);
    pixels.sort_by_key(|&(col, row)| (row, col));
    pixels
}

#[cfg(test)]
mod tests;

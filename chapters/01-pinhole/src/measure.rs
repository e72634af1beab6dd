//! What f32 and f64 cost on a grid of pixels: points timed, and judged against their exact places.
//!
//! The three grids are not rivals. Each is another definition of where a pixel lies, and is judged by its
//! own.

use std::hint::black_box;

use lab::{Effort, Nanoseconds, Pass, Progress, Runner, Ulps, asked_for, oracle, time};
use math::{Grid, Real, Wide, Window};
use stage::{Error, Precision, TradeAsk};

/// A picture and its window.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene {
    /// Its name, for `--regime`.
    pub(crate) name: &'static str,
    /// What it is, in half a sentence.
    pub(crate) what: &'static str,
    /// Columns and rows.
    size: (u32, u32),
    /// Left, right, bottom, top.
    window: [f64; 4],
}

/// The scenes, the ordinary one first. No width or height in pixels is a power of two: divided by that, nothing is
/// rounded.
pub(crate) const SCENES: [Scene; 6] = [
    Scene {
        name: "picture",
        what: "640 × 480 pixels, a window of ±1 by ±0.75",
        size: (640, 480),
        window: [-1.0, 1.0, -0.75, 0.75],
    },
    Scene {
        name: "off-axis",
        what: "640 × 480 pixels, a window from 100 left of the axis to 999 right of it",
        size: (640, 480),
        window: [-100.0, 999.0, -50.0, 774.0],
    },
    Scene {
        name: "tiny",
        what: "640 × 480 pixels, a window of ±1e-30",
        size: (640, 480),
        window: [-1e-30, 1e-30, -0.75e-30, 0.75e-30],
    },
    Scene {
        name: "poster",
        what: "16000 × 16000 pixels, almost the most there are, a window of ±1",
        size: (16_000, 16_000),
        window: [-1.0, 1.0, -1.0, 1.0],
    },
    Scene {
        name: "strip",
        what: "16 million columns, about as many as f32 can count, and 16 rows, a window of ±1 by ±1e-6",
        size: (16_000_000, 16),
        window: [-1.0, 1.0, -1e-6, 1e-6],
    },
    Scene {
        name: "shifted-1e6",
        what: "the picture's window, moved 1e6 to the right and up",
        size: (640, 480),
        window: [999_999.0, 1_000_001.0, 999_999.25, 1_000_000.75],
    },
];

/// What was measured in a scene.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    pub(crate) scene: Scene,
    pub(crate) entries: Vec<Entry>,
}

/// One grid at one precision.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) grid: Grid,
    pub(crate) precision: Precision,
    /// Nanoseconds a point.
    pub(crate) ns: Nanoseconds,
    pub(crate) off: Off,
    /// No other is at least as fast and as accurate, and better in one of the two.
    pub(crate) on_front: bool,
}

/// How far points are off.
#[derive(Clone, Debug, Default)]
pub(crate) struct Off {
    /// How many points.
    pub(crate) points: u64,
    /// How many lie nearer to the place of another pixel.
    pub(crate) lost: u64,
    /// The errors of x and of y.
    pub(crate) ulps: Ulps,
    /// The sum over the points of how far they are off, in pixels; more than one counts as one.
    sum: f64,
    /// The farthest that one is off, in pixels.
    pub(crate) worst: f64,
}

impl Off {
    /// How far points are off on average, in pixels; more than one counts as one.
    pub(crate) fn mean(&self) -> f64 {
        self.sum / self.points.max(1) as f64
    }

    /// Counts a point that is so many pixels off.
    fn count(&mut self, pixels: f64) {
        self.points += 1;
        self.lost += u64::from(pixels > 0.5);
        self.sum += pixels.min(1.0);
        self.worst = self.worst.max(pixels);
    }
}

/// Measures the grids in the scenes.
///
/// [`Error::Request`] where a scene is asked for that there is not.
pub(crate) fn measure(ask: &TradeAsk) -> Result<Vec<Measured>, Error> {
    let scenes = asked_for(ask, SCENES.to_vec(), |scene| scene.name)?;
    let effort = Effort::of(ask, scenes.len());
    let progress = Progress::new(scenes.len() as u64);
    let measure = |scene: Scene| {
        progress.starts(scene.name);
        let measured = Measured { scene, entries: scene.measure(ask, effort) };
        progress.done();
        measured
    };
    Ok(scenes.into_iter().map(measure).collect())
}

impl Scene {
    fn measure(&self, ask: &TradeAsk, effort: Effort) -> Vec<Entry> {
        let grids = Grid::ALL.into_iter().enumerate().filter(|(place, _)| ask.wants_method(*place));
        let grids: Vec<Grid> = grids.map(|(_, grid)| grid).collect();
        let mut wanted = Vec::new();
        for precision in Precision::ALL.into_iter().filter(|it| ask.wants_precision(*it)) {
            wanted.extend(grids.iter().map(|&grid| (grid, precision)));
        }
        let mut runners: Vec<Runner<'_>> = wanted
            .iter()
            .map(|&(grid, precision)| match precision {
                Precision::F32 => self.runner::<f32>(grid, self.pixels(ask.seed, effort.timed)),
                Precision::F64 => self.runner::<f64>(grid, self.pixels(ask.seed, effort.timed)),
            })
            .collect();
        let times = time(&mut runners, Pass::Throughput, effort.timed, effort.rounds, effort.allowed);
        let pixels = self.pixels(ask.seed, effort.cases);
        let offs: Vec<Off> = wanted
            .iter()
            .map(|&(grid, precision)| match precision {
                Precision::F32 => self.judge::<f32>(grid, &pixels, precision),
                Precision::F64 => self.judge::<f64>(grid, &pixels, precision),
            })
            .collect();
        let points: Vec<(f64, f64)> =
            times.iter().zip(&offs).map(|(ns, off)| (ns.median, off.mean())).collect();
        let measured = wanted.into_iter().zip(times).zip(offs).zip(lab::front(&points));
        let entry = |((((grid, precision), ns), off), on_front)| Entry { grid, precision, ns, off, on_front };
        measured.map(entry).collect()
    }

    /// Pixels of the picture, none likelier than another.
    fn pixels(&self, seed: u64, count: usize) -> Vec<(u32, u32)> {
        lab::scenes::pixels(self.name, seed, self.size, count)
    }

    /// The window in a precision.
    fn window<R: Real>(&self) -> Window<R> {
        let [left, right, bottom, top] = self.window.map(R::round_from);
        Window { left, right, bottom, top }
    }

    /// The function of the stage's `eval`, to be timed over these pixels.
    fn runner<R: Real>(&self, grid: Grid, pixels: Vec<(u32, u32)>) -> Runner<'static> {
        let (window, size) = (self.window::<R>(), self.size);
        Box::new(move |_, count| {
            let (window, size) = black_box((window, size));
            let pixels = &pixels[..count.min(pixels.len())];
            for &pixel in pixels {
                black_box(grid.point(&window, size, pixel).ok());
            }
            pixels.len()
        })
    }

    /// The points of these pixels against their exact places, in the window as it is in R.
    fn judge<R: Real>(&self, grid: Grid, pixels: &[(u32, u32)], precision: Precision) -> Off {
        let window = self.window::<R>();
        let [left, right, bottom, top] =
            [window.left, window.right, window.bottom, window.top].map(Into::<f64>::into);
        let exact_window = Window { left, right, bottom, top };
        let last = if grid == Grid::Edges { 1 } else { 0 };
        let step = |from: f64, to: f64, count: u32| {
            (Wide::from(to) - Wide::from(from)) / Wide::from(f64::from(count - last))
        };
        let steps = [step(left, right, self.size.0), step(bottom, top, self.size.1)];
        let mut off = Off::default();
        for &pixel in pixels {
            let Ok((x, y)) = grid.point(&window, self.size, pixel) else { continue };
            let point: [f64; 2] = [x, y].map(Into::into);
            let places = oracle::pixel(grid, &exact_window, self.size, pixel, precision);
            let mut farthest: f64 = 0.0;
            for ((x, place), step) in point.into_iter().zip(&places).zip(steps) {
                off.ulps.count(lab::ulps(x, place.nearest, precision));
                farthest = farthest.max(((Wide::from(x) - place.fine) / step).to_f64().abs());
            }
            off.count(farthest);
        }
        off
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(grid: Grid, scene: &str, precision: Precision) -> Off {
        let scene = SCENES.iter().find(|it| it.name == scene).unwrap();
        let pixels = scene.pixels(1, 500);
        match precision {
            Precision::F32 => scene.judge::<f32>(grid, &pixels, precision),
            Precision::F64 => scene.judge::<f64>(grid, &pixels, precision),
        }
    }

    #[test]
    fn what_f32_and_f64_are_good_for() {
        for grid in Grid::ALL {
            for scene in SCENES {
                let off = judged(grid, scene.name, Precision::F64);
                assert!(off.points == 500 && off.worst < 1e-5, "{grid:?} {}: {off:?}", scene.name);
            }
            for (scene, least, most) in [
                // 640 columns, and a few roundings of 2^-24 to a coordinate
                ("picture", 1e-6, 1e-3),
                ("off-axis", 1e-6, 1e-3),
                ("tiny", 1e-6, 1e-3),
                // 16000 of them
                ("poster", 1e-4, 1e-2),
                // numbers about 1e6 are 1/16 apart: a window 2 wide has 32 of them, for 640 pixels
                ("shifted-1e6", 9.0, 21.0),
            ] {
                let off = judged(grid, scene, Precision::F32);
                assert!((least..most).contains(&off.worst), "{grid:?} {scene}: {off:?}");
            }
            // col + ½ is no f32 above 2^23 columns; col is one, and x is not
            let least = if grid == Grid::Centers { 0.49 } else { 0.2 };
            assert!(judged(grid, "strip", Precision::F32).worst > least, "{grid:?}");
        }
    }

    #[test]
    fn a_point_in_the_next_pixel_is_lost() {
        let mut off = Off::default();
        [0.25, 0.5, 0.75, 12.0].into_iter().for_each(|pixels| off.count(pixels));
        // by hand: (1/4 + 1/2 + 3/4 + 1) / 4
        assert_eq!((off.points, off.lost, off.mean(), off.worst), (4, 2, 0.625, 12.0));
    }
}

//! The picture: how many tests each pixel cost.

use math::Real;
use signature::Scene;
use stage::{Anchor, Canvas, Color, Error, Ids, Pen, each_pixel};

use crate::{Bounded, Counts};

/// What each pixel cost and what it sees.
pub(crate) struct Cost {
    size: (u32, u32),
    /// Row by row from the top.
    pixels: Vec<Pixel>,
}

/// One pixel.
#[derive(Clone, Copy, Default)]
pub(crate) struct Pixel {
    pub(crate) counts: Counts,
    /// The place of the object that it sees.
    object: Option<u32>,
}

impl Cost {
    /// Asks every pixel. [`Error::Failed`] where the memory for a picture cannot be had.
    pub(crate) fn of<R: Real>(bounded: &Bounded<'_, R>, size: (u32, u32)) -> Result<Cost, Error> {
        let pixels = each_pixel(size, |col, row| {
            let mut counts = Counts::default();
            let first = bounded.seen((col, row), &mut counts);
            Pixel { counts, object: first.map(|first| first.object as u32) }
        })?;
        Ok(Cost { size, pixels })
    }

    /// How many pixels there are.
    pub(crate) fn pixels(&self) -> u64 {
        self.pixels.len() as u64
    }

    /// All counts together.
    pub(crate) fn total(&self) -> Counts {
        let mut total = Counts::default();
        for Pixel { counts, .. } in &self.pixels {
            total.boxes += counts.boxes;
            total.tests += counts.tests;
            total.hits += counts.hits;
        }
        total
    }

    /// The counts of the pixel that cost most, and where it is.
    pub(crate) fn dearest(&self) -> (Counts, (u32, u32)) {
        let dearest =
            (0..self.pixels.len()).max_by_key(|&at| (tests(&self.pixels[at]), std::cmp::Reverse(at)));
        let at = dearest.unwrap_or(0);
        let width = self.size.0 as usize;
        (self.pixels[at].counts, ((at % width) as u32, (at / width) as u32))
    }

    /// How many pixels see something.
    pub(crate) fn seeing(&self) -> u64 {
        self.pixels.iter().filter(|pixel| pixel.object.is_some()).count() as u64
    }

    /// The ids of the objects that are seen.
    pub(crate) fn ids<R: Real>(&self, scene: &Scene<R>) -> Ids {
        let id = |pixel: &Pixel| pixel.object.map(|object| scene.objects[object as usize].id);
        Ids::new(self.size, self.pixels.iter().map(id))
    }
}

/// What a pixel cost: tests of bounds and of objects.
fn tests(pixel: &Pixel) -> u64 {
    pixel.counts.boxes + pixel.counts.tests
}

/// Stations of the color scale, which is even from dark to bright and told apart without red and green: each
/// twice as bright to the eye as the last, from black over blue, violet and orange to pale yellow.
const SCALE: [[u8; 3]; 6] =
    [[8, 8, 16], [46, 30, 110], [132, 38, 120], [213, 70, 80], [250, 150, 50], [252, 250, 170]];

/// The color of a share from 0 to 1.
fn color(share: f64) -> Color {
    let place = share.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let station = (place as usize).min(SCALE.len() - 2);
    let between = place - station as f64;
    let mixed = |channel: usize| {
        let [a, b] = [SCALE[station], SCALE[station + 1]].map(|color| f64::from(color[channel]));
        (a + (b - a) * between).round() as u8
    };
    Color([0, 1, 2].map(mixed))
}

/// Every pixel by its tests against the dearest pixel's, a scale of colors, and a ring around the pixel that
/// is explained.
pub(crate) fn draw(cost: &Cost, pixel: (u32, u32)) -> Result<Canvas, Error> {
    let most = cost.pixels.iter().map(tests).max().unwrap_or(0).max(1);
    let mut canvas = Canvas::new(cost.size, Color::BLACK)?;
    let width = cost.size.0 as usize;
    canvas.shade(|col, row| {
        color(tests(&cost.pixels[row as usize * width + col as usize]) as f64 / most as f64)
    });
    canvas.fit(cost.size.0 as f32, cost.size.1 as f32);
    let at = (pixel.0 as f32 + 0.5, pixel.1 as f32 + 0.5);
    canvas.circle(at, 6.0, Pen::solid(Color::BLACK, 4.0));
    canvas.circle(at, 6.0, Pen::solid(Color::WHITE, 1.5));
    if cost.size.0 >= 240 && cost.size.1 >= 120 {
        scale(&mut canvas, cost.size, most);
    }
    Ok(canvas)
}

/// The scale of colors in the lower left corner, from no test to the most.
fn scale(canvas: &mut Canvas, (_, height): (u32, u32), most: u64) {
    let (left, bottom, length, thick) = (12.0, height as f32 - 14.0, 160.0, 10.0);
    canvas.rectangle((left - 4.0, bottom - 30.0), (left + length + 4.0, bottom + 6.0), Color::BLACK, 0.7);
    for step in 0..160 {
        let (x, share) = (left + step as f32, f64::from(step) / 159.0);
        canvas.rectangle((x, bottom - thick), (x + 1.0, bottom), color(share), 1.0);
    }
    let mut say = |x, anchor, text: &str| canvas.label((x, bottom - 15.0), anchor, 12.0, Color::WHITE, text);
    say(left, Anchor::Left, "0 bounds and objects");
    say(left + length, Anchor::Right, &most.to_string());
}

//! A picture by the local model alone: a ray of the eye a sample, and a second ray to each light.

use bounds::{Counts, Query};
use math::{Ray3, Real, Span};
use stage::{Error, Tile, Workers, tiled};

use crate::shadow::LastBlockers;
use crate::{Fate, Landing, Lighting, Point, Rgb};

/// What one pixel sees, term by term; with more samples, their means.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Seen {
    /// E, all of it.
    pub(crate) e: Rgb,
    /// r_a I_a C
    pub(crate) ambient: Rgb,
    /// Σ V r_d I C max(0, n⃗·s⃗)
    pub(crate) diffuse: Rgb,
    /// Σ V r_s I max(0, c⃗·m⃗)^α
    pub(crate) specular: Rgb,
    /// The light that arrives if it is seen: Σ V I, cut at each light's own brightness.
    pub(crate) lit: Rgb,
}

/// What was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Work {
    /// Rays of the eye.
    pub(crate) eye_rays: u64,
    /// Those that hit something.
    pub(crate) hits: u64,
    /// Rays to lights.
    pub(crate) shadow_rays: u64,
    /// Those that something blocks.
    pub(crate) blocked: u64,
    /// What the rays of the eye tested.
    pub(crate) of_eye: Counts,
    /// What the rays to lights tested.
    pub(crate) of_shadows: Counts,
}

impl Work {
    fn add(&mut self, other: &Work) {
        self.eye_rays += other.eye_rays;
        self.hits += other.hits;
        self.shadow_rays += other.shadow_rays;
        self.blocked += other.blocked;
        for (counts, more) in [(&mut self.of_eye, other.of_eye), (&mut self.of_shadows, other.of_shadows)] {
            counts.boxes += more.boxes;
            counts.tests += more.tests;
            counts.hits += more.hits;
        }
    }
}

/// A whole picture, and what is kept of each pixel.
#[derive(Clone, Debug)]
pub(crate) struct Rendered<T> {
    pub(crate) size: (u32, u32),
    /// Row by row from the top.
    pub(crate) pixels: Vec<T>,
    pub(crate) work: Work,
}

impl<T> Rendered<T> {
    /// What is kept of a pixel of it.
    pub(crate) fn at(&self, (col, row): (u32, u32)) -> &T {
        &self.pixels[row as usize * self.size.0 as usize + col as usize]
    }
}

/// Renders a picture of the scene's own size, `samples` × `samples` rays a pixel. All terms of a pixel take
/// more memory than its colors: `keeps` says what is kept of them.
///
/// [`Error::Failed`] where the memory for it or a thread cannot be had.
pub(crate) fn render<R: Real, T: Clone + Default + Send>(
    lighting: &Lighting<'_, R>,
    samples: u32,
    threads: Option<usize>,
    keeps: impl Fn(&Seen) -> T + Sync,
) -> Result<Rendered<T>, Error> {
    // nothing here recurses: a thread's usual stack
    let workers = Workers { threads, stack: 1 << 20, progress: Some("shading") };
    let size = lighting.scene.geometry.size;
    let mut work = Work::default();
    let one_tile = |tile: &Tile, values: &mut [T]| {
        let mut work = Work::default();
        let pixels = tile.rows.clone().flat_map(|row| tile.cols.clone().map(move |col| (col, row)));
        for (value, pixel) in values.iter_mut().zip(pixels) {
            *value = keeps(&lighting.pixel(pixel, samples, &mut work));
        }
        work
    };
    let pixels = tiled(size, &workers, one_tile, |more: Work| work.add(&more))?;
    Ok(Rendered { size, pixels, work })
}

impl<R: Real> Lighting<'_, R> {
    /// The rays of a pixel, `samples` × `samples`, row by row.
    pub(crate) fn rays(&self, pixel: (u32, u32), samples: u32) -> impl Iterator<Item = Ray3<R>> {
        let across = move |place: u32| R::round_from((f64::from(place) + 0.5) / f64::from(samples));
        let geometry = &self.scene.geometry;
        let places = (0..samples).flat_map(move |j| (0..samples).map(move |i| (i, j)));
        places.map(move |(i, j)| geometry.ray_within(pixel, (across(i), across(j))))
    }

    /// Where a ray of the eye lands, ready to be lit; `None` where it hits nothing, or too far away to say where.
    pub(crate) fn landed(&self, ray: &Ray3<R>, counts: &mut Counts) -> Option<Landed<R>> {
        let query = Query::new(*ray, Span::ahead());
        let has_texture = |object: usize| self.scene.painted[object].texture.is_some();
        let landing = Landing::of(self.bounded, &query, counts, has_texture)?;
        Some(Landed { landing, point: self.point(ray.direction, landing) })
    }

    /// What a pixel sees: the mean over its rays.
    pub(crate) fn pixel(&self, pixel: (u32, u32), samples: u32, work: &mut Work) -> Seen {
        let mut sum = Seen::default();
        for ray in self.rays(pixel, samples) {
            let seen = self.sample(&ray, work);
            sum.e += seen.e;
            sum.ambient += seen.ambient;
            sum.diffuse += seen.diffuse;
            sum.specular += seen.specular;
            sum.lit += seen.lit;
        }
        let count = f64::from(samples) * f64::from(samples);
        let mean = |sum: Rgb| Rgb(sum.0.map(|channel| channel / count));
        Seen {
            e: mean(sum.e),
            ambient: mean(sum.ambient),
            diffuse: mean(sum.diffuse),
            specular: mean(sum.specular),
            lit: mean(sum.lit),
        }
    }

    fn sample(&self, ray: &Ray3<R>, work: &mut Work) -> Seen {
        work.eye_rays += 1;
        let background = Seen { e: self.scene.background, ..Seen::default() };
        let Some(Landed { landing, point }) = self.landed(ray, &mut work.of_eye) else { return background };
        work.hits += 1;
        let Some(point) = point else {
            let ambient = self.ambient(landing.object, self.color(&landing));
            return Seen { e: ambient, ambient, ..Seen::default() };
        };
        let mut seen = Seen { ambient: self.ambient(landing.object, point.color), ..Seen::default() };
        let (mut shadow_rays, mut blocked) = (0, 0);
        seen.e = self.local(&point, &mut LastBlockers::default(), &mut work.of_shadows, |light, fate| {
            shadow_rays += u64::from(matches!(fate, Fate::Seen(_) | Fate::Shadowed(_)));
            blocked += u64::from(matches!(fate, Fate::Shadowed(_)));
            if let Fate::Seen(phong) = fate {
                seen.diffuse += phong.diffuse;
                seen.specular += phong.specular;
                seen.lit += self.scene.lights[light].intensity;
            }
        });
        work.shadow_rays += shadow_rays;
        work.blocked += blocked;
        seen
    }
}

/// Where a ray of the eye lands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Landed<R: Real> {
    pub(crate) landing: Landing<R>,
    /// `None` where the point is too far away to be a number.
    pub(crate) point: Option<Point<R>>,
}

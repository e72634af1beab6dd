//! Which pixels are traced in both precisions, and where in them.
//!
//! Where the precisions see something else they do so beside an edge: of an object, a shadow, a square of a
//! checker, or of where light is reflected totally. There f32 puts the edge elsewhere, by a small part of a
//! pixel, and few pixels have their middle in between: too few to be met by chance. So where a drawn pixel
//! and the one to its right, or below it, see by rays that go other ways, the edge between their middles is
//! found by halving, in both precisions.

use lab::Draw;
use math::wide::scaled;
use shading::Rgb;
use stage::{Error, Precision};

use super::rays::Rays;

/// Fields of the picture across and down; from each a pixel is drawn.
const FIELDS: u32 = 96;
/// A picture of no more pixels is traced as a whole: two for each field.
const SMALL: u64 = 2 * (FIELDS as u64) * (FIELDS as u64);
/// So often the way to an edge is halved: as often as f32 has digits.
const HALVINGS: i32 = f32::MANTISSA_DIGITS as i32;
/// Any number: which pixels are drawn follows from it.
const SEED: u64 = 11;

/// A column and a row.
pub(super) type Pixel = (u32, u32);

/// What is traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    /// A pixel with all rays that the picture has for it.
    Pixel(Pixel),
    /// A point of the picture: a pixel, and how far to the right of its left border and below its top, in
    /// pixels.
    Point(Pixel, [f64; 2]),
}

/// What a place sees.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Seen {
    pub(super) e: Rgb,
    pub(super) rays: Rays,
}

/// Traces places.
pub(super) type SeenIn<'a> = dyn Fn(&[Place]) -> Result<Vec<Seen>, Error> + 'a;

/// Some places, and what they see.
#[derive(Clone, Debug, Default)]
pub(super) struct Sample {
    pub(super) places: Vec<Place>,
    pub(super) seen: Vec<Seen>,
}

impl Sample {
    fn new(places: Vec<Place>, seen: &SeenIn) -> Result<Sample, Error> {
        Ok(Sample { seen: seen(&places)?, places })
    }
}

/// Whether a picture is traced as a whole.
pub(super) fn is_small((width, height): (u32, u32)) -> bool {
    u64::from(width) * u64::from(height) <= SMALL
}

/// An edge on the way from a pixel's middle to that of the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) pixel: Pixel,
    /// The way: 0 across, 1 down.
    pub(super) way: usize,
    /// How far it is to the edge, or a little less, in pixels.
    pub(super) at: f64,
    /// What is seen before and beyond it.
    pub(super) sides: [Seen; 2],
}

/// A point on the way across or down from a pixel's middle, so many pixels away.
fn on_the_way(pixel: Pixel, way: usize, at: f64) -> Place {
    let mut point = [0.5; 2];
    point[way] += at;
    Place::Point(pixel, point)
}

/// The pixels that are drawn, and the edges right of their middles and below, not yet found. Of a small
/// picture all pixels and no edge.
///
/// What `seen` returns as an error.
pub(super) fn sample(size: (u32, u32), seen: &SeenIn) -> Result<(Sample, Vec<Edge>), Error> {
    if is_small(size) {
        let all = (0..size.1).flat_map(|row| (0..size.0).map(move |col| Place::Pixel((col, row))));
        return Ok((Sample::new(all.collect(), seen)?, Vec::new()));
    }
    let pixels = drawn(size);
    let middles = seen(&pixels.iter().map(|&pixel| on_the_way(pixel, 0, 0.0)).collect::<Vec<_>>())?;
    let mut edges = Vec::new();
    for way in [0, 1] {
        let next = seen(&pixels.iter().map(|&pixel| on_the_way(pixel, way, 1.0)).collect::<Vec<_>>())?;
        let pairs = pixels.iter().zip(middles.iter().zip(next));
        let pairs = pairs.filter(|(_, (middle, next))| middle.rays.all != next.rays.all);
        edges.extend(pairs.map(|(&pixel, (&middle, next))| Edge {
            pixel,
            way,
            at: 0.0,
            sides: [middle, next],
        }));
    }
    Ok((Sample::new(pixels.into_iter().map(Place::Pixel).collect(), seen)?, edges))
}

/// The edges, found by halving: what is seen as from the middle is before them.
///
/// What `seen` returns as an error.
pub(super) fn halved(edges: &[Edge], seen: &SeenIn) -> Result<Vec<Edge>, Error> {
    let mut found = edges.to_vec();
    for step in 1..=HALVINGS {
        let half = scaled(1.0, -step);
        let place = |edge: &Edge| on_the_way(edge.pixel, edge.way, edge.at + half);
        let places: Vec<Place> = found.iter().map(place).collect();
        for (edge, seen) in found.iter_mut().zip(seen(&places)?) {
            let is_before = seen.rays.all == edge.sides[0].rays.all;
            edge.at += if is_before { half } else { 0.0 };
            edge.sides[usize::from(!is_before)] = seen;
        }
    }
    Ok(found)
}

/// A pixel from each field, row by row.
pub(super) fn drawn((width, height): (u32, u32)) -> Vec<Pixel> {
    let mut draw = Draw::new(SEED, "auto", Precision::F64);
    let mut within = |field: u32, fields: u32, size: u32| {
        let edge = |field: u32| (u64::from(field) * u64::from(size) / u64::from(fields)) as u32;
        let (from, to) = (edge(field), edge(field + 1));
        from + draw.below(u64::from(to - from)) as u32
    };
    let (across, down) = (width.min(FIELDS), height.min(FIELDS));
    let fields = (0..down).flat_map(|row| (0..across).map(move |col| (col, row)));
    fields.map(|(col, row)| (within(col, across, width), within(row, down, height))).collect()
}

//! Which pixels are traced in both precisions, and where in them.
//!
//! Where the precisions see something else they do so beside an edge: of an object, a shadow, a square of a checker, or of
//! where light is reflected totally. There f32 puts the edge elsewhere, by a small part of a pixel, and few pixels have their
//! middle in between: too few to be met by chance. So where a drawn pixel and the one to its right see by rays that go other
//! ways, the edge between them is found by halving, in both precisions.

use lab::Draw;
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

/// A point of the picture: a pixel, and how far to the right of its left border, in pixels.
pub(super) type Place = (Pixel, f64);

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

/// An edge right of a pixel's middle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pixel: Pixel,
    /// Not farther to the right than the edge, in pixels from the left border.
    pub(super) at: f64,
    /// What is seen left and right of it.
    pub(super) sides: [Seen; 2],
}

/// The middles of the pixels that are drawn, and the edges right of them, not yet found. Of a small picture all pixels and no
/// edge.
///
/// What `seen` returns as an error.
pub(super) fn sample(size: (u32, u32), seen: &SeenIn) -> Result<(Sample, Vec<Edge>), Error> {
    let middles = |pixels: Vec<Pixel>| pixels.into_iter().map(|pixel| (pixel, 0.5)).collect();
    if is_small(size) {
        let all = (0..size.1).flat_map(|row| (0..size.0).map(move |col| (col, row))).collect();
        return Ok((Sample::new(middles(all), seen)?, Vec::new()));
    }
    let drawn = Sample::new(middles(drawn(size)), seen)?;
    let right = Sample::new(drawn.places.iter().map(|&(pixel, at)| (pixel, at + 1.0)).collect(), seen)?;
    let pairs = drawn.places.iter().zip(drawn.seen.iter().zip(&right.seen));
    let pairs = pairs.filter(|(_, (left, right))| left.rays.all != right.rays.all);
    let edges = pairs.map(|(&(pixel, at), (&left, &right))| Edge { pixel, at, sides: [left, right] });
    let edges = edges.collect();
    Ok((drawn, edges))
}

/// The edges, found by halving: what is seen as on the left is left of them.
///
/// What `seen` returns as an error.
pub(super) fn halved(edges: &[Edge], seen: &SeenIn) -> Result<Vec<Edge>, Error> {
    let mut found = edges.to_vec();
    for step in 1..=HALVINGS {
        let half = 0.5_f64.powi(step);
        let places: Vec<Place> = found.iter().map(|edge| (edge.pixel, edge.at + half)).collect();
        for (edge, seen) in found.iter_mut().zip(seen(&places)?) {
            let is_left = seen.rays.all == edge.sides[0].rays.all;
            edge.at += if is_left { half } else { 0.0 };
            edge.sides[usize::from(!is_left)] = seen;
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

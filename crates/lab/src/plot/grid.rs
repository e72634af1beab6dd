//! What stands behind the marks of a panel: the lines of its axes with their numbers.

use stage::Anchor;

use super::axis::{LogAxis, decade, decimal, log10};
use super::extent::Extent;
use super::legend::ROUNDOFF;
use super::palette::{DIM, GRID};
use super::pen::{Letters, Stroke};
use super::svg::Svg;

/// What rounding once costs: half an ulp of 1, for `f32` and `f64`.
pub(super) const HALF_ULPS: [f64; 2] = [f32::EPSILON as f64 / 2.0, f64::EPSILON / 2.0];

/// Draws the grid within a frame.
pub(super) fn grid(svg: &mut Svg, frame: Extent, ns: &LogAxis, error: &LogAxis) {
    let numbers = Letters::new(12.0, DIM);
    // exact answers have a row of their own
    let zero = error.places.0;
    svg.rectangle((frame.left, zero - 9.0), (frame.right, frame.bottom), GRID, 0.6);
    for (time, is_decade) in times(ns.ends) {
        let x = ns.at(time);
        svg.line((x, frame.top), (x, frame.bottom), Stroke::solid(GRID, if is_decade { 1.4 } else { 0.7 }));
        svg.line((x, frame.bottom), (x, frame.bottom + 4.0), Stroke::solid(DIM, 1.0));
        if (-3..5).contains(&decade(time)) {
            svg.text((x, frame.bottom + 17.0), numbers.at(Anchor::Middle), &time.to_string());
        } else if is_decade {
            svg.power_of_ten((x, frame.bottom + 17.0), numbers.at(Anchor::Middle), decade(time));
        }
    }
    for exponent in powers(error.ends) {
        let y = error.at_exponent(f64::from(exponent));
        svg.line((frame.left, y), (frame.right, y), Stroke::solid(GRID, 1.0));
        svg.line((frame.left - 4.0, y), (frame.left, y), Stroke::solid(DIM, 1.0));
        match exponent {
            0 => svg.text((frame.left - 7.0, y + 4.0), numbers.at(Anchor::Right), "1"),
            _ => svg.power_of_ten((frame.left - 7.0, y + 5.0), numbers.at(Anchor::Right), exponent),
        }
    }
    svg.text((frame.left - 7.0, zero + 4.0), numbers.bold(true).at(Anchor::Right), "0");
    for half_ulp in HALF_ULPS {
        svg.line((frame.left, error.at(half_ulp)), (frame.right, error.at(half_ulp)), ROUNDOFF);
    }
    let corners = [(frame.left, frame.top), (frame.left, frame.bottom), (frame.right, frame.bottom)];
    svg.polyline(&corners, Stroke::solid(DIM, 1.2));
    let middle = (frame.left + frame.right) / 2.0;
    svg.text((middle, frame.bottom + 35.0), Letters::new(13.0, DIM).at(Anchor::Middle), "ns per ray");
}

/// The times with a line: 1, 2 and 5 times the powers of ten, or only those where there are many.
fn times((low, high): (f64, f64)) -> Vec<(f64, bool)> {
    let digits: &[u32] = if high - low > 3.0 { &[1] } else { &[1, 2, 5] };
    let every = ((high - low) / 8.0).ceil().max(1.0) as i32;
    let decades = (low.floor() as i32..=high.ceil() as i32).filter(|exponent| exponent % every == 0);
    let times = decades.flat_map(|exponent| digits.iter().map(move |&digit| (digit, exponent)));
    let is_within = |exponent: f64| (low - 1e-9..=high + 1e-9).contains(&exponent);
    times
        .map(|(digit, exponent)| (decimal(digit, exponent), digit == 1))
        .filter(|&(time, _)| is_within(log10(time)))
        .collect()
}

/// The exponents with a line: every fourth one, or as many as there is room for; the lower end is left
/// to 0.
fn powers((low, _): (f64, f64)) -> Vec<i32> {
    let low = low as i32;
    let every = if low >= -20 { 4 } else { 8 * (-low / 48 + 1) };
    (0..).map(|i| -i * every).take_while(|&exponent| exponent > low).collect()
}

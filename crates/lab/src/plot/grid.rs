//! What stands behind the marks of a panel: the lines of its axes with their numbers.

use stage::Anchor;

use super::axis::{LogAxis, decade, decimal, log10};
use super::extent::Extent;
use super::legend::ROUNDOFF;
use super::palette::{DIM, GRID};
use super::pen::{Letters, Stroke};
use super::shared::Times;
use super::svg::Svg;
use super::trade::Words;

/// What rounding once costs: half an ulp of 1, for `f32` and `f64`.
pub(super) const HALF_ULPS: [f64; 2] = [f32::EPSILON as f64 / 2.0, f64::EPSILON / 2.0];
/// The numbers along the axes and their titles.
const NUMBER: f64 = 14.0;
/// How far the row of exact answers reaches above the end of its axis.
pub(super) const ZERO: f64 = 9.0;

/// Draws the grid within a frame.
pub(super) fn grid(svg: &mut Svg, frame: Extent, times: &Times, error: &LogAxis, words: Words) {
    let numbers = Letters::new(NUMBER, DIM);
    let right = times.band.map_or(frame.right, |band| band.0);
    // exact answers have a row of their own
    let zero = error.places.0;
    svg.rectangle((frame.left, zero - ZERO), (right, frame.bottom), GRID, 0.6);
    for (time, is_decade) in numbered(times.axis.ends) {
        let x = times.axis.at(time);
        svg.line((x, frame.top), (x, frame.bottom), Stroke::solid(GRID, if is_decade { 1.4 } else { 0.7 }));
        svg.line((x, frame.bottom), (x, frame.bottom + 4.0), Stroke::solid(DIM, 1.0));
        if (-3..5).contains(&decade(time)) {
            svg.text((x, frame.bottom + 18.0), numbers.at(Anchor::Middle), &time.to_string());
        } else if is_decade {
            svg.power_of_ten((x, frame.bottom + 18.0), numbers.at(Anchor::Middle), decade(time));
        }
    }
    for exponent in powers(error.ends) {
        let y = error.at_exponent(f64::from(exponent));
        svg.line((frame.left, y), (frame.right, y), Stroke::solid(GRID, 1.0));
        svg.line((frame.left - 4.0, y), (frame.left, y), Stroke::solid(DIM, 1.0));
        match exponent {
            // too close to the number 0, where a plot is low
            _ if zero - y < 0.8 * NUMBER => {}
            0 => svg.text((frame.left - 7.0, y + 4.0), numbers.at(Anchor::Right), "1"),
            _ => svg.power_of_ten((frame.left - 7.0, y + 5.0), numbers.at(Anchor::Right), exponent),
        }
    }
    svg.text((frame.left - 7.0, zero + 4.0), numbers.bold(true).at(Anchor::Right), "0");
    if let Some(band) = times.band {
        slower(svg, frame, band);
    }
    for half_ulp in HALF_ULPS.into_iter().filter(|_| words.rounds) {
        svg.line((frame.left, error.at(half_ulp)), (frame.right, error.at(half_ulp)), ROUNDOFF);
    }
    let corners = [(frame.left, frame.top), (frame.left, frame.bottom), (right, frame.bottom)];
    svg.polyline(&corners, Stroke::solid(DIM, 1.2));
    let middle = (frame.left + times.axis.places.1) / 2.0;
    let title = Letters::new(NUMBER, DIM).at(Anchor::Middle);
    svg.text((middle, frame.bottom + 37.0), title, &format!("ns per {}", words.unit));
}

/// The band of what is slower than the axis, which breaks off at two strokes.
fn slower(svg: &mut Svg, frame: Extent, (left, right): (f64, f64)) {
    svg.rectangle((left, frame.top), (frame.right, frame.bottom), GRID, 0.5);
    svg.line((left + 4.0, frame.bottom), (frame.right, frame.bottom), Stroke::solid(DIM, 1.2));
    for x in [left, left + 4.0] {
        let ends = ((x - 2.5, frame.bottom + 5.0), (x + 2.5, frame.bottom - 5.0));
        svg.line(ends.0, ends.1, Stroke::solid(DIM, 1.2));
    }
    let place = ((left + right) / 2.0 + 2.0, frame.bottom + 18.0);
    svg.text(place, Letters::new(NUMBER, DIM).at(Anchor::Middle), "slower");
}

/// The times with a line: 1, 2 and 5 times the powers of ten, or only those where there are many.
fn numbered((low, high): (f64, f64)) -> Vec<(f64, bool)> {
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

/// The exponents with a line: all of a few, else every fourth one, or as many as there is room for; the
/// lower end is left to 0.
fn powers((low, _): (f64, f64)) -> Vec<i32> {
    let low = low as i32;
    let every = match low {
        -8.. => 1,
        -20..-8 => 4,
        _ => 8 * (-low / 48 + 1),
    };
    (0..).map(|i| -i * every).take_while(|&exponent| exponent > low).collect()
}

//! One panel: the plot of a regime.

use stage::{Anchor, Color, Precision};

use super::axis::LogAxis;
use super::extent::Extent;
use super::front::staircase;
use super::grid::{HALF_ULPS, ZERO, grid};
use super::labels::{Line, Tag, place_labels};
use super::letters::{cut, width, wrapped};
use super::mark::{self, Look};
use super::palette::{self, DIM, INK};
use super::pen::{Letters, Stroke};
use super::shared::{Shared, Times};
use super::svg::{Point, Svg};
use super::trade::{Mark, Panel, Words};

/// Where a panel goes.
#[derive(Clone, Copy)]
pub(super) struct Room {
    /// Its top left.
    pub(super) corner: Point,
    /// Its width and height.
    pub(super) size: (f64, f64),
    /// How many lines all panels have for what their cases are.
    pub(super) lines: usize,
}

/// Room for the numbers at the left.
const LEFT: f64 = 50.0;
const RIGHT: f64 = 14.0;
/// Room for the numbers and the axis title below.
const FOOT: f64 = 56.0;
/// Marks at the ends of the axes keep off the frame, and their labels find room.
const SIDE: f64 = 12.0;
const TOP: f64 = 30.0;
const BOTTOM: f64 = 26.0;

const NAME: f64 = 18.0;
const WHAT: f64 = 13.0;
const LABEL: f64 = 13.0;

/// What the cases of a panel are, in at most two lines.
pub(super) fn what(panel: &Panel, width: f64) -> Vec<String> {
    wrapped(&panel.what, WHAT, width - LEFT - RIGHT, 2)
}

impl Room {
    /// Where the plot lies: below the name and what it means.
    fn frame(&self) -> Extent {
        let ((x, y), (width, height)) = (self.corner, self.size);
        let head = 28.0 + 16.0 * self.lines as f64;
        Extent { left: x + LEFT, top: y + head, right: x + width - RIGHT, bottom: y + height - FOOT }
    }

    /// The middle of the plot, for the title of the axis.
    pub(super) fn middle(&self) -> f64 {
        let frame = self.frame();
        (frame.top + frame.bottom) / 2.0
    }
}

/// Draws a panel.
pub(super) fn draw(svg: &mut Svg, panel: &Panel, shared: &Shared, room: Room) {
    let frame = room.frame();
    let plot = Extent {
        left: frame.left + SIDE,
        top: frame.top + TOP,
        right: frame.right - if shared.has_slower { 0.0 } else { SIDE },
        bottom: frame.bottom - BOTTOM,
    };
    let (times, error) = shared.axes(plot, &panel.marks);

    let y = room.corner.1;
    let name = cut(&panel.name, NAME, frame.width());
    svg.text((frame.left, y + 16.0), Letters::new(NAME, INK).bold(true), &name);
    for (i, line) in what(panel, room.size.0).iter().enumerate() {
        svg.text((frame.left, y + 34.0 + 16.0 * i as f64), Letters::new(WHAT, DIM), line);
    }
    grid(svg, frame, &times, &error, shared.words);
    let corners = staircase(&panel.marks);
    let corners: Vec<Point> = corners.iter().map(|&(t, e)| (times.at(t), error.at(e))).collect();
    let stairs = front(svg, frame, &corners);
    marks(svg, panel, shared, frame, (&times, &error), &stairs);
}

/// Draws the front and what it dominates; the corners of the line.
fn front(svg: &mut Svg, frame: Extent, corners: &[Point]) -> Vec<Point> {
    let (Some(first), Some(last)) = (corners.first(), corners.last()) else { return Vec::new() };
    let mut stairs = vec![(first.0, frame.top)];
    stairs.extend(corners);
    stairs.push((frame.right, last.1));
    let mut dominated = stairs.clone();
    dominated.push((frame.right, frame.top));
    svg.area(&dominated, INK, 0.05);
    svg.polyline(&stairs, mark::FRONT);
    stairs
}

fn marks(
    svg: &mut Svg,
    panel: &Panel,
    shared: &Shared,
    frame: Extent,
    (times, error): (&Times, &LogAxis),
    stairs: &[Point],
) {
    let look = |mark: &Mark| {
        let place = shared.methods.iter().position(|method| *method == mark.method).unwrap_or(0);
        let color = palette::of_method(place);
        Look { color, precision: mark.precision, is_wrong: mark.wrong > 0, on_front: mark.on_front }
    };
    let (mut placed, missing): (Vec<&Mark>, Vec<&Mark>) =
        panel.marks.iter().partition(|mark| mark.has_place());
    // the front on top
    placed.sort_by_key(|mark| mark.on_front);
    let text = |mark: &Mark| {
        let time = if times.is_slower(mark.ns) { " ".to_owned() + &duration(mark.ns) } else { String::new() };
        cut(&mark.method, LABEL, frame.width() / 2.0) + &time
    };
    // above the row of exact answers and the line close above it
    let zero = error.places.0 - ZERO;
    let stack = if shared.words.rounds { error.at(HALF_ULPS[1]).min(zero) } else { zero } - 1.0;
    let tag = |mark: &&Mark| {
        // bold letters are wider
        let width = width(&text(mark), LABEL) * if mark.on_front { 1.08 } else { 1.0 };
        Tag {
            at: (times.at(mark.ns), error.at(mark.error)),
            radius: look(mark).radius(),
            size: (width, LABEL + 2.0),
            stack: (mark.error == 0.0).then_some(stack),
        }
    };
    let tags: Vec<Tag> = placed.iter().map(tag).collect();
    let stairs = stairs.windows(2).map(|pair| Line { ends: (pair[0], pair[1]), cost: 90.0 });
    let half_ulps = HALF_ULPS.into_iter().filter(|_| shared.words.rounds).map(|half_ulp| error.at(half_ulp));
    let half_ulps = half_ulps.map(|y| Line { ends: ((frame.left, y), (frame.right, y)), cost: 16.0 });
    let lines: Vec<Line> = stairs.chain(half_ulps).collect();
    let labels = place_labels(&tags, frame.inset(3.0), &lines);
    for (mark, label) in placed.iter().zip(&labels) {
        if let Some((from, to)) = label.leader {
            let color = palette::as_text(look(mark).color);
            svg.line(from, to, Stroke { color, width: 0.9, opacity: 0.8, dash: "" });
        }
    }
    for (mark, tag) in placed.iter().zip(&tags) {
        svg.open_group(&tooltip(mark, shared.words));
        mark::draw(svg, tag.at, look(mark));
        svg.close_group();
    }
    for (mark, label) in placed.iter().zip(&labels) {
        let extent = label.extent;
        if lines.iter().any(|line| extent.is_crossed(line.ends)) {
            svg.rectangle((extent.left, extent.top), (extent.right, extent.bottom), Color::WHITE, 0.75);
        }
        let letters = Letters::new(LABEL, palette::as_text(look(mark).color)).bold(mark.on_front);
        let place = ((extent.left + extent.right) / 2.0, extent.bottom - 3.4);
        svg.text(place, letters.at(Anchor::Middle), &text(mark));
    }
    list(svg, &missing, shared, frame);
}

/// What cannot be placed is named at the top right, so that it is missed.
fn list(svg: &mut Svg, missing: &[&Mark], shared: &Shared, frame: Extent) {
    for (i, mark) in missing.iter().enumerate() {
        let text = format!("{} {}: no figure", mark.method, mark.precision.name());
        let place = (frame.right - 4.0, frame.top + 14.0 + 14.0 * i as f64);
        svg.open_group(&tooltip(mark, shared.words));
        svg.text(place, Letters::new(LABEL, DIM).at(Anchor::Right), &cut(&text, LABEL, frame.width()));
        svg.close_group();
    }
}

/// Nanoseconds to two digits, in the unit that they are read in.
fn duration(ns: f64) -> String {
    let units = [(1.0, "ns"), (1e3, "µs"), (1e6, "ms"), (1e9, "s")];
    let unit = units.into_iter().find(|unit| ns / unit.0 < 995.0).unwrap_or(units[3]);
    match ns / unit.0 {
        few @ ..9.95 => format!("{few:.1} {}", unit.1),
        many @ ..99.5 => format!("{many:.0} {}", unit.1),
        many @ ..1e4 => format!("{:.0} {}", 10.0 * (many / 10.0).round(), unit.1),
        many => format!("{many:.0e} {}", unit.1),
    }
}

/// All that is known of a mark.
fn tooltip(mark: &Mark, words: Words) -> String {
    let Mark { method, ns, error, wrong, cases, .. } = mark;
    let precision = match mark.precision {
        Precision::F32 => "f32",
        Precision::F64 => "f64",
    };
    let front = if mark.on_front { "; on the Pareto front" } else { "" };
    let Words { unit, wrong: is_wrong, .. } = words;
    format!("{method} {precision}: {ns} ns per {unit}, error {error:e}, {wrong} of {cases} {is_wrong}{front}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_told_in_two_digits() {
        let cases = [
            (0.04, "0.0 ns"),
            (9.94, "9.9 ns"),
            (9.96, "10 ns"),
            (148.0, "150 ns"),
            (994.0, "990 ns"),
            (996.0, "1.0 µs"),
            (5720.0, "5.7 µs"),
            (16_899.0, "17 µs"),
            (2.5e6, "2.5 ms"),
            (7e9, "7.0 s"),
            (7e19, "7e10 s"),
        ];
        for (ns, text) in cases {
            assert_eq!(duration(ns), text);
        }
    }
}

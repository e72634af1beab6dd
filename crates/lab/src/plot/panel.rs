//! One panel: the plot of a regime.

use stage::{Anchor, Color, Precision};

use super::axis::LogAxis;
use super::extent::Extent;
use super::front::staircase;
use super::grid::{HALF_ULPS, grid};
use super::labels::{Line, Tag, place_labels};
use super::letters::{cut, width, wrapped};
use super::mark::{self, Look};
use super::palette::{self, DIM, INK};
use super::pen::{Letters, Stroke};
use super::shared::Shared;
use super::svg::{Point, Svg};
use super::trade::{Mark, Panel};

/// Room for the name and what it means, above the plot.
const HEAD: f64 = 56.0;
/// Room for the numbers at the left.
const LEFT: f64 = 46.0;
const RIGHT: f64 = 16.0;
/// Room for the numbers and the axis title below.
const FOOT: f64 = 56.0;
/// Marks at the ends of the axes keep off the frame, and their labels find room.
const SIDE: f64 = 12.0;
const TOP: f64 = 20.0;
const BOTTOM: f64 = 24.0;
/// From the top of a panel to the middle of its plot, for the title of the axis.
pub(super) const PLOT_MIDDLE: f64 = 212.0;

const LABEL: f64 = 12.0;

/// Draws a panel of `size` = (width, height) from its top left corner.
pub(super) fn draw(svg: &mut Svg, panel: &Panel, shared: &Shared, (x, y): Point, size: (f64, f64)) {
    let frame =
        Extent { left: x + LEFT, top: y + HEAD, right: x + size.0 - RIGHT, bottom: y + size.1 - FOOT };
    let plot = Extent {
        left: frame.left + SIDE,
        top: frame.top + TOP,
        right: frame.right - SIDE,
        bottom: frame.bottom - BOTTOM,
    };
    let (ns, error) = shared.axes(plot);

    svg.text(
        (frame.left, y + 16.0),
        Letters::new(17.0, INK).bold(true),
        &cut(&panel.name, 17.0, frame.width()),
    );
    for (i, line) in wrapped(&panel.what, 12.5, frame.width(), 2).iter().enumerate() {
        svg.text((frame.left, y + 33.0 + 15.0 * i as f64), Letters::new(12.5, DIM), line);
    }
    grid(svg, frame, &ns, &error);
    let corners = staircase(&panel.marks);
    let corners: Vec<Point> = corners.iter().map(|&(t, e)| (ns.at(t), error.at(e))).collect();
    let stairs = front(svg, frame, &corners);
    marks(svg, panel, shared, frame, (&ns, &error), &stairs);
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
    (ns, error): (&LogAxis, &LogAxis),
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
    let tag = |mark: &&Mark| {
        let text = cut(&mark.method, LABEL, frame.width() / 2.0);
        // bold letters are wider
        let width = width(&text, LABEL) * if mark.on_front { 1.08 } else { 1.0 };
        Tag {
            at: (ns.at(mark.ns), error.at(mark.error)),
            radius: look(mark).radius(),
            size: (width, LABEL + 2.0),
        }
    };
    let tags: Vec<Tag> = placed.iter().map(tag).collect();
    let stairs = stairs.windows(2).map(|pair| Line { ends: (pair[0], pair[1]), cost: 45.0 });
    let half_ulps = HALF_ULPS.map(|half_ulp| error.at(half_ulp));
    let half_ulps = half_ulps.map(|y| Line { ends: ((frame.left, y), (frame.right, y)), cost: 9.0 });
    let lines: Vec<Line> = stairs.chain(half_ulps).collect();
    let labels = place_labels(&tags, frame.inset(3.0), &lines);
    for (mark, label) in placed.iter().zip(&labels) {
        if let Some((from, to)) = label.leader {
            let color = palette::as_text(look(mark).color);
            svg.line(from, to, Stroke { color, width: 0.9, opacity: 0.8, dash: "" });
        }
    }
    for (mark, tag) in placed.iter().zip(&tags) {
        svg.open_group(&tooltip(mark));
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
        svg.text(place, letters.at(Anchor::Middle), &cut(&mark.method, LABEL, frame.width() / 2.0));
    }
    list(svg, &missing, frame);
}

/// What cannot be placed is named at the top right, so that it is missed.
fn list(svg: &mut Svg, missing: &[&Mark], frame: Extent) {
    for (i, mark) in missing.iter().enumerate() {
        let text = format!("{} {}: no figure", mark.method, mark.precision.name());
        let place = (frame.right - 4.0, frame.top + 14.0 + 14.0 * i as f64);
        svg.open_group(&tooltip(mark));
        svg.text(place, Letters::new(LABEL, DIM).at(Anchor::Right), &cut(&text, LABEL, frame.width()));
        svg.close_group();
    }
}

/// All that is known of a mark.
fn tooltip(mark: &Mark) -> String {
    let Mark { method, ns, error, wrong, cases, .. } = mark;
    let precision = match mark.precision {
        Precision::F32 => "f32",
        Precision::F64 => "f64",
    };
    let front = if mark.on_front { "; on the Pareto front" } else { "" };
    format!(
        "{method} {precision}: {ns} ns per ray, error {error:e}, {wrong} of {cases} verdicts wrong{front}"
    )
}

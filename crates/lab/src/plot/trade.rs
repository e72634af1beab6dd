//! Speed against accuracy: a grid of panels, one a regime.

use stage::{Anchor, Precision};

use super::letters::wrapped;
use super::palette::{DIM, INK};
use super::pen::Letters;
use super::shared::Shared;
use super::svg::{Point, Svg};
use super::{legend, panel};

/// What is shown: the methods of a concept in every regime.
#[derive(Clone, Debug, PartialEq)]
pub struct TradePlot {
    /// The heading.
    pub title: String,
    /// A line below it: the machine, the build, how many cases.
    pub subtitle: String,
    /// The regimes, in their order.
    pub panels: Vec<Panel>,
}

/// One regime.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// The regime's name.
    pub name: String,
    /// What its cases are; two lines of it are shown.
    pub what: String,
    /// A mark for every method at every precision.
    pub marks: Vec<Mark>,
}

/// One method at one precision in one regime.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// The method's name.
    pub method: String,
    /// The precision.
    pub precision: Precision,
    /// Nanoseconds per ray, above 0. A mark without such a time is listed, not placed.
    pub ns: f64,
    /// The mean relative error of t, a wrong verdict counting as 1: from 0 to 1. A mark without a finite
    /// error is listed, not placed.
    pub error: f64,
    /// How many verdicts (hit or miss) are wrong.
    pub wrong: u64,
    /// Out of how many.
    pub cases: u64,
    /// Whether it is on the Pareto front: nothing in the panel is both faster and closer.
    pub on_front: bool,
}

impl Mark {
    /// Whether it can be placed: a clock that measured nothing, or a mean over nothing, cannot.
    pub(super) fn has_place(&self) -> bool {
        self.ns.is_finite() && self.ns > 0.0 && self.error.is_finite() && self.error >= 0.0
    }
}

const MARGIN: f64 = 24.0;
/// Room for the upward axis title at the left of every row.
const AXIS_TITLE: f64 = 44.0;
const PANEL_WIDTH: f64 = 456.0;
const PANEL_HEIGHT: f64 = 430.0;
/// The least width of a page, so that its heading fits.
const LEAST_WIDTH: f64 = 960.0;

/// Speed against accuracy as an SVG: nanoseconds per ray to the right, error upward, both logarithmic,
/// the better the further down and left. Both axes are the same in every panel.
///
/// The axis of errors is whole decades up to 1, from 1e-17 or below, where an error of exactly 0 is
/// shown. The axis of times ends at numbers 1, 2 or 5 times a power of ten: times mostly span less than
/// two decades, and whole ones would leave half of every panel empty.
pub fn trade_svg(plot: &TradePlot) -> String {
    let columns = columns(plot.panels.len());
    let width = (2.0 * MARGIN + AXIS_TITLE + columns as f64 * PANEL_WIDTH).max(LEAST_WIDTH);
    let panel_width = (width - 2.0 * MARGIN - AXIS_TITLE) / columns as f64;
    let rows = plot.panels.len().div_ceil(columns);
    let shared = Shared::of(&plot.panels);

    let subtitle = wrapped(&plot.subtitle, 17.0, width - 2.0 * MARGIN, 2);
    let legend_top = MARGIN + 52.0 + 24.0 * subtitle.len() as f64;
    let legend = legend::items(&shared, plot);
    let top = legend_top + legend::height(&legend, width - 2.0 * MARGIN) + 14.0;
    let height = top + rows as f64 * PANEL_HEIGHT + MARGIN;

    let mut svg = Svg::new((width, height), &plot.title);
    svg.text((MARGIN, MARGIN + 28.0), Letters::new(32.0, INK).bold(true), &plot.title);
    for (i, line) in subtitle.iter().enumerate() {
        svg.text((MARGIN, MARGIN + 56.0 + 24.0 * i as f64), Letters::new(17.0, DIM), line);
    }
    legend::draw(&mut svg, &legend, (MARGIN, legend_top), width - 2.0 * MARGIN);
    for row in 0..rows {
        axis_title(&mut svg, (MARGIN, top + row as f64 * PANEL_HEIGHT + panel::PLOT_MIDDLE));
    }
    for (i, panel) in plot.panels.iter().enumerate() {
        let (column, row) = ((i % columns) as f64, (i / columns) as f64);
        let corner = (MARGIN + AXIS_TITLE + column * panel_width, top + row * PANEL_HEIGHT);
        panel::draw(&mut svg, panel, &shared, corner, (panel_width, PANEL_HEIGHT));
    }
    svg.finish()
}

/// The title of the axis of errors, in two lines that read upward.
fn axis_title(svg: &mut Svg, (x, y): Point) {
    let letters = Letters::new(13.0, DIM).at(Anchor::Middle);
    svg.upward_text((x + 12.0, y), letters, "error: mean relative error of t,");
    svg.upward_text((x + 29.0, y), letters, "a wrong verdict counts as 1");
}

/// How many panels stand side by side: no more than four can be read on a slide.
fn columns(panels: usize) -> usize {
    match panels {
        0 | 1 => 1,
        2 | 4 => 2,
        3 | 5 | 6 | 9 => 3,
        _ => 4,
    }
}

#[cfg(test)]
mod tests {
    use super::super::extent::Extent;
    use super::super::xml::tests::assert_well_formed;
    use super::*;

    fn mark(ns: f64, error: f64) -> Mark {
        let method = "half-quadratic".to_owned();
        Mark { method, precision: Precision::F64, ns, error, wrong: 0, cases: 20_000, on_front: true }
    }

    fn plot(panels: Vec<Vec<Mark>>) -> TradePlot {
        let panel = |marks| Panel { name: "far".to_owned(), what: "distance / radius".to_owned(), marks };
        let panels = panels.into_iter().map(panel).collect();
        TradePlot { title: "Ray and sphere".to_owned(), subtitle: String::new(), panels }
    }

    /// A number among the attributes of an element.
    fn attribute(tag: &str, name: &str) -> Option<f64> {
        let after = tag.split(&format!(" {name}=\"")).nth(1)?;
        after.split('"').next()?.parse().ok()
    }

    /// The centers of the circles within tooltips: the marks, not the legend.
    fn centers(document: &str) -> Vec<Point> {
        let after_tooltips = document.split("</title>\n<circle").skip(1);
        after_tooltips.filter_map(|tag| Some((attribute(tag, "cx")?, attribute(tag, "cy")?))).collect()
    }

    #[test]
    fn a_mark_lies_within_a_pixel_of_the_closed_form() {
        // the axes end at 1e-31 and 1, at 1 and 100 ns; the first two marks say where these ends are
        let mut marks = vec![mark(1.0, 0.0), mark(99.0, 1.0)];
        marks.extend(
            (0..=30).map(|power| mark(10f64.powf(f64::from(power) / 15.0), 3.0 * 10f64.powi(-power - 1))),
        );
        // a front would be drawn above the others: the order is kept without
        marks.iter_mut().for_each(|mark| mark.on_front = false);
        let document = trade_svg(&plot(vec![marks.clone()]));
        let places = centers(&document);
        assert_eq!(places.len(), marks.len());
        let ((left, bottom), (last, top)) = (places[0], places[1]);
        // and they lie at their numbers
        for (y, tick) in [(bottom, "0"), (top, "1")] {
            let is_tick = |line: &&str| {
                line.contains("text-anchor=\"end\"") && line.ends_with(&format!(">{tick}</text>"))
            };
            let baseline = document.lines().find(is_tick).and_then(|line| attribute(line, "y")).unwrap();
            assert!((baseline - 4.0 - y).abs() < 1.0, "the number {tick} is not at {y}");
        }
        let right = left + (last - left) * 2.0 / 99f64.log10();
        for (mark, place) in marks.iter().zip(&places).skip(2) {
            let x = left + (right - left) * mark.ns.log10() / 2.0;
            let y = top + (bottom - top) * mark.error.log10() / -31.0;
            assert!(
                (place.0 - x).abs() < 1.0 && (place.1 - y).abs() < 1.0,
                "{mark:?}: {place:?}, not {x}, {y}"
            );
        }
    }

    #[test]
    fn the_axes_are_shared_and_reach_over_all_panels() {
        let shared =
            Shared::of(&plot(vec![vec![mark(0.9, 1e-3)], vec![mark(43.0, 3e-17), mark(2.0, 0.0)]]).panels);
        assert_eq!((shared.error, shared.methods.len()), ((-17.0, 0.0), 1));
        let (ns, error) = shared.axes(Extent { left: 0.0, top: 0.0, right: 200.0, bottom: 170.0 });
        assert!((ns.at(0.5), ns.at(50.0)) == (0.0, 200.0) && (ns.at(5.0) - 100.0).abs() < 1e-9);
        assert!((error.at(0.0), error.at(1.0)) == (170.0, 0.0) && (error.at(1e-8) - 80.0).abs() < 1e-9);
    }

    #[test]
    fn zero_infinity_and_nan_do_not_break_it() {
        let odd = [0.0, -1.0, 5e-324, 1e-31, 1.0, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
        let mut marks: Vec<Mark> = odd.map(|ns| mark(ns, 0.5)).to_vec();
        marks.extend(odd.map(|error| mark(3.0, error)));
        let singles: Vec<Vec<Mark>> = marks.iter().map(|mark| vec![mark.clone()]).collect();
        let mut all = vec![vec![], vec![vec![]], vec![vec![mark(5.0, 1e-16)]], vec![marks.clone()]];
        all.extend(singles.iter().map(|single| vec![single.clone()]));
        for panels in all {
            let document = trade_svg(&plot(panels));
            assert_well_formed(&document);
            let outside_of_tooltips = document.split("<title>").map(|part| part.split("</title>").last());
            for text in outside_of_tooltips.flatten() {
                assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
            }
        }
        let have_place: Vec<bool> = marks.iter().map(Mark::has_place).collect();
        let (yes, no) = (true, false);
        assert_eq!(have_place[..9], [no, no, yes, yes, yes, yes, no, no, no]);
        assert_eq!(have_place[9..], [yes, no, yes, yes, yes, yes, no, no, no]);
        let listed = trade_svg(&plot(vec![vec![mark(f64::NAN, 0.5)]]));
        assert!(listed.contains("half-quadratic f64: no figure"));
    }

    #[test]
    fn text_is_escaped_and_tooltips_are_exact() {
        let mut plot = plot(vec![vec![mark(4.25, 1.5e-16), Mark { wrong: 7, ..mark(3.0, 3.5e-4) }]]);
        plot.title = "<script>".to_owned();
        plot.panels[0].name = "a & b".to_owned();
        plot.panels[0].marks[0].method = "\"<i>\"".to_owned();
        let document = trade_svg(&plot);
        assert_well_formed(&document);
        assert!(
            !document.contains("<script>") && !document.contains("<i>") && document.contains("a &amp; b")
        );
        assert!(document.contains("f64: 4.25 ns per ray, error 1.5e-16, 0 of 20000 verdicts wrong"));
        assert!(document.contains("f64: 3 ns per ray, error 3.5e-4, 7 of 20000 verdicts wrong"));
    }

    #[test]
    fn the_same_data_give_the_same_bytes() {
        let panels = vec![vec![mark(4.0, 1e-16), mark(4.1, 1e-16), mark(4.2, 2e-16)]; 5];
        assert_eq!(trade_svg(&plot(panels.clone())), trade_svg(&plot(panels)));
    }
}

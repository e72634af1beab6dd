//! How a time depends on one quantity: a line a method, with its spread.

use stage::Anchor;

use super::axis::{LinearAxis, log10, round_numbers};
use super::extent::Extent;
use super::letters::{cut, width, wrapped};
use super::palette::{DIM, GRID, INK};
use super::pen::{Letters, Stroke};
use super::series::{band, line, names_at_the_end};
use super::svg::Svg;

/// What is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct LinePlot {
    /// The heading.
    pub title: String,
    /// A line below it: the machine, the build, how many rays.
    pub subtitle: String,
    /// The title of the horizontal axis, with its unit: "share of rays that hit (%)".
    pub x_title: String,
    /// The title of the vertical axis, with its unit: "ns per ray".
    pub y_title: String,
    /// The lines.
    pub series: Vec<Series>,
    /// What it shows, in a sentence below the plot.
    pub conclusion: String,
    /// Both axes in powers of ten; then no coordinate may be zero or less. Else both are even, and the vertical one starts
    /// at 0, so that heights can be compared.
    pub powers: bool,
    /// Places that are marked with a ring and a word: x, y.
    pub marks: Vec<(f64, f64, String)>,
}

/// One line.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// The method.
    pub name: String,
    /// Its points (x, y, low, high) from left to right: the median and, say, the quartiles. A point that
    /// is not finite is left out.
    pub points: Vec<(f64, f64, f64, f64)>,
}

pub(super) const WIDTH: f64 = 1280.0;
const HEIGHT: f64 = 760.0;
const MARGIN: f64 = 40.0;
/// The size of the names of lines.
pub(super) const LABEL: f64 = 17.0;

/// Lines as the text of an SVG of a slide's shape, 1280 by 760 units.
pub fn lines_svg(plot: &LinePlot) -> String {
    // powers of ten are drawn by their exponents, on even axes
    let scaled = |x: f64| if plot.powers { log10(x) } else { x };
    let series: Vec<Series> = plot.series.iter().map(|series| finite(series, scaled)).collect();
    let mut svg = Svg::new((WIDTH, HEIGHT), &plot.title);
    let limit = WIDTH - 2.0 * MARGIN;
    svg.text((MARGIN, 66.0), Letters::new(32.0, INK).bold(true), &cut(&plot.title, 33.0, limit));
    svg.text((MARGIN, 97.0), Letters::new(17.0, DIM), &cut(&plot.subtitle, 17.0, limit));
    let conclusion = wrapped(&plot.conclusion, 20.0, limit, 3);
    for (i, line) in conclusion.iter().enumerate() {
        let y = HEIGHT - 30.0 - 27.0 * (conclusion.len() - 1 - i) as f64;
        svg.text((MARGIN, y), Letters::new(20.0, INK), line);
    }

    let names = series.iter().map(|series| width(&series.name, LABEL) * 1.1).fold(0.0, f64::max);
    let right = WIDTH - MARGIN - names.min(WIDTH / 3.0) - 30.0;
    let bottom = HEIGHT - 110.0 - 27.0 * conclusion.len() as f64;
    let frame = Extent { left: MARGIN + 50.0, top: 150.0, right, bottom };
    let (x, y) = if plot.powers { axes_of_powers(&series, frame) } else { axes(&series, frame) };
    grid(&mut svg, plot, frame, &x, &y);
    for (i, series) in series.iter().enumerate() {
        band(&mut svg, series, i, &x, &y);
    }
    for (i, series) in series.iter().enumerate() {
        line(&mut svg, series, i, &x, &y);
    }
    names_at_the_end(&mut svg, &series, frame, &x, &y);
    ring_marks(&mut svg, plot, |(mark_x, mark_y)| (x.at(scaled(mark_x)), y.at(scaled(mark_y))));
    svg.finish()
}

/// The marks, each with its word above; words that would stand on each other are put on lines of their own.
fn ring_marks(svg: &mut Svg, plot: &LinePlot, at: impl Fn((f64, f64)) -> (f64, f64)) {
    let places = plot.marks.iter().map(|(x, y, word)| (at((*x, *y)), word));
    let mut places: Vec<_> = places.filter(|((x, y), _)| x.is_finite() && y.is_finite()).collect();
    places.sort_by(|((a, _), _), ((b, _), _)| a.total_cmp(b));
    let mut right_of_last = f64::NEG_INFINITY;
    let mut last_line = f64::INFINITY;
    for ((x, y), word) in places {
        let half = width(word, 15.0) / 2.0;
        let above = y - 14.0;
        let line = if x - half < right_of_last { above.min(last_line - 18.0) } else { above };
        svg.circle((x, y), 7.0, None, Stroke::solid(INK, 2.0));
        svg.text_over_lines((x, line), Letters::new(15.0, INK).at(Anchor::Middle), word);
        (right_of_last, last_line) = (right_of_last.max(x + half + 6.0), line);
    }
}

fn finite(series: &Series, scaled: impl Fn(f64) -> f64) -> Series {
    let points = series
        .points
        .iter()
        .map(|point| (scaled(point.0), scaled(point.1), scaled(point.2), scaled(point.3)));
    let is_finite =
        |point: &(f64, f64, f64, f64)| [point.0, point.1, point.2, point.3].iter().all(|x| x.is_finite());
    Series { name: series.name.clone(), points: points.filter(is_finite).collect() }
}

/// Axes from a whole power of ten to another, around all points.
fn axes_of_powers(series: &[Series], frame: Extent) -> (LinearAxis, LinearAxis) {
    let points = || series.iter().flat_map(|series| &series.points);
    let around = |numbers: &mut dyn Iterator<Item = f64>| {
        let ends = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        let (low, high) = (ends.0.floor(), ends.1.ceil());
        if low < high {
            (low, high)
        } else if low.is_finite() {
            (low, low + 1.0)
        } else {
            (0.0, 1.0)
        }
    };
    let x = around(&mut points().map(|point| point.0));
    let y = around(&mut points().flat_map(|point| [point.1, point.2, point.3]));
    (
        LinearAxis { ends: x, places: (frame.left, frame.right) },
        LinearAxis { ends: y, places: (frame.bottom, frame.top) },
    )
}

/// The axes: the horizontal one over all x, the vertical one from 0 to a little above all y.
fn axes(series: &[Series], frame: Extent) -> (LinearAxis, LinearAxis) {
    let points = || series.iter().flat_map(|series| &series.points);
    let left = points().map(|point| point.0).fold(f64::INFINITY, f64::min);
    let right = points().map(|point| point.0).fold(f64::NEG_INFINITY, f64::max);
    let top = points().map(|point| point.1.max(point.3)).fold(0.0, f64::max);
    let x = if left < right {
        (left, right)
    } else if left == right {
        (left - 1.0, left + 1.0)
    } else {
        (0.0, 100.0)
    };
    let top = if top > 0.0 { (1.06 * top).min(f64::MAX) } else { 1.0 };
    (
        LinearAxis { ends: x, places: (frame.left, frame.right) },
        LinearAxis { ends: (0.0, top), places: (frame.bottom, frame.top) },
    )
}

fn grid(svg: &mut Svg, plot: &LinePlot, frame: Extent, x: &LinearAxis, y: &LinearAxis) {
    let numbers = Letters::new(15.0, DIM);
    // an axis of powers has its whole exponents
    let numbers_of = |(low, high): (f64, f64), about: u32| match plot.powers {
        true => (low as i32..=high as i32).map(f64::from).collect(),
        false => round_numbers(low, high, about),
    };
    let say = |svg: &mut Svg, at: (f64, f64), letters: Letters, number: f64| match plot.powers {
        true => svg.power_of_ten(at, letters, number as i32),
        false => svg.text(at, letters, &short(number)),
    };
    for number in numbers_of(y.ends, 6) {
        let at = y.at(number);
        svg.line((frame.left, at), (frame.right, at), Stroke::solid(GRID, 1.0));
        say(svg, (frame.left - 10.0, at + 5.0), numbers.at(Anchor::Right), number);
    }
    for number in numbers_of(x.ends, 10) {
        let at = x.at(number);
        svg.line((at, frame.bottom), (at, frame.bottom + 6.0), Stroke::solid(DIM, 1.2));
        say(svg, (at, frame.bottom + 24.0), numbers.at(Anchor::Middle), number);
    }
    svg.line((frame.left, frame.bottom), (frame.right, frame.bottom), Stroke::solid(DIM, 1.4));
    let titles = Letters::new(17.0, DIM);
    // level, not upward: it is read without turning the head
    svg.text((MARGIN, frame.top - 18.0), titles, &plot.y_title);
    let middle = (frame.left + frame.right) / 2.0;
    svg.text((middle, frame.bottom + 50.0), titles.at(Anchor::Middle), &plot.x_title);
}

/// A round number without the last digits of its binary fraction.
fn short(number: f64) -> String {
    if number != 0.0 && !(1e-3..1e7).contains(&number.abs()) {
        return format!("{number:e}").replace('-', "−");
    }
    let text = format!("{number:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::super::xml::tests::assert_well_formed;
    use super::*;

    fn plot(series: Vec<Series>) -> LinePlot {
        let text = |text: &str| text.to_owned();
        LinePlot {
            title: text("t < 0 & \"all\""),
            subtitle: text("s"),
            x_title: text("x (%)"),
            y_title: text("ns"),
            series,
            conclusion: text("It is <so>."),
            powers: false,
            marks: vec![(1.0, 2.0, text("<here>"))],
        }
    }

    #[test]
    fn nothing_and_what_is_no_number_do_not_break_it() {
        let (nan, inf) = (f64::NAN, f64::INFINITY);
        let one = Series { name: "a<b".to_owned(), points: vec![(50.0, 3.0, 2.0, 4.0)] };
        let bad = Series { name: String::new(), points: vec![(nan, 1.0, 1.0, 1.0), (1.0, inf, 0.0, inf)] };
        let zero = Series { name: "0".to_owned(), points: vec![(0.0, 0.0, 0.0, 0.0); 2] };
        for series in [vec![], vec![one.clone()], vec![bad.clone()], vec![zero.clone()], vec![one, bad, zero]]
        {
            for powers in [false, true] {
                let document = lines_svg(&LinePlot { powers, ..plot(series.clone()) });
                assert_well_formed(&document);
                assert!(!document.contains("NaN") && !document.contains("inf"));
            }
        }
    }

    #[test]
    fn powers_of_ten_are_as_far_from_each_other() {
        let points = vec![(1.0, 20.0, 20.0, 20.0), (100.0, 3000.0, 3000.0, 3000.0)];
        let logs = finite(&Series { name: String::new(), points }, log10);
        let frame = Extent { left: 0.0, top: 0.0, right: 100.0, bottom: 300.0 };
        let (x, y) = axes_of_powers(&[logs], frame);
        // by hand: x from 10⁰ to 10², y from 10¹ to 10⁴
        assert_eq!([x.at(0.0), x.at(1.0), x.at(2.0)], [0.0, 50.0, 100.0]);
        assert_eq!([y.at(1.0), y.at(2.0), y.at(4.0)], [300.0, 200.0, 0.0]);
    }

    #[test]
    fn the_vertical_axis_starts_at_zero() {
        let frame = Extent { left: 0.0, top: 0.0, right: 100.0, bottom: 106.0 };
        let series =
            [Series { name: String::new(), points: vec![(0.0, 8.0, 7.0, 10.0), (100.0, 5.0, 5.0, 5.0)] }];
        let (x, y) = axes(&series, frame);
        assert_eq!([x.at(0.0), x.at(25.0), x.at(100.0)], [0.0, 25.0, 100.0]);
        let heights = [0.0, 5.0, 10.0].map(|ns| y.at(ns));
        assert!(
            heights.iter().zip([106.0, 56.0, 6.0]).all(|(got, want)| (got - want).abs() < 1e-9),
            "{heights:?}"
        );
    }
}

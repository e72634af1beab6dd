//! Speed against accuracy: a grid of panels, one a regime.

use stage::{Anchor, Precision};

use super::legend::Legend;
use super::letters::wrapped;
use super::palette::{DIM, INK};
use super::panel::{self, Room};
use super::pen::Letters;
use super::shared::Shared;
use super::svg::{Point, Svg};

/// What is shown: the methods of a concept in every regime.
#[derive(Clone, Debug, PartialEq)]
pub struct TradePlot {
    /// The heading.
    pub title: String,
    /// A line below it: the machine, the build, how many cases.
    pub subtitle: String,
    /// What the figures are called.
    pub words: Words,
    /// The regimes, in their order.
    pub panels: Vec<Panel>,
}

/// What the figures of a plot are called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    /// What it is that takes so many ns.
    pub unit: &'static str,
    /// The title of the axis of errors, in two lines.
    pub error: [&'static str; 2],
    /// What is counted as wrong.
    pub wrong: &'static str,
    /// Whether the errors are those of numbers, which end at what rounding costs; else they are shares of cases,
    /// and the axis ends below the least of them.
    pub rounds: bool,
}

impl Words {
    /// Rays that hit or miss, with errors of t.
    pub const RAYS: Words = Words {
        unit: "ray",
        error: ["error: mean relative error of t,", "a wrong verdict counts as 1"],
        wrong: "verdicts (hit or miss) wrong",
        rounds: true,
    };
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
    /// Nanoseconds per ray, or whatever [`Words::unit`] says, above 0. A mark without such a time is listed, not placed.
    pub ns: f64,
    /// The error that [`Words::error`] names, from 0 to 1. A mark without a finite
    /// error is listed, not placed.
    pub error: f64,
    /// How many are wrong, in the sense of [`Words::wrong`].
    pub wrong: u64,
    /// Out of how many.
    pub cases: u64,
    /// Whether it is on the Pareto front: nothing in the panel is at least as fast and as close, and
    /// better in one of the two.
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
const AXIS_TITLE: f64 = 40.0;
/// The height of a panel where there are several rows.
const PANEL_HEIGHT: f64 = 430.0;

/// How large a page is by the number of panels that stand side by side.
struct Page {
    columns: usize,
    /// Its width, in which letters and marks have their fixed sizes.
    width: f64,
    /// The width that it is shown at: the fewer panels, the larger is all that is on it.
    shown: f64,
    /// The size of the letters of the heading and of what is below it.
    letters: (f64, f64),
}

impl Page {
    /// No more than four panels side by side can be read on a slide.
    fn of(panels: usize) -> Page {
        let slide = |columns, width| Page { columns, width, shown: 1280.0, letters: (27.0, 14.0) };
        match panels {
            0 | 1 => slide(1, 960.0),
            2 | 4 => slide(2, 1120.0),
            3 | 5 | 6 | 9 => slide(3, 1200.0),
            _ => Page { columns: 4, width: 1920.0, shown: 1920.0, letters: (34.0, 17.0) },
        }
    }

    /// The height of a panel: a single row fills a slide.
    fn panel_height(&self, rows: usize, top: f64) -> f64 {
        if rows > 1 { PANEL_HEIGHT } else { (self.width * 9.0 / 16.0 - top - MARGIN / 2.0).max(280.0) }
    }
}

/// Speed against accuracy as the text of an SVG: nanoseconds per ray to the right, error upward, both
/// logarithmic, the better the further down and left. Both axes are the same in every panel.
///
/// The axis of errors is whole decades up to 1, from 1e-17 or below where they are of numbers
/// ([`Words::rounds`]), else from below the least share; an error of exactly 0 is shown at its end. The axis
/// of times ends at numbers 1, 2 or 5 times a power of ten: times mostly span less than two decades, and
/// whole ones would leave half of every panel empty. It covers what is typical; the few marks that are far
/// slower stand in a band at its end, and their labels give the time.
pub fn trade_svg(plot: &TradePlot) -> String {
    let page = Page::of(plot.panels.len());
    let inner = page.width - 2.0 * MARGIN;
    let panel_width = (inner - AXIS_TITLE) / page.columns as f64;
    let rows = plot.panels.len().div_ceil(page.columns);
    let shared = Shared::of(plot);

    let (large, small) = page.letters;
    let title = wrapped(&plot.title, 1.08 * large, inner, 2);
    let subtitle = wrapped(&plot.subtitle, small, inner, 3);
    let title_bottom = MARGIN + 1.15 * large * title.len() as f64;
    let legend_top = title_bottom + 1.4 * small * subtitle.len() as f64 + 0.4 * small;
    let legend = Legend::of(&shared, plot, small - 1.0, inner);
    let top = legend_top + legend.height() + small;
    let panel_height = page.panel_height(rows, top);
    let height = top + rows as f64 * panel_height + MARGIN / 2.0;

    let mut svg = Svg::scaled((page.width, height), page.shown / page.width, &plot.title);
    for (i, line) in title.iter().enumerate() {
        let baseline = MARGIN + large * (0.75 + 1.15 * i as f64);
        svg.text((MARGIN, baseline), Letters::new(large, INK).bold(true), line);
    }
    for (i, line) in subtitle.iter().enumerate() {
        let baseline = title_bottom + small * (0.9 + 1.4 * i as f64);
        svg.text((MARGIN, baseline), Letters::new(small, DIM), line);
    }
    legend.draw(&mut svg, (MARGIN, legend_top));
    let lines = plot.panels.iter().map(|panel| panel::what(panel, panel_width).len()).max().unwrap_or(0);
    for (i, panel) in plot.panels.iter().enumerate() {
        let (column, row) = ((i % page.columns) as f64, (i / page.columns) as f64);
        let corner = (MARGIN + AXIS_TITLE + column * panel_width, top + row * panel_height);
        let room = Room { corner, size: (panel_width, panel_height), lines };
        if i % page.columns == 0 {
            axis_title(&mut svg, (MARGIN, room.middle()), plot.words);
        }
        panel::draw(&mut svg, panel, &shared, room);
    }
    svg.finish()
}

/// The title of the axis of errors, in two lines that read upward.
fn axis_title(svg: &mut Svg, (x, y): Point, words: Words) {
    let letters = Letters::new(13.0, DIM).at(Anchor::Middle);
    svg.upward_text((x + 12.0, y), letters, words.error[0]);
    svg.upward_text((x + 29.0, y), letters, words.error[1]);
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
        TradePlot { title: "Ray and sphere".to_owned(), subtitle: String::new(), words: Words::RAYS, panels }
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
            (0..=15).map(|at| mark(10f64.powf(f64::from(2 * at) / 15.0), 3.0 * 10f64.powi(-2 * at - 1))),
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
        let shared = Shared::of(&plot(vec![vec![mark(0.9, 1e-3)], vec![mark(43.0, 3e-17), mark(2.0, 0.0)]]));
        assert_eq!((shared.error, shared.methods.len()), ((-17.0, 0.0), 1));
        let (ns, error) = shared.axes(Extent { left: 0.0, top: 0.0, right: 200.0, bottom: 170.0 }, &[]);
        assert!((ns.at(0.5), ns.at(50.0)) == (0.0, 200.0) && (ns.at(5.0) - 100.0).abs() < 1e-9);
        assert!((error.at(0.0), error.at(1.0)) == (170.0, 0.0) && (error.at(1e-8) - 80.0).abs() < 1e-9);
    }

    /// A share of 20 000 cases is never near what rounding costs, and no line says what that is.
    #[test]
    fn an_axis_of_shares_ends_below_the_least_share() {
        let shares = |marks: Vec<Mark>| {
            let plot = plot(vec![marks]);
            TradePlot { words: Words { rounds: false, ..Words::RAYS }, ..plot }
        };
        let plots = [vec![mark(1.0, 0.5), mark(2.0, 5e-5)], vec![mark(1.0, 0.0)], vec![]].map(shares);
        let bottoms = plots.each_ref().map(|plot| Shared::of(plot).error.0);
        assert_eq!(bottoms, [-5.0, -2.0, -2.0]);
        for plot in plots {
            let document = trade_svg(&plot);
            assert_well_formed(&document);
            assert!(!document.contains("half an ulp"));
        }
        assert!(trade_svg(&plot(vec![vec![mark(1.0, 0.5)]])).contains("half an ulp"));
    }

    #[test]
    fn a_mark_beyond_the_axis_stands_in_the_band_and_tells_its_time() {
        let mut marks = vec![mark(10.0, 1e-8); 12];
        assert!(!trade_svg(&plot(vec![marks.clone()])).contains(">slower"));
        marks.extend([mark(5720.0, 0.0), Mark { on_front: false, ..mark(16_899.0, 1e-3) }]);
        let document = trade_svg(&plot(vec![marks.clone(), vec![mark(60.0, 1e-8)]]));
        assert_well_formed(&document);
        assert_eq!(document.matches(">slower</text>").count(), 2, "a band in every panel");
        assert!(document.contains(">half-quadratic 5.7 µs<") && document.contains(">half-quadratic 17 µs<"));
        assert!(document.contains("f64: 5720 ns per ray") && document.contains("slower than the axis"));
        let last = document.lines().find(|line| line.ends_with(">100</text>"));
        let last = last.and_then(|line| attribute(line, "x")).unwrap();
        let name = document.lines().find(|line| line.ends_with(">slower</text>"));
        let name = name.and_then(|line| attribute(line, "x")).unwrap();
        let xs: Vec<f64> = centers(&document).iter().map(|center| center.0).collect();
        let beyond = |xs: &[f64]| xs.iter().filter(|&&x| x > last && (x - name).abs() < 20.0).count();
        assert_eq!((beyond(&xs[..14]), beyond(&xs[14..])), (2, 0));
    }

    #[test]
    fn a_single_panel_fills_a_slide_with_letters_to_read() {
        let marks = vec![mark(4.0, 1e-16), mark(8.0, 0.0), mark(9.0, 1.0), mark(9e4, 1e-3)];
        for count in 1..=3 {
            let document = trade_svg(&plot(vec![marks.clone(); count]));
            let page = document.lines().next().unwrap();
            assert_eq!([attribute(page, "width"), attribute(page, "height")], [Some(1280.0), Some(720.0)]);
            let inner: f64 =
                page.split("viewBox=\"0 0 ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
            let sizes = document.split("font-size=\"").skip(1).map(|rest| rest.split('"').next().unwrap());
            let least = sizes.map(|size| size.parse::<f64>().unwrap() * 1280.0 / inner).fold(99.0, f64::min);
            assert!(least > if count == 1 { 16.0 } else { 12.5 }, "{count} panels: {least}");
        }
    }

    #[test]
    fn long_headings_are_wrapped() {
        let mut plot = plot(vec![vec![mark(4.0, 1e-16)]]);
        plot.title = "speed for accuracy ".repeat(5);
        plot.subtitle = "what the median is taken over ".repeat(9);
        let document = trade_svg(&plot);
        let is_heading = |line: &&str| {
            attribute(line, "x") == Some(MARGIN) && !line.contains("rotate") && line.starts_with("<text")
        };
        let headings: Vec<&str> = document.lines().filter(is_heading).collect();
        assert_eq!(headings.len(), 2 + 3, "{headings:?}");
        assert!(headings.iter().all(|line| line.len() < 230), "{headings:?}");
        assert!(document.contains("height=\"720\""));
    }

    #[test]
    fn above_an_error_of_1_there_is_room_for_a_label() {
        let document = trade_svg(&plot(vec![vec![mark(4.0, 1.0)]]));
        let number = document.lines().find(|line| line.ends_with(">1</text>")).unwrap();
        let name = document.lines().find(|line| line.ends_with(">distance / radius</text>")).unwrap();
        let room = attribute(number, "y").unwrap() - attribute(name, "y").unwrap();
        assert!(room > 40.0, "{room}");
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
        assert!(
            document.contains("f64: 4.25 ns per ray, error 1.5e-16, 0 of 20000 verdicts (hit or miss) wrong")
        );
        assert!(
            document.contains("f64: 3 ns per ray, error 3.5e-4, 7 of 20000 verdicts (hit or miss) wrong")
        );
    }

    #[test]
    fn the_same_data_give_the_same_bytes() {
        let panels = vec![vec![mark(4.0, 1e-16), mark(4.1, 1e-16), mark(4.2, 2e-16)]; 5];
        assert_eq!(trade_svg(&plot(panels.clone())), trade_svg(&plot(panels)));
    }
}

//! Where a method fails: a plane of two quantities, colored by the worst error.

use stage::{Anchor, Canvas, Color, Error, Pen};

use super::heat;
use super::letters::wrapped;
use super::map_axes::{axes, key};
use super::palette::{DIM, INK, mixed};

/// What is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct MapPlot {
    /// The heading.
    pub title: String,
    /// A line below it.
    pub subtitle: String,
    /// The horizontal quantity.
    pub x: MapAxis,
    /// The vertical quantity.
    pub y: MapAxis,
    /// How many panels stand side by side; at least 1.
    pub columns: usize,
    /// The panels, row by row: a method at a precision each.
    pub panels: Vec<MapPanel>,
}

/// A logarithmic axis of a map, cut into cells.
#[derive(Clone, Debug, PartialEq)]
pub struct MapAxis {
    /// What is plotted.
    pub title: String,
    /// The power of ten at its left or lower end.
    pub low: i32,
    /// The power of ten at its right or upper end; it may be the smaller one.
    pub high: i32,
    /// How many cells lie between them.
    pub cells: usize,
}

/// One panel.
#[derive(Clone, Debug, PartialEq)]
pub struct MapPanel {
    /// Which method at which precision.
    pub title: String,
    /// The cells, row by row from the lower left. What is missing at the end is empty.
    pub cells: Vec<Cell>,
}

/// What became of the cases of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// All verdicts are right; this is the worst error of t in ulps.
    Ulps(f64),
    /// This share of the verdicts is wrong, above 0.
    Wrong(f64),
    /// No case fell here.
    Empty,
}

const MARGIN: f32 = 36.0;
const HEAD: f32 = 84.0;
/// Room for the numbers at the left of all panels; for the title above a panel, for the axis below, for
/// air at its right.
const LEFT: f32 = 80.0;
const ABOVE: f32 = 92.0;
const BELOW: f32 = 68.0;
const RIGHT: f32 = 40.0;
const KEY: f32 = 100.0;
/// A slide is about this wide.
const WIDTH: f32 = 1920.0;
/// The least width of a map, so that its key fits.
const LEAST_WIDTH: f32 = 1540.0;
/// The sizes of the letters: a slide of 1280 pixels shows them at two thirds.
const TITLE: f32 = 40.0;
const SUBTITLE: f32 = 22.0;
const PANEL_TITLE: f32 = 26.0;
const AXIS_TITLE: f32 = 20.0;
/// From a line of the subtitle to the next.
const LINE: f32 = 30.0;
/// The largest side of a panel.
const LARGEST: f32 = 600.0;

/// Where the cells of a panel lie.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub(super) left: f32,
    pub(super) top: f32,
    pub(super) right: f32,
    pub(super) bottom: f32,
}

/// The map as a picture about 1920 pixels wide. Every cell is a whole number of pixels, so that none
/// looks larger than another. [`Error::Failed`] where the memory for it cannot be had.
pub fn failure_map(plot: &MapPlot) -> Result<Canvas, Error> {
    let columns = plot.columns.max(1).min(plot.panels.len().max(1));
    let rows = plot.panels.len().div_ceil(columns);
    let room = ((WIDTH - 2.0 * MARGIN - LEFT) / columns as f32 - RIGHT).min(LARGEST);
    let pixels = |cells: usize| (room / cells.max(1) as f32).round().max(1.0);
    let (wide, high) = (pixels(plot.x.cells), pixels(plot.y.cells));
    let plane = (wide * plot.x.cells.max(1) as f32, high * plot.y.cells.max(1) as f32);
    let pitch = (plane.0 + RIGHT, ABOVE + plane.1 + BELOW);
    let width = (2.0 * MARGIN + LEFT + columns as f32 * pitch.0).max(LEAST_WIDTH);
    let subtitle = lines(&plot.subtitle, SUBTITLE, width - 2.0 * MARGIN);
    let head = HEAD + LINE * subtitle.len() as f32;
    let height = head + rows as f32 * pitch.1 + KEY;

    let mut canvas = Canvas::new((width as u32, height as u32), Color::WHITE)?;
    canvas.label((MARGIN, 64.0), Anchor::Left, TITLE, INK, &plot.title);
    for (i, line) in subtitle.iter().enumerate() {
        canvas.label((MARGIN, 100.0 + LINE * i as f32), Anchor::Left, SUBTITLE, DIM, line);
    }
    let title_size = panel_title_size(plot, pitch.0);
    for (i, panel) in plot.panels.iter().enumerate() {
        let (column, row) = ((i % columns) as f32, (i / columns) as f32);
        let (left, top) = (MARGIN + LEFT + column * pitch.0, head + row * pitch.1 + ABOVE);
        let frame = Frame { left, top, right: left + plane.0, bottom: top + plane.1 };
        cells(&mut canvas, plot, panel, frame, (wide, high));
        // all panels have the same axes: what is said of them stands at the left and at the bottom
        axes(&mut canvas, plot, frame, i % columns == 0);
        canvas.label((left, top - 56.0), Anchor::Left, title_size, INK, &panel.title);
        if i % columns == 0 {
            let title = format!("↑ {}", plot.y.title);
            canvas.label((MARGIN, top - 24.0), Anchor::Left, AXIS_TITLE, DIM, &title);
        }
        if i + columns >= plot.panels.len() {
            let title = format!("{} →", plot.x.title);
            canvas.label((left + plane.0, frame.bottom + 56.0), Anchor::Right, AXIS_TITLE, DIM, &title);
        }
    }
    key(&mut canvas, (MARGIN + LEFT, height - KEY + 22.0));
    Ok(canvas)
}

/// The text in lines; the canvas's letters are wider than those that [`wrapped`] reckons with.
fn lines(text: &str, size: f32, limit: f32) -> Vec<String> {
    wrapped(text, 1.12 * f64::from(size), f64::from(limit), 2)
}

/// The size at which the longest title of a panel fits between two panels.
fn panel_title_size(plot: &MapPlot, pitch: f32) -> f32 {
    let longest = plot.panels.iter().map(|panel| panel.title.chars().count()).max().unwrap_or(0);
    (0.95 * pitch / (0.6 * longest.max(1) as f32)).clamp(14.0, PANEL_TITLE)
}

fn cells(canvas: &mut Canvas, plot: &MapPlot, panel: &MapPanel, frame: Frame, (wide, high): (f32, f32)) {
    // a line of the hatching begins about this many pixels after the last
    let every = ((16.0 / wide.max(high)).round() as usize).max(1);
    for row in 0..plot.y.cells {
        for column in 0..plot.x.cells {
            let cell = panel.cells.get(row * plot.x.cells + column).copied().unwrap_or(Cell::Empty);
            let (left, bottom) = (frame.left + column as f32 * wide, frame.bottom - row as f32 * high);
            let is_hatched = (column + plot.y.cells * every - row).is_multiple_of(every);
            swatch(canvas, (left, bottom - high), (left + wide, bottom), cell, is_hatched);
        }
    }
}

/// Draws a rectangle in the color of a cell. Wrong verdicts are hatched, so that they are told from the
/// scale without colors, too: the diagonals of neighbors make one line.
pub(super) fn swatch(canvas: &mut Canvas, from: (f32, f32), to: (f32, f32), cell: Cell, is_hatched: bool) {
    canvas.rectangle(from, to, heat::color(cell), 1.0);
    if matches!(cell, Cell::Wrong(_)) && is_hatched {
        // thin among small cells, so that they keep their color
        let width = if to.0 - from.0 < 8.0 { 1.0 } else { 1.3 };
        let pen = Pen::solid(mixed(Color::VERMILLION, Color::WHITE, 0.75), width);
        canvas.line((from.0, to.1), (to.0, from.1), pen);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(columns: usize, panels: Vec<Vec<Cell>>) -> MapPlot {
        let axis = |low, high| MapAxis { title: "x".to_owned(), low, high, cells: 4 };
        let panel = |cells| MapPanel { title: "quadratic · f64".to_owned(), cells };
        let panels = panels.into_iter().map(panel).collect();
        let (title, subtitle) = ("Ray and sphere".to_owned(), String::new());
        MapPlot { title, subtitle, x: axis(0, 16), y: axis(0, -16), columns, panels }
    }

    /// The side of a cell where a single panel has 4 by 4 of them.
    const SIDE: u32 = LARGEST as u32 / 4;

    #[test]
    fn cells_lie_row_by_row_from_the_lower_left() {
        let mut cells = vec![Cell::Ulps(1.0); 16];
        (cells[0], cells[3], cells[12], cells[6]) =
            (Cell::Ulps(1e4), Cell::Ulps(1e8), Cell::Ulps(1e16), Cell::Empty);
        let canvas = failure_map(&plot(1, vec![cells])).unwrap();
        let color = |column: u32, row: u32| {
            let (left, top) = ((MARGIN + LEFT) as u32, (HEAD + ABOVE) as u32);
            // off the middle, where the hatching is
            canvas.pixel(left + column * SIDE + SIDE / 4, top + (3 - row) * SIDE + SIDE / 4)
        };
        let of = |cell| Some(heat::color(cell));
        assert_eq!(color(0, 0), of(Cell::Ulps(1e4)));
        assert_eq!(color(3, 0), of(Cell::Ulps(1e8)));
        assert_eq!(color(0, 3), of(Cell::Ulps(1e16)));
        assert_eq!(color(2, 1), of(Cell::Empty));
        assert_eq!(color(1, 1), of(Cell::Ulps(0.0)));
    }

    #[test]
    fn a_wrong_verdict_shows_even_among_unlimited_errors() {
        let mut cells = vec![Cell::Ulps(f64::INFINITY); 16];
        cells[5] = Cell::Wrong(0.0);
        let canvas = failure_map(&plot(1, vec![cells])).unwrap();
        let (width, height) = canvas.size();
        // the panel only: the key shows the color, too
        let panel = (0..height - KEY as u32).flat_map(|row| (0..width).map(move |column| (column, row)));
        let wrong =
            panel.filter(|&(column, row)| canvas.pixel(column, row) == Some(Color::VERMILLION)).count();
        assert!(wrong > (SIDE * SIDE * 9 / 10) as usize && wrong <= (SIDE * SIDE) as usize, "{wrong} pixels");
    }

    #[test]
    fn hatching_leaves_small_cells_their_color() {
        let mut plot = plot(6, vec![vec![Cell::Wrong(0.0); 64 * 64]; 6]);
        (plot.x.cells, plot.y.cells) = (64, 64);
        let canvas = failure_map(&plot).unwrap();
        let (left, top) = ((MARGIN + LEFT) as u32, (HEAD + ABOVE) as u32);
        // within the first panel
        let places = (0..200 * 200).map(|i| (left + 20 + i % 200, top + 20 + i / 200));
        let is_plain = |&(column, row): &(u32, u32)| canvas.pixel(column, row) == Some(Color::VERMILLION);
        let percent = places.filter(is_plain).count() / 400;
        assert!((90..97).contains(&percent), "{percent} % are not hatched");
    }

    #[test]
    fn titles_of_panels_do_not_run_into_each_other() {
        let mut plot = plot(6, vec![vec![]; 6]);
        assert_eq!(panel_title_size(&plot, 600.0), PANEL_TITLE);
        plot.panels[2].title = "closest-approach · f64".to_owned();
        let size = panel_title_size(&plot, 296.0);
        assert!(size > 20.0 && 0.6 * size * 22.0 < 296.0, "{size}");
    }

    #[test]
    fn odd_data_do_not_break_it() {
        let odd = vec![Cell::Ulps(f64::NAN), Cell::Ulps(-1.0), Cell::Wrong(f64::NAN), Cell::Wrong(9.0)];
        for (columns, panels) in
            [(0, vec![]), (0, vec![odd.clone()]), (9, vec![odd.clone(); 3]), (2, vec![odd; 3])]
        {
            let mut plot = plot(columns, panels);
            assert!(failure_map(&plot).is_ok());
            (plot.x.high, plot.y.cells) = (plot.x.low, 0);
            assert!(failure_map(&plot).is_ok());
        }
    }
}

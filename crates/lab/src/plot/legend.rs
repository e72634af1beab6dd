//! What colors, shapes and lines mean; once for all panels.

use stage::{Color, Precision};

use super::letters::width;
use super::mark::{self, Look};
use super::palette::{self, DIM, GRID, INK};
use super::pen::{Letters, Stroke};
use super::shared::Shared;
use super::svg::{Point, Svg};
use super::trade::TradePlot;

/// What the signs mean, side by side as long as they fit.
pub(super) struct Legend {
    items: Vec<Item>,
    /// The size of its letters.
    size: f64,
    /// How wide it may be.
    limit: f64,
}

/// A sign and what it means.
struct Item {
    sign: Sign,
    text: String,
}

enum Sign {
    Method(Color),
    Mark(Look),
    Front,
    Roundoff,
    Slower,
}

/// From the left end of an item to its text.
const SIGN: f64 = 24.0;
const GAP: f64 = 26.0;

impl Legend {
    /// The legend of a plot: its methods, then the shapes and lines.
    pub(super) fn of(shared: &Shared, plot: &TradePlot, size: f64, limit: f64) -> Legend {
        let item = |sign, text: &str| Item { sign, text: text.to_owned() };
        let look =
            |precision, is_wrong, on_front| Sign::Mark(Look { color: DIM, precision, is_wrong, on_front });
        let mut items: Vec<Item> = (shared.methods.iter().enumerate())
            .map(|(i, method)| item(Sign::Method(palette::of_method(i)), method))
            .collect();
        items.extend([
            item(look(Precision::F64, false, false), "f64"),
            item(look(Precision::F32, false, false), "f32"),
        ]);
        if plot.panels.iter().flat_map(|panel| &panel.marks).any(|mark| mark.wrong > 0) {
            items.push(item(look(Precision::F64, true, false), &format!("some {}", plot.words.wrong)));
        }
        items.push(item(
            Sign::Front,
            "Pareto front: nothing is as fast and as close, and better in one; better is down and left",
        ));
        if plot.words.rounds {
            items.push(item(Sign::Roundoff, "half an ulp of 1: f32 above, f64 below"));
        }
        if shared.has_slower {
            items.push(item(Sign::Slower, "slower than the axis: in order, not to scale"));
        }
        Legend { items, size, limit }
    }

    /// How high it is.
    pub(super) fn height(&self) -> f64 {
        self.places().last().map_or(0.0, |place| place.1 + self.line())
    }

    /// Draws it from its top left.
    pub(super) fn draw(&self, svg: &mut Svg, (left, top): Point) {
        for (item, place) in self.items.iter().zip(self.places()) {
            let (x, y) = (left + place.0, top + place.1 + self.line() / 2.0);
            sign(svg, &item.sign, (x, y));
            svg.text((x + SIGN, y + 0.36 * self.size), Letters::new(self.size, INK), &item.text);
        }
    }

    /// From one line to the next.
    fn line(&self) -> f64 {
        1.75 * self.size
    }

    /// Where each item starts.
    fn places(&self) -> Vec<Point> {
        let (mut x, mut y) = (0.0, 0.0);
        let place = |item: &Item| {
            let own = SIGN + width(&item.text, self.size);
            if x > 0.0 && x + own > self.limit {
                (x, y) = (0.0, y + self.line());
            }
            let place = (x, y);
            x += own + GAP;
            place
        };
        self.items.iter().map(place).collect()
    }
}

/// Draws a sign, `y` its middle.
fn sign(svg: &mut Svg, sign: &Sign, (x, y): Point) {
    let middle = (x + SIGN / 2.0 - 3.0, y);
    match sign {
        Sign::Method(color) => svg.rectangle((x, y - 4.5), (x + 18.0, y + 4.5), *color, 1.0),
        Sign::Mark(look) => mark::draw(svg, middle, *look),
        Sign::Front => {
            let look = Look { color: DIM, precision: Precision::F64, is_wrong: false, on_front: true };
            let steps = [(-4.0, -10.0), (-4.0, 0.0), (8.0, 0.0), (8.0, 9.0)];
            let steps = steps.map(|(dx, dy)| (middle.0 + dx, middle.1 + dy));
            svg.polyline(&steps, mark::FRONT);
            mark::draw(svg, (middle.0 - 4.0, middle.1), look);
        }
        Sign::Roundoff => svg.line((x - 2.0, y), (x + 19.0, y), ROUNDOFF),
        Sign::Slower => svg.rectangle((x + 2.0, y - 8.0), (x + 18.0, y + 8.0), GRID, 1.0),
    }
}

/// The line at what rounding once costs.
pub(super) const ROUNDOFF: Stroke = Stroke { color: DIM, width: 1.0, opacity: 0.9, dash: "2 3" };

//! What colors, shapes and lines mean; once for all panels.

use stage::{Color, Precision};

use super::letters::width;
use super::mark::{self, Look};
use super::palette::{self, DIM, INK};
use super::pen::{Letters, Stroke};
use super::shared::Shared;
use super::svg::{Point, Svg};
use super::trade::TradePlot;

/// A sign and what it means.
pub(super) struct Item {
    sign: Sign,
    text: String,
}

enum Sign {
    Method(Color),
    Mark(Look),
    Front,
    Roundoff,
}

const SIZE: f64 = 15.0;
const LINE: f64 = 26.0;
/// From the left end of an item to its text.
const SIGN: f64 = 24.0;
const GAP: f64 = 26.0;

/// The legend of a plot: its methods, then the shapes and lines.
pub(super) fn items(shared: &Shared, plot: &TradePlot) -> Vec<Item> {
    let item = |sign, text: &str| Item { sign, text: text.to_owned() };
    let look = |precision, is_wrong, on_front| Sign::Mark(Look { color: DIM, precision, is_wrong, on_front });
    let mut items: Vec<Item> = (shared.methods.iter().enumerate())
        .map(|(i, method)| item(Sign::Method(palette::of_method(i)), method))
        .collect();
    items.extend([
        item(look(Precision::F64, false, false), "f64"),
        item(look(Precision::F32, false, false), "f32"),
    ]);
    if plot.panels.iter().flat_map(|panel| &panel.marks).any(|mark| mark.wrong > 0) {
        items.push(item(look(Precision::F64, true, false), "some verdicts (hit or miss) wrong"));
    }
    items.extend([
        item(Sign::Front, "Pareto front: nothing is both faster and closer; better is down and left"),
        item(Sign::Roundoff, "half an ulp of 1: f32 above, f64 below"),
    ]);
    items
}

/// How high the legend is within this width.
pub(super) fn height(items: &[Item], limit: f64) -> f64 {
    places(items, limit).last().map_or(0.0, |place| place.1 + LINE)
}

/// Draws the legend from its top left.
pub(super) fn draw(svg: &mut Svg, items: &[Item], (left, top): Point, limit: f64) {
    for (item, place) in items.iter().zip(places(items, limit)) {
        let (x, y) = (left + place.0, top + place.1 + LINE / 2.0);
        let middle = (x + SIGN / 2.0 - 3.0, y);
        match item.sign {
            Sign::Method(color) => svg.rectangle((x, y - 4.5), (x + 18.0, y + 4.5), color, 1.0),
            Sign::Mark(look) => mark::draw(svg, middle, look),
            Sign::Front => {
                let look = Look { color: DIM, precision: Precision::F64, is_wrong: false, on_front: true };
                let steps = [(-4.0, -10.0), (-4.0, 0.0), (8.0, 0.0), (8.0, 9.0)];
                let steps = steps.map(|(dx, dy)| (middle.0 + dx, middle.1 + dy));
                svg.polyline(&steps, mark::FRONT);
                mark::draw(svg, (middle.0 - 4.0, middle.1), look);
            }
            Sign::Roundoff => svg.line((x - 2.0, y), (x + 19.0, y), ROUNDOFF),
        }
        svg.text((x + SIGN, y + 0.36 * SIZE), Letters::new(SIZE, INK), &item.text);
    }
}

/// The line at what rounding once costs.
pub(super) const ROUNDOFF: Stroke = Stroke { color: DIM, width: 1.0, opacity: 0.9, dash: "2 3" };

/// Where each item starts: side by side as long as they fit.
fn places(items: &[Item], limit: f64) -> Vec<Point> {
    let (mut x, mut y) = (0.0, 0.0);
    let place = |item: &Item| {
        let own = SIGN + width(&item.text, SIZE);
        if x > 0.0 && x + own > limit {
            (x, y) = (0.0, y + LINE);
        }
        let place = (x, y);
        x += own + GAP;
        place
    };
    items.iter().map(place).collect()
}

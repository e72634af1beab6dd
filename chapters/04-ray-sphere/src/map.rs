//! The failure map: how far away, and how near the rim, until a method dies?

use lab::cells;
use lab::plot::{MapAxis, MapPlot, failure_map};
use stage::{Drawing, Error, Sheet, TradeAsk};

use crate::stage::RaySphere;
use crate::{Method, regimes};

/// Judges every method by distance and impact parameter, and draws `map.png`.
pub(crate) fn draw(ask: &TradeAsk) -> Result<Drawing, Error> {
    let (cells_a_side, per_cell) = if ask.quick { (24, 4) } else { (64, 8) };
    let x = MapAxis { title: "distance / radius".to_string(), low: 0, high: 16, cells: cells_a_side };
    let y = MapAxis {
        title: "|impact parameter / radius − 1|".to_string(),
        low: 0,
        high: -16,
        cells: cells_a_side,
    };
    let panels = cells(&RaySphere, ask, &x, &y, per_cell, |draw, radii, from_the_rim| {
        // One ray in two passes within the sphere, the others outside.
        let impact = 1.0 + draw.sign() * from_the_rim;
        regimes::passing(draw, radii, impact)
    });
    let plot = MapPlot {
        title: "Where each method dies: ray against sphere".to_string(),
        subtitle: format!(
            "each cell: the worst of {per_cell} rays against the exact oracle, within the rim or outside it; nearer to the \
             rim than 1e-16 (f64) and 1e-7 (f32) there are no numbers; seed {}",
            ask.seed
        ),
        x,
        y,
        columns: Method::ALL.len(),
        panels,
    };
    Ok(Drawing { ending: "map.png", sheet: Sheet::Picture(failure_map(&plot)?) })
}

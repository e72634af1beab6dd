//! Where each method loses its digits, as a map: an eye one unit above a plane, at a shallow angle and far
//! away from the point p_0.

use lab::plot::{MapAxis, MapPlot, failure_map};
use lab::{Draw, cells};
use math::Real;
use stage::{Drawing, Error, Sheet, TradeAsk};

use crate::stage::RayPlane;

/// Judges both methods by distance and slope, and draws `map.png`.
pub(crate) fn draw(ask: &TradeAsk) -> Result<Drawing, Error> {
    let (cells_a_side, per_cell) = if ask.quick { (32, 4) } else { (48, 8) };
    let axis = |title: &str, high| MapAxis { title: title.to_string(), low: 0, high, cells: cells_a_side };
    let (x, y) = (axis("distance of p_0, in heights of the eye", 16), axis("slope of the ray", -16));
    let panels = cells(&RayPlane, ask, &x, &y, per_cell, at_a_slope);
    let plot = MapPlot {
        title: "Ray against plane: where the digits go".to_string(),
        subtitle: format!(
            "An eye one unit above a tilted plane. Each cell is the worst of {per_cell} rays against the exact oracle, \
             seed {}.",
            ask.seed
        ),
        x,
        y,
        columns: 2,
        panels,
    };
    Ok(Drawing { ending: "map.png", sheet: Sheet::Picture(failure_map(&plot)?) })
}

/// The eye is one unit above a plane that is no axis', p_0 is `distance` away from the point below it, and
/// the ray falls by `slope` a unit: both dot products cancel, n · (p_r − p_0) to 1 and n · u_r to the
/// slope.
///
/// All four vectors are rounded. Height and slope are what was asked for only as far as their numbers
/// can say it: beyond that every other ray has the plane behind it.
fn at_a_slope(draw: &mut Draw, distance: f64, slope: f64) -> [f64; 12] {
    let n = draw.direction();
    let (away, along) = (draw.perpendicular(n), draw.perpendicular(n));
    let p_r = f64::vec3(0.0, 0.0, 0.0);
    let p_0 = p_r - n + away * distance;
    let u_r = along - n * slope;
    [p_r.x, p_r.y, p_r.z, u_r.x, u_r.y, u_r.z, p_0.x, p_0.y, p_0.z, n.x, n.y, n.z]
}

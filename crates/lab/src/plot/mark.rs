//! The sign of one method at one precision.

use stage::{Color, Precision};

use super::palette::INK;
use super::pen::Stroke;
use super::svg::{Point, Svg};

/// How a mark looks: color by method, shape by precision, hollow and crossed where a verdict is wrong,
/// larger and outlined on the front. All but the color survive a printer without colors.
#[derive(Clone, Copy)]
pub(super) struct Look {
    pub(super) color: Color,
    pub(super) precision: Precision,
    pub(super) is_wrong: bool,
    pub(super) on_front: bool,
}

impl Look {
    /// How far it reaches from its center.
    pub(super) fn radius(self) -> f64 {
        if self.on_front { 7.5 } else { 5.0 }
    }
}

/// The staircase of the Pareto front.
pub(super) const FRONT: Stroke = Stroke { color: INK, width: 2.0, opacity: 0.75, dash: "" };

/// Draws a mark around its place.
pub(super) fn draw(svg: &mut Svg, center: Point, look: Look) {
    let radius = look.radius();
    if look.is_wrong && look.on_front {
        shape(svg, center, radius - 0.8, Some(Color::WHITE), Stroke::solid(INK, 1.6), look.precision);
        cross(svg, center, radius - 1.8, Stroke::solid(look.color, 2.8), look.precision);
    } else if look.is_wrong {
        cross(svg, center, radius - 0.8, Stroke::solid(look.color, 1.6), look.precision);
        shape(svg, center, radius - 0.8, None, Stroke::solid(look.color, 1.6), look.precision);
    } else if look.on_front {
        shape(svg, center, radius - 0.75, Some(look.color), Stroke::solid(INK, 1.6), look.precision);
    } else {
        // the white rim keeps neighbors apart
        shape(svg, center, radius, Some(look.color), Stroke::solid(Color::WHITE, 0.8), look.precision);
    }
}

fn shape(
    svg: &mut Svg,
    center: Point,
    radius: f64,
    fill: Option<Color>,
    stroke: Stroke,
    precision: Precision,
) {
    match precision {
        Precision::F64 => svg.circle(center, radius, fill, stroke),
        Precision::F32 => {
            // a square of the circle's area
            let half = 0.886 * radius;
            let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
            svg.shape(&corners.map(|(dx, dy)| (center.0 + dx, center.1 + dy)), fill, stroke);
        }
    }
}

/// Both diagonals, from rim to rim.
fn cross(svg: &mut Svg, (x, y): Point, radius: f64, stroke: Stroke, precision: Precision) {
    let half = match precision {
        Precision::F64 => 0.65 * radius,
        Precision::F32 => 0.82 * radius,
    };
    svg.line((x - half, y - half), (x + half, y + half), stroke);
    svg.line((x - half, y + half), (x + half, y - half), stroke);
}

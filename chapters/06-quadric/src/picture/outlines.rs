//! The true cone's outline over the printed one's.

use stage::{Anchor, Canvas, Color, Pen, View};

use super::area::{Area, LIST};
use super::captions;
use super::panels::{HEIGHT, Layout, Panel, WIDTH};
use crate::printed::{printed_radius, radius};

/// Draws both in the plane y = 0, with their radii at three heights.
pub(crate) fn outlines(canvas: &mut Canvas, layout: &Layout) {
    let corner = layout.corner(Panel::Outlines);
    let (view, area) = (Panel::Outlines.view(corner), Area::of_section(corner));
    let cone: Vec<_> = [(0.5, 0.0), (0.0, 1.0), (-0.5, 0.0)].map(|point| view.at(point)).into();
    canvas.area(&cone, Color([236, 240, 244]));
    ellipse(canvas, &view, &area);
    for side in [1.0, -1.0] {
        view.line(canvas, (side * radius(0.0), 0.0), (0.0, 1.0), Pen::solid(Color::BLUE, 2.2));
    }
    view.line(canvas, (-0.5, 0.0), (0.5, 0.0), Pen::solid(Color::PURPLE, 2.6));
    for (i, z) in HEIGHTS.into_iter().enumerate() {
        let (inner, outer) = (radius(z), printed_radius(z));
        view.line(canvas, (inner, z), (outer, z), Pen::solid(Color::GRAY, 1.0));
        canvas.disc(view.at((inner, z)), 3.0, Color::BLUE);
        canvas.disc(view.at((outer, z)), 3.0, Color::VERMILLION);
        let at = view.at((outer, z));
        canvas.label((at.0 + 8.0, at.1 + 3.5), Anchor::Left, 10.5, Color::GRAY, &format!("z = {z}"));
        row(
            canvas,
            corner,
            i + 1,
            [&format!("{z}"), &format!("{inner}"), &format!("{outer:.3}")],
            Color::BLACK,
        );
    }
    row(canvas, corner, 0, ["z", "½(1 − z)", "½√(1 − z²)"], Color::GRAY);
    captions(canvas, corner, ["both in the plane y = 0", "the cone: straight; as printed: an ellipse"]);
}

/// The heights at which the radii are compared.
const HEIGHTS: [f64; 3] = [0.75, 0.5, 0.25];

/// The printed curve: half an ellipse above z = 0, its other half dashed.
fn ellipse(canvas: &mut Canvas, view: &View, area: &Area) {
    const STEPS: u32 = 96;
    // In equal steps of the half angle's tangent the points lie close where the curve bends.
    let at = |step: u32| {
        let s = f64::from(step) / f64::from(STEPS);
        let (sine, cosine) = (2.0 * s / (1.0 + s * s), (1.0 - s * s) / (1.0 + s * s));
        (0.5 * cosine, sine)
    };
    for step in 0..STEPS {
        for (x, z) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
            let [from, to] = [at(step), at(step + 1)].map(|(across, up)| view.at((x * across, z * up)));
            let Some((from, to)) = area.clip(from, to) else { continue };
            match z > 0.0 {
                true => canvas.line(from, to, Pen::solid(Color::VERMILLION, 2.2)),
                false if step / 3 % 2 == 0 => canvas.line(from, to, Pen::solid(Color::VERMILLION, 1.2)),
                false => {}
            }
        }
    }
}

/// A line of the table below: a height and the two radii.
fn row(canvas: &mut Canvas, (left, top): (f32, f32), line: usize, cells: [&str; 3], color: Color) {
    let y = top + HEIGHT - LIST + 14.0 + 15.0 * line as f32;
    for (cell, x) in cells.into_iter().zip([40.0, 105.0, WIDTH - 56.0]) {
        canvas.label((left + x, y), Anchor::Middle, 10.5, color, cell);
    }
}

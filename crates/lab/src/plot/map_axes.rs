//! What stands around the panels of a failure map: titles, numbers, and the key to the colors.

use stage::{Anchor, Canvas, Color, Pen};

use super::heat::{self, LAST_POWER};
use super::map::{Cell, Frame, MapAxis, MapPlot, swatch};
use super::palette::{DIM, INK};

const NUMBER: f32 = 20.0;
/// From one number to the next, at least: along the horizontal axis and the vertical one.
const APART: (f32, f32) = (84.0, 48.0);

/// Draws the frame of a panel and the numbers along its axes; along the vertical one only where the panel
/// is the first of its row.
pub(super) fn axes(canvas: &mut Canvas, plot: &MapPlot, frame: Frame, is_first: bool) {
    let Frame { left, top, right, bottom } = frame;
    canvas.frame((left - 0.5, top - 0.5), (right + 0.5, bottom + 0.5), Pen::solid(DIM, 1.0));
    // every second line has a number
    for (_, share) in ticks(&plot.x, right - left, APART.0 / 2.0) {
        let x = left + share * (right - left);
        canvas.line((x, bottom), (x, bottom + 4.0), Pen::solid(DIM, 1.0));
    }
    for (exponent, share) in ticks(&plot.x, right - left, APART.0) {
        let x = left + share * (right - left);
        canvas.line((x, bottom), (x, bottom + 8.0), Pen::solid(DIM, 1.0));
        power_of_ten(canvas, (x, bottom + 28.0), Anchor::Middle, (NUMBER, DIM), ("", exponent));
    }
    for (exponent, share) in ticks(&plot.y, bottom - top, APART.1) {
        let y = bottom - share * (bottom - top);
        canvas.line((left - 6.0, y), (left, y), Pen::solid(DIM, 1.0));
        if is_first {
            power_of_ten(canvas, (left - 12.0, y + 7.0), Anchor::Right, (NUMBER, DIM), ("", exponent));
        }
    }
}

/// The powers of ten that are named along an axis, each with its share of the way: as many as have room.
fn ticks(axis: &MapAxis, length: f32, apart: f32) -> Vec<(i32, f32)> {
    let span = axis.high.abs_diff(axis.low).max(1);
    let most = (length / apart).max(1.0) as u32;
    let every =
        [1, 2, 4, 8, 16, 32, 64, 128, 256].into_iter().find(|every| span / every <= most).unwrap_or(512);
    let (first, last) = (axis.low.min(axis.high), axis.low.max(axis.high));
    let exponents = (first..=last).filter(|exponent| exponent.rem_euclid(every as i32) == 0);
    exponents.map(|exponent| (exponent, exponent.abs_diff(axis.low) as f32 / span as f32)).collect()
}

/// Writes a power of ten, with what stands before it. The exponent is made of smaller digits, raised:
/// the bundled font has no raised 1.
fn power_of_ten(
    canvas: &mut Canvas,
    (x, y): (f32, f32),
    anchor: Anchor,
    (size, color): (f32, Color),
    (before, exponent): (&str, i32),
) {
    if exponent == 0 {
        return canvas.label((x, y), anchor, size, color, &format!("{before}1"));
    }
    let raised = if exponent < 0 { format!("−{}", -exponent) } else { exponent.to_string() };
    // all digits of the font are this wide, and a minus sign is a little wider
    const DIGIT: f32 = 0.636;
    let small = 0.72 * size;
    let minus = if exponent < 0 { 0.2 } else { 0.0 };
    let wide = small * (DIGIT * raised.chars().count() as f32 + minus);
    let base = DIGIT * 2.0 * size;
    let end_of_base = match anchor {
        Anchor::Left => x + base,
        Anchor::Middle => x + (base - wide) / 2.0,
        Anchor::Right => x - wide,
    };
    canvas.label((end_of_base, y), Anchor::Right, size, color, &format!("{before}10"));
    canvas.label((end_of_base + 0.5, y - 0.4 * size), Anchor::Left, small, color, &raised);
}

/// Draws what the colors mean.
pub(super) fn key(canvas: &mut Canvas, (left, top): (f32, f32)) {
    const LENGTH: u16 = 420;
    const LETTERS: f32 = 20.0;
    let (right, bottom) = (left + f32::from(LENGTH), top + 18.0);
    for step in 0..LENGTH {
        let power = f64::from(LAST_POWER) * f64::from(step) / f64::from(LENGTH);
        let x = left + f32::from(step);
        canvas.rectangle((x, top), (x + 1.0, bottom), heat::of_power(power), 1.0);
    }
    for power in (0..=LAST_POWER).step_by(4) {
        let x = left + f32::from(LENGTH) * power as f32 / LAST_POWER as f32;
        let before = match power {
            0 => "≤ ",
            LAST_POWER => "≥ ",
            _ => "",
        };
        canvas.line((x, bottom), (x, bottom + 5.0), Pen::solid(DIM, 1.0));
        let place = (x, bottom + 28.0);
        power_of_ten(canvas, place, Anchor::Middle, (LETTERS, INK), (before, power));
    }
    let baseline = bottom - 2.0;
    canvas.label((right + 16.0, baseline), Anchor::Left, LETTERS, INK, "ulps: the worst error of t");

    let wrong = right + 340.0;
    for column in 0..12 {
        for row in 0..2 {
            let share = (f64::from(column) + 0.5) / 12.0;
            let (x, y) = (wrong + 9.0 * column as f32, top + 9.0 * row as f32);
            swatch(canvas, (x, y), (x + 9.0, y + 9.0), Cell::Wrong(share), (column + row) % 2 == 1);
        }
    }
    canvas.label((wrong + 124.0, baseline), Anchor::Left, LETTERS, INK, "some … all verdicts wrong");
    let empty = wrong + 450.0;
    swatch(canvas, (empty, top), (empty + 27.0, bottom), Cell::Empty, false);
    canvas.frame((empty, top), (empty + 27.0, bottom), Pen::solid(DIM, 1.0));
    canvas.label((empty + 38.0, baseline), Anchor::Left, LETTERS, INK, "no case");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_lie_at_their_share_of_the_way() {
        let axis = |low, high| MapAxis { title: String::new(), low, high, cells: 8 };
        assert_eq!(ticks(&axis(0, 16), 250.0, 56.0), [(0, 0.0), (4, 0.25), (8, 0.5), (12, 0.75), (16, 1.0)]);
        assert_eq!(ticks(&axis(0, -16), 120.0, 56.0), [(-16, 1.0), (-8, 0.5), (0, 0.0)]);
        assert_eq!(ticks(&axis(-3, -3), 120.0, 56.0), [(-3, 0.0)]);
        assert!(ticks(&axis(-323, 308), 300.0, 56.0).len() < 8);
    }
}

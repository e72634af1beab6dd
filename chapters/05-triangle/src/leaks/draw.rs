//! The ball shot along its edges, leaks in red, method beside method.

use lab::Vec3;
use lab::table::short;
use math::Real;
use stage::{Anchor, Canvas, Color, Drawing, Error, Pen, Precision, Sheet, View};

use super::target::Target;
use super::{CENTERS, Volley};
use crate::Method;
use crate::mesh::ball;

/// So many of the shots are drawn: more would hide each other.
const SHOWN: usize = 6000;
/// One ball with its name, in pixels.
const PANEL: (f32, f32) = (420.0, 440.0);
const HEAD: f32 = 76.0;

/// A panel a method, and below it the other precision: `leaks.png`.
pub(crate) fn draw(volleys: &[Volley]) -> Result<Drawing, Error> {
    let size = (3.0 * PANEL.0, HEAD + 2.0 * PANEL.1);
    let mut canvas = Canvas::new((size.0 as u32, size.1 as u32), Color::WHITE)?;
    let title = "Shot from inside at its edges and vertices: where rays slip through a closed ball";
    canvas.label((20.0, 32.0), Anchor::Left, 22.0, Color::BLACK, title);
    let count = volleys.first().map_or(0, |volley| volley.shots.len());
    let share = format!(
        "{count} rays a panel; of the first {} those at the half of the ball in front are drawn. A small dot: the ray \
         meets the ball; a large one: it leaks",
        count.min(SHOWN)
    );
    canvas.label((20.0, 58.0), Anchor::Left, 15.0, Color::GRAY, &share);
    let target = Target::new(ball::bumpy_ball::<f64>(ball::DIVISIONS, CENTERS[0]));
    for volley in volleys.iter().filter(|volley| volley.place == 0) {
        let column = Method::ALL.iter().position(|&method| method == volley.method).unwrap_or(0);
        let row = if volley.precision == Precision::F32 { 0.0 } else { 1.0 };
        let corner = (column as f32 * PANEL.0, HEAD + row * PANEL.1);
        let (from, to) =
            ((corner.0 + 16.0, corner.1), (corner.0 + PANEL.0 - 16.0, corner.1 + PANEL.1 - 52.0));
        let shots = volley.shots.iter().take(SHOWN).copied();
        shot_ball(&mut canvas, &target, &view(from, to), shots, 1.0);
        let middle = corner.0 + PANEL.0 / 2.0;
        let name = format!("{} · {}", volley.method.name(), volley.precision.name());
        let leaks = format!("{} leaks in a million", short(volley.per_million()));
        canvas.label((middle, to.1 + 16.0), Anchor::Middle, 17.0, Color::BLACK, &name);
        canvas.label((middle, to.1 + 37.0), Anchor::Middle, 15.0, Color::GRAY, &leaks);
    }
    Ok(Drawing { ending: "leaks.png", sheet: Sheet::Picture(canvas) })
}

/// All of a ball around (0, 0), seen along −z, in a part of a picture.
pub(crate) fn view(from: (f32, f32), to: (f32, f32)) -> View {
    View::new((-1.25, -1.25), (1.25, 1.25), from, to)
}

/// The front half of a ball around the origin: its edges, and what was shot at. A dot where the ray meets the ball,
/// a large one where it leaks; `size` is that of a line.
pub(crate) fn shot_ball<R: Real>(
    canvas: &mut Canvas,
    target: &Target<R>,
    view: &View,
    shots: impl Iterator<Item = (Vec3, bool)> + Clone,
    size: f32,
) {
    let at = |v: Vec3| view.at((v.x, v.y));
    for edge in target.edges() {
        let [a, b] = edge.map(|vertex| target.vertex(vertex));
        if a.z + b.z >= 0.0 {
            canvas.line(at(a), at(b), Pen::solid(Color::PALE, size));
        }
    }
    // the leaks last, so that nothing hides them
    for leaks in [false, true] {
        for (point, _) in shots.clone().filter(|(point, leaked)| *leaked == leaks && point.z >= 0.0) {
            let (radius, color) =
                if leaks { (2.6 * size, Color::VERMILLION) } else { (0.9 * size, Color::BLUE) };
            canvas.disc(at(point), radius, color);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_leak_is_drawn_over_what_hits_and_what_is_behind_is_not_drawn() {
        let target = Target::new(ball::bumpy_ball::<f64>(0, [0.0; 3]));
        let view = view((0.0, 0.0), (100.0, 100.0));
        let colors = |shots: &[(Vec3, bool)]| {
            let mut canvas = Canvas::new((100, 100), Color::WHITE).unwrap();
            shot_ball(&mut canvas, &target, &view, shots.iter().copied(), 4.0);
            [(50, 50), (20, 20)].map(|(col, row)| canvas.pixel(col, row).unwrap())
        };
        let front = Vec3::new(0.0, 0.0, 1.0);
        // by hand: (−0.75, 0.75) is 0.5 and 0.5 from the view's top left corner, 2.5 across: pixel 20, 20
        let behind = Vec3::new(-0.75, 0.75, -0.1);
        assert_eq!(colors(&[(front, true), (front, false)])[0], Color::VERMILLION);
        assert_eq!(colors(&[(front, false), (behind, true)]), [Color::BLUE, Color::WHITE]);
    }
}

//! A concave star with test rays, and a pentagram by both rules.

use math::Real;
use stage::{Anchor, Canvas, Color, Pen, View};

use super::{CONCAVE, GROUND, PENTAGRAMS, Part, view_in};
use crate::polygon::{Polygon, Rule, even_odd, star};

const INSIDE: Color = Color([150, 196, 226]);

/// The star to the left, and room for the test rays to the right of it.
pub(super) fn concave_view() -> View {
    view_in(&CONCAVE, (-11.5, -8.8), (26.5, 11.0), 2.0, 0.0)
}

pub(super) fn pentagram_view(part: &Part) -> View {
    view_in(part, (-10.5, -8.5), (10.5, 10.5), 4.0, 22.0)
}

/// Inside or outside, at a point of the plane of the star.
pub(super) fn color<R: Real>(star: &Polygon<R>, rule: Rule, (x, y): (f64, f64)) -> Color {
    let point = R::vec3(R::round_from(x), R::round_from(y), R::from(0.0));
    if star.holds(rule, point) { INSIDE } else { GROUND }
}

/// The concave star with three test rays, the sides that each crosses, and what their number means.
pub(super) fn concave<R: Real>(canvas: &mut Canvas, polygon: &Polygon<R>) {
    let view = concave_view();
    outline(canvas, &view, &star::CONCAVE);
    for start in [[-6.0, 6.5], [0.0, 3.0], [0.0, -1.0]] {
        let work = even_odd(polygon.outline(), start.map(R::from));
        let [x, y] = start.map(f64::from);
        view.arrow(canvas, (x, y), (13.0, y), Pen::solid(Color::VERMILLION, 1.4));
        canvas.disc(view.at((x, y)), 3.0, Color::BLACK);
        for crossing in &work.crossings {
            canvas.circle(view.at((x + crossing.t.into(), y)), 4.0, Pen::solid(Color::BLACK, 1.4));
        }
        let place = if work.is_inside() { "odd: inside" } else { "even: outside" };
        let text = format!("{}, {place}", work.crossings.len());
        let (label_x, label_y) = view.at((13.6, y));
        canvas.label((label_x, label_y + 4.0), Anchor::Left, 12.0, Color::BLACK, &text);
    }
    let right = (CONCAVE.to.0 - 8.0, CONCAVE.to.1 - 9.0);
    canvas.label(right, Anchor::Right, 11.0, Color::GRAY, "a corner counts once");
}

/// The pentagram by even-odd and by winding, with its winding numbers.
pub(super) fn pentagrams<R: Real>(canvas: &mut Canvas, polygon: &Polygon<R>) {
    for (part, rule) in PENTAGRAMS.iter().zip(Rule::ALL) {
        let view = pentagram_view(part);
        outline(canvas, &view, &star::PENTAGRAM);
        for (x, y) in [(0.0, 0.0), (0.0, 6.0), (-6.5, 2.0), (6.5, 2.0), (-4.0, -5.4), (4.0, -5.4)] {
            let point = [x, y].map(R::round_from);
            let number = crate::polygon::winding(polygon.outline(), point).number;
            let (x, y) = view.at((x, y));
            canvas.label((x, y + 4.0), Anchor::Middle, 11.0, Color::BLACK, &number.to_string());
        }
        let text = match rule {
            Rule::EvenOdd => "even-odd: odd is in",
            Rule::Winding => "winding: ≠ 0 is in",
        };
        let middle = (part.from.0 + part.to.0) / 2.0;
        canvas.label((middle, part.to.1 - 7.0), Anchor::Middle, 12.0, Color::BLACK, text);
    }
}

fn outline(canvas: &mut Canvas, view: &View, corners: &[[f32; 2]]) {
    let corners: Vec<_> = corners.iter().map(|&[x, y]| (f64::from(x), f64::from(y))).collect();
    for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        view.line(canvas, from, to, Pen::solid(Color::BLACK, 1.2));
    }
}

//! The squashed sphere cut open: the unit circle with n, and the deformed one with A⁻ᵀ n and with A n.

use math::{Real, Vector};
use stage::{Anchor, Canvas, Color, Pen, View};

use super::layout::Part;
use super::{RIGHT, WRONG, plate};
use crate::{Deformed, Matrix3};

/// Where normals are drawn: eight points of the unit circle with exact coordinates, an eighth of a turn apart or
/// all but that.
const POINTS: [(f32, f32, f32); 8] = [
    (1.0, 0.0, 1.0),
    (21.0, 20.0, 29.0),
    (0.0, 1.0, 1.0),
    (-20.0, 21.0, 29.0),
    (-1.0, 0.0, 1.0),
    (-21.0, -20.0, 29.0),
    (0.0, -1.0, 1.0),
    (20.0, -21.0, 29.0),
];

/// How long the normals are drawn, and half a tangent.
const NORMAL: f64 = 0.6;
const TANGENT: f64 = 0.42;

/// What the circle takes, and both halves are drawn to the same scale.
const HALF_HEIGHT: f64 = 1.62;

/// The section through the middle of the squashed sphere, at right angles to the view.
pub(crate) fn draw<R: Real>(canvas: &mut Canvas, part: &Part, sphere: &Deformed<R>) {
    plate(canvas, part);
    let half = |left: f32, width: f32| {
        let wide = HALF_HEIGHT * f64::from(width) / 150.0;
        View::new(
            (-wide, -HALF_HEIGHT),
            (wide, HALF_HEIGHT),
            part.at(left, 28.0),
            part.at(left + width, 178.0),
        )
    };
    let (before, after) = (half(2.0, 148.0), half(150.0, 176.0));
    let a = &sphere.affine.a;
    outline(canvas, &before, &Matrix3::<R>::identity());
    outline(canvas, &after, a);
    for (x, y, length) in POINTS {
        let [x, y, length] = [x, y, length].map(R::from);
        let zero = R::from(0.0);
        let n = R::vec3(x / length, y / length, zero); // and the point itself
        let along = R::vec3(-y / length, x / length, zero);
        arrow::<R>(canvas, &before, n, n, Pen::solid(Color::BLACK, 1.6));

        let q = a.times(n);
        let right = sphere.inverse.transposed_times(n).normalized();
        tangent::<R>(canvas, &after, q, a.times(along).normalized());
        arrow::<R>(canvas, &after, q, a.times(n).normalized(), Pen { dash: 3.0, ..Pen::solid(WRONG, 1.8) });
        arrow::<R>(canvas, &after, q, right, Pen::solid(RIGHT, 1.8));
    }
    words(canvas, part, &before, &after);
}

fn words(canvas: &mut Canvas, part: &Part, before: &View, after: &View) {
    let black = Color::BLACK;
    canvas.label(part.at(10.0, 17.0), Anchor::Left, 12.0, black, "The sphere cut open: n before and after A");
    for (view, name) in [(before, "n"), (after, "A")] {
        let (x, y) = view.at((0.0, 0.0));
        if name == "n" {
            canvas.label((x, y + 4.0), Anchor::Middle, 12.0, black, "‖x‖ = 1");
        } else {
            canvas.label((x, y + 4.0), Anchor::Middle, 12.0, black, "A x");
        }
    }
    let rows = [
        (58.0, Pen::solid(RIGHT, 1.8), "A⁻ᵀ n", "at right angles"),
        (108.0, Pen { dash: 3.0, ..Pen::solid(WRONG, 1.8) }, "A n", "wrong: askew"),
    ];
    for (down, pen, name, meaning) in rows {
        let (start, end) = (part.at(318.0, down - 4.0), part.at(342.0, down - 4.0));
        canvas.arrow(start, end, pen);
        canvas.label(part.at(348.0, down), Anchor::Left, 12.0, pen.color, name);
        canvas.label(part.at(318.0, down + 16.0), Anchor::Left, 11.0, black, meaning);
    }
    canvas.line(part.at(318.0, 148.0), part.at(342.0, 148.0), Pen::solid(Color::GRAY, 1.4));
    canvas.label(part.at(348.0, 152.0), Anchor::Left, 11.0, black, "tangent");
}

/// The unit circle deformed.
fn outline<R: Real>(canvas: &mut Canvas, view: &View, a: &Matrix3<R>) {
    let points: Vec<_> = circle().map(|(x, y)| place::<R>(view, a.times(flat::<R>(x, y)))).collect();
    canvas.area(&points, Color([246, 240, 226]));
    for (i, &point) in points.iter().enumerate() {
        canvas.line(point, points[(i + 1) % points.len()], Pen::solid(Color::BLACK, 1.4));
    }
}

/// Points around the unit circle, without sines: (1 − u², 2u) / (1 + u²) is a quarter of it for u from 0 to 1, and
/// the others are that one turned.
fn circle() -> impl Iterator<Item = (f64, f64)> {
    const QUARTER: u32 = 24;
    (0..4 * QUARTER).map(|i| {
        let u = f64::from(i % QUARTER) / f64::from(QUARTER);
        let (x, y) = ((1.0 - u * u) / (1.0 + u * u), 2.0 * u / (1.0 + u * u));
        match i / QUARTER {
            0 => (x, y),
            1 => (-y, x),
            2 => (-x, -y),
            _ => (y, -x),
        }
    })
}

fn flat<R: Real>(x: f64, y: f64) -> R::Vec3 {
    R::vec3(R::round_from(x), R::round_from(y), R::from(0.0))
}

fn place<R: Real>(view: &View, point: impl Vector<R>) -> (f32, f32) {
    let [x, y, _] = point.in_f64();
    view.at((x, y))
}

fn arrow<R: Real>(canvas: &mut Canvas, view: &View, from: R::Vec3, direction: R::Vec3, pen: Pen) {
    let to = from + direction * R::round_from(NORMAL);
    canvas.arrow(place::<R>(view, from), place::<R>(view, to), pen);
}

fn tangent<R: Real>(canvas: &mut Canvas, view: &View, at: R::Vec3, direction: R::Vec3) {
    let half = direction * R::round_from(TANGENT);
    canvas.line(place::<R>(view, at - half), place::<R>(view, at + half), Pen::solid(Color::GRAY, 1.4));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::squashed;
    use crate::{Deformed, Object};
    use glam::DVec3;

    /// By hand: 20² + 21² = 29². What is drawn in blue is at right angles to the tangent, what is drawn in
    /// vermillion is not, at each of the eight.
    #[test]
    fn the_blue_arrows_are_at_right_angles_and_the_others_are_not() {
        let sphere = Deformed::<f64>::new(Object::Sphere, squashed()).unwrap();
        for (x, y, length) in POINTS.map(|(x, y, length)| (f64::from(x), f64::from(y), f64::from(length))) {
            assert_eq!(x * x + y * y, length * length);
            let n = DVec3::new(x / length, y / length, 0.0);
            let tangent = sphere.affine.a.times(DVec3::new(-n.y, n.x, 0.0)).normalize();
            let right = sphere.inverse.transposed_times(n).normalize();
            assert!(right.dot(tangent).abs() < 1e-15);
            assert!(sphere.affine.a.times(n).normalize().dot(tangent).abs() > 0.3);
        }
    }
}

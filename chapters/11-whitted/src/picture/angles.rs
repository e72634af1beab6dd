//! Light that leaves water, and dense flint: before the critical angle, at it, and beyond.

use math::{Real, Vector};
use stage::{Anchor, Canvas, Color, Pen};

use super::{LETTERS, color_of, plate};
use crate::{Kind, critical_angle, mirror, refract};

/// How long the rays are.
const LENGTH: f64 = 84.0;
/// And how far to the side they may reach.
const WIDTH: f64 = 62.0;

/// A drawing for each of the page's two indices, between two corners of a canvas.
pub(super) fn draw(canvas: &mut Canvas, from: (f32, f32), to: (f32, f32)) {
    plate(canvas, from, to);
    canvas.label(
        (from.0 + 10.0, from.1 + 18.0),
        Anchor::Left,
        LETTERS,
        Color::BLACK,
        "out of a slower medium",
    );
    let half = (to.0 - from.0) / 2.0;
    let media = [
        ("water", 1.33, [20.0, 38.0, 62.0], Color([206, 230, 246])),
        ("flint", 1.8, [12.0, 26.0, 50.0], Color([206, 236, 222])),
    ];
    for (place, (name, n, angles, tint)) in (0_u8..).zip(media) {
        let left = from.0 + f32::from(place) * half;
        let corners = ((left + 6.0, from.1 + 28.0), (left + half - 6.0, to.1 - 6.0));
        one(canvas, name, n, angles, tint, corners);
    }
}

/// One medium: from within, at three angles and at the critical one.
fn one(
    canvas: &mut Canvas,
    name: &str,
    n: f64,
    angles: [f64; 3],
    tint: Color,
    (from, to): ((f32, f32), (f32, f32)),
) {
    let o = ((from.0 + to.0) / 2.0, from.1 + 98.0);
    canvas.rectangle((from.0, o.1), to, tint, 1.0);
    canvas.line((from.0, o.1), (to.0, o.1), Pen::solid(Color::GRAY, 1.0));
    canvas.line((o.0, o.1 - LENGTH as f32), (o.0, o.1 + LENGTH as f32), Pen::dashed(Color::GRAY, 0.8));
    let Some(critical) = critical_angle(n, 1.0) else { return };
    for theta in angles {
        ray(canvas, o, n, theta, 1.4);
    }
    ray(canvas, o, n, critical, 2.6);
    let (x, below) = (o.0, to.1 - 9.0);
    canvas.label((x, below - 16.0), Anchor::Middle, LETTERS, Color::BLACK, &format!("{name}, n = {n}"));
    canvas.label((x, below), Anchor::Middle, LETTERS, Color::BLACK, &format!("θ_c = {critical:.2}°"));
}

/// Light that comes to the surface at θ1 degrees, and goes on from there. At the critical angle it leaves
/// along the surface.
fn ray(canvas: &mut Canvas, o: (f32, f32), n: f64, theta1: f64, width: f32) {
    let up = f64::vec3(0.0, 1.0, 0.0);
    let (sin, cos) = (math::portable::sin(theta1.to_radians()), math::portable::cos(theta1.to_radians()));
    let d = f64::vec3(sin, cos, 0.0);
    let at = |v: <f64 as Real>::Vec3, length: f64| {
        let [x, y, _] = f64::xyz(v);
        (o.0 + (length * x) as f32, o.1 - (length * y) as f32)
    };
    canvas.line(at(-d, LENGTH.min(WIDTH / sin)), o, Pen::solid(Color::BLACK, width));
    let (kind, on) = match refract::<f64>(d, -up, n, 1.0).t {
        Some(t) => (Kind::Refracted, t),
        None if width > 2.0 => (Kind::Refracted, f64::vec3(1.0, 0.0, 0.0)),
        None => (Kind::Mirror, mirror::<f64>(d, -up).m_s),
    };
    let on = on.unit();
    let length = LENGTH.min(WIDTH / f64::xyz(on)[0]);
    canvas.arrow(o, at(on, length), Pen::solid(color_of(kind), width));
}

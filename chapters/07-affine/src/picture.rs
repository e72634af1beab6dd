//! The picture: the five deformed objects, and what A n gets wrong on the squashed sphere.

mod extent;
mod layout;
mod pair;
mod section;

use math::{Camera, Ray3, Real, Vector};
use stage::{Anchor, Canvas, Color, Error, Pen};

use crate::scene::{Placed, first, pixel_ray, seen_at};
use crate::{Method, Object};
use extent::Extent;
pub(crate) use layout::Layout;
use layout::Part;
use pair::Pair;

const SKY: Color = Color([214, 228, 240]);
/// The tiles of the plane: the mean of their two colors, and how far each is from it.
const TILES: [(f64, f64); 3] = [(211.0, 25.0), (213.0, 23.0), (212.0, 18.0)];
/// Tiles farther than this many lengths of d⃗ fade.
const FADED: f64 = 8.0;
/// The normal by A⁻ᵀ and the one by A: blue and vermillion, and the second is dashed.
const RIGHT: Color = Color::BLUE;
const WRONG: Color = Color::VERMILLION;

/// One ray a pixel, the names, the section and the pair below, and a ring around the ray of the transcript.
pub(crate) fn draw<R: Real>(
    method: Method,
    size: (u32, u32),
    camera: &Camera<R>,
    objects: &[Placed<R>],
    explained: &Ray3<R>,
) -> Result<Canvas, Error> {
    let layout = Layout::of(size);
    let mut canvas = Canvas::new(size, SKY)?;
    canvas.fit(layout.frame.0, layout.frame.1);
    let squashed = &objects[0];
    let pair = Pair::new(method, squashed, layout.pair);
    let objects_seen: Vec<_> = objects.iter().map(|placed| (Extent::of(placed), placed)).collect();
    canvas.shade(|col, row| {
        let place = layout.place_of(size, (col, row));
        match () {
            _ if layout.pair.holds(place) => pair.color(place),
            _ if layout.section.holds(place) => Color::WHITE,
            _ => color(method, &pixel_ray(camera, size, (col, row)), &objects_seen),
        }
    });
    name_objects(&mut canvas, &layout, objects);
    section::draw(&mut canvas, &layout.section, &squashed.deformed);
    frame(&mut canvas, &layout.pair);
    pair.words(&mut canvas);
    let ((left, top), (right, _)) = canvas.corners();
    let name = format!("{} · {}", method.name(), R::NAME);
    canvas.plate((left + 10.0, top + 18.0), Anchor::Left, 13.0, Color::BLACK, &name);
    canvas.plate((right - 10.0, top + 18.0), Anchor::Right, 12.0, Color::BLACK, "the ray of the transcript");
    if canvas.is_readable(12.0) {
        ring(&mut canvas, (right - 174.0, top + 14.0));
    }
    mark(&mut canvas, &layout, explained);
    Ok(canvas)
}

/// The color of what a ray from the eye meets first.
fn color<R: Real>(method: Method, ray: &Ray3<R>, objects: &[(Extent, &Placed<R>)]) -> Color {
    let [x, y, _]: [f64; 3] = ray.direction.in_f64();
    let may_be_seen = objects.iter().filter(|(extent, _)| extent.holds((x, y))).map(|(_, placed)| *placed);
    let Some((placed, found)) = first(method, ray, may_be_seen) else { return SKY };
    let normal = found.normal();
    // a surface without an inside is seen from both sides
    let is_away = placed.deformed.object.is_flat() && normal.dot(ray.direction) > R::from(0.0);
    let normal = if is_away { -normal } else { normal };
    match placed.deformed.object {
        Object::Plane => tile::<R>(found.p, found.lambda),
        _ => light::<R>(placed.color, normal),
    }
}

/// The color of a point of the plane: light or dark by the parity of ⌊x⌋ + ⌊y⌋ in the plane's own space, so that the
/// tiles are deformed with it. Far away, where many tiles share a pixel, they fade into their mean.
fn tile<R: Real>(p: R::Vec3, lambda: R) -> Color {
    let ([x, y, _], lambda): ([f64; 3], f64) = (p.in_f64(), lambda.into());
    let is_dark = (x.floor() + y.floor()).rem_euclid(2.0) == 1.0;
    let contrast = (FADED / lambda).min(1.0) * if is_dark { -1.0 } else { 1.0 };
    Color(TILES.map(|(mean, difference)| (mean + contrast * difference) as u8))
}

/// A color in the light of a far lamp at the upper left behind the viewer: as bright as n · s, and a highlight.
fn light<R: Real>(color: [u8; 3], normal: R::Vec3) -> Color {
    let [x, y, z]: [f64; 3] = normal.in_f64();
    let n_dot_s = -0.48 * x + 0.6 * y + 0.64 * z; // (−0.48, 0.6, 0.64) has length 1
    let diffuse = 0.3 + 0.7 * n_dot_s.max(0.0);
    // the mirror direction 2 (n · s) n − s against the way to the viewer, along z
    let c_dot_m = (2.0 * n_dot_s * z - 0.64).max(0.0);
    let fourth = c_dot_m * c_dot_m * c_dot_m * c_dot_m;
    let sixteenth = fourth * fourth * fourth * fourth;
    let highlight = if n_dot_s > 0.0 { 110.0 * sixteenth } else { 0.0 };
    Color(color.map(|channel| (f64::from(channel) * diffuse + highlight).min(255.0) as u8))
}

/// A white plate with a thin frame, for what is drawn beside the scene.
fn plate(canvas: &mut Canvas, part: &Part) {
    canvas.rectangle(part.from, part.to, Color::WHITE, 1.0);
    frame(canvas, part);
}

fn frame(canvas: &mut Canvas, part: &Part) {
    canvas.frame(part.from, part.to, Pen::solid(Color::GRAY, 1.0));
}

/// The objects' names, on the ground before them.
fn name_objects<R: Real>(canvas: &mut Canvas, layout: &Layout, objects: &[Placed<R>]) {
    for placed in objects {
        let (x, y) = layout.view().at(seen_at(placed.foot));
        canvas.plate((x, y + 14.0), Anchor::Middle, 12.0, Color::BLACK, placed.name);
    }
}

/// A ring around the ray of the transcript, over everything.
fn mark<R: Real>(canvas: &mut Canvas, layout: &Layout, ray: &Ray3<R>) {
    let [x, y, _]: [f64; 3] = ray.direction.in_f64();
    ring(canvas, layout.view().at((x, y)));
}

fn ring(canvas: &mut Canvas, at: (f32, f32)) {
    canvas.circle(at, 6.0, Pen::solid(Color::WHITE, 4.0));
    canvas.circle(at, 6.0, Pen::solid(Color::BLACK, 1.8));
}

//! What an eye sees: the nearest hit of each pixel's ray, colored by its part and its normal.

use math::{Camera, Ray3, Real, Span, Vector};
use stage::{Anchor, Canvas, Color, Pen};

use super::hue;
use super::panels::{HEIGHT, Layout, Panel, WIDTH};
use crate::{Hit3, Method, Part, Shape, printed};

/// Colors the pixels of the three panels that are seen; the others stay white.
pub(crate) fn shade<R: Real>(
    canvas: &mut Canvas,
    layout: &Layout,
    method: Method,
    [cylinder, cone]: [&Camera<R>; 2],
) {
    let views = [Panel::Seen(Shape::Cylinder), Panel::Seen(Shape::Cone)].map(|panel| panel.view((0.0, 0.0)));
    canvas.shade(|col, row| {
        let (panel, place) = layout.place_of((col, row));
        let (camera, view) = match panel.shape() {
            Shape::Cylinder => (cylinder, &views[0]),
            Shape::Cone => (cone, &views[1]),
        };
        let met = |ray: &Ray3<R>| match panel {
            Panel::Seen(shape) => first(method, ray, shape),
            _ => first_as_printed(ray),
        };
        match panel {
            Panel::Seen(_) | Panel::AsPrinted => {
                let ray = panel.ray(camera, view, place);
                met(&ray).map_or(Color::WHITE, |(part, hit)| color(part, &ray, &hit))
            }
            Panel::Section(_) | Panel::Outlines => Color::WHITE,
        }
    });
}

/// The part of a solid that a ray meets first, and where.
fn first<R: Real>(method: Method, ray: &Ray3<R>, shape: Shape) -> Option<(Part, Hit3<R>)> {
    let work = method.work(ray, shape);
    Some((work.part()?, work.hit(Span::ahead()).ok()??))
}

/// The part of the printed surface that a ray hits: its base is the only place whose normal points straight down.
fn first_as_printed<R: Real>(ray: &Ray3<R>) -> Option<(Part, Hit3<R>)> {
    let hit = printed::hit(ray, Span::ahead()).ok()??;
    let is_base = R::xyz(hit.normal)[2] < R::from(0.0);
    Some((if is_base { Part::Base } else { Part::Wall }, hit))
}

/// The part's hue, darker the more its normal turns away from the eye: 0.35 + 0.65 |n · d| / ‖d‖. (Light comes in
/// chapter 10.)
fn color<R: Real>(part: Part, ray: &Ray3<R>, hit: &Hit3<R>) -> Color {
    let facing: f64 = hit.normal.dot(ray.direction.normalized()).into();
    let brightness = 0.35 + 0.65 * facing.abs();
    let Color(hue) = hue(part);
    Color(hue.map(|channel| (f64::from(channel) * brightness).round() as u8))
}

/// What the hues and the ring mean, at the bottom of a panel; `name` at its right.
pub(crate) fn legend(canvas: &mut Canvas, (left, top): (f32, f32), shape: Shape, name: &str) {
    let y = top + HEIGHT - 8.0;
    let mut x = left + 12.0;
    let parts: &[(Part, &str, f32)] = match shape {
        Shape::Cylinder => &[(Part::Wall, "wall", 44.0), (Part::Top, "cap", 40.0)],
        Shape::Cone => &[(Part::Wall, "wall", 44.0)],
    };
    for (part, text, width) in parts {
        canvas.disc((x, y - 4.0), 4.5, hue(*part));
        canvas.label((x + 8.0, y), Anchor::Left, 11.0, Color::BLACK, text);
        x += width;
    }
    ring_at(canvas, (x, y - 4.0));
    canvas.label((x + 10.0, y), Anchor::Left, 11.0, Color::BLACK, "explained");
    canvas.label((left + WIDTH - 8.0, y), Anchor::Right, 11.0, Color::GRAY, name);
}

/// The ring of the explained ray.
pub(crate) fn ring_at(canvas: &mut Canvas, at: (f32, f32)) {
    canvas.circle(at, 6.0, Pen::solid(Color::WHITE, 4.5));
    canvas.circle(at, 6.0, Pen::solid(Color::BLACK, 2.0));
}

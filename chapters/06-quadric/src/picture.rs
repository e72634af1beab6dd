//! The picture: both solids as seen, one ray a pixel; the cone as printed beside the true one; and below each the
//! upright plane of a ray with its candidates.

mod area;
mod marks;
mod outlines;
mod panels;
mod section;
mod seen;
mod slice;

use math::{Camera, Ray3, Real, Vector};
use stage::{Anchor, Canvas, Color, Error, Pen};

use crate::scene::worked;
use crate::{Method, Part, Shape};
use panels::{HEIGHT, Layout, Panel, WIDTH};
use section::section;

/// The ray of each solid that is explained: the worked example's, or a pixel's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Explained<R: Real> {
    /// The ray at the cylinder.
    pub(crate) cylinder: Ray3<R>,
    /// The ray at the cone.
    pub(crate) cone: Ray3<R>,
    /// The solid whose panel the pixel lies in; `None` where no pixel was asked for.
    pub(crate) asked: Option<Shape>,
}

impl<R: Real> Explained<R> {
    /// The worked examples; where a pixel is asked for, its ray in the place of that of its solid.
    pub(crate) fn new(size: (u32, u32), pixel: Option<(u32, u32)>) -> Result<Explained<R>, Error> {
        let [cylinder, cone] = Shape::ALL.map(worked::<R>);
        let Some(pixel) = pixel else { return Ok(Explained { cylinder, cone, asked: None }) };
        let (panel, place) = Layout::new(size).place_of(pixel);
        let ray = panel.ray(&panel.camera::<R>()?, &panel.view((0.0, 0.0)), place);
        Ok(match panel.shape() {
            Shape::Cylinder => Explained { cylinder: ray, cone, asked: Some(Shape::Cylinder) },
            Shape::Cone => Explained { cylinder, cone: ray, asked: Some(Shape::Cone) },
        })
    }

    /// The ray at one of the solids.
    pub(crate) fn of(&self, shape: Shape) -> &Ray3<R> {
        match shape {
            Shape::Cylinder => &self.cylinder,
            Shape::Cone => &self.cone,
        }
    }
}

/// One ray a pixel, then the sections and the labels.
pub(crate) fn draw<R: Real>(
    method: Method,
    size: (u32, u32),
    explained: &Explained<R>,
) -> Result<Canvas, Error> {
    let layout = Layout::new(size);
    let mut canvas = Canvas::new(size, Color::WHITE)?;
    let [cylinder, cone] = Shape::ALL.map(|shape| Panel::Seen(shape).camera::<R>());
    let (cylinder, cone) = (cylinder?, cone?);
    seen::shade(&mut canvas, &layout, method, [&cylinder, &cone]);
    let (width, height) = layout.frame();
    canvas.fit(width, height);

    let name = format!("{} · {}", method.name(), R::NAME);
    for (shape, camera) in Shape::ALL.into_iter().zip([&cylinder, &cone]) {
        let panel = Panel::Seen(shape);
        let corner = layout.corner(panel);
        captions(&mut canvas, corner, [shape.name(), formula(shape)]);
        seen::legend(&mut canvas, corner, shape, &name);
        ring(&mut canvas, &layout, panel, camera, explained.of(shape));
        section(&mut canvas, &layout, method, explained.of(shape), shape);
    }
    let corner = layout.corner(Panel::AsPrinted);
    captions(&mut canvas, corner, ["the cone as printed", "x² + y² = ¼(1 − z²): half an ellipsoid"]);
    seen::legend(&mut canvas, corner, Shape::Cone, "a slip of the page");
    ring(&mut canvas, &layout, Panel::AsPrinted, &cone, &explained.cone);
    outlines::outlines(&mut canvas, &layout);
    frames(&mut canvas, &layout);
    Ok(canvas)
}

/// The page's formula of a solid.
fn formula(shape: Shape) -> &'static str {
    match shape {
        Shape::Cylinder => "x² + y² = 1, |z| ≤ 1, two caps",
        Shape::Cone => "x² + y² = ¼(1 − z)², 0 ≤ z ≤ 1, a base",
    }
}

/// The two lines at the top of a panel.
fn captions(canvas: &mut Canvas, (left, top): (f32, f32), [title, below]: [&str; 2]) {
    canvas.label((left + 8.0, top + 17.0), Anchor::Left, 13.0, Color::BLACK, title);
    canvas.label((left + 8.0, top + 32.0), Anchor::Left, 11.0, Color::GRAY, below);
}

/// A line around each panel.
fn frames(canvas: &mut Canvas, layout: &Layout) {
    for panel in panels::ALL {
        let (left, top) = layout.corner(panel);
        canvas.frame((left, top), (left + WIDTH, top + HEIGHT), Pen::solid(Color::PALE, 1.0));
    }
}

/// The hue of a part.
fn hue(part: Part) -> Color {
    match part {
        Part::Wall | Part::Apex => Color::BLUE,
        Part::Top => Color::ORANGE,
        Part::Bottom | Part::Base => Color::PURPLE,
    }
}

/// A ring around the pixel whose ray is explained, in the panel of an eye.
fn ring<R: Real>(canvas: &mut Canvas, layout: &Layout, panel: Panel, camera: &Camera<R>, ray: &Ray3<R>) {
    let [right, up, ahead]: [f64; 3] =
        [camera.u, camera.v, camera.w].map(|axis| axis.dot(ray.direction).into());
    let f: f64 = camera.f.into();
    let at = panel.view(layout.corner(panel)).at((f * right / ahead, f * up / ahead));
    // A ray of a section may leave the eye to where the panel does not look.
    if ahead > 0.0 && layout.panel_at(at) == panel {
        seen::ring_at(canvas, at);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn the_ring_stands_around_the_pixel_that_was_asked_for() {
        // one pixel a unit, so a pixel's center is half a unit in; a ring is black 6 units from its middle
        let size = (720, 540);
        for (col, row) in [(100, 100), (300, 200), (560, 90)] {
            let explained = Explained::<f64>::new(size, Some((col, row))).unwrap();
            let canvas = draw(Method::Notes, size, &explained).unwrap();
            for pixel in [(col - 6, row), (col + 6, row), (col, row - 6), (col, row + 6)] {
                assert_eq!(canvas.pixel(pixel.0, pixel.1), Some(Color::BLACK), "{col},{row}");
            }
        }
    }

    #[test]
    fn a_pixel_is_explained_against_the_solid_of_its_panel() {
        let size = (720, 540);
        let asked = |pixel| Explained::<f64>::new(size, Some(pixel)).unwrap().asked;
        assert_eq!([asked((120, 100)), asked((120, 400))], [Some(Shape::Cylinder); 2]);
        let cone = [asked((360, 100)), asked((360, 400)), asked((600, 100)), asked((600, 400))];
        assert_eq!(cone, [Some(Shape::Cone); 4]);
        // by hand: the middle of a section's area shows its window's middle, for the cone (0, 0.4)
        let area = area::Area::of_section((240.0, 270.0));
        let middle = (area.from.1 + area.to.1) / 2.0;
        let explained = Explained::<f64>::new(size, Some((359, middle as u32))).unwrap();
        let point = explained.cone.at(1.0);
        assert!((point - DVec3::new(0.0, 0.0, 0.4)).length() < 0.01, "{point}");
    }
}

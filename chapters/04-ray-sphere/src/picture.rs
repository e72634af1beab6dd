//! The picture: Figure 2-11 with Figure 2-10 in its corners.

use math::{Camera, Ray3, Real, Span};
use stage::{Anchor, Canvas, Color, Error, Pen, View};

use crate::Method;
use crate::scene::{self, BACKGROUND, CENTERS, pixel_ray, three_spheres, trace_ray};

/// One ray a pixel through Gambetta's lattice, then the labels.
pub(crate) fn draw<R: Real>(
    method: Method,
    size: (u32, u32),
    camera: &Camera<R>,
    ray: &Ray3<R>,
) -> Result<Canvas, Error> {
    let mut canvas = Canvas::new(size, Color(BACKGROUND))?;
    shade(&mut canvas, method, camera);
    canvas.fit(540.0, 540.0);
    name_spheres(&mut canvas);
    ring_tangents(&mut canvas);
    from_above::<R>(&mut canvas, ray);
    from_the_right::<R>(&mut canvas, ray);
    let text = format!("{} · {}", method.name(), R::NAME);
    canvas.plate((532.0, 530.0), Anchor::Right, 13.0, Color::BLACK, &text);
    Ok(canvas)
}

/// Gambetta's loop (Listing 2-2) over the pixels, each colored by TraceRay.
fn shade<R: Real>(canvas: &mut Canvas, method: Method, camera: &Camera<R>) {
    let (size, spheres) = (canvas.size(), three_spheres::<R>());
    canvas.shade(|col, row| {
        let ray = pixel_ray(camera, size, (col, row));
        // The scene has no degenerate sphere, the camera no zero direction.
        let seen = trace_ray(method, &ray, &spheres, Span::from_view_plane()).ok().flatten();
        Color(seen.map_or(BACKGROUND, |(index, _)| spheres[index].color))
    });
}

/// The names, for a reader who cannot tell red from green.
fn name_spheres(canvas: &mut Canvas) {
    let (width, height) = canvas.size();
    for ([x, y, z], painted) in CENTERS.iter().map(|center| center.map(f64::from)).zip(three_spheres::<f64>())
    {
        // The center projects to (x/z, y/z) on the view plane, which is one picture high.
        let col = f64::from(width) / 2.0 + x / z * 0.72 * f64::from(height);
        let row = f64::from(height) / 2.0 - y / z * f64::from(height);
        let (x, y) = canvas.place((col, row));
        canvas.plate((x as f32, y as f32), Anchor::Middle, 13.0, Color::BLACK, painted.name);
    }
}

fn ring_tangents(canvas: &mut Canvas) {
    let tangents = scene::tangents(canvas.size());
    for tangent in &tangents {
        let (x, y) = canvas.place_of(tangent.pixel);
        let at = (x as f32, y as f32);
        canvas.circle(at, 6.0, Pen::solid(Color::WHITE, 4.0));
        canvas.circle(at, 6.0, Pen::solid(Color::BLACK, 1.5));
    }
    if !tangents.is_empty() {
        canvas.circle((16.0, 526.0), 6.0, Pen::solid(Color::BLACK, 1.5));
        canvas.plate((28.0, 530.0), Anchor::Left, 13.0, Color::BLACK, "exactly tangent on paper");
    }
}

/// The scene on two of its axes: which coordinates go right and up.
struct Plan<'a> {
    view: View,
    right: usize,
    up: usize,
    canvas: &'a mut Canvas,
}

impl Plan<'_> {
    fn at(&self, point: [f64; 3]) -> (f32, f32) {
        self.view.at((point[self.right], point[self.up]))
    }

    fn draw(&mut self, direction: [f64; 3]) {
        // The axis that points at the viewer: what is farther away is drawn first.
        let toward_viewer = 3 - self.right - self.up;
        let mut spheres: Vec<_> = CENTERS.iter().zip(three_spheres::<f64>()).collect();
        spheres.sort_by_key(|(center, _)| center[toward_viewer]);
        for (center, painted) in spheres {
            let (at, radius) = (self.at(center.map(f64::from)), self.view.length(1.0));
            self.canvas.disc(at, radius, Color(painted.color));
            self.canvas.circle(at, radius, Pen::solid(Color::BLACK, 1.0));
        }
        let eye = self.at([0.0; 3]);
        for (x, y) in [(-0.5, -0.5), (0.5, 0.5)] {
            let edge = self.at([x * 4.6, y * 4.6, 4.6]);
            self.canvas.line(eye, edge, Pen::dashed(Color::GREY, 1.0));
        }
        self.canvas.line(self.at([-0.5, -0.5, 1.0]), self.at([0.5, 0.5, 1.0]), Pen::solid(Color::BLACK, 2.0));
        let end = self.at(direction.map(|component| 4.6 * component));
        self.canvas.arrow(eye, end, Pen::solid(Color::ORANGE, 1.8));
        self.canvas.disc(eye, 3.0, Color::BLACK);
    }
}

fn direction<R: Real>(ray: &Ray3<R>) -> [f64; 3] {
    use math::Vector;
    std::array::from_fn(|axis| ray.direction.components()[axis].into())
}

/// Figure 2-10, left: x to the right, z up.
fn from_above<R: Real>(canvas: &mut Canvas, ray: &Ray3<R>) {
    canvas.rectangle((4.0, 4.0), (200.0, 126.0), Color::WHITE, 0.9);
    canvas.frame((4.0, 4.0), (200.0, 126.0), Pen::solid(Color::PALE, 1.0));
    let view = View::new((-3.6, -0.4), (3.6, 5.1), (70.0, 8.0), (198.0, 122.0));
    Plan { view, right: 0, up: 2, canvas }.draw(direction::<R>(ray));
    canvas.label((10.0, 20.0), Anchor::Left, 12.0, Color::BLACK, "from above");
    canvas.label((10.0, 34.0), Anchor::Left, 11.0, Color::GREY, "x →, z ↑");
}

/// Figure 2-10, right: z to the right, y up.
fn from_the_right<R: Real>(canvas: &mut Canvas, ray: &Ray3<R>) {
    canvas.rectangle((340.0, 4.0), (536.0, 126.0), Color::WHITE, 0.9);
    canvas.frame((340.0, 4.0), (536.0, 126.0), Pen::solid(Color::PALE, 1.0));
    let view = View::new((-0.4, -2.3), (5.3, 1.6), (344.0, 22.0), (532.0, 122.0));
    Plan { view, right: 2, up: 1, canvas }.draw(direction::<R>(ray));
    canvas.label((346.0, 20.0), Anchor::Left, 12.0, Color::BLACK, "from the right");
    canvas.label((346.0, 34.0), Anchor::Left, 11.0, Color::GREY, "z →, y ↑");
}

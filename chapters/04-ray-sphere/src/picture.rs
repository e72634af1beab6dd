//! The picture: Figure 2-11 with Figure 2-10 in its corners.

use math::{Camera, Ray3, Real, Span, Vector};
use stage::{Anchor, Canvas, Color, Error, Pen, View};

use crate::Method;
use crate::scene::{BACKGROUND, CENTERS, Tangent, pixel_ray, three_spheres, trace_ray};

/// One ray a pixel through Gambetta's lattice, then the labels.
pub(crate) fn draw<R: Real>(
    method: Method,
    size: (u32, u32),
    camera: &Camera<R>,
    ray: &Ray3<R>,
    tangents: &[Tangent],
) -> Result<Canvas, Error> {
    let mut canvas = Canvas::new(size, Color(BACKGROUND))?;
    shade(&mut canvas, method, camera);
    canvas.fit(540.0, 540.0);
    let ((left, top), (right, bottom)) = canvas.corners();
    name_spheres(&mut canvas);
    ring_tangents(&mut canvas, (left, bottom), tangents);

    let edges = [camera.window.right, camera.window.top].map(Into::into);
    let direction = ray.direction.in_f64();
    from_above(&mut canvas, (left, top), edges, direction);
    from_the_right(&mut canvas, (right, top), edges, direction);
    let text = format!("{} · {}", method.name(), R::NAME);
    canvas.plate((right - 8.0, bottom - 10.0), Anchor::Right, 13.0, Color::BLACK, &text);
    Ok(canvas)
}

/// Gambetta's loop (Listing 2-2) over the pixels, each colored by TraceRay.
fn shade<R: Real>(canvas: &mut Canvas, method: Method, camera: &Camera<R>) {
    let (size, spheres) = (canvas.size(), three_spheres::<R>());
    canvas.shade(|col, row| {
        let ray = pixel_ray(camera, size, (col, row));
        let seen = trace_ray(method, &ray, &spheres, Span::from_view_plane());
        Color(seen.map_or(BACKGROUND, |(index, _)| spheres[index].color))
    });
}

/// The names, for a reader who cannot tell red from green.
fn name_spheres(canvas: &mut Canvas) {
    let (width, height) = canvas.size();
    let (width, height) = (f64::from(width), f64::from(height));
    for ([x, y, z], painted) in CENTERS.iter().map(|center| center.map(f64::from)).zip(three_spheres::<f64>())
    {
        // The center projects to (x/z, y/z) on the view plane, which is one picture high. The blue and
        // the green one project to the very edges of a square picture: their names stand farther in.
        let inward = 0.72;
        let place = (width / 2.0 + inward * x / z * height, height / 2.0 - y / z * height);
        if !(0.0..width).contains(&place.0) {
            continue;
        }
        let (x, y) = canvas.place(place);
        canvas.plate((x as f32, y as f32), Anchor::Middle, 13.0, Color::BLACK, painted.name);
    }
}

/// A ring around each exactly tangent pixel, and what it means in the corner at (`left`, `bottom`).
fn ring_tangents(canvas: &mut Canvas, (left, bottom): (f32, f32), tangents: &[Tangent]) {
    let ring = |canvas: &mut Canvas, at| {
        canvas.circle(at, 6.0, Pen::solid(Color::WHITE, 4.0));
        canvas.circle(at, 6.0, Pen::solid(Color::BLACK, 1.5));
    };
    for tangent in tangents {
        let (x, y) = canvas.place_of(tangent.pixel);
        ring(canvas, (x as f32, y as f32));
    }
    if !tangents.is_empty() {
        ring(canvas, (left + 16.0, bottom - 14.0));
        let at = (left + 28.0, bottom - 10.0);
        canvas.plate(at, Anchor::Left, 13.0, Color::BLACK, "exactly tangent on paper");
    }
}

/// The scene on two of its axes: which coordinates go right and up.
struct Plan<'a> {
    view: View,
    right: usize,
    up: usize,
    /// The right and the top edge of the window at distance 1: the left and bottom ones mirror them.
    edges: [f64; 2],
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
        let [x, y] = self.edges;
        for [x, y] in [[x, y], [-x, -y]] {
            let far = (3.4 / x.abs().max(y.abs())).min(4.6);
            self.canvas.line(eye, self.at([x * far, y * far, far]), Pen::dashed(Color::GRAY, 1.0));
        }
        self.canvas.line(self.at([-x, -y, 1.0]), self.at([x, y, 1.0]), Pen::solid(Color::BLACK, 2.0));
        let end = self.at(direction.map(|component| 4.6 * component));
        self.canvas.arrow(eye, end, Pen::solid(Color::ORANGE, 1.8));
        self.canvas.disc(eye, 3.0, Color::BLACK);
    }
}

/// Figure 2-10, left: x to the right, z up. In the corner at (`left`, `top`).
fn from_above(canvas: &mut Canvas, (left, top): (f32, f32), edges: [f64; 2], direction: [f64; 3]) {
    plate(canvas, (left + 4.0, top + 4.0));
    let view = View::new((-3.6, -0.4), (3.6, 5.1), (left + 70.0, top + 8.0), (left + 198.0, top + 122.0));
    Plan { view, right: 0, up: 2, edges, canvas }.draw(direction);
    canvas.label((left + 10.0, top + 20.0), Anchor::Left, 12.0, Color::BLACK, "from above");
    canvas.label((left + 10.0, top + 34.0), Anchor::Left, 11.0, Color::GRAY, "x →, z ↑");
}

/// Figure 2-10, right: z to the right, y up. In the corner at (`right`, `top`).
fn from_the_right(canvas: &mut Canvas, (right, top): (f32, f32), edges: [f64; 2], direction: [f64; 3]) {
    let left = right - 200.0;
    plate(canvas, (left, top + 4.0));
    let view = View::new((-0.4, -2.3), (5.3, 1.6), (left + 6.0, top + 36.0), (left + 192.0, top + 122.0));
    Plan { view, right: 2, up: 1, edges, canvas }.draw(direction);
    canvas.label((left + 6.0, top + 20.0), Anchor::Left, 12.0, Color::BLACK, "from the right");
    canvas.label((left + 6.0, top + 34.0), Anchor::Left, 11.0, Color::GRAY, "z →, y ↑");
}

/// What a plan is drawn on.
fn plate(canvas: &mut Canvas, (left, top): (f32, f32)) {
    let corner = (left + 196.0, top + 122.0);
    canvas.rectangle((left, top), corner, Color::WHITE, 0.9);
    canvas.frame((left, top), corner, Pen::solid(Color::PALE, 1.0));
}

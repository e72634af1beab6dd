//! The picture: the ground to the horizon, where n · u_r → 0.

use math::{Camera, Ray3, Real, Span, Vector};
use stage::{Anchor, Canvas, Color, Error, Pen, Value};

use crate::ground::{SKY, camera, ground, is_dark, pixel_ray};
use crate::{Meeting, Method};

const LIGHT_TILE: Color = Color([240, 240, 232]);
const DARK_TILE: Color = Color([66, 110, 150]);
const SKY_BLUE: Color = Color([200, 226, 244]);

/// One ray a pixel, then the labels and the pixel of the transcript.
pub(crate) fn draw<R: Real>(method: Method, size: (u32, u32), explained: &Ray3<R>) -> Result<Canvas, Error> {
    let camera = camera::<R>(size)?;
    let mut canvas = Canvas::new(size, SKY_BLUE)?;
    canvas.shade(|col, row| color(method, &pixel_ray(&camera, size, (col, row))));
    canvas.fit(640.0, 402.0);
    depths(&mut canvas);
    signs(&mut canvas);
    let (_, (right, bottom)) = canvas.corners();
    let name = format!("{} · {}", method.name(), R::NAME);
    canvas.plate((right - 8.0, bottom - 8.0), Anchor::Right, 13.0, Color::BLACK, &name);
    mark(&mut canvas, &camera, explained);
    Ok(canvas)
}

/// The tile that a ray hits; the sky where the plane is behind; the horizon where it is parallel.
fn color<R: Real>(method: Method, ray: &Ray3<R>) -> Color {
    let work = method.work(ray, &ground());
    if let Ok(Some(hit)) = work.hit(Span::ahead()) {
        return if is_dark::<R>(hit.point) { DARK_TILE } else { LIGHT_TILE };
    }
    match work.meeting() {
        Meeting::Never(_) => Color::VERMILLION,
        Meeting::At(_) => SKY_BLUE,
    }
}

/// Where the height y of the view plane lies in the picture.
fn row_of(canvas: &Canvas, y: f64) -> f32 {
    let height = f64::from(canvas.size().1);
    canvas.place((0.0, (SKY - y) * height)).1 as f32
}

/// The depth t at which a row meets the ground is 1 / |y|: marks at the left edge.
fn depths(canvas: &mut Canvas) {
    let ((left, _), _) = canvas.corners();
    for t in [1.5, 2.0, 3.0, 5.0, 10.0] {
        let y = row_of(canvas, -1.0 / t);
        canvas.line((left, y), (left + 16.0, y), Pen::solid(Color::BLACK, 3.0));
        canvas.line((left, y), (left + 16.0, y), Pen::solid(Color::YELLOW, 1.4));
        let text = format!("t = {}", Value::number(t).to_text());
        canvas.plate((left + 24.0, y + 4.5), Anchor::Left, 12.0, Color::BLACK, &text);
    }
}

/// What the sign of n · u_r means: above, on and below the horizon.
fn signs(canvas: &mut Canvas) {
    let y = row_of(canvas, 0.0);
    let (_, (right, _)) = canvas.corners();
    for (dy, text) in [
        (-58.0, "n · u_r > 0: the plane is behind, t < 0"),
        (-10.0, "the horizon: n · u_r = 0, parallel"),
        (150.0, "n · u_r < 0: t = 1 / |n · u_r|"),
    ] {
        canvas.plate((right - 8.0, y + dy), Anchor::Right, 13.0, Color::BLACK, text);
    }
}

/// A ring around the pixel of the transcript, named on the side where there is room.
fn mark<R: Real>(canvas: &mut Canvas, camera: &Camera<R>, ray: &Ray3<R>) {
    let [x, y]: [f64; 2] = [ray.direction.x().into(), ray.direction.y().into()];
    let left_edge: f64 = camera.window.left.into();
    let height = f64::from(canvas.size().1);
    let (x, y) = canvas.place(((x - left_edge) * height, (SKY - y) * height));
    let at = (x as f32, y as f32);
    canvas.circle(at, 7.0, Pen::solid(Color::WHITE, 4.5));
    canvas.circle(at, 7.0, Pen::solid(Color::VERMILLION, 2.2));
    let ((left, top), (right, bottom)) = canvas.corners();
    let (dx, anchor) =
        if at.0 < (left + right) / 2.0 { (13.0, Anchor::Left) } else { (-13.0, Anchor::Right) };
    let label_y = (at.1 + 4.0).clamp(top + 16.0, bottom - 6.0);
    canvas.plate((at.0 + dx, label_y), anchor, 12.0, Color::BLACK, "the ray of the transcript");
}

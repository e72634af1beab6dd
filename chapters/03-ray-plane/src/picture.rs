//! The picture: the ground to the horizon, where n · u_r → 0.

use math::{Camera, Ray3, Real, Span, Vector};
use stage::{Anchor, Canvas, Color, Error, Pen, Value};

use crate::ground::{camera, ground, is_dark, pixel_ray};
use crate::{Meeting, Method};

const LIGHT_TILE: Color = Color([240, 240, 232]);
const DARK_TILE: Color = Color([66, 110, 150]);
const SKY: Color = Color([200, 226, 244]);

/// One ray a pixel, then the labels and the pixel of the transcript.
pub(crate) fn draw<R: Real>(method: Method, size: (u32, u32), explained: &Ray3<R>) -> Result<Canvas, Error> {
    let camera = camera::<R>(size).map_err(|degenerate| Error::Failed(degenerate.to_string()))?;
    let mut canvas = Canvas::new(size, SKY)?;
    canvas.shade(|col, row| color(method, &pixel_ray(&camera, size, (col, row))));
    canvas.fit(640.0, 402.0);
    depths(&mut canvas);
    horizon(&mut canvas);
    mark(&mut canvas, &camera, explained);
    let name = format!("{} · {}", method.name(), R::NAME);
    canvas.plate((632.0, 394.0), Anchor::Right, 13.0, Color::BLACK, &name);
    Ok(canvas)
}

/// The tile that a ray hits; the sky where the plane is behind; the horizon where it is parallel.
fn color<R: Real>(method: Method, ray: &Ray3<R>) -> Color {
    let work = method.work(ray, &ground());
    match (work.hit(Span::ahead()), work.meeting()) {
        (Ok(Some(hit)), _) if is_dark::<R>(hit.point) => DARK_TILE,
        (Ok(Some(_)), _) => LIGHT_TILE,
        (_, Meeting::Never(_)) => Color::VERMILLION,
        _ => SKY,
    }
}

/// Where the height y of the view plane lies in the picture: its window is 1 high, 0.25 of it above
/// the horizon.
fn row_of(canvas: &Canvas, y: f64) -> f32 {
    let height = f64::from(canvas.size().1);
    canvas.place((0.0, (0.25 - y) * height)).1 as f32
}

/// The depth t at which a row meets the ground is 1 / |y|: marks at the left edge.
fn depths(canvas: &mut Canvas) {
    for t in [1.5, 2.0, 3.0, 5.0, 10.0, 30.0] {
        let y = row_of(canvas, -1.0 / t);
        canvas.line((0.0, y), (16.0, y), Pen::solid(Color::BLACK, 3.0));
        canvas.line((0.0, y), (16.0, y), Pen::solid(Color::YELLOW, 1.4));
        let text = format!("t = {}", Value::number(t).to_text());
        // Below 10 the labels would run into each other.
        if t <= 10.0 {
            canvas.plate((24.0, y + 4.5), Anchor::Left, 12.0, Color::BLACK, &text);
        }
    }
}

fn horizon(canvas: &mut Canvas) {
    let y = row_of(canvas, 0.0);
    let place = (632.0, y - 10.0);
    canvas.plate(place, Anchor::Right, 13.0, Color::BLACK, "the horizon: n · u_r = 0, parallel, t = −1/0");
    canvas.plate(
        (632.0, y - 58.0),
        Anchor::Right,
        13.0,
        Color::BLACK,
        "n · u_r > 0: the plane is behind, t < 0",
    );
    canvas.plate((632.0, y + 150.0), Anchor::Right, 13.0, Color::BLACK, "n · u_r < 0: t = 1 / |n · u_r|");
}

/// A ring around the pixel of the transcript.
fn mark<R: Real>(canvas: &mut Canvas, camera: &Camera<R>, ray: &Ray3<R>) {
    let [x, y]: [f64; 2] = [ray.direction.x().into(), ray.direction.y().into()];
    let (width, height) = canvas.size();
    let left: f64 = camera.window.left.into();
    let (col, row) = ((x - left) * f64::from(height), (0.25 - y) * f64::from(height));
    let pixel = ((col as u32).min(width - 1), (row as u32).min(height - 1));
    let (x, y) = canvas.place_of(pixel);
    let at = (x as f32, y as f32);
    canvas.circle(at, 7.0, Pen::solid(Color::WHITE, 4.5));
    canvas.circle(at, 7.0, Pen::solid(Color::VERMILLION, 2.2));
    canvas.plate((at.0 + 13.0, at.1 + 4.0), Anchor::Left, 12.0, Color::BLACK, "the ray of the transcript");
}

//! The picture: barycentric colors, stars, and a closed mesh shot along its edges.

mod balls;
mod barycentric;
mod stars;

use math::{Ray3, Real};
use stage::{Canvas, Color, Error, Pen, View};

use crate::polygon::{Polygon, Rule, star};
use crate::scene::{WORKED, view_ray};
use crate::{Method, Triangle};

/// A part of the drawing frame: its top left and its bottom right corner.
#[derive(Clone, Copy, Debug)]
struct Part {
    from: (f32, f32),
    to: (f32, f32),
}

const TRIANGLE: Part = Part { from: (8.0, 8.0), to: (404.0, 294.0) };
const CONCAVE: Part = Part { from: (412.0, 8.0), to: (712.0, 162.0) };
const PENTAGRAMS: [Part; 2] =
    [Part { from: (412.0, 170.0), to: (558.0, 294.0) }, Part { from: (566.0, 170.0), to: (712.0, 294.0) }];

/// The drawing frame, and where the balls are in it: below the rest, or beside it in a picture that is much wider
/// than high.
#[derive(Clone, Copy, Debug)]
struct Layout {
    width: f32,
    height: f32,
    balls: [Part; 3],
}

impl Layout {
    fn of((columns, rows): (u32, u32)) -> Layout {
        let balls = |left: f32, top: f32, bottom: f32| {
            [0.0, 1.0, 2.0].map(|column| {
                let left = left + 237.0 * column;
                Part { from: (left, top), to: (left + 230.0, bottom) }
            })
        };
        if u64::from(columns) < 2 * u64::from(rows) {
            Layout { width: 720.0, height: 540.0, balls: balls(8.0, 302.0, 532.0) }
        } else {
            Layout { width: 1432.0, height: 302.0, balls: balls(720.0, 8.0, 294.0) }
        }
    }
}

const GROUND: Color = Color([244, 244, 244]);

impl Part {
    fn holds(&self, (x, y): (f64, f64)) -> bool {
        let [left, top, right, bottom] = [self.from.0, self.from.1, self.to.0, self.to.1].map(f64::from);
        (left..right).contains(&x) && (top..bottom).contains(&y)
    }
}

/// What is asked of every pixel: the triangle and the stars in the precision of the picture.
struct Scene<R: Real> {
    method: Method,
    triangle: Triangle<R>,
    concave: Polygon<R>,
    pentagram: Polygon<R>,
    balls: [Part; 3],
}

impl<R: Real> Scene<R> {
    /// The color at a place of the frame.
    fn color(&self, place: (f64, f64)) -> Color {
        if TRIANGLE.holds(place) {
            let ray = view_ray::<R>(barycentric::view().plane(place));
            return barycentric::color(self.method, &ray, &self.triangle).unwrap_or(GROUND);
        }
        if CONCAVE.holds(place) {
            return stars::color(&self.concave, Rule::EvenOdd, stars::concave_view().plane(place));
        }
        for (part, rule) in PENTAGRAMS.iter().zip(Rule::ALL) {
            if part.holds(place) {
                return stars::color(&self.pentagram, rule, stars::pentagram_view(part).plane(place));
            }
        }
        if self.balls.iter().any(|part| part.holds(place)) { GROUND } else { Color::WHITE }
    }
}

/// Everything, at any size: one ray a pixel for the triangle, one point a pixel for the stars, then the lines.
pub(crate) fn draw<R: Real>(
    method: Method,
    size: (u32, u32),
    pixel: Option<(u32, u32)>,
) -> Result<Canvas, Error> {
    let layout = Layout::of(size);
    let mut canvas = Canvas::new(size, Color::WHITE)?;
    canvas.fit(layout.width, layout.height);
    let polygon = |corners: &[[f32; 2]]| {
        Polygon::new(star::in_space::<R>(corners)).map_err(|error| Error::Failed(error.to_string()))
    };
    let scene = Scene::<R> {
        method,
        triangle: crate::scene::triangle(),
        concave: polygon(&star::CONCAVE)?,
        pentagram: polygon(&star::PENTAGRAM)?,
        balls: layout.balls,
    };
    shade(&mut canvas, &scene);
    for part in [TRIANGLE, CONCAVE].iter().chain(&PENTAGRAMS).chain(&layout.balls) {
        canvas.frame(part.from, part.to, Pen::solid(Color::PALE, 1.0));
    }
    stars::concave(&mut canvas, &scene.concave);
    stars::pentagrams(&mut canvas, &scene.pentagram);
    balls::draw::<R>(&mut canvas, &layout.balls);
    barycentric::name_corners(&mut canvas, &scene.triangle, &format!("{} · {}", method.name(), R::NAME));
    mark(&mut canvas, pixel);
    Ok(canvas)
}

fn shade<R: Real>(canvas: &mut Canvas, scene: &Scene<R>) {
    let ((left, top), (next_x, next_y)) = (canvas.place((0.5, 0.5)), canvas.place((1.5, 1.5)));
    let (across, down) = (next_x - left, next_y - top);
    canvas.shade(|col, row| scene.color((left + across * f64::from(col), top + down * f64::from(row))));
}

/// The ray through a pixel, wherever in the picture it is; without one, the worked example's.
pub(crate) fn ray_of<R: Real>(size: (u32, u32), pixel: Option<(u32, u32)>) -> Result<Ray3<R>, Error> {
    let Some(pixel) = pixel else { return Ok(view_ray(WORKED)) };
    // Where a pixel lies in the frame is known to a canvas of the picture's shape.
    let mut canvas = Canvas::new(size, Color::WHITE)?;
    let layout = Layout::of(size);
    canvas.fit(layout.width, layout.height);
    Ok(view_ray(barycentric::view().plane(canvas.place_of(pixel))))
}

/// A ring around the pixel of the transcript.
fn mark(canvas: &mut Canvas, pixel: Option<(u32, u32)>) {
    let at = match pixel {
        Some(pixel) => {
            let (x, y) = canvas.place_of(pixel);
            (x as f32, y as f32)
        }
        None => barycentric::view().at(WORKED),
    };
    barycentric::ring(canvas, at);
}

/// A view of a part of the plane that fills a part of the frame.
fn view_in(part: &Part, low: (f64, f64), high: (f64, f64), head: f32, foot: f32) -> View {
    View::new(low, high, (part.from.0, part.from.1 + head), (part.to.0, part.to.1 - foot))
}

#[cfg(test)]
mod tests;

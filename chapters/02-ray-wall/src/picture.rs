//! The picture: a fan of rays against the wall, hits marked.

use math::{Degenerate, Ray2, Real, Span, Vector};
use stage::{Anchor, Canvas, Color, Error, Pen, Value, View};

use crate::stage::{ORIGIN, WALL};
use crate::{Crossing, Hit2, Method, Wall};

/// The part of the plane that the picture shows: left, right, bottom, top.
const LEFT: f64 = -1.5;
const RIGHT: f64 = 7.5;
const BOTTOM: f64 = -2.0;
const TOP: f64 = 4.0;

/// The drawing's frame.
const FRAME: (f32, f32) = (720.0, 480.0);

pub(crate) fn view() -> View {
    View::new((LEFT, BOTTOM), (RIGHT, TOP), (0.0, 0.0), FRAME)
}

/// An empty picture, with the plane laid over it.
pub(crate) fn canvas(size: (u32, u32)) -> Result<Canvas, Error> {
    let mut canvas = Canvas::new(size, Color::WHITE)?;
    canvas.fit(FRAME.0, FRAME.1);
    Ok(canvas)
}

/// The wall, the fan from the page's origin, rays from inside and behind, and the ray that is explained.
pub(crate) fn draw<R: Real>(mut canvas: Canvas, method: Method, explained: &Ray2<R>) -> Canvas {
    let view = view();
    axes(&mut canvas, view);
    wall(&mut canvas, view);
    let mut drawing = Drawing { canvas, view, method };

    // Directions to the points of a square's edge: a fan without sines, two of them exactly parallel.
    for (i, j) in (-3_i8..=3).flat_map(|i| (-3_i8..=3).map(move |j| (i, j))) {
        if i.abs().max(j.abs()) == 3 {
            let direction = unit::<R>(f32::from(i), f32::from(j));
            drawing.ray::<R>(ORIGIN, direction, Pen::solid(Color::BLUE, 1.2));
        }
    }
    for (origin, to_x, to_y) in [((4.25, 3.4), 1.0, 0.0), ((4.25, -1.4), -1.0, 0.0), ((6.6, 2.4), -1.0, 0.15)]
    {
        drawing.ray::<R>(origin, unit::<R>(to_x, to_y), Pen::solid(Color::PURPLE, 1.6));
    }
    let Drawing { mut canvas, .. } = drawing;
    explained_ray(&mut canvas, view, method, explained);

    let at = view.at(ORIGIN);
    canvas.disc(at, 4.0, Color::BLACK);
    canvas.plate((at.0 - 10.0, at.1 - 12.0), Anchor::Right, 15.0, Color::BLACK, "p_r = (1, 1)");
    legend(&mut canvas);
    let name = format!("{} · {}", method.name(), R::NAME);
    canvas.plate((FRAME.0 - 8.0, FRAME.1 - 8.0), Anchor::Right, 13.0, Color::BLACK, &name);
    canvas
}

fn unit<R: Real>(x: f32, y: f32) -> R::Vec2 {
    let direction = R::vec2(R::from(x), R::from(y));
    direction / direction.length()
}

fn numbers<R: Real>(v: R::Vec2) -> (f64, f64) {
    (v.x().into(), v.y().into())
}

/// Tick marks a unit apart.
fn axes(canvas: &mut Canvas, view: View) {
    let (grid, axis) = (Pen::solid(Color::PALE, 0.6), Pen::solid(Color::GREY, 1.0));
    for x in -1..=7 {
        view.line(canvas, (f64::from(x), BOTTOM), (f64::from(x), TOP), grid);
        let (x_at, y_at) = view.at((f64::from(x), 0.0));
        canvas.label(
            (x_at + 3.0, y_at + 14.0),
            Anchor::Left,
            11.0,
            Color::GREY,
            &Value::number(x as f32).to_text(),
        );
    }
    for y in -1..=3 {
        view.line(canvas, (LEFT, f64::from(y)), (RIGHT, f64::from(y)), grid);
        let (x_at, y_at) = view.at((0.0, f64::from(y)));
        if y != 0 {
            canvas.label(
                (x_at + 3.0, y_at - 3.0),
                Anchor::Left,
                11.0,
                Color::GREY,
                &Value::number(y as f32).to_text(),
            );
        }
    }
    view.line(canvas, (LEFT, 0.0), (RIGHT, 0.0), axis);
    view.line(canvas, (0.0, BOTTOM), (0.0, TOP), axis);
}

fn wall(canvas: &mut Canvas, view: View) {
    let (top_left, bottom_right) = (view.at((WALL.front, TOP)), view.at((WALL.back, BOTTOM)));
    canvas.rectangle(top_left, bottom_right, Color::ORANGE, 0.45);
    for x in [WALL.front, WALL.back] {
        view.line(canvas, (x, BOTTOM), (x, TOP), Pen::solid(Color::BLACK, 1.5));
    }
    let ((front, _), (back, _)) = (view.at((WALL.front, 0.0)), view.at((WALL.back, 0.0)));
    canvas.plate((front - 6.0, 18.0), Anchor::Right, 13.0, Color::BLACK, "front: x = 4");
    canvas.plate((back + 6.0, 18.0), Anchor::Left, 13.0, Color::BLACK, "back: x = 4.5");
}

struct Drawing {
    canvas: Canvas,
    view: View,
    method: Method,
}

impl Drawing {
    /// A ray up to its hit, or dashed to the border where there is none.
    fn ray<R: Real>(&mut self, (x, y): (f64, f64), direction: R::Vec2, pen: Pen) {
        let ray = Ray2::<R>::new(R::vec2(R::round_from(x), R::round_from(y)), direction);
        let from = self.view.at((x, y));
        match hit(self.method, &ray) {
            Ok(Some(hit)) => {
                let to = self.view.at(numbers::<R>(hit.point));
                self.canvas.line(from, to, pen);
                self.canvas.disc(to, 3.5, Color::BLACK);
            }
            _ => {
                let end = numbers::<R>(ray.at(R::from(12.0)));
                self.view.arrow(
                    &mut self.canvas,
                    (x, y),
                    end,
                    Pen { dash: 4.0, color: Color::GREY, width: 1.0 },
                );
            }
        }
        if (x, y) != ORIGIN {
            self.canvas.disc(from, 3.5, pen.color);
        }
    }
}

fn hit<R: Real>(method: Method, ray: &Ray2<R>) -> Result<Option<Hit2<R>>, Degenerate> {
    method.work(ray, &wall_of()).hit(Span::ahead())
}

pub(crate) fn wall_of<R: Real>() -> Wall<R> {
    Wall { front: R::round_from(WALL.front), back: R::round_from(WALL.back) }
}

/// The ray of the transcript, thick, with t at both faces.
fn explained_ray<R: Real>(canvas: &mut Canvas, view: View, method: Method, ray: &Ray2<R>) {
    let from = numbers::<R>(ray.origin);
    let Ok(hit) = hit(method, ray) else { return };
    let length = ray.direction.length();
    let end = match hit {
        Some(hit) => numbers::<R>(hit.point),
        None => numbers::<R>(ray.at(R::from(12.0) / length)),
    };
    view.arrow(canvas, from, end, Pen::solid(Color::VERMILLION, 2.6));
    let Crossing::Through(roots) = method.work(ray, &wall_of()).crossing() else { return };
    for (t, anchor, dx) in [(roots.near, Anchor::Right, -8.0), (roots.far, Anchor::Left, 8.0)] {
        let at = view.at(numbers::<R>(ray.at(t)));
        if at.0 > 0.0 && at.0 < FRAME.0 && at.1 > 0.0 && at.1 < FRAME.1 && Span::ahead().contains(t) {
            canvas.disc(at, 4.5, Color::VERMILLION);
            let text = format!("t = {}", short(t));
            canvas.plate((at.0 + dx, at.1 - 8.0), anchor, 14.0, Color::BLACK, &text);
        }
    }
}

/// A number to three decimals: enough for a label.
fn short<R: Real>(x: R) -> String {
    let x: f64 = x.into();
    Value::number((x * 1000.0).round() / 1000.0).to_text()
}

fn legend(canvas: &mut Canvas) {
    let rows = [
        (Color::VERMILLION, 2.6, 0.0, "the ray of the transcript"),
        (Color::BLUE, 1.2, 0.0, "rays that hit the front, from p_r"),
        (Color::PURPLE, 1.6, 0.0, "from inside, and from behind"),
        (Color::GREY, 1.0, 4.0, "pointing away, or parallel: no hit"),
    ];
    canvas.rectangle((6.0, 380.0), (262.0, 474.0), Color::WHITE, 0.9);
    for (row, (color, width, dash, text)) in rows.into_iter().enumerate() {
        let y = 396.0 + 22.0 * row as f32;
        canvas.line((14.0, y), (44.0, y), Pen { color, width, dash });
        canvas.label((52.0, y + 4.5), Anchor::Left, 12.5, Color::BLACK, text);
    }
}

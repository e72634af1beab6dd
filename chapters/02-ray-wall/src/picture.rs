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
pub(crate) fn draw<R: Real>(canvas: Canvas, method: Method, explained: &Ray2<R>) -> Canvas {
    let mut drawing = Drawing::new(canvas, method);
    drawing.axes();
    drawing.wall();

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
    drawing.legend();
    drawing.explained(explained);

    let at = drawing.view.at(ORIGIN);
    drawing.canvas.disc(at, 4.0, Color::BLACK);
    drawing.canvas.plate((at.0 - 12.0, at.1 + 30.0), Anchor::Right, 15.0, Color::BLACK, "p_r = (1, 1)");
    let (_, (right, bottom)) = drawing.canvas.corners();
    let name = format!("{} · {}", method.name(), R::NAME);
    drawing.canvas.plate((right - 8.0, bottom - 8.0), Anchor::Right, 13.0, Color::BLACK, &name);
    drawing.canvas
}

fn unit<R: Real>(x: f32, y: f32) -> R::Vec2 {
    let direction = R::vec2(R::from(x), R::from(y));
    direction / direction.length()
}

fn numbers<R: Real>(v: R::Vec2) -> (f64, f64) {
    (v.x().into(), v.y().into())
}

fn hit<R: Real>(method: Method, ray: &Ray2<R>) -> Result<Option<Hit2<R>>, Degenerate> {
    method.work(ray, &wall_of()).hit(Span::ahead())
}

pub(crate) fn wall_of<R: Real>() -> Wall<R> {
    Wall { front: R::round_from(WALL.front), back: R::round_from(WALL.back) }
}

/// The picture in the making, and the part of the plane that it shows.
struct Drawing {
    canvas: Canvas,
    view: View,
    method: Method,
    /// The left, bottom, right and top of what is seen: more than the frame where the picture's shape is
    /// not the frame's.
    seen: (f64, f64, f64, f64),
}

impl Drawing {
    fn new(canvas: Canvas, method: Method) -> Drawing {
        let view = view();
        let (top_left, bottom_right) = canvas.corners();
        let plane = |(x, y): (f32, f32)| view.plane((f64::from(x), f64::from(y)));
        let ((left, top), (right, bottom)) = (plane(top_left), plane(bottom_right));
        Drawing { canvas, view, method, seen: (left, bottom, right, top) }
    }

    /// Grid lines a unit apart, and the numbers on the axes.
    fn axes(&mut self) {
        let (left, bottom, right, top) = self.seen;
        let (grid, axis) = (Pen::solid(Color::PALE, 0.6), Pen::solid(Color::GRAY, 1.0));
        let whole = |from: f64, to: f64| (from.ceil() as i32..=to.floor() as i32).map(f64::from);
        let number = |x: f64| Value::number(x).to_text();
        for x in whole(left, right) {
            let pen = if x == 0.0 { axis } else { grid };
            self.view.line(&mut self.canvas, (x, bottom), (x, top), pen);
            let (x_at, y_at) = self.view.at((x, 0.0));
            self.canvas.label((x_at + 3.0, y_at + 14.0), Anchor::Left, 11.0, Color::GRAY, &number(x));
        }
        for y in whole(bottom, top) {
            let pen = if y == 0.0 { axis } else { grid };
            self.view.line(&mut self.canvas, (left, y), (right, y), pen);
            let (x_at, y_at) = self.view.at((0.0, y));
            if y != 0.0 {
                self.canvas.label((x_at + 3.0, y_at - 3.0), Anchor::Left, 11.0, Color::GRAY, &number(y));
            }
        }
    }

    fn wall(&mut self) {
        let (_, bottom, _, top) = self.seen;
        let (view, canvas) = (self.view, &mut self.canvas);
        canvas.rectangle(view.at((WALL.front, top)), view.at((WALL.back, bottom)), Color::ORANGE, 0.45);
        for x in [WALL.front, WALL.back] {
            view.line(canvas, (x, bottom), (x, top), Pen::solid(Color::BLACK, 1.5));
        }
        let ((front, ceiling), (back, _)) = (view.at((WALL.front, top)), view.at((WALL.back, top)));
        canvas.plate((front - 6.0, ceiling + 18.0), Anchor::Right, 13.0, Color::BLACK, "front: x = 4");
        canvas.plate((back + 6.0, ceiling + 18.0), Anchor::Left, 13.0, Color::BLACK, "back: x = 4.5");
    }

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
                let end = self.far_along(&ray);
                let dashed = Pen { dash: 4.0, color: Color::GRAY, width: 1.0 };
                self.view.arrow(&mut self.canvas, (x, y), end, dashed);
            }
        }
        if (x, y) != ORIGIN {
            self.canvas.disc(from, 3.5, pen.color);
        }
    }

    /// A point of the ray beyond the border of the picture.
    fn far_along<R: Real>(&self, ray: &Ray2<R>) -> (f64, f64) {
        let (left, bottom, right, top) = self.seen;
        let beyond = R::round_from((right - left) + (top - bottom));
        numbers::<R>(ray.at(beyond / ray.direction.length()))
    }

    /// The ray of the transcript, thick, with t at both faces and at its direction's end.
    fn explained<R: Real>(&mut self, ray: &Ray2<R>) {
        let from = numbers::<R>(ray.origin);
        let Ok(hit) = hit(self.method, ray) else { return };
        let end = match hit {
            Some(hit) => numbers::<R>(hit.point),
            None => self.far_along(ray),
        };
        let down = ray.direction.y() < R::from(0.0);
        let mut marks = vec![(R::from(1.0), Anchor::Left, Color::GRAY)];
        if let Crossing::Through(roots) = self.method.work(ray, &wall_of()).crossing() {
            marks.push((roots.near, Anchor::Right, Color::VERMILLION));
            marks.push((roots.far, Anchor::Left, Color::VERMILLION));
        }
        // Where t = 1 is next to where the ray leaves the wall, their labels are on either side of the ray.
        let place = |t: R| self.view.at(numbers::<R>(ray.at(t)));
        let is_crowded = marks.len() == 3 && View::apart(place(marks[0].0), place(marks[2].0)) < 70.0;
        for (t, anchor, color) in marks {
            let point = numbers::<R>(ray.at(t));
            let at = self.view.at(point);
            let apart = View::apart(at, self.view.at(from));
            if !self.is_seen(point) || !Span::ahead().contains(t) || apart < 20.0 {
                continue;
            }
            self.canvas.disc(at, 4.5, color);
            // The label stands on the side of the ray where nothing is drawn.
            let dx = if anchor == Anchor::Right { -9.0 } else { 9.0 };
            let other_side = is_crowded && color == Color::GRAY;
            let dy = if down == ((anchor == Anchor::Right) != other_side) { 20.0 } else { -9.0 };
            let text = format!("t = {}", short(t));
            self.canvas.plate((at.0 + dx, at.1 + dy), anchor, 14.0, Color::BLACK, &text);
        }
        self.view.arrow(&mut self.canvas, from, end, Pen::solid(Color::VERMILLION, 2.6));
    }

    fn is_seen(&self, (x, y): (f64, f64)) -> bool {
        let (left, bottom, right, top) = self.seen;
        (left..right).contains(&x) && (bottom..top).contains(&y)
    }

    fn legend(&mut self) {
        let rows = [
            (Color::VERMILLION, 2.6, 0.0, "the ray of the transcript"),
            (Color::BLUE, 1.2, 0.0, "rays that hit the front, from p_r"),
            (Color::PURPLE, 1.6, 0.0, "from inside, and from behind"),
            (Color::GRAY, 1.0, 4.0, "pointing away, or parallel: no hit"),
        ];
        if !self.canvas.is_readable(12.5) {
            return;
        }
        let ((left, _), (_, bottom)) = self.canvas.corners();
        let (from, to) = ((left + 6.0, bottom - 102.0), (left + 266.0, bottom - 6.0));
        self.canvas.rectangle(from, to, Color::WHITE, 1.0);
        self.canvas.frame(from, to, Pen::solid(Color::PALE, 1.0));
        for (row, (color, width, dash, text)) in rows.into_iter().enumerate() {
            let y = bottom - 84.0 + 22.0 * row as f32;
            self.canvas.line((left + 14.0, y), (left + 44.0, y), Pen { color, width, dash });
            self.canvas.label((left + 52.0, y + 4.5), Anchor::Left, 12.5, Color::BLACK, text);
        }
    }
}

/// A number to three decimals: enough for a label.
fn short<R: Real>(x: R) -> String {
    let x: f64 = x.into();
    Value::number((x * 1000.0).round() / 1000.0).to_text()
}

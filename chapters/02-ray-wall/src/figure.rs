//! The figure of the book: a ray and a wall to drag.

use math::{Degenerate, Ray2, Real, Span, Vector};
use stage::figure::{Figure, Handle, Place, first_steps, hit_in_words, moved, to_hundredths};
use stage::{Ink, Section, Sketch};

use crate::stage::{ORIGIN, WALL, explain, why};
use crate::{Crossing, Method, Wall};

/// A ray and a wall as they are dragged; House's for the start.
pub struct RayAndWall {
    p_r: Place,
    /// p_r + u_r
    tip: Place,
    wall: Wall<f64>,
}

impl Default for RayAndWall {
    fn default() -> RayAndWall {
        RayAndWall { p_r: ORIGIN, tip: (ORIGIN.0 + 1.0, ORIGIN.1), wall: WALL }
    }
}

impl RayAndWall {
    fn ray<R: Real>(&self) -> Ray2<R> {
        let [p, tip] = [self.p_r, self.tip].map(|(x, y)| R::vec2(R::round_from(x), R::round_from(y)));
        Ray2::new(p, tip - p)
    }

    fn wall<R: Real>(&self) -> Wall<R> {
        Wall { front: R::round_from(self.wall.front), back: R::round_from(self.wall.back) }
    }
}

impl Figure for RayAndWall {
    const CAPTION: &'static str = "The plane, x to the right and y upward. Drag the ray's start p_r, the \
                                   end of its direction p_r + u_r, and the two faces of the wall.";
    const FRAME: (Place, Place) = ((-1.5, -1.8), (7.5, 3.8));

    fn methods() -> Vec<&'static str> {
        Method::ALL.map(Method::name).to_vec()
    }

    fn handles(&self) -> Vec<Handle> {
        let Wall { front, back } = self.wall;
        let places = [self.p_r, self.tip, (front, 3.2), (back, -1.2)];
        let names = ["p_r", "p_r + u_r", "front", "back"];
        names.into_iter().zip(places).map(|(name, place)| Handle { name, place }).collect()
    }

    fn drag(&mut self, handle: usize, to: Place) {
        let Some(Handle { place, .. }) = self.handles().into_iter().nth(handle) else { return };
        let (x, y) = to_hundredths(place, to);
        match handle {
            0 => (self.p_r, self.tip) = moved((self.p_r, self.tip), (x, y)),
            1 => self.tip = (x, y),
            2 => self.wall.front = x,
            3 => self.wall.back = x,
            _ => {}
        }
    }

    fn draw(&self, sketch: &mut Sketch) {
        let (((left, low), (right, high)), Wall { front, back }) = (Self::FRAME, self.wall);
        sketch.outline(&[(front, low), (back, low), (back, high), (front, high)], Ink::Object);
        sketch.line((left, 0.0), (right, 0.0), Ink::Quiet).line((0.0, low), (0.0, high), Ink::Quiet);
        let ray = self.ray::<f64>();
        let ahead = ray.at(1e3);
        sketch.line(self.p_r, (ahead.x(), ahead.y()), Ink::Ray).arrow(self.p_r, self.tip, Ink::Normal, 1.0);
        if let Crossing::Through(roots) = Method::Robust.work(&ray, &self.wall).crossing() {
            for t in [roots.near, roots.far].into_iter().filter(|&t| Span::ahead().contains(t)) {
                let point = ray.at(t);
                sketch.dot((point.x(), point.y()), Ink::Ray);
            }
        }
        for (handle, aside) in
            self.handles().into_iter().zip([(-14.0, 20.0), (10.0, -16.0), (-30.0, 0.0), (28.0, 0.0)])
        {
            sketch.label(handle.place, aside, Ink::Quiet, handle.name);
        }
    }

    fn steps<R: Real>(&self, method: usize) -> Result<Section, Degenerate> {
        let (ray, wall) = (self.ray::<R>(), self.wall::<R>());
        wall.check(&ray)?;
        Ok(first_steps::<R>(|transcript| explain(transcript, Method::ALL[method], &ray, &wall)))
    }

    fn answer<R: Real>(&self, method: usize) -> String {
        let work = Method::ALL[method].work(&self.ray::<R>(), &self.wall());
        let hit = work.hit(Span::ahead());
        let why = if hit == Ok(None) { why(&work) } else { "" };
        hit_in_words(hit, why)
    }
}

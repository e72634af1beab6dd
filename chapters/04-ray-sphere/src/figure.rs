//! The figure of the book: a ray and a sphere to drag.

use math::{Degenerate, Ray3, Real, Span};
use stage::figure::{Figure, Handle, Place, first_steps, hit_in_words, hundredths, moved, to_hundredths};
use stage::{Ink, Section, Sketch};

use crate::explain::explain;
use crate::scene::Painted;
use crate::{Method, Sphere, closest_approach};

/// A ray and a sphere as they are dragged; the ray of the worked example and the red sphere for the start.
pub struct RayAndSphere {
    p_r: Place,
    /// p_r + D
    tip: Place,
    c: Place,
    r: f64,
}

impl Default for RayAndSphere {
    fn default() -> RayAndSphere {
        RayAndSphere { p_r: (0.0, 0.0), tip: (1.0, -0.25), c: (3.0, -1.0), r: 1.0 }
    }
}

/// A point of the cut x = 0: z to the right, y upward.
fn point<R: Real>((z, y): Place) -> R::Vec3 {
    R::vec3(R::from(0.0), R::round_from(y), R::round_from(z))
}

/// Where a point of the cut stands in the drawing.
fn place(point: <f64 as Real>::Vec3) -> Place {
    let [_, y, z] = f64::xyz(point);
    (z, y)
}

impl RayAndSphere {
    fn ray<R: Real>(&self) -> Ray3<R> {
        let [p, tip] = [self.p_r, self.tip].map(point::<R>);
        Ray3::new(p, tip - p)
    }

    fn sphere<R: Real>(&self) -> Sphere<R> {
        Sphere { center: point::<R>(self.c), radius: R::round_from(self.r) }
    }
}

impl Figure for RayAndSphere {
    const CAPTION: &'static str = "A cut at x = 0, z to the right and y upward. Drag the ray's start p_r, \
                                   the end of its direction D, the sphere's center c, and its rim.";
    const FRAME: (Place, Place) = ((-1.0, -3.2), (6.5, 1.8));

    fn methods() -> Vec<&'static str> {
        Method::ALL.map(Method::name).to_vec()
    }

    fn handles(&self) -> Vec<Handle> {
        let names = ["p_r", "p_r + D", "c", "r"];
        let places = [self.p_r, self.tip, self.c, (self.c.0, self.c.1 - self.r)];
        names.into_iter().zip(places).map(|(name, place)| Handle { name, place }).collect()
    }

    fn drag(&mut self, handle: usize, to: Place) {
        let Some(Handle { place, .. }) = self.handles().into_iter().nth(handle) else { return };
        let (z, y) = to_hundredths(place, to);
        match handle {
            0 => (self.p_r, self.tip) = moved((self.p_r, self.tip), (z, y)),
            1 => self.tip = (z, y),
            2 => self.c = (z, y),
            // a radius below 0 may be had: it has no answer
            3 => self.r = hundredths(self.c.1 - y),
            _ => {}
        }
    }

    fn draw(&self, sketch: &mut Sketch) {
        let (ray, sphere) = (self.ray::<f64>(), self.sphere::<f64>());
        sketch.circle(self.c, self.r.max(0.0), Ink::Object);
        sketch.line(self.p_r, place(ray.at(1e3)), Ink::Ray).arrow(self.p_r, self.tip, Ink::Normal, 1.0);
        if sphere.check(&ray).is_ok() {
            let house = closest_approach(&ray, &sphere);
            let x_close = place(house.x_close);
            sketch.line(x_close, self.c, Ink::Length).dot(x_close, Ink::Surface);
            sketch.label(x_close, (0.0, -14.0), Ink::Surface, "x_close");
            if let Ok(Some(hit)) = Method::Robust.work(&ray, &sphere).hit(Span::ahead()) {
                let (x_hit, n) = (place(hit.point), place(hit.normal));
                sketch.arrow(x_hit, (x_hit.0 + 0.7 * n.0, x_hit.1 + 0.7 * n.1), Ink::Normal, 1.0);
                sketch.dot(x_hit, Ink::Ray).label(x_hit, (-4.0, 18.0), Ink::Ray, "x_hit");
            }
        }
        let asides = [(0.0, -16.0), (0.0, -16.0), (0.0, 20.0), (14.0, 14.0)];
        for (handle, aside) in self.handles().into_iter().zip(asides) {
            sketch.label(handle.place, aside, Ink::Quiet, handle.name);
        }
    }

    fn steps<R: Real>(&self, method: usize) -> Result<Section, Degenerate> {
        let (ray, sphere) = (self.ray::<R>(), self.sphere::<R>());
        sphere.check(&ray)?;
        let painted = Painted { name: "dragged", sphere, color: [255, 0, 0] };
        Ok(first_steps::<R>(|transcript| explain(transcript, Method::ALL[method], &ray, &painted)))
    }

    fn answer<R: Real>(&self, method: usize) -> String {
        let hit = Method::ALL[method].work(&self.ray::<R>(), &self.sphere()).hit(Span::ahead());
        hit_in_words(hit, "")
    }
}

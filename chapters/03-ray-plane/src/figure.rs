//! The figure of the book: a ray and a plane to drag.

use math::{Degenerate, Parallel, Ray3, Real, Span, Vector};
use stage::figure::{Figure, Handle, Place, at_z_0, first_steps, hit_in_words, moved, to_hundredths};
use stage::{Ink, Section, Sketch};

use crate::stage::explain;
use crate::{Meeting, Method, Plane};

/// A ray and a plane as they are dragged; a ray that comes down to the ground for the start.
pub struct RayAndPlane {
    p_r: Place,
    /// p_r + u_r
    tip: Place,
    p_0: Place,
    /// p_0 + n
    n_tip: Place,
}

impl Default for RayAndPlane {
    fn default() -> RayAndPlane {
        RayAndPlane { p_r: (-3.0, 1.0), tip: (-2.0, 0.75), p_0: (0.0, 0.0), n_tip: (0.0, 1.0) }
    }
}

impl RayAndPlane {
    fn ray<R: Real>(&self) -> Ray3<R> {
        let [p, tip] = [self.p_r, self.tip].map(at_z_0::<R>);
        Ray3::new(p, tip - p)
    }

    fn plane<R: Real>(&self) -> Plane<R> {
        let [p_0, tip] = [self.p_0, self.n_tip].map(at_z_0::<R>);
        Plane { point: p_0, normal: tip - p_0 }
    }
}

impl Figure for RayAndPlane {
    const CAPTION: &'static str = "A cut at z = 0, x to the right and y upward: the plane is seen from \
                                   its edge. Drag the ray's start p_r, the end of its direction, the \
                                   plane's point p_0 and the end of its normal.";
    const FRAME: (Place, Place) = ((-4.5, -2.4), (4.5, 3.2));

    fn methods() -> Vec<&'static str> {
        Method::ALL.map(Method::name).to_vec()
    }

    fn handles(&self) -> Vec<Handle> {
        let names = ["p_r", "p_r + u_r", "p_0", "p_0 + n"];
        let places = [self.p_r, self.tip, self.p_0, self.n_tip];
        names.into_iter().zip(places).map(|(name, place)| Handle { name, place }).collect()
    }

    fn drag(&mut self, handle: usize, to: Place) {
        let Some(Handle { place, .. }) = self.handles().into_iter().nth(handle) else { return };
        let (x, y) = to_hundredths(place, to);
        match handle {
            0 => (self.p_r, self.tip) = moved((self.p_r, self.tip), (x, y)),
            1 => self.tip = (x, y),
            2 => (self.p_0, self.n_tip) = moved((self.p_0, self.n_tip), (x, y)),
            3 => self.n_tip = (x, y),
            _ => {}
        }
    }

    fn draw(&self, sketch: &mut Sketch) {
        let (n_x, n_y) = (self.n_tip.0 - self.p_0.0, self.n_tip.1 - self.p_0.1);
        let along = |s: f64| (self.p_0.0 - s * n_y, self.p_0.1 + s * n_x);
        sketch.line(along(-1e3), along(1e3), Ink::Surface);
        sketch.arrow(self.p_0, self.n_tip, Ink::Normal, 1.0);
        let ray = self.ray::<f64>();
        let ahead = ray.at(1e3);
        sketch.line(self.p_r, (ahead.x(), ahead.y()), Ink::Ray).arrow(self.p_r, self.tip, Ink::Normal, 1.0);
        if let Ok(Some(hit)) = Method::Robust.work(&ray, &self.plane()).hit(Span::ahead()) {
            sketch.dot((hit.point.x(), hit.point.y()), Ink::Ray);
            sketch.label((hit.point.x(), hit.point.y()), (0.0, 18.0), Ink::Ray, "x");
        }
        let asides = [(0.0, -16.0), (0.0, -16.0), (0.0, 18.0), (0.0, -16.0)];
        for (handle, aside) in self.handles().into_iter().zip(asides) {
            sketch.label(handle.place, aside, Ink::Quiet, handle.name);
        }
    }

    fn steps<R: Real>(&self, method: usize) -> Result<Section, Degenerate> {
        let (ray, plane) = (self.ray::<R>(), self.plane::<R>());
        plane.check(&ray)?;
        Ok(first_steps::<R>(|transcript| explain(transcript, Method::ALL[method], &ray, &plane)))
    }

    fn answer<R: Real>(&self, method: usize) -> String {
        let work = Method::ALL[method].work(&self.ray::<R>(), &self.plane());
        let hit = work.hit(Span::ahead());
        let why = match hit {
            Ok(None) => match work.meeting() {
                Meeting::Never(how) => Parallel::reason(how),
                Meeting::At(_) => "behind",
            },
            _ => "",
        };
        hit_in_words(hit, why)
    }
}

//! The figure of the book: a ray and the corners of a triangle to drag, as the eye sees them.

use math::{Degenerate, Parallel, Ray3, Real, Span};
use stage::figure::{Figure, Handle, Place, first_steps, hit_in_words, to_hundredths};
use stage::{Ink, Section, Sketch};

use crate::explain::one_method;
use crate::scene::{WORKED, seen_at, triangle, view_ray};
use crate::{Method, Triangle};

/// A ray and a triangle as they are dragged; the worked example for the start.
pub struct RayAndTriangle {
    /// x and y of p̄_ij
    seen: Place,
    corners: [[f64; 3]; 3],
}

impl Default for RayAndTriangle {
    fn default() -> RayAndTriangle {
        RayAndTriangle { seen: WORKED, corners: triangle::<f64>().corners().map(f64::xyz) }
    }
}

impl RayAndTriangle {
    fn ray<R: Real>(&self) -> Ray3<R> {
        view_ray(self.seen)
    }

    fn triangle<R: Real>(&self) -> Triangle<R> {
        let [p1, p2, p3] = self.corners.map(|corner| {
            let [x, y, z] = corner.map(R::round_from);
            R::vec3(x, y, z)
        });
        Triangle { p1, p2, p3 }
    }
}

impl Figure for RayAndTriangle {
    const CAPTION: &'static str = "The view plane z = −1, as the eye sees it, x to the right and y \
                                   upward. Drag the ray's point p̄_ij and the corners: those keep their \
                                   z, so that the triangle leans back as before.";
    const FRAME: (Place, Place) = ((-1.2, -0.7), (1.2, 0.7));

    fn methods() -> Vec<&'static str> {
        Method::ALL.map(Method::name).to_vec()
    }

    fn handles(&self) -> Vec<Handle> {
        let names = ["p̄1", "p̄2", "p̄3"].into_iter();
        let mut handles = vec![Handle { name: "p̄_ij", place: self.seen }];
        let corners = self.triangle::<f64>().corners().map(seen_at::<f64>);
        handles.extend(names.zip(corners).map(|(name, place)| Handle { name, place }));
        handles
    }

    fn drag(&mut self, handle: usize, to: Place) {
        if handle == 0 {
            self.seen = to_hundredths(self.seen, to);
        } else if let Some(corner) = self.corners.get_mut(handle - 1) {
            let [x, y, z] = *corner;
            let (x, y) = to_hundredths((x, y), (-z * to.0, -z * to.1));
            *corner = [x, y, z];
        }
    }

    fn draw(&self, sketch: &mut Sketch) {
        let triangle = self.triangle::<f64>();
        let corners = triangle.corners().map(seen_at::<f64>);
        sketch.outline(&corners, Ink::Object);
        for corner in corners {
            sketch.line(corner, self.seen, Ink::Quiet);
        }
        let is_hit = matches!(Method::Robust.work(&self.ray(), &triangle).hit(Span::ahead()), Ok(Some(_)));
        sketch.dot(self.seen, if is_hit { Ink::Ray } else { Ink::Quiet });
        for handle in self.handles() {
            sketch.label(handle.place, (0.0, -16.0), Ink::Quiet, handle.name);
        }
    }

    fn steps<R: Real>(&self, method: usize) -> Result<Section, Degenerate> {
        let (ray, triangle) = (self.ray::<R>(), self.triangle::<R>());
        triangle.check(&ray)?;
        Ok(first_steps::<R>(|transcript| one_method(transcript, Method::ALL[method], &ray, &triangle)))
    }

    fn answer<R: Real>(&self, method: usize) -> String {
        let work = Method::ALL[method].work(&self.ray::<R>(), &self.triangle());
        let hit = work.hit(Span::ahead());
        let why = if hit == Ok(None) { work.parallel().map_or("past it", Parallel::reason) } else { "" };
        hit_in_words(hit, why)
    }
}

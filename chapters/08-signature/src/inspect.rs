//! Every pixel's ray for the inspector: the loop over the objects, and a side view of the ray where it hits.

use math::{Ray3, Real, Span, Vector};
use stage::{Ask, Chapter, Error, Ink, Inspect, Inspector, Look, Sketch, Transcript};

use crate::false_color::{NOTHING, color_of};
use crate::stage::{Signature, fault, read, worked};
use crate::{First, Hit3, Method, Object, Scene, Shape, explain, first_hit, from_file};

/// The picture of a scene, ray by ray.
struct Rays<'a, R: Real> {
    ask: &'a Ask,
    first: (u32, u32),
    method: Method,
    scene: Scene<R>,
}

/// Hands the rays to `write`.
///
/// [`Error::Request`] where the scene cannot be read or the pixel lies outside the picture; the error of
/// `write`.
pub(crate) fn inspect<R: Real>(ask: &Ask, write: Inspector<'_>) -> Result<(), Error> {
    let file = read(ask.scene.as_deref())?;
    let (size, first) = ask.to_inspect(file.camera.size.value, |size| worked(ask, size))?;
    let scene = from_file::scene::<R>(&file, Some(size)).map_err(fault)?;
    write(&Rays { ask, first, method: Method::ALL[ask.method], scene })
}

impl<R: Real> Inspect for Rays<'_, R> {
    fn size(&self) -> (u32, u32) {
        self.scene.size
    }

    fn first(&self) -> (u32, u32) {
        self.first
    }

    fn caption(&self) -> &'static str {
        "The ray from the side, in the plane of the ray and the normal where it hits: λ along it, a mark where \
         it hits each object, and at the first one the surface and its normal. A sphere is cut through its \
         center."
    }

    fn look(&self, pixel: (u32, u32)) -> Result<Look, Error> {
        let Rays { ask, method, scene, .. } = self;
        let ray = scene.ray(pixel);
        let mut transcript = Transcript::new(&Signature.about(), ask);
        explain::explain(&mut transcript, *method, scene, pixel);
        explain::trace_ray(&mut transcript, *method, scene, pixel);
        let first = first_hit(*method, &ray, &scene.objects, Span::ahead());
        let color = first.map_or(NOTHING, |first| color_of(first.object));
        let drawing = match first {
            None => misses(),
            Some(first) => section(*method, &ray, &scene.objects, first),
        };
        Ok(Look { color, sections: transcript.sections, drawing })
    }
}

/// A ray that hits nothing.
fn misses() -> String {
    let mut sketch = Sketch::new((0.0, -1.0), (3.0, 1.0));
    sketch.arrow((0.0, 0.0), (3.0, 0.0), Ink::Ray, 1.0).dot((0.0, 0.0), Ink::Ray);
    sketch.label((0.0, 0.0), (4.0, -12.0), Ink::Ray, "ē").caption(
        (12.0, 22.0),
        Ink::Quiet,
        "It hits nothing.",
    );
    sketch.into_svg()
}

/// The ray goes to the right, and half as far again as the first hit. Of the point ē + x u + y v the place is
/// (x, y): u is the ray's direction, and v that of the normal across the ray; both of length 1.
fn section<R: Real>(method: Method, ray: &Ray3<R>, objects: &[Object<R>], first: First<R>) -> String {
    let object = &objects[first.object];
    let length: f64 = ray.direction.length().into();
    let way = |lambda: R| length * Into::<f64>::into(lambda);
    let distance = way(first.lambda);
    // from a hit at the eye one sees a unit of the ray
    let right = if distance > 0.0 { 1.5 * distance } else { length };
    let high = right / 3.0;
    let mut sketch = Sketch::new((-0.03 * right, -high), (right, high));

    let hit = object.shape.hit(method, ray, Span::ahead());
    let n = hit.map(|hit| across(ray, &hit));
    let place = (distance, 0.0);
    if let (Shape::Sphere(sphere), Some(n)) = (&object.shape, n) {
        let r: f64 = sphere.radius.into();
        sketch.circle((distance - r * n.0, -r * n.1), r, Ink::Object);
    }
    sketch.arrow((0.0, 0.0), (right, 0.0), Ink::Ray, 1.0).dot((0.0, 0.0), Ink::Ray);
    sketch.label((0.0, 0.0), (6.0, -12.0), Ink::Ray, "ē");
    sketch.line((length, -0.15 * high), (length, 0.15 * high), Ink::Quiet);
    sketch.label((length, 0.15 * high), (0.0, -9.0), Ink::Quiet, "λ = 1");
    others(&mut sketch, (method, ray), objects, first, (way, high));

    let name =
        object.id.map_or(object.shape.name().to_string(), |id| format!("{id}, {}", object.shape.name()));
    if let Some(n) = n {
        // the surface is seen from its edge, and the normal stands on it
        let half = 0.4 * high;
        sketch.line((distance - half * n.1, half * n.0), (distance + half * n.1, -half * n.0), Ink::Surface);
        let end = (distance + 0.55 * high * n.0, 0.55 * high * n.1);
        sketch.arrow(place, end, Ink::Normal, 1.0).label(end, (-10.0, -6.0), Ink::Normal, "n");
    }
    let lambda: f64 = first.lambda.into();
    sketch.dot(place, Ink::Ray).label(place, (26.0, 20.0), Ink::Ray, &format!("λ_ij = {lambda:.4}"));
    let side = match n.map(|n| n.0) {
        Some(along) if along < 0.0 => "against the normal, d⃗ · n < 0: from outside",
        Some(along) if along > 0.0 => "along the normal, d⃗ · n > 0: from inside, or from behind",
        _ => "along the surface, d⃗ · n = 0",
    };
    sketch.caption((12.0, 22.0), Ink::Object, &format!("object {name}"));
    sketch.caption((12.0, 40.0), Ink::Quiet, &format!("The ray comes {side}."));
    sketch.into_svg()
}

/// The other objects that the ray hits: a mark on it, with the object's id.
fn others<R: Real>(
    sketch: &mut Sketch,
    (method, ray): (Method, &Ray3<R>),
    objects: &[Object<R>],
    first: First<R>,
    (way, high): (impl Fn(R) -> f64, f64),
) {
    for (place, object) in objects.iter().enumerate().filter(|(place, _)| *place != first.object) {
        let Some(hit) = object.shape.hit(method, ray, Span::ahead()) else { continue };
        let at = way(hit.t);
        sketch.line((at, -0.12 * high), (at, 0.12 * high), Ink::Surface);
        let id = object.id.map_or(place + 1, usize::from);
        sketch.label((at, -0.12 * high), (0.0, 11.0), Ink::Surface, &id.to_string());
    }
}

/// The normal in the plane of the drawing: along the ray, and across it, which is never less than 0.
fn across<R: Real>(ray: &Ray3<R>, hit: &Hit3<R>) -> (f64, f64) {
    let (u, n): ([f64; 3], [f64; 3]) = (ray.direction.unit().in_f64(), hit.normal.in_f64());
    let along: f64 = (0..3).map(|i| u[i] * n[i]).sum();
    let rest = (0..3).map(|i| n[i] - along * u[i]);
    (along, rest.map(|it| it * it).sum::<f64>().sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the page has of a pixel is what `show --pixel` says of it.
    #[test]
    fn a_look_is_what_show_says_of_the_pixel() {
        let size = Some((16, 12));
        for method in 0..Method::ALL.len() {
            for pixel in [(9, 6), (0, 0), (8, 11), (4, 7)] {
                let ask = Ask { method, size, pixel: Some(pixel), ..Ask::default() };
                let shown = Signature.show::<f64>(&ask).unwrap();
                let mut looked = None;
                let mut look = |rays: &dyn Inspect| {
                    looked = Some(rays.look(rays.first())?);
                    Ok(())
                };
                Signature.inspect::<f64>(&ask, &mut look).unwrap();
                let look = looked.unwrap();
                assert!(look.sections.len() >= 3);
                assert_eq!(look.sections, shown.transcript.sections[..look.sections.len()], "{pixel:?}");
            }
        }
    }

    /// By hand: a ray along z that meets a unit sphere around (0, 0.6, 5) has n = (0, −0.6, −0.8).
    #[test]
    fn a_normal_stands_across_the_ray() {
        let center = glam::DVec3::new(0.0, 0.6, 5.0);
        let sphere = Shape::<f64>::Sphere(ray_sphere::Sphere { center, radius: 1.0 });
        let ray = Ray3::<f64>::new(glam::DVec3::ZERO, glam::DVec3::new(0.0, 0.0, 2.0));
        let hit = sphere.hit(Method::Robust, &ray, Span::ahead()).unwrap();
        let (along, across) = across(&ray, &hit);
        // the normal, its square and the root are each rounded by half a unit of the last digit of 1 at most
        let few = 4.0 * f64::EPSILON;
        assert!((along + 0.8).abs() <= few && (across - 0.6).abs() <= few, "{along} {across}");
        let objects = [Object { id: Some(7), shape: sphere }];
        let drawn = section(Method::Robust, &ray, &objects, First { object: 0, lambda: hit.t });
        for part in [
            ">ij</tspan><tspan dy=\"-3\"> = 2.1000<",
            "object 7, sphere",
            "from outside",
            "<circle class=\"object\"",
        ] {
            assert!(drawn.contains(part), "{part}: {drawn}");
        }
    }
}

//! Every pixel's ray for the inspector: the steps of the method, and the section through the ray and a
//! sphere's center.

use math::{Camera, Ray3, Real, Span};
use stage::{Ask, Color, Error, Ink, Inspect, Inspector, Look, Sketch, Transcript};

use crate::scene::{BACKGROUND, Painted, camera, pixel_ray, three_spheres, trace_ray};
use crate::stage::{RaySphere, subject};
use crate::{Method, explain};

/// The picture of the three spheres, ray by ray.
struct Rays<'a, R: Real> {
    ask: &'a Ask,
    size: (u32, u32),
    first: (u32, u32),
    method: Method,
    camera: Camera<R>,
    spheres: [Painted<R>; 3],
}

/// Hands the rays to `write`.
///
/// [`Error::Request`] where the pixel that is asked for lies outside the picture; the error of `write`.
pub(crate) fn inspect<R: Real>(ask: &Ask, own: (u32, u32), write: Inspector<'_>) -> Result<(), Error> {
    // the worked example looks at the center of the red sphere, a third of the viewport below the middle
    let worked = |(width, height): (u32, u32)| (width / 2, height / 2 + height / 3);
    let (size, first) = ask.to_inspect(own, worked)?;
    let (method, spheres) = (Method::ALL[ask.method], three_spheres());
    write(&Rays::<R> { ask, size, first, method, camera: camera(size)?, spheres })
}

impl<R: Real> Inspect for Rays<'_, R> {
    fn size(&self) -> (u32, u32) {
        self.size
    }

    fn first(&self) -> (u32, u32) {
        self.first
    }

    fn caption(&self) -> &'static str {
        "The plane through the ray and the center of the sphere that it meets first, or passes nearest, in \
         units of length: the ray goes to the right from p_r."
    }

    fn look(&self, pixel: (u32, u32)) -> Result<Look, Error> {
        let Rays { ask, method, spheres, .. } = self;
        let ray = pixel_ray(&self.camera, self.size, pixel);
        let painted = &spheres[subject(*method, &ray, spheres)];
        let mut transcript = Transcript::new(&stage::Chapter::about(&RaySphere), ask);
        explain::explain(&mut transcript, *method, &ray, painted);
        explain::trace_ray(&mut transcript, *method, &ray, spheres);
        let seen = trace_ray(*method, &ray, spheres, Span::from_view_plane());
        let color = Color(seen.map_or(BACKGROUND, |(index, _)| spheres[index].color));
        Ok(Look { color, sections: transcript.sections, drawing: section(*method, &ray, painted) })
    }
}

/// House's figure: along the ray to the right, away from it upward.
///
/// Of the point p_r + x u_r + y e the place is (x, y), where e points from x_close to c.
fn section<R: Real>(method: Method, ray: &Ray3<R>, painted: &Painted<R>) -> String {
    let house = crate::closest_approach(ray, &painted.sphere);
    let [length, t_close, d, r] =
        [house.length, house.t_close, house.d, painted.sphere.radius].map(Into::into);
    // the method's own roots, in units of length
    let roots = method.work(ray, &painted.sphere).roots();
    let roots = roots.map(|roots| [roots.near, roots.far].map(|t| length * Into::<f64>::into(t)));

    let (c, x_close) = ((t_close, d), (t_close, 0.0));
    let right = f64::max(5.9, t_close + r + 0.3);
    let mut sketch = Sketch::new((-0.3, -1.3), (right, f64::max(2.6, d + r + 0.2)));
    sketch.circle(c, r, Ink::Object);
    sketch.line((length, -0.45), (length, 0.45), Ink::Quiet).label(
        (length, 0.45),
        (0.0, -9.0),
        Ink::Quiet,
        "t = 1",
    );
    sketch.arrow((0.0, 0.0), (right, 0.0), Ink::Ray, 1.0).dot((0.0, 0.0), Ink::Ray);
    sketch.label((0.0, 0.0), (4.0, -12.0), Ink::Ray, "p_r");

    // how far x_close is, below the ray
    let below = -0.95;
    sketch.line((0.0, below), (t_close, below), Ink::Length);
    sketch.line((0.0, 0.0), (0.0, below - 0.1), Ink::Quiet).line(x_close, (t_close, below - 0.1), Ink::Quiet);
    sketch.label((t_close / 2.0, below), (0.0, 11.0), Ink::Length, &format!("t_close = {t_close:.4}"));
    // how far the center is from the ray
    sketch.line(x_close, c, Ink::Length);
    sketch.label((t_close, f64::max(d / 2.0, 0.3)), (42.0, 0.0), Ink::Length, &format!("d = {d:.4}"));
    sketch.dot(c, Ink::Surface).label(c, (0.0, -12.0), Ink::Surface, "c");

    match roots {
        None => {
            sketch.label(x_close, (0.0, 14.0), Ink::Quiet, "x_close");
            sketch.caption((12.0, 22.0), Ink::Quiet, &why_none(method.name(), d > r, r, painted.name));
        }
        Some([near, far]) => {
            // half the chord, on the ray
            sketch.line((near, 0.0), x_close, Ink::Length);
            let a = (far - near) / 2.0;
            sketch.label(((near + t_close) / 2.0, 0.0), (0.0, 14.0), Ink::Length, &format!("a = {a:.4}"));
            sketch.dot((far, 0.0), Ink::Ray).dot((near, 0.0), Ink::Ray);
            sketch.line(c, (near, 0.0), Ink::Quiet);
            // n = (x_hit − c) / r, at the nearer root
            let n = ((near - t_close) / r, -d / r);
            sketch.arrow((near, 0.0), (near + 0.8 * n.0, 0.8 * n.1), Ink::Normal, 1.0);
            sketch.label((near + 0.8 * n.0, 0.8 * n.1), (-10.0, 2.0), Ink::Normal, "n");
            sketch.label((near, 0.0), (-26.0, -12.0), Ink::Ray, "x_hit");
            sketch.caption(
                (12.0, 22.0),
                Ink::Quiet,
                &format!("the {} sphere, r = {r}: enters at {near:.4}, leaves at {far:.4}", painted.name),
            );
        }
    }
    sketch.into_svg()
}

/// What a drawing says where the method finds no root. The length d is House's, rounded as his are: near a tangent another
/// method may miss where he does not.
fn why_none(method: &str, is_beyond: bool, r: f64, name: &str) -> String {
    match is_beyond {
        true => format!("d > r = {r}: the ray misses the {name} sphere"),
        false => {
            format!("{method} finds no root, though d > r = {r} does not hold: a miss of the {name} sphere")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stage::Chapter;

    /// The ray of this pixel touches on paper; rounded, the quadratic's discriminant is negative and House's d is r.
    #[test]
    fn a_drawing_does_not_say_what_is_not_so() {
        let pixel = Some((170, 300));
        let method = Method::ALL.iter().position(|method| *method == Method::Quadratic).unwrap();
        let ask = Ask { method, size: Some((540, 540)), pixel, ..Ask::default() };
        let mut drawn = String::new();
        let mut look = |rays: &dyn Inspect| {
            drawn = rays.look(rays.first())?.drawing;
            Ok(())
        };
        RaySphere.inspect::<f64>(&ask, &mut look).unwrap();
        assert!(drawn.contains("quadratic finds no root, though d &gt; r = 1 does not hold"), "{drawn}");
    }

    /// What the page has of a pixel is what `show --pixel` says of it, and its color is the picture's.
    #[test]
    fn a_look_is_what_show_says_of_the_pixel() {
        let size = Some((12, 12));
        for method in 0..Method::ALL.len() {
            for pixel in [(6, 9), (0, 0), (11, 6), (6, 6)] {
                let ask = Ask { method, size, pixel: Some(pixel), ..Ask::default() };
                let shown = RaySphere.show::<f64>(&ask).unwrap();
                let mut looked = None;
                let mut look = |rays: &dyn Inspect| {
                    looked = Some(rays.look(rays.first())?);
                    Ok(())
                };
                RaySphere.inspect::<f64>(&ask, &mut look).unwrap();
                let look = looked.unwrap();
                assert!(look.sections.len() >= 2);
                assert_eq!(look.sections, shown.transcript.sections[..look.sections.len()], "{pixel:?}");
            }
        }
    }

    /// House's example: the ray through the center of the red sphere has t_close = √10 and d = 0.
    #[test]
    fn the_section_has_the_lengths_of_the_page() {
        let spheres = three_spheres::<f64>();
        let ray = Ray3::<f64>::new(glam::DVec3::ZERO, glam::DVec3::new(0.0, -1.0, 3.0));
        let drawn = section(Method::ClosestApproach, &ray, &spheres[0]);
        // an index is an element of its own
        let t_close = "t<tspan dy=\"3\" font-size=\"0.8em\">close</tspan><tspan dy=\"-3\"> = 3.1623</tspan>";
        for label in
            [t_close, "d = 0.0000", "a = 1.0000", ">hit</tspan>", "enters at 2.1623, leaves at 4.1623"]
        {
            assert!(drawn.contains(label), "{label}: {drawn}");
        }
        let aside = Ray3::<f64>::new(glam::DVec3::ZERO, glam::DVec3::Y);
        let drawn = section(Method::Quadratic, &aside, &spheres[0]);
        assert!(drawn.contains("misses the red sphere") && !drawn.contains(">hit</tspan>"), "{drawn}");
    }
}

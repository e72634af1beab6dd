//! The figure of the book: a ray that meets a surface, and a light.

use math::{Degenerate, Ray3, Real, Span, Vector};
use ray_plane::{Hit3, Plane};
use shading::{Material, Rgb, phong};
use signature::Method;
use stage::figure::{Dial, Figure, Handle, Place, at_z_0, hit_in_words, hundredths, moved, to_hundredths};
use stage::{Ink, Section, Sketch, Value};

use crate::show::of_ray::{refracted, terms};
use crate::{critical_angle, mirror, refract};

/// A ray that goes from the air into water, for the start.
pub struct RayAndSurface {
    a: Place,
    /// ā + b⃗
    tip: Place,
    light: Place,
    /// The index of refraction above the surface, and below it.
    n: [f64; 2],
}

/// What the surface is made of: matte and shining.
const MATERIAL: Material =
    Material { color: Rgb([1.0, 1.0, 1.0]), ambient: 0.0, diffuse: 0.5, specular: 0.5, shininess: 16.0 };

impl Default for RayAndSurface {
    fn default() -> RayAndSurface {
        RayAndSurface { a: (-2.5, 2.0), tip: (-1.5, 1.2), light: (2.0, 2.0), n: [1.0, 1.33] }
    }
}

/// What happens where the ray lands.
struct Landed<R: Real> {
    p: R::Vec3,
    /// Toward where the ray comes from.
    n: R::Vec3,
    d: R::Vec3,
    from_above: bool,
}

impl RayAndSurface {
    fn ray<R: Real>(&self) -> Ray3<R> {
        let [a, tip] = [self.a, self.tip].map(at_z_0::<R>);
        Ray3::new(a, tip - a)
    }

    /// The surface, y = 0, met by a method.
    fn hit<R: Real>(&self, method: usize) -> Result<Option<Hit3<R>>, Degenerate> {
        let surface = Plane { point: at_z_0::<R>((0.0, 0.0)), normal: at_z_0::<R>((0.0, 1.0)) };
        match Method::ALL[method] {
            Method::Robust => ray_plane::robust(&self.ray(), &surface).hit(Span::ahead()),
            Method::Notes => ray_plane::notes(&self.ray(), &surface).hit(Span::ahead()),
        }
    }

    fn landed<R: Real>(&self, method: usize) -> Result<Option<Landed<R>>, Degenerate> {
        let Some(hit) = self.hit::<R>(method)? else { return Ok(None) };
        let d = self.ray::<R>().direction.unit();
        let from_above = hit.normal.dot(d) < R::from(0.0);
        let n = if from_above { hit.normal } else { -hit.normal };
        Ok(Some(Landed { p: hit.point, n, d, from_above }))
    }

    fn media(&self, from_above: bool) -> [f64; 2] {
        let [above, below] = self.n;
        if from_above { [above, below] } else { [below, above] }
    }
}

impl Figure for RayAndSurface {
    const CAPTION: &'static str = "A cut at z = 0: the surface is y = 0, seen from its edge. Drag the \
                                   ray, also from below, and the light l̄; turn the indices of refraction \
                                   above and below.";
    const FRAME: (Place, Place) = ((-3.6, -2.2), (3.6, 2.6));

    fn methods() -> Vec<&'static str> {
        Method::ALL.map(Method::name).to_vec()
    }

    fn handles(&self) -> Vec<Handle> {
        let names = ["ā", "ā + b⃗", "l̄"];
        let places = [self.a, self.tip, self.light];
        names.into_iter().zip(places).map(|(name, place)| Handle { name, place }).collect()
    }

    fn drag(&mut self, handle: usize, to: Place) {
        let Some(Handle { place, .. }) = self.handles().into_iter().nth(handle) else { return };
        let (x, y) = to_hundredths(place, to);
        match handle {
            0 => (self.a, self.tip) = moved((self.a, self.tip), (x, y)),
            1 => self.tip = (x, y),
            2 => self.light = (x, y),
            _ => {}
        }
    }

    fn dials(&self) -> Vec<Dial> {
        let names = ["n above", "n below"].into_iter();
        names.zip(self.n).map(|(name, value)| Dial { name, value, least: 1.0, most: 2.5 }).collect()
    }

    fn turn(&mut self, dial: usize, to: f64) {
        if let Some(n) = self.n.get_mut(dial) {
            *n = hundredths(to.clamp(1.0, 2.5));
        }
    }

    fn draw(&self, sketch: &mut Sketch) {
        let ((left, low), (right, _)) = Self::FRAME;
        // it goes on below what is seen
        let below = low - 1.0;
        sketch.outline(
            &[(left - 1.0, below), (right + 1.0, below), (right + 1.0, 0.0), (left - 1.0, 0.0)],
            Ink::Object,
        );
        sketch.dot(self.light, Ink::Shadow);
        let ray = self.ray::<f64>();
        let place = |v: <f64 as Real>::Vec3| (v.x(), v.y());
        match self.landed::<f64>(0) {
            Ok(Some(Landed { p, n, d, from_above })) => {
                sketch.line(self.a, place(p), Ink::Ray).arrow(place(p), place(p + n), Ink::Normal, 1.0);
                sketch.line(place(p), self.light, Ink::Shadow);
                let m_s = mirror::<f64>(d, n).m_s;
                sketch.arrow(place(p), place(p + m_s * 1.6), Ink::Mirror, 1.0);
                sketch.label(place(p + m_s * 1.6), (0.0, -12.0), Ink::Mirror, "m⃗_s");
                let [n1, n2] = self.media(from_above);
                if let Some(t) = refract::<f64>(d, n, n1, n2).t {
                    sketch.arrow(place(p), place(p + t * 1.6), Ink::Refracted, 1.0);
                    sketch.label(place(p + t * 1.6), (12.0, 12.0), Ink::Refracted, "t⃗");
                } else {
                    sketch.caption((12.0, 22.0), Ink::Quiet, "total internal reflection");
                }
            }
            _ => {
                sketch.line(self.a, place(ray.at(1e3)), Ink::Ray);
            }
        }
        sketch.arrow(self.a, self.tip, Ink::Normal, 1.0);
        for handle in self.handles() {
            sketch.label(handle.place, (0.0, -16.0), Ink::Quiet, handle.name);
        }
    }

    fn steps<R: Real>(&self, method: usize) -> Result<Section, Degenerate> {
        let ray = self.ray::<R>();
        let mut section = Section::new("", "CSC418 11.7");
        section.vector::<R>("ā", "its origin", ray.origin).vector::<R>("b⃗", "its direction", ray.direction);
        let Some(landed) = self.landed::<R>(method)? else {
            section.step("p̄", "ā + λ* b⃗", Value::text("none")).note("it does not meet the surface");
            return Ok(section);
        };
        let Landed { p, n, d, from_above } = landed;
        let m_s = mirror::<R>(d, n);
        section
            .vector::<R>("p̄", "ā + λ* b⃗", p)
            .vector::<R>("n⃗", "the unit normal, toward where the ray comes from", n)
            .vector::<R>("d⃗", "b⃗ / ‖b⃗‖", d)
            .number("d⃗·n⃗", "−cos θ1", m_s.d_dot_n)
            .vector::<R>("m⃗_s", "−2 (d⃗·n⃗) n⃗ + d⃗", m_s.m_s);
        let [n1, n2] = self.media(from_above);
        refracted(&mut section, &refract::<R>(d, n, n1, n2), Some(from_above), || "goes through".to_string());
        let angle = critical_angle(n1, n2).map_or(Value::text("none"), Value::number);
        section.step("θ_c", "degrees, sin θ_c = n2 / n1", angle);

        let to_light = at_z_0::<R>(self.light) - p;
        if to_light.is_zero() {
            section.step("s⃗", "(l̄ − p̄) / ‖l̄ − p̄‖", Value::text("none")).note("the light is at p̄");
            return Ok(section);
        }
        let white = MATERIAL.color;
        let light = phong::<R>(&MATERIAL, white, white, n, to_light, -d);
        section.vector::<R>("s⃗", "(l̄ − p̄) / ‖l̄ − p̄‖", light.s).number(
            "n⃗·s⃗",
            "cos of its angle",
            light.n_dot_s,
        );
        if light.n_dot_s > R::from(0.0) {
            section.note("r_d = r_s = ½, α = 16, white");
            terms(&mut section, str::to_string, &MATERIAL, &light);
        } else {
            section.note("≤ 0: the light is behind the surface");
        }
        Ok(section)
    }

    fn answer<R: Real>(&self, method: usize) -> String {
        hit_in_words(self.hit::<R>(method), "")
    }
}

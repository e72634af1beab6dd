//! The page's rayTrace, findFirstHit and rtShade.

use bounds::{Bounded, Found, Query};
use math::{Ray3, Real, Span, Vector};
use shading::lighting::{Again, Point};
use shading::shadow::LastBlockers;
use shading::{Fate, Landing, Lighting, Rgb, Start};

use crate::media::{Undo, around_eye, entered_from_behind};
use crate::{Kind, Media, Requirements, Scene, Sent, Tolerance, Witness, mirror, refract};

/// The tracer: a scene, how to search it, and how much of it to model.
#[derive(Clone, Debug)]
pub struct Tracer<'a, R: Real> {
    scene: &'a Scene<R>,
    lighting: Lighting<'a, R>,
    /// Whether the media have to be known.
    media: bool,
    /// The solids that hold the eye; none where the media need not be known.
    around_eye: Vec<usize>,
    tolerance: Option<Tolerance>,
}

/// What a ray carries along: the media it is in, and with what weight it counts.
#[derive(Clone, Debug, Default)]
pub struct Path {
    media: Media,
    /// The product of the coefficients on the way from the eye.
    weight: f64,
    /// How much may still be left out of this pixel.
    left: f64,
    /// What stood before the lights.
    last: LastBlockers,
}

impl<'a, R: Real> Tracer<'a, R> {
    /// A tracer that models what `requirements` says. With a tolerance, which must be that of the scene, it
    /// leaves out what changes less. `bounded` is of the scene's own geometry.
    pub fn new(
        scene: &'a Scene<R>,
        bounded: &'a Bounded<'a, R>,
        requirements: &Requirements,
        tolerance: Option<Tolerance>,
    ) -> Tracer<'a, R> {
        let lighting = Lighting {
            scene: &scene.lit,
            bounded,
            start: Start::Bound,
            idle_shadows: requirements.idle_shadows,
            again: if requirements.idle_tests { Again::Idly } else { Again::Never },
        };
        let around_eye = if requirements.media { around_eye(scene) } else { Vec::new() };
        Tracer { scene, lighting, media: requirements.media, around_eye, tolerance }
    }

    /// The page's maxDepth.
    pub fn max_depth(&self) -> u32 {
        self.scene.max_depth
    }

    /// What a pixel sees, in linear radiance before clamping: the mean of `samples` × `samples` rays across
    /// it, at least 1 × 1, with a tolerance at most 64 × 64. The pixel is (column, row) from the top left.
    ///
    /// A path begins as its default; the same tracer may use it again for the next pixel.
    pub fn pixel(
        &self,
        pixel: (u32, u32),
        samples: u32,
        path: &mut Path,
        witness: &mut impl Witness<R>,
    ) -> Rgb {
        let mut sum = Rgb::BLACK;
        for (j, i) in (0..samples).flat_map(|j| (0..samples).map(move |i| (j, i))) {
            let across = |place: u32| R::round_from((f64::from(place) + 0.5) / f64::from(samples));
            sum += self.eye_ray(&self.ray(pixel, (across(i), across(j))), path, witness);
        }
        let count = f64::from(samples) * f64::from(samples);
        Rgb(sum.0.map(|channel| channel / count))
    }

    /// The ray from the eye through a point of a pixel: see [`signature::Scene::ray_within`].
    #[inline(always)]
    pub fn ray(&self, pixel: (u32, u32), within: (R, R)) -> Ray3<R> {
        self.scene.lit.geometry.ray_within(pixel, within)
    }

    /// The page's rayTrace(p̄_ij, d⃗_ij, 1): linear radiance, before clamping. An eye ray may hit at λ = 0. It
    /// must start at the scene's eye, as the media are those around it. It recurses, and each level of depth
    /// takes some kilobytes of the thread's stack.
    #[inline]
    pub fn eye_ray(&self, ray: &Ray3<R>, path: &mut Path, witness: &mut impl Witness<R>) -> Rgb {
        path.weight = 1.0;
        path.left = self.tolerance.as_ref().map_or(0.0, Tolerance::of_a_pixel);
        if !self.around_eye.is_empty() {
            path.media = Media::of(entered_from_behind(self.scene, &self.around_eye, ray));
        }
        let query = Query::new(*ray, Span::ahead());
        self.ray_trace(&query, Kind::Eye, 1.0, 1, path, witness)
    }

    /// rayTrace(ā, b⃗, depth): what the ray sees.
    #[inline]
    fn ray_trace<W: Witness<R>>(
        &self,
        query: &Query<R>,
        kind: Kind,
        coefficient: f64,
        depth: u32,
        path: &mut Path,
        witness: &mut W,
    ) -> Rgb {
        witness.sent(&Sent { kind, depth, ray: query.ray, coefficient });
        let bounded = self.lighting.bounded;
        let e = match bounded.find(query, witness) {
            None => self.scene.lit.background,
            Some(found) => match self.one_color(bounded.all_parts().object(found.part), depth) {
                Some(e) if !W::WANTS_LANDINGS => e,
                _ => self.landed(query, found, depth, path, witness),
            },
        };
        witness.ends(e);
        e
    }

    /// What an object returns wherever it is hit, if nothing depends on where: it has no texture, answers no
    /// light, and sends no ray on.
    #[inline(always)]
    fn one_color(&self, object: usize, depth: u32) -> Option<Rgb> {
        let lit = &self.scene.lit;
        let (material, optics) = (self.lighting.material(object), self.scene.optics_of(object));
        let is_lit = !lit.lights.is_empty() && (material.answers_lights() || self.lighting.idle_shadows);
        let sends_on = depth < self.scene.max_depth && (optics.mirror > 0.0 || optics.transmit > 0.0);
        let is_textured = lit.painted[object].texture.is_some();
        (!is_lit && !sends_on && !is_textured).then(|| self.lighting.ambient(object, material.color))
    }

    /// What a ray sees that lands on what it has found: findFirstHit's λ, p̄ and n⃗, and rtShade there.
    #[inline(always)]
    fn landed<W: Witness<R>>(
        &self,
        query: &Query<R>,
        found: Found<R>,
        depth: u32,
        path: &mut Path,
        witness: &mut W,
    ) -> Rgb {
        let is_textured = |object: usize| self.scene.lit.painted[object].texture.is_some();
        match Landing::on(self.lighting.bounded, query, found, is_textured) {
            Some(landing) => self.rt_shade(query.ray.direction, landing, depth, path, witness),
            None => self.scene.lit.background,
        }
    }

    /// rtShade(OBJ, p̄, n⃗, d⃗_e, depth): the local component and, before maxDepth, the global one.
    fn rt_shade<W: Witness<R>>(
        &self,
        direction: R::Vec3,
        landing: Landing<R>,
        depth: u32,
        path: &mut Path,
        witness: &mut W,
    ) -> Rgb {
        let (object, lambda) = (landing.object, landing.lambda);
        let Some(point) = self.lighting.point(direction, landing) else {
            witness.landed(object, lambda, None);
            let ambient = self.lighting.ambient(object, self.lighting.color(&landing));
            witness.local(ambient);
            return ambient;
        };
        witness.landed(object, lambda, Some(&point));
        let mut e = self.local(&point, path, witness);
        witness.local(e);
        if depth < self.scene.max_depth {
            let optics = self.scene.optics_of(object);
            if optics.mirror > 0.0 {
                // m⃗_s = −2 (d⃗·n⃗) n⃗ + d⃗
                let m_s = mirror::<R>(-point.c, point.turned.n).m_s;
                e += self.branch(&point, m_s, Kind::Mirror, optics.mirror, depth, path, witness);
            }
            if optics.transmit > 0.0 {
                e += self.refracted(&point, optics.transmit, depth, path, witness);
            }
        }
        e
    }

    /// I_l: the local model of chapter 10.
    #[inline]
    fn local<W: Witness<R>>(&self, point: &Point<R>, path: &mut Path, witness: &mut W) -> Rgb {
        let (mut shadow_rays, mut fates) = (0, Vec::new());
        let e = self.lighting.local(point, &mut path.last, witness, |light, fate| {
            shadow_rays += u64::from(matches!(fate, Fate::Shadowed(_) | Fate::Seen(_)));
            if W::WANTS_LANDINGS {
                fates.push((light, fate));
            }
        });
        witness.shadow_rays(shadow_rays);
        for (light, fate) in &fates {
            witness.light(*light, fate);
        }
        e
    }

    /// What comes through the surface: bent where it is a solid's, straight on where it is not.
    #[inline]
    fn refracted<W: Witness<R>>(
        &self,
        point: &Point<R>,
        transmit: f64,
        depth: u32,
        path: &mut Path,
        witness: &mut W,
    ) -> Rgb {
        let object = point.landing.object;
        let is_solid = self.scene.is_solid(object);
        let enters = point.turned.from_outside;
        let before = self.index(path.media.top());
        witness.media(&path.media);
        let undo = if self.media && is_solid { path.media.pass(object, enters) } else { Undo::Nothing };
        witness.media(&path.media);
        let after = self.index(path.media.top());
        let refraction = refract::<R>(-point.c, point.turned.n, before, after);
        witness.refraction(&refraction, is_solid.then_some(enters));
        let e = match refraction.t {
            Some(t) => self.branch(point, t, Kind::Refracted, transmit, depth, path, witness),
            // total internal reflection: the mirror term stays as it is, and nothing is refracted
            None => Rgb::BLACK,
        };
        path.media.undo(undo);
        e
    }

    /// The index of refraction of a solid's inside, and 1 outside of all.
    #[inline(always)]
    fn index(&self, solid: Option<usize>) -> f64 {
        solid.map_or(1.0, |solid| self.scene.optics_of(solid).ior)
    }

    /// rayTrace(p̄, …, depth + 1), scaled by its coefficient; or nothing, where all that it could bring is
    /// within what may be left out.
    #[inline]
    #[expect(
        clippy::too_many_arguments,
        reason = "what the page passes, and where to, why and to whom it is told"
    )]
    fn branch<W: Witness<R>>(
        &self,
        point: &Point<R>,
        direction: R::Vec3,
        kind: Kind,
        coefficient: f64,
        depth: u32,
        path: &mut Path,
        witness: &mut W,
    ) -> Rgb {
        // a direction without a length comes of numbers that overflowed
        if direction.is_zero() || !direction.is_finite() {
            return Rgb::BLACK;
        }
        let weight = path.weight;
        if let Some(tolerance) = &self.tolerance {
            let at_most = tolerance.at_most(weight * coefficient, depth + 1);
            if at_most <= path.left {
                // rounded down, so that all together stay within
                path.left = if at_most > 0.0 { (path.left - at_most).next_down() } else { path.left };
                witness.left_out(kind, at_most);
                return Rgb::BLACK;
            }
            path.weight = weight * coefficient;
        }
        let query = point.starts.toward(direction);
        let e = self.ray_trace(&query, kind, coefficient, depth + 1, path, witness) * coefficient;
        path.weight = weight;
        e
    }
}

#[cfg(test)]
mod tests {
    use bounds::Parts;
    use signature::Method;

    use super::*;

    /// A ball before the eye, of one pixel.
    fn ball(material: &str, light: &str) -> Scene<f64> {
        let text = format!(
            "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nsize = [1, 1]\n{light}[material.m]\n{material}\n\
             [[object]]\nsphere = {{ center = [0, 0, 0], radius = 1 }}\nmaterial = \"m\"\n"
        );
        let file = scene_file::Scene::from_toml("scene.toml", &text, std::path::Path::new("")).unwrap();
        crate::from_file::scene::<f64>(&file, None, None).unwrap()
    }

    /// By hand: one ray in the middle, four at a quarter and three quarters, the rows first; and of the ball in the middle, with
    /// a light behind the eye, each is a test and a hit, and its shadow ray a test, as it passes what it leaves. In a tree of
    /// one box each looks into one box as well.
    #[test]
    fn the_rays_of_a_pixel_are_spread_and_counted() {
        let scene = ball("mirror = 0", "[[light]]\nposition = [0, 0, 9]\nintensity = [1, 1, 1]\n");
        for (tree, boxes) in [(false, 0), (true, 2)] {
            let requirements = Requirements { tree, ..Requirements::of(&scene, 1) };
            let bounded = requirements.bounded(Method::Robust, &scene.lit.geometry);
            let tracer = Tracer::new(&scene, &bounded, &requirements, None);
            let rays = |samples: u32| {
                let mut all = crate::Tree::new();
                tracer.pixel((0, 0), samples, &mut Path::default(), &mut all);
                all
            };
            let (middle, four) = (rays(1), rays(4));
            assert_eq!(middle.nodes[0].sent.ray, tracer.ray((0, 0), (0.5, 0.5)));
            for (place, node) in four.nodes.iter().enumerate() {
                let within = [place % 4, place / 4].map(|it| (it as f64 + 0.5) / 4.0);
                assert_eq!(node.sent.ray, tracer.ray((0, 0), (within[0], within[1])), "{place}");
            }
            let search = bounds::Counts { boxes, tests: 2, hits: 1 };
            let counts = crate::Counts { eye: 1, shadow: 1, search, ..crate::Counts::default() };
            assert_eq!(middle.counts, counts, "{tree}");
        }
    }

    /// What nothing lights has one color wherever it is hit: r_a I_a C = 0.1. With a light it has it only where r_d + r_s = 0
    /// and no idle ray is wanted.
    #[test]
    fn what_no_light_changes_has_one_color() {
        let of = |material: &str, light: &str, idle: bool| {
            let scene = ball(material, light);
            let count = Parts::of(&scene.lit.geometry).count();
            let requirements = Requirements { idle_shadows: idle, ..Requirements::of(&scene, count) };
            let bounded = requirements.bounded(Method::Robust, &scene.lit.geometry);
            let tracer = Tracer::new(&scene, &bounded, &requirements, None);
            [1, scene.max_depth].map(|depth| tracer.one_color(0, depth))
        };
        let light = "[[light]]\nposition = [0, 0, 9]\nintensity = [1, 1, 1]\n";
        let (some, none) = ([Some(Rgb([0.1; 3])); 2], [None; 2]);
        assert_eq!(of("", "", false), some);
        assert_eq!(of("", light, false), none);
        assert_eq!(of("diffuse = 0", light, false), some);
        assert_eq!(of("diffuse = 0", light, true), none);
        // at the last depth no ray is sent on
        assert_eq!(of("diffuse = 0\nmirror = 0.5", light, false), [None, some[1]]);
        assert_eq!(of("diffuse = 0\ntransmit = 0.5", light, false), [None, some[1]]);
        assert_eq!(
            of("diffuse = 0\ntexture = { checker = [[1, 1, 1], [0, 0, 0]], scale = 1 }", light, false),
            none
        );
    }
}

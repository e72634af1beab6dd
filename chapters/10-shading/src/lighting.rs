//! The local model at a point, all lights together.

use bounds::{Bounded, Leaves, Tally};
use math::{Real, Vector};
use signature::Method;

use crate::landing::Turned;
use crate::shadow::{LastBlockers, blocker};
use crate::start::spared;
use crate::{Landing, Material, Phong, Rgb, Scene, Start, Starts, phong};

/// A scene ready to be lit.
#[derive(Clone, Copy, Debug)]
pub struct Lighting<'a, R: Real> {
    /// What there is.
    pub scene: &'a Scene<R>,
    /// The same, to be searched.
    pub bounded: &'a Bounded<'a, R>,
    /// Where the second rays start.
    pub start: Start,
    /// A ray is sent to a light even where r_d + r_s = 0 and it changes nothing.
    pub idle_shadows: bool,
    /// Whether a second ray is tried on what it leaves and cannot meet again.
    pub again: Again,
}

/// Whether a second ray is tried on the part that it leaves, where that cannot be met again: see [`spared`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Again {
    /// No.
    Never,
    /// Yes, and it does not count: for who wants to know what that costs. (To count it would say something
    /// else of a ray that runs along a plane by all its digits, as to a light in that plane: on which side it
    /// is depends on their rounding.)
    Idly,
    /// Yes, as on every other part: for who wants to know whether it is met.
    Counted,
}

/// What becomes of one light at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fate<R: Real> {
    /// n⃗·s⃗ ≤ 0, or the light is at the point: V = 0.
    Behind,
    /// r_d + r_s = 0: whether it is seen does not matter.
    Unanswered,
    /// This part stands in between: V = 0. Of several it is any.
    Shadowed(usize),
    /// V = 1.
    Seen(Phong<R>),
}

/// A point to be shaded: where a ray landed, how it sees the surface, and what the surface is like there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<R: Real> {
    /// Where the ray landed.
    pub landing: Landing<R>,
    /// The normals turned toward the viewer.
    pub turned: Turned<R>,
    /// c⃗, the unit vector to the viewer.
    pub c: R::Vec3,
    /// C, with the texture.
    pub color: Rgb,
    /// Where the rays start that leave it.
    pub starts: Starts<R>,
}

impl<'a, R: Real> Lighting<'a, R> {
    /// What a shading needs to know of a landing, by a ray with this direction, of any length but zero.
    ///
    /// `None` where the point is too far away to be a number: then there is no way from it to a light, and only the ambient
    /// term is left.
    #[inline(always)]
    pub fn point(&self, direction: R::Vec3, landing: Landing<R>) -> Option<Point<R>> {
        if !landing.point.is_finite() {
            return None;
        }
        let parts = self.bounded.all_parts();
        let shape = parts.shape(landing.part);
        let face = parts.face(landing.part);
        let formulas = self.bounded.formulas();
        let mut starts = Starts::of(self.start, formulas, shape, face, &landing);
        // the notes' formulas may say of what cannot be met that it is, and they are taken at their word
        if self.start == Start::Bound && formulas == Method::Robust && self.again != Again::Counted {
            starts.leaves = spared(shape, landing.part);
            if self.again == Again::Idly {
                starts.leaves = starts.leaves.map(Leaves::tried_idly);
            }
        }
        Some(Point {
            turned: landing.turned_toward(direction),
            c: -direction.unit(),
            color: self.color(&landing),
            landing,
            starts,
        })
    }

    /// C at a landing, linear: the material's color, times the texture where there is one.
    #[inline(always)]
    pub fn color(&self, landing: &Landing<R>) -> Rgb {
        let painted = &self.scene.painted[landing.object];
        let color = self.scene.materials[painted.material].color;
        match &painted.texture {
            None => color,
            Some(texture) => {
                let alpha_beta = landing.alpha_beta.map(|(alpha, beta)| (alpha.into(), beta.into()));
                color * texture.at(landing.point.in_f64(), alpha_beta)
            }
        }
    }

    /// What an object is made of, by its place in the scene.
    #[inline(always)]
    pub fn material(&self, object: usize) -> &'a Material {
        &self.scene.materials[self.scene.painted[object].material]
    }

    /// r_a I_a C, with C as `color`.
    #[inline(always)]
    pub fn ambient(&self, object: usize, color: Rgb) -> Rgb {
        self.scene.ambient * color * self.material(object).ambient
    }

    /// E without what comes from elsewhere: the ambient term and, for each light in turn, the diffuse and the specular one.
    /// Linear, before clamping. `told` is told what became of each light, by its place in the scene.
    #[inline]
    pub fn local(
        &self,
        point: &Point<R>,
        last: &mut LastBlockers,
        counts: &mut impl Tally,
        mut told: impl FnMut(usize, Fate<R>),
    ) -> Rgb {
        let mut e = self.ambient(point.landing.object, point.color);
        for light in 0..self.scene.lights.len() {
            let fate = self.fate(point, light, last, counts);
            if let Fate::Seen(phong) = &fate {
                e += phong.diffuse + phong.specular;
            }
            told(light, fate);
        }
        e
    }

    /// One light at a point.
    #[inline(always)]
    fn fate(
        &self,
        point: &Point<R>,
        number: usize,
        last: &mut LastBlockers,
        counts: &mut impl Tally,
    ) -> Fate<R> {
        let light = &self.scene.lights[number];
        let to_light = light.position - point.landing.point;
        // n⃗·s⃗ > 0, without the length of s⃗
        let faces_the_light = point.turned.n.dot(to_light) > R::from(0.0);
        if !faces_the_light {
            return Fate::Behind;
        }
        let material = self.material(point.landing.object);
        if !material.answers_lights() && !self.idle_shadows {
            return Fate::Unanswered;
        }
        let there = (number, light.position);
        if let Some(blocker) = blocker(self.bounded, &point.starts, there, to_light, last, counts) {
            return Fate::Shadowed(blocker);
        }
        Fate::Seen(phong(material, point.color, light.intensity, point.turned.n, to_light, point.c))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Painted;
    use crate::landing::tests::{alone, landing};
    use glam::DVec3;
    use ray_sphere::Sphere;
    use signature::Shape;

    /// What is known of the only part, a ball straight ahead, by rays that leave it.
    fn leaves(formulas: Method, start: Start, again: Again) -> [Leaves; 2] {
        let ball = || Shape::Sphere(Sphere { center: DVec3::new(0.0, 0.0, 4.0), radius: 1.0 });
        let matte = Material { color: Rgb::WHITE, ambient: 0.1, diffuse: 0.5, specular: 0.0, shininess: 1.0 };
        let scene = Scene {
            geometry: alone(ball()),
            painted: vec![Painted { material: 0, texture: None }],
            materials: vec![matte],
            lights: Vec::new(),
            ambient: Rgb::WHITE,
            background: Rgb::BLACK,
        };
        let bounded = Bounded::by(formulas, &scene.geometry, bounds::Method::None);
        let lighting = Lighting { scene: &scene, bounded: &bounded, start, idle_shadows: false, again };
        lighting.point(DVec3::Z, landing(formulas, ball(), DVec3::Z, false)).unwrap().starts.leaves
    }

    /// What is known of a ball, by its kind: a ray away from it cannot meet it again, and one into it starts
    /// within. Only who starts by the bound knows on which side that is, and only the robust formulas say it in
    /// the end.
    #[test]
    fn a_part_is_spared_where_it_is_sure_that_it_is_not_met_again() {
        let (passes, idly, within) = (Leaves::Passes(0), Leaves::PassesIdly(0), Leaves::Within(0));
        let unknown = [Leaves::Unknown; 2];
        let by_bound = |formulas, again| leaves(formulas, Start::Bound, again);
        assert_eq!(by_bound(Method::Robust, Again::Never), [passes, within]);
        assert_eq!(by_bound(Method::Robust, Again::Idly), [idly, within]);
        assert_eq!(by_bound(Method::Robust, Again::Counted), unknown);
        for again in [Again::Never, Again::Idly, Again::Counted] {
            assert_eq!(by_bound(Method::Notes, again), unknown, "{again:?}");
            for start in [Start::None, Start::Fixed, Start::Scaled] {
                assert_eq!(leaves(Method::Robust, start, again), unknown, "{start:?} {again:?}");
            }
            assert_eq!(leaves(Method::Robust, Start::Exclude, again), [passes; 2], "{again:?}");
        }
    }
}

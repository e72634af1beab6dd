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

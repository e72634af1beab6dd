//! Only what the scene requires.
//!
//! A tracer that could do everything pays for it with every ray: it keeps a stack of media where all is opaque, asks for
//! shadows that change nothing, builds a tree for three spheres, carries every ray through a matrix that does nothing. So what
//! a scene requires is found out once, and the rest is not done. The radiance of every pixel is the same to the last bit.

use bounds::Bounded;
use math::Real;
use signature::{Method, Shape};

use crate::Scene;

/// What may be modeled though a scene does not require it, and changes nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// Rays to lights that nothing answers.
    IdleShadows,
    /// Rays tried on what they cannot meet again.
    IdleTests,
    /// The stack of media where nothing bends.
    Media,
    /// A white texture on every object that has none and a shape with (u, v).
    IdleTextures,
    /// Every object carried through a transform that changes nothing.
    IdleTransforms,
    /// A tree for a few parts.
    Tree,
}

impl Feature {
    /// All of them.
    pub const ALL: [Feature; 6] = [
        Feature::IdleShadows,
        Feature::IdleTests,
        Feature::Media,
        Feature::IdleTextures,
        Feature::IdleTransforms,
        Feature::Tree,
    ];

    /// What it is, in a few words.
    pub fn name(self) -> &'static str {
        match self {
            Feature::IdleShadows => "shadow rays that change nothing",
            Feature::IdleTests => "tests of what a ray leaves",
            Feature::Media => "the stack of media",
            Feature::IdleTextures => "texture coordinates",
            Feature::IdleTransforms => "a transform for every object",
            Feature::Tree => "a tree of boxes",
        }
    }
}

/// What is modeled beyond eye rays and ambient light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Requirements {
    /// Rays to lights where they change something.
    pub shadows: bool,
    /// Rays to lights even where r_d + r_s = 0.
    pub idle_shadows: bool,
    /// Rays tried even on what they start from and cannot meet again.
    pub idle_tests: bool,
    /// Mirror rays.
    pub mirror: bool,
    /// Rays through surfaces.
    pub refraction: bool,
    /// The stack of media: something bends light.
    pub media: bool,
    /// Texture coordinates.
    pub textures: bool,
    /// Those of objects without a texture as well: a matter of the scene, see
    /// [`idle_textures`](crate::from_file::idle_textures).
    pub idle_textures: bool,
    /// Objects that are met in a space of their own.
    pub transforms: bool,
    /// The others as well, by a transform that changes nothing.
    pub idle_transforms: bool,
    /// A tree of boxes.
    pub tree: bool,
}

impl Requirements {
    /// What a scene requires, with so many parts to test.
    pub fn of<R: Real>(scene: &Scene<R>, parts: usize) -> Requirements {
        let lit = &scene.lit;
        let used = |object: &usize| {
            let material = lit.painted[*object].material;
            (&lit.materials[material], &scene.optics[material])
        };
        let objects = 0..lit.geometry.objects.len();
        let any = |holds: &dyn Fn(&usize) -> bool| objects.clone().any(|object| holds(&object));
        let is_traced_on = scene.max_depth > 1;
        let refraction = is_traced_on && any(&|object| used(object).1.transmit > 0.0);
        let bends = any(&|object| scene.is_solid(*object) && used(object).1.ior != 1.0);
        let lets_into = any(&|object| scene.is_solid(*object) && used(object).1.transmit > 0.0);
        let deformed = |object: &usize| matches!(lit.geometry.objects[*object].shape, Shape::Deformed(_));
        Requirements {
            shadows: !lit.lights.is_empty() && any(&|object| used(object).0.answers_lights()),
            idle_shadows: false,
            idle_tests: false,
            mirror: is_traced_on && any(&|object| used(object).1.mirror > 0.0),
            refraction,
            media: refraction && bends && lets_into,
            textures: lit.painted.iter().any(|painted| painted.texture.is_some()),
            idle_textures: false,
            transforms: any(&deformed),
            idle_transforms: false,
            tree: bounds::Method::required(parts) != bounds::Method::None || dear(scene) > 0,
        }
    }

    /// The same, and one feature more.
    pub fn and(mut self, feature: Feature) -> Requirements {
        match feature {
            Feature::IdleShadows => self.idle_shadows = true,
            Feature::IdleTests => self.idle_tests = true,
            Feature::Media => self.media = true,
            Feature::IdleTextures => self.idle_textures = true,
            Feature::IdleTransforms => self.idle_transforms = true,
            Feature::Tree => self.tree = true,
        }
        self
    }

    /// All that can be modeled.
    pub fn everything(self) -> Requirements {
        Feature::ALL.into_iter().fold(self, Requirements::and)
    }

    /// The geometry of a scene, to be searched by the formulas of `method`.
    pub fn bounded<'a, R: Real>(&self, method: Method, geometry: &'a signature::Scene<R>) -> Bounded<'a, R> {
        let bounded = Bounded::by(method, geometry, self.bounds());
        if self.idle_transforms { bounded.carrying() } else { bounded }
    }

    /// The structure for rays.
    pub fn bounds(&self) -> bounds::Method {
        if self.tree { bounds::Method::Wide } else { bounds::Method::None }
    }
}

/// How many objects take so long to test that a box in front of one alone pays: those that no glance in plain numbers decides
/// ([`Shape::glance`]), so that nearly every test is one to the last digit, and those at which a glance takes long.
///
/// Measured by `cargo run --release -p whitted -- --explain --scene FILE`: with a tree a ray takes 0.05 times as long in
/// `chapters/11-whitted/scenes/hall-of-mirrors.toml` (11 parts, 6 of them such) and 0.2 times in
/// `chapters/08-signature/scenes/tiny.toml` (4 parts, 1 such), and 4 times as long in `gambetta.toml` (4 spheres).
pub(crate) fn dear<R: Real>(scene: &Scene<R>) -> usize {
    let is_dear = |shape: &Shape<R>| match shape {
        Shape::Plane(_) | Shape::Sphere(_) | Shape::Triangle(_) | Shape::Mesh(_) => false,
        Shape::Polygon(_) | Shape::Solid(_) | Shape::OpenCone(_) | Shape::Deformed(_) => true,
    };
    scene.lit.geometry.objects.iter().filter(|object| is_dear(&object.shape)).count()
}

#[cfg(all(test, feature = "stage"))]
mod tests;

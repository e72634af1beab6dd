//! A scene with light: the geometry of chapter 08, and what is seen of it.

use math::Real;

use crate::{Material, Rgb, Textured};

/// Objects, what they are made of, and what shines on them.
#[derive(Clone, Debug)]
pub struct Scene<R: Real> {
    /// The camera and the objects.
    pub geometry: signature::Scene<R>,
    /// Of each object, in their order.
    pub painted: Vec<Painted>,
    /// The materials there are.
    pub materials: Vec<Material>,
    /// The point lights.
    pub lights: Vec<Light<R>>,
    /// I_a
    pub ambient: Rgb,
    /// What a ray sees that hits nothing.
    pub background: Rgb,
}

/// What an object is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Painted {
    /// Its place among the materials.
    pub material: usize,
    /// What its color is multiplied by, from place to place; `None` where its material has no texture.
    pub texture: Option<Box<Textured>>,
}

/// A point light, without attenuation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light<R: Real> {
    /// l̄ in the world, finite.
    pub position: R::Vec3,
    /// I, for the diffuse and the specular term.
    pub intensity: Rgb,
}

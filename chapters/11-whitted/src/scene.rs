//! A scene for the recursive tracer.

use math::Real;

/// The scene of chapter 10, and how its materials mirror and let through.
#[derive(Clone, Debug)]
pub struct Scene<R: Real> {
    /// Objects, materials, lights.
    pub lit: shading::Scene<R>,
    /// Of each material, in the order of [`shading::Scene::materials`].
    pub optics: Vec<Optics>,
    /// The page's maxDepth, at least 1: an eye ray has depth 1.
    pub max_depth: u32,
}

/// What a material does with the rays that it sends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Optics {
    /// r_g, the page's specularReflCoef, not negative; 0 where it is no mirror.
    pub mirror: f64,
    /// The page's refractiveReflCoef, not negative; 0 where nothing goes through.
    pub transmit: f64,
    /// The index of refraction of the inside, above 0; air has 1.
    pub ior: f64,
}

impl<R: Real> Scene<R> {
    /// How an object mirrors and lets through.
    #[inline(always)]
    pub fn optics_of(&self, object: usize) -> &Optics {
        &self.optics[self.lit.painted[object].material]
    }

    /// Whether an object has an inside, which a ray that goes through it enters and leaves. Flat things,
    /// meshes and open cones have none.
    #[inline(always)]
    pub fn is_solid(&self, object: usize) -> bool {
        use signature::Shape;
        matches!(
            self.lit.geometry.objects[object].shape,
            Shape::Sphere(_) | Shape::Solid(_) | Shape::Deformed(_)
        )
    }
}

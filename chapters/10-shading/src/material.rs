//! How a surface answers light.

use crate::Rgb;

/// The coefficients of Phong's model (CSC418 11.7.1), none of them negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// C, linear, which multiplies the ambient and the diffuse term.
    pub color: Rgb,
    /// r_a
    pub ambient: f64,
    /// r_d
    pub diffuse: f64,
    /// r_s, in the color of the light.
    pub specular: f64,
    /// α ≥ 0
    pub shininess: f64,
}

impl Material {
    /// r_d + r_s > 0: a light can change what is seen, so that its shadow matters.
    #[inline(always)]
    pub fn answers_lights(&self) -> bool {
        self.diffuse + self.specular > 0.0
    }
}

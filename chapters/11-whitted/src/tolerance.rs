//! Leaving out what nobody would see.
//!
//! A ray that was mirrored five times counts with the product of five coefficients. If all that it could
//! bring is less than anybody wants to know, it need not be sent. How much it could bring follows from the
//! scene: no surface is brighter than its local model in the light of all lights, plus what it mirrors and
//! lets through of the brightest that there is one level deeper.
//!
//! ```text
//! B(maxDepth) = max(background, L)      L = the largest of r_a I_a C + Σ I (r_d C + r_s)
//! B(depth) = max(background, the largest of L + (r_g + r_t) B(depth + 1))
//! ```
//!
//! A pixel may leave out rays until what they all could bring together is E; or a little less, as the sums
//! that have them are rounded, and those that have them not are rounded in another way. Where B is infinite
//! nothing is left out.

use math::Real;

use crate::Scene;

/// E, and the most that a ray of each depth can bring.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// E: linear radiance, before clamping.
    pub e: f64,
    /// B(depth), from depth 1.
    at_most: Vec<f64>,
    /// How much of E the rays of a pixel may bring: what rounding leaves of it.
    of_a_pixel: f64,
}

/// The most rays through a pixel: 64 × 64 samples.
const SAMPLES: f64 = 4096.0;

impl Tolerance {
    /// The bounds of a scene, for at most 64 × 64 rays a pixel. `e` is finite and not negative.
    pub fn new<R: Real>(scene: &Scene<R>, e: f64) -> Tolerance {
        let lit = &scene.lit;
        let background = lit.background.largest().max(0.0);
        let lights: f64 = lit.lights.iter().map(|light| light.intensity.largest().max(0.0)).sum();
        let local = |material: &shading::Material| {
            let color = material.color.largest();
            material.ambient * lit.ambient.largest().max(0.0) * color
                + lights * (material.diffuse * color + material.specular)
        };
        let materials: Vec<(f64, f64)> = lit
            .materials
            .iter()
            .zip(&scene.optics)
            .map(|(material, optics)| (local(material), optics.mirror + optics.transmit))
            .collect();
        let depths = scene.max_depth as usize;
        let mut at_most = vec![0.0; depths];
        let mut deeper = 0.0;
        for depth in (0..depths).rev() {
            let brightest =
                materials.iter().map(|(local, on)| local + on * deeper).fold(background, f64::max);
            at_most[depth] = brightest;
            deeper = brightest;
        }
        // Each level, here and in the tracer, rounds a product and a sum for each light and four more, each
        // by half a unit of the last digit; and a radiance may be rounded up as much as this is rounded down.
        let roundings = (2.0 * lit.lights.len() as f64 + 4.0) * depths as f64;
        at_most.iter_mut().for_each(|most| *most *= 1.0 + 2.0 * roundings * f64::EPSILON);
        // What is not negative and no more than B(1) is off by that much too when it is added up over all
        // levels and samples, once with the rays that are left out and once without.
        let off = 2.0 * (roundings + SAMPLES) * f64::EPSILON * at_most.first().copied().unwrap_or(0.0);
        Tolerance { e, at_most, of_a_pixel: (e - off).max(0.0) }
    }

    /// What a pixel may leave out.
    pub(crate) fn of_a_pixel(&self) -> f64 {
        self.of_a_pixel
    }

    /// B(depth) times a weight; infinite beyond the last depth. A weight that is too small for its digits
    /// counts as the smallest that has them all.
    #[inline(always)]
    pub(crate) fn at_most(&self, weight: f64, depth: u32) -> f64 {
        let weight = weight.max(f64::MIN_POSITIVE);
        self.at_most.get(depth as usize - 1).map_or(f64::INFINITY, |most| weight * most)
    }

    /// B(depth), in linear radiance, for a depth of at least 1; `None` beyond the last.
    pub fn bound(&self, depth: u32) -> Option<f64> {
        self.at_most.get(depth as usize - 1).copied()
    }
}

#[cfg(all(test, feature = "stage"))]
mod tests;

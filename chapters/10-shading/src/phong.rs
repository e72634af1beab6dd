//! Phong's model, term by term (CSC418 11.7.1).

use math::{Real, Vector, portable};

use crate::{Material, Rgb};

/// What one light adds at a point that sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong<R: Real> {
    /// s⃗ = (l̄ − p̄) / ‖l̄ − p̄‖: the page's s⃗ = l̄ − p̄ is no unit vector, and n⃗·s⃗ needs one (slip 25).
    pub s: R::Vec3,
    /// n⃗·s⃗
    pub n_dot_s: R,
    /// m⃗ = 2 (s⃗·n⃗) n⃗ − s⃗, where a mirror would send the light.
    pub m: R::Vec3,
    /// c⃗·m⃗
    pub c_dot_m: R,
    /// r_d I C max(0, n⃗·s⃗)
    pub diffuse: Rgb,
    /// r_s I max(0, c⃗·m⃗)^α
    pub specular: Rgb,
}

/// The terms of a light with intensity `i` in the direction `to_light` = l̄ − p̄, of any length but zero, on a
/// surface with the unit normal `n` and the color `color`, with the unit vector `c` to the viewer. Colors are
/// linear.
///
/// V is not in it: a light behind the surface, n⃗·s⃗ < 0, may still give a specular term.
#[inline(always)]
pub fn phong<R: Real>(
    material: &Material,
    color: Rgb,
    i: Rgb,
    n: R::Vec3,
    to_light: R::Vec3,
    c: R::Vec3,
) -> Phong<R> {
    // exercise s: The way to the light has some length. What should s⃗ be, if n⃗·s⃗ is to be a cosine?
    let s: R::Vec3 = to_light.unit();
    // end s
    // exercise m: How directly does the light fall on the surface, and where would a mirror send it?
    let n_dot_s: R = n.dot(s);
    let m: R::Vec3 = n * (n_dot_s + n_dot_s) - s;
    // end m
    // exercise c_dot_m: How near is the viewer to the mirror direction?
    let c_dot_m: R = c.dot(m);
    // end c_dot_m
    // exercise diffuse: How much does a matte surface of this color send on, whoever looks?
    let diffuse: Rgb = i * color * (material.diffuse * from_zero_to_one(n_dot_s));
    // end diffuse
    // exercise specular: And how bright is the highlight, and what color has it?
    let specular: Rgb = match material.specular > 0.0 {
        true => i * (material.specular * power(from_zero_to_one(c_dot_m), material.shininess)),
        false => Rgb::BLACK,
    };
    // end specular
    Phong { s, n_dot_s, m, c_dot_m, diffuse, specular }
}

/// max(0, x), for the cosine x. Rounding may leave it a digit above 1; with an α of millions its power would be brighter
/// than the light.
#[inline(always)]
fn from_zero_to_one<R: Real>(x: R) -> f64 {
    let x: f64 = x.into();
    // exercise clamp: What does a cosine below zero say about the light, and how much comes from there?
    if x > 0.0 { x.min(1.0) } else { 0.0 }
    // end clamp
}

/// x^α for 0 ≤ x and 0 ≤ α, with 0⁰ = 1. A whole α up to 4096 is a product of squares, which is faster; the
/// others take a logarithm, the same one on every machine.
#[inline(always)]
pub fn power(x: f64, alpha: f64) -> f64 {
    const LARGEST: f64 = 4096.0;
    if alpha <= LARGEST && alpha == alpha.trunc() {
        let (mut factor, mut product, mut bits) = (x, 1.0, alpha as u32);
        while bits > 0 {
            if bits & 1 == 1 {
                product *= factor;
            }
            factor *= factor;
            bits >>= 1;
        }
        return product;
    }
    if x == 0.0 { 0.0 } else { portable::pow(x, alpha) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    const MATERIAL: Material =
        Material { color: Rgb::WHITE, ambient: 0.1, diffuse: 0.5, specular: 0.25, shininess: 2.0 };

    /// By hand: n = (0, 1, 0), the light up and to the right at 3-4-5, the viewer straight above: n·s = 4/5,
    /// m = (−3/5, 4/5, 0), c·m = 4/5.
    #[test]
    fn a_light_at_an_angle() {
        let color = Rgb([1.0, 0.5, 0.0]);
        let (to_light, n) = (DVec3::new(6.0, 8.0, 0.0), DVec3::Y);
        let it = phong::<f64>(&MATERIAL, color, Rgb([2.0; 3]), n, to_light, DVec3::Y);
        assert!((it.s - DVec3::new(0.6, 0.8, 0.0)).length() < 1e-15);
        assert!((it.m - DVec3::new(-0.6, 0.8, 0.0)).length() < 1e-15);
        // 0.5 · 2 · 0.8 = 0.8; 0.25 · 2 · 0.64 = 0.32
        for (got, want) in it.diffuse.0.into_iter().zip([0.8, 0.4, 0.0]) {
            assert!((got - want).abs() < 1e-15);
        }
        assert!((it.specular.0[0] - 0.32).abs() < 1e-15);
        assert_eq!(it.specular.0[0], it.specular.0[2], "in the color of the light");
    }

    /// Slip 25: with s⃗ = l̄ − p̄ as printed a light ten times as far is ten times as bright.
    #[test]
    fn as_printed_a_far_light_is_brighter() {
        let at = |far: f64| {
            phong::<f64>(
                &MATERIAL,
                Rgb::WHITE,
                Rgb::WHITE,
                DVec3::Y,
                DVec3::new(3.0, 4.0, 0.0) * far,
                DVec3::Y,
            )
        };
        assert_eq!(at(1.0).diffuse, at(16.0).diffuse);
        let as_printed = |far: f64| DVec3::Y.dot(DVec3::new(3.0, 4.0, 0.0) * far);
        assert_eq!(as_printed(16.0), 16.0 * as_printed(1.0));
    }

    /// Slip 17, by hand: the light is below the surface, s = (3, −4, 0)/5, and m = (−3, −4, 0)/5. A viewer at
    /// (−24, 7, 0)/25 above it has c·m = (72 − 28)/125, and E as printed a highlight on the dark side.
    #[test]
    fn as_printed_there_is_a_highlight_on_the_dark_side() {
        let (to_light, c) = (DVec3::new(3.0, -4.0, 0.0), DVec3::new(-0.96, 0.28, 0.0));
        let it = phong::<f64>(&MATERIAL, Rgb::WHITE, Rgb::WHITE, DVec3::Y, to_light, c);
        assert!((it.c_dot_m - 44.0 / 125.0).abs() < 1e-15 && it.n_dot_s < 0.0);
        assert_eq!(it.diffuse, Rgb::BLACK);
        assert!(it.specular.0[0] > 0.0, "as printed; `Lighting` asks for n·s > 0 first, for both terms");
    }

    /// Straight from the mirror direction the highlight is r_s I, for whatever α. In f32 some such direction has c·m > 1,
    /// and (1 + 2⁻²³)^α is e for an α of 2²³.
    #[test]
    fn no_highlight_is_brighter_than_its_light() {
        let material = Material { shininess: (2.0_f64).powi(23), ..MATERIAL };
        let mut above = 0;
        for step in 1..2000_u16 {
            let c = glam::Vec3::new(f32::from(step), 1000.0, 77.0).normalize();
            let it = phong::<f32>(&material, Rgb::WHITE, Rgb::WHITE, c, c, c);
            above += u32::from(it.c_dot_m > 1.0);
            assert!(it.specular.0[0] <= 0.25 && it.diffuse.0[0] <= 0.5, "{it:?}");
        }
        assert!(above > 0);
    }

    /// Exact powers: 0.75³ = 27/64, 0.5^32 = 2⁻³². And x^2.5 = x² √x.
    #[test]
    fn powers() {
        assert_eq!(power(0.75, 3.0), 27.0 / 64.0);
        assert_eq!(power(0.5, 32.0), (2.0_f64).powi(-32));
        assert_eq!(
            (power(0.0, 0.0), power(0.5, 0.0), power(0.0, 0.5), power(1.0, 1e300)),
            (1.0, 1.0, 0.0, 1.0)
        );
        assert!((power(0.25, 2.5) - 1.0 / 32.0).abs() < 1e-17);
    }

    /// r_s = 0: however bright the light, nothing of it is in a highlight; 0 · ∞ is no number.
    #[test]
    fn a_matte_surface_has_no_highlight() {
        let matte = Material { specular: 0.0, ..MATERIAL };
        let too_bright = Rgb([f64::INFINITY; 3]);
        let it = phong::<f64>(&matte, Rgb::WHITE, too_bright, DVec3::Y, DVec3::Y, DVec3::Y);
        assert_eq!((it.diffuse, it.specular), (too_bright, Rgb::BLACK));
    }

    /// By hand: n⃗·s⃗ = 0 · (−1) + 1 · (−0) + 0 · (−1) is −0, a cosine of a light that is level with the
    /// surface. The light from there is 0, whose power and whose digits have no sign.
    #[test]
    fn no_light_has_no_sign() {
        for (x, want) in [(-0.0, 0.0), (0.0, 0.0), (-1.0, 0.0), (0.5, 0.5), (1.0 + f64::EPSILON, 1.0)] {
            assert_eq!(from_zero_to_one::<f64>(x).to_bits(), f64::to_bits(want), "{x}");
        }
    }
}

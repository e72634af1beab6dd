//! Colors that a color-blind reader can tell apart, and colors from light.

use math::portable;

/// An opaque color, red, green and blue from 0 to 255 as a PNG stores them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color(pub [u8; 3]);

/// The palette of Okabe and Ito (2008), chosen to stay apart under every common color blindness,
/// and the grays to draw with.
impl Color {
    /// Black.
    pub const BLACK: Color = Color([0, 0, 0]);
    /// White.
    pub const WHITE: Color = Color([255, 255, 255]);
    /// A dark gray, for axes and secondary text.
    pub const GRAY: Color = Color([110, 110, 110]);
    /// A light gray, for grids and fills.
    pub const PALE: Color = Color([224, 224, 224]);
    /// Orange.
    pub const ORANGE: Color = Color([230, 159, 0]);
    /// Bluish green.
    pub const GREEN: Color = Color([0, 158, 115]);
    /// Yellow.
    pub const YELLOW: Color = Color([240, 228, 66]);
    /// Blue.
    pub const BLUE: Color = Color([0, 114, 178]);
    /// Vermillion.
    pub const VERMILLION: Color = Color([213, 94, 0]);
    /// Reddish purple.
    pub const PURPLE: Color = Color([204, 121, 167]);
}

/// Colors from linear radiance, red, green and blue: what is below 0 or is no number is black, what is above
/// 1 white.
impl Color {
    /// The nearest byte to 255 E, halves up, with no gamma.
    pub fn from_linear(rgb: [f64; 3]) -> Color {
        Color(rgb.map(|radiance| byte(clamped(radiance))))
    }

    /// The same after the transfer curve of sRGB (IEC 61966-2-1), which is what a screen expects.
    pub fn from_linear_srgb(rgb: [f64; 3]) -> Color {
        Color(rgb.map(|radiance| byte(srgb(clamped(radiance)))))
    }
}

/// E cut off at 0 and 1; NaN is 0.
fn clamped(radiance: f64) -> f64 {
    if radiance.is_nan() { 0.0 } else { radiance.clamp(0.0, 1.0) }
}

/// The transfer curve of sRGB: a straight piece near black, where a power would be infinitely steep. `x` from
/// 0 to 1.
fn srgb(x: f64) -> f64 {
    if x < 0.0031308 { 12.92 * x } else { 1.055 * portable::pow(x, 1.0 / 2.4) - 0.055 }
}

/// The nearest whole number to 255 x, halves up. `x` from 0 to 1.
///
/// (`round` would do, and is a call of a library where the processor has no instruction for it that all of its kind have.)
fn byte(x: f64) -> u8 {
    let x = 255.0 * x;
    let below = x as u8;
    below + u8::from(x - f64::from(below) >= 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gray's byte.
    fn gray(color: fn([f64; 3]) -> Color, radiance: f64) -> u8 {
        color([radiance; 3]).0[0]
    }

    #[test]
    fn linear_radiance_is_rounded_halves_up_and_cut_off() {
        // 255/2 = 127.5, 255/4 = 63.75 and 255/8 = 31.875
        assert_eq!(Color::from_linear([0.5, 0.25, 0.125]), Color([128, 64, 32]));
        // the half between 0 and 1 is 1/510 = 0.00196078…
        assert_eq!([0.0019607, 0.0019608].map(|radiance| gray(Color::from_linear, radiance)), [0, 1]);
        assert_eq!(Color::from_linear([-0.5, 1.5, f64::NAN]), Color([0, 255, 0]));
        assert_eq!(Color::from_linear([f64::NEG_INFINITY, f64::INFINITY, 1.0]), Color([0, 255, 255]));
    }

    #[test]
    fn srgb_is_brighter_between_black_and_white() {
        // 1.055 · 0.5^(1/2.4) − 0.055 = 0.735357, times 255: 187.516; of 0.18, a gray card: 0.461356, 117.646
        assert_eq!([0.5, 0.18].map(|radiance| gray(Color::from_linear_srgb, radiance)), [188, 118]);
        // the straight piece: 0.003 · 12.92 · 255 = 9.884
        assert_eq!(gray(Color::from_linear_srgb, 0.003), 10);
        assert_eq!(Color::from_linear_srgb([0.0, 1.0, f64::NAN]), Color([0, 255, 0]));
        assert_eq!(Color::from_linear_srgb([-1.0, 1e300, f64::INFINITY]), Color([0, 255, 255]));
    }

    #[test]
    fn every_gray_comes_back_from_its_radiance() {
        // the inverse of the curve, as the standard has it; its two pieces meet at 0.04045
        let linear = |v: f64| if v <= 0.04045 { v / 12.92 } else { portable::pow((v + 0.055) / 1.055, 2.4) };
        for gray_level in 0..=255 {
            let v = f64::from(gray_level) / 255.0;
            assert_eq!(gray(Color::from_linear, v), gray_level);
            assert_eq!(gray(Color::from_linear_srgb, linear(v)), gray_level);
        }
    }

    #[test]
    fn the_two_pieces_of_the_curve_meet() {
        // the standard's constants are rounded: at 0.0031308 the pieces differ by 3e-8, 7 millionths of the
        // step of a byte
        let (straight, power) = (12.92 * 0.0031308, srgb(0.0031308));
        assert!((straight - power).abs() * 255.0 < 1e-5, "{straight} {power}");
    }
}

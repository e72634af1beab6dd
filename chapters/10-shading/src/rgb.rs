//! Light in three colors.

use std::ops::{Add, AddAssign, Mul};

/// Linear radiance, or what multiplies it: red, green and blue. In `f64` whatever the rays are in: a picture's error
/// then comes from where the rays went.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb(pub [f64; 3]);

impl Rgb {
    /// No light.
    pub const BLACK: Rgb = Rgb([0.0; 3]);
    /// What multiplies by 1.
    pub const WHITE: Rgb = Rgb([1.0; 3]);

    /// The largest of the three.
    pub fn largest(self) -> f64 {
        self.0.into_iter().fold(f64::NEG_INFINITY, f64::max)
    }
}

impl Add for Rgb {
    type Output = Rgb;
    #[inline(always)]
    fn add(self, other: Rgb) -> Rgb {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Rgb([a + x, b + y, c + z])
    }
}

impl AddAssign for Rgb {
    #[inline(always)]
    fn add_assign(&mut self, other: Rgb) {
        *self = *self + other;
    }
}

/// Channel by channel.
impl Mul for Rgb {
    type Output = Rgb;
    #[inline(always)]
    fn mul(self, other: Rgb) -> Rgb {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Rgb([a * x, b * y, c * z])
    }
}

impl Mul<f64> for Rgb {
    type Output = Rgb;
    #[inline(always)]
    fn mul(self, k: f64) -> Rgb {
        Rgb(self.0.map(|channel| channel * k))
    }
}

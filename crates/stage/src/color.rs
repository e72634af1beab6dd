//! Colors that a color-blind reader can tell apart.

/// An opaque color, red, green and blue from 0 to 255 as a PNG stores them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color(pub [u8; 3]);

/// The palette of Okabe and Ito (2008), chosen to stay apart under every common color blindness,
/// and the greys to draw with.
impl Color {
    /// Black.
    pub const BLACK: Color = Color([0, 0, 0]);
    /// White.
    pub const WHITE: Color = Color([255, 255, 255]);
    /// A dark grey, for axes and secondary text.
    pub const GREY: Color = Color([110, 110, 110]);
    /// A light grey, for grids and fills.
    pub const PALE: Color = Color([224, 224, 224]);
    /// Orange.
    pub const ORANGE: Color = Color([230, 159, 0]);
    /// Sky blue.
    pub const SKY: Color = Color([86, 180, 233]);
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

    /// The color `share` of the way from this one to `other`, 0 to 1.
    pub fn toward(self, other: Color, share: f64) -> Color {
        let mix = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * share).round() as u8;
        let (a, b) = (self.0, other.0);
        Color([mix(a[0], b[0]), mix(a[1], b[1]), mix(a[2], b[2])])
    }
}

//! Colors that a color-blind reader can tell apart.

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

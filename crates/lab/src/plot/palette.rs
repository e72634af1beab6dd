//! Which method has which color.

use stage::Color;

/// The colors of methods, in the order in which they are first named: those of the palette of Okabe and
/// Ito that show on white. Its sky blue takes the place of yellow, which does not.
const METHODS: [Color; 7] = [
    Color::BLUE,
    Color::VERMILLION,
    Color::GREEN,
    Color::PURPLE,
    Color::ORANGE,
    Color([86, 180, 233]),
    Color::BLACK,
];

/// The color of text.
pub(super) const INK: Color = Color([34, 34, 34]);
/// The color of secondary text and axes.
pub(super) const DIM: Color = Color([95, 95, 95]);
/// The color of the lines of a grid.
pub(super) const GRID: Color = Color([228, 228, 228]);

/// The color of a method by its place among the methods; after the seventh they repeat, and its label
/// tells.
pub(super) fn of_method(place: usize) -> Color {
    METHODS[place % METHODS.len()]
}

/// From one color (share 0) to another (share 1).
pub(super) fn mixed(Color(a): Color, Color(b): Color, share: f64) -> Color {
    Color([0, 1, 2].map(|i| {
        let (a, b) = (f64::from(a[i]), f64::from(b[i]));
        (a + share.clamp(0.0, 1.0) * (b - a)).round() as u8
    }))
}

/// The color, dark enough to read as text on white.
pub(super) fn as_text(color: Color) -> Color {
    mixed(color, Color::BLACK, 0.4)
}

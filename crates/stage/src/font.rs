//! Letters as outlines, from the bundled DejaVu Sans.

use std::sync::LazyLock;

use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, OutlineBuilder};

static FACE: LazyLock<Face<'static>> = LazyLock::new(|| {
    Face::parse(include_bytes!("../font/DejaVuSans-subset.ttf"), 0).expect("the bundled font is a font")
});

/// The outline of a line of text whose baseline starts at (`x`, `y`), y downward, `size` units high
/// from line to line, and its width. Signs the font lacks show as its empty box.
pub(crate) fn outline(text: &str, x: f32, y: f32, size: f32) -> Option<Path> {
    let scale = size / f32::from(FACE.units_per_em());
    let mut glyphs = Glyphs { builder: PathBuilder::new(), x, y, scale };
    for letter in text.chars() {
        let glyph = FACE.glyph_index(letter).unwrap_or_default();
        FACE.outline_glyph(glyph, &mut glyphs);
        glyphs.x += f32::from(FACE.glyph_hor_advance(glyph).unwrap_or(0)) * scale;
    }
    glyphs.builder.finish()
}

/// The width of a line of text.
pub(crate) fn width(text: &str, size: f32) -> f32 {
    let advance = |letter| FACE.glyph_hor_advance(FACE.glyph_index(letter).unwrap_or_default()).unwrap_or(0);
    let units: f32 = text.chars().map(|letter| f32::from(advance(letter))).sum();
    units * size / f32::from(FACE.units_per_em())
}

/// Turns the font's outlines (y upward, in font units) into a path of the picture.
struct Glyphs {
    builder: PathBuilder,
    x: f32,
    y: f32,
    scale: f32,
}

impl Glyphs {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + x * self.scale, self.y - y * self.scale)
    }
}

impl OutlineBuilder for Glyphs {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.builder.move_to(x, y);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.builder.line_to(x, y);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.builder.quad_to(x1, y1, x, y);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.builder.cubic_to(x1, y1, x2, y2, x, y);
    }
    fn close(&mut self) {
        self.builder.close();
    }
}

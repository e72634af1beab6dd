//! A picture: pixels, and anti-aliased drawing over them.

use tiny_skia::{
    FillRule, IntSize, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Rect, Stroke, StrokeDash,
    Transform,
};

use crate::pixels::{by_row, no_memory, reserved};
use crate::{Color, Error, font};

/// A picture in the making.
///
/// Pixels are set with [`shade`](Canvas::shade), which leaves nothing of what was drawn before. Lines and
/// labels are drawn in units that the stage chooses with [`fit`](Canvas::fit), y downward, so that a drawing
/// looks the same at every size.
#[derive(Clone, Debug, PartialEq)]
pub struct Canvas {
    pixels: Pixmap,
    fit: Fit,
}

/// Where the drawing frame lies on the pixels: its scale, and the place of its top left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Fit {
    scale: f64,
    x: f64,
    y: f64,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Its color.
    pub color: Color,
    /// Its width, in drawing units.
    pub width: f32,
    /// The length of its dashes and gaps, in drawing units; 0 for a solid line.
    pub dash: f32,
}

impl Pen {
    /// A solid line.
    pub fn solid(color: Color, width: f32) -> Pen {
        Pen { color, width, dash: 0.0 }
    }

    /// A dashed line, its dashes and gaps 5 drawing units long.
    pub fn dashed(color: Color, width: f32) -> Pen {
        Pen { color, width, dash: 5.0 }
    }
}

/// Which point of a label is put at the given place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The left end of the baseline.
    Left,
    /// The middle of the baseline.
    Middle,
    /// The right end of the baseline.
    Right,
}

type Point = (f32, f32);

impl Canvas {
    /// A picture of `size` = (columns, rows), neither 0, in one color. [`Error::Failed`] where the memory for
    /// it cannot be had.
    pub fn new(size: (u32, u32), background: Color) -> Result<Canvas, Error> {
        let mut data = reserved(4, size)?;
        data.resize(data.capacity(), 0);
        let int_size = IntSize::from_wh(size.0, size.1).ok_or_else(|| no_memory(size))?;
        let mut pixels = Pixmap::from_vec(data, int_size).ok_or_else(|| no_memory(size))?;
        pixels.fill(skia(background));
        Ok(Canvas { pixels, fit: Fit { scale: 1.0, x: 0.0, y: 0.0 } })
    }

    /// Columns and rows.
    pub fn size(&self) -> (u32, u32) {
        (self.pixels.width(), self.pixels.height())
    }

    /// The color of a pixel; `None` outside the picture.
    pub fn pixel(&self, col: u32, row: u32) -> Option<Color> {
        self.pixels.pixel(col, row).map(|pixel| Color([pixel.red(), pixel.green(), pixel.blue()]))
    }

    /// The pixels, row by row from the top left, three bytes each. [`Error::Failed`] where the memory
    /// for them cannot be had.
    pub fn to_rgb(&self) -> Result<Vec<u8>, Error> {
        let mut bytes = reserved(3, self.size())?;
        for pixel in self.pixels.pixels() {
            bytes.extend([pixel.red(), pixel.green(), pixel.blue()]);
        }
        Ok(bytes)
    }

    /// Colors every pixel by its column and row, on as many threads as the machine has. The picture does not depend
    /// on how many.
    pub fn shade(&mut self, color: impl Fn(u32, u32) -> Color + Sync) {
        let width = self.pixels.width() as usize;
        by_row(self.pixels.data_mut(), 4 * width, |row, bytes| {
            for (col, pixel) in (0..).zip(bytes.chunks_exact_mut(4)) {
                let Color([r, g, b]) = color(col, row);
                pixel.copy_from_slice(&[r, g, b, 255]);
            }
        });
    }

    /// From here on, drawing is done in a frame of `width` by `height` units, both above 0, as large as fits
    /// and in the middle. Until then a unit is a pixel.
    pub fn fit(&mut self, width: f32, height: f32) {
        let (columns, rows) = (f64::from(self.pixels.width()), f64::from(self.pixels.height()));
        let (width, height) = (f64::from(width), f64::from(height));
        let scale = (columns / width).min(rows / height);
        self.fit = Fit { scale, x: (columns - scale * width) / 2.0, y: (rows - scale * height) / 2.0 };
    }

    /// The center of a pixel, in the units of [`fit`](Canvas::fit).
    pub fn place_of(&self, (col, row): (u32, u32)) -> (f64, f64) {
        self.place((f64::from(col) + 0.5, f64::from(row) + 0.5))
    }

    /// A place given in pixels from the top left corner of the picture, in the units of
    /// [`fit`](Canvas::fit).
    pub fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        ((x - self.fit.x) / self.fit.scale, (y - self.fit.y) / self.fit.scale)
    }

    fn transform(&self) -> Transform {
        let [scale, x, y] = [self.fit.scale, self.fit.x, self.fit.y].map(|number| number as f32);
        Transform::from_row(scale, 0.0, 0.0, scale, x, y)
    }

    /// The corners of the whole picture, top left and bottom right, in the units of
    /// [`fit`](Canvas::fit): where its shape is not the frame's, they lie outside the frame.
    pub fn corners(&self) -> ((f32, f32), (f32, f32)) {
        let (columns, rows) = self.size();
        let corner = |x: f64, y: f64| {
            let (x, y) = self.place((x, y));
            (x as f32, y as f32)
        };
        (corner(0.0, 0.0), corner(f64::from(columns), f64::from(rows)))
    }

    /// A line from one point to another.
    pub fn line(&mut self, from: Point, to: Point, pen: Pen) {
        if let Some(path) = path(&[from, to], false) {
            self.stroke(&path, pen);
        }
    }

    /// The area within points, filled.
    pub fn area(&mut self, points: &[Point], color: Color) {
        if let Some(path) = path(points, true) {
            self.fill(&path, color, 1.0);
        }
    }

    /// A filled rectangle, from its top left to its bottom right, as opaque as `opacity` says (0 to 1).
    pub fn rectangle(&mut self, (left, top): Point, (right, bottom): Point, color: Color, opacity: f32) {
        if let Some(rect) = Rect::from_ltrb(left, top, right, bottom) {
            self.fill(&PathBuilder::from_rect(rect), color, opacity);
        }
    }

    /// The outline of a rectangle.
    pub fn frame(&mut self, (left, top): Point, (right, bottom): Point, pen: Pen) {
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        if let Some(path) = path(&corners, true) {
            self.stroke(&path, pen);
        }
    }

    /// A circle.
    pub fn circle(&mut self, center: Point, radius: f32, pen: Pen) {
        if let Some(path) = PathBuilder::from_circle(center.0, center.1, radius) {
            self.stroke(&path, pen);
        }
    }

    /// A filled disc.
    pub fn disc(&mut self, center: Point, radius: f32, color: Color) {
        if let Some(path) = PathBuilder::from_circle(center.0, center.1, radius) {
            self.fill(&path, color, 1.0);
        }
    }

    /// An arrow: a line with a filled head at its end; nothing where it has no length.
    pub fn arrow(&mut self, from: Point, to: Point, pen: Pen) {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = (dx * dx + dy * dy).sqrt();
        if length == 0.0 {
            return;
        }
        let head = 3.0 * pen.width + 4.0;
        let (along, across) =
            ((dx / length * head, dy / length * head), (-dy / length * head / 2.5, dx / length * head / 2.5));
        let neck = (to.0 - along.0, to.1 - along.1);
        self.line(from, neck, pen);
        self.area(
            &[to, (neck.0 + across.0, neck.1 + across.1), (neck.0 - across.0, neck.1 - across.1)],
            pen.color,
        );
    }

    /// A cross, for a point that has no extent.
    pub fn cross(&mut self, (x, y): Point, radius: f32, pen: Pen) {
        self.line((x - radius, y - radius), (x + radius, y + radius), pen);
        self.line((x - radius, y + radius), (x + radius, y - radius), pen);
    }

    /// Letters smaller than this many pixels cannot be read and are left out.
    const SMALLEST_LETTERS: f64 = 5.0;

    /// Whether letters of this size, in drawing units, can be read in this picture: at 5 pixels or more.
    pub fn is_readable(&self, size: f32) -> bool {
        f64::from(size) * self.fit.scale >= Self::SMALLEST_LETTERS
    }

    /// A line of text, its letters `size` units large; left out where the picture is too small to read it.
    pub fn label(&mut self, (x, y): Point, anchor: Anchor, size: f32, color: Color, text: &str) {
        if !self.is_readable(size) {
            return;
        }
        let width = font::width(text, size);
        let start = match anchor {
            Anchor::Left => x,
            Anchor::Middle => x - width / 2.0,
            Anchor::Right => x - width,
        };
        if let Some(path) = font::outline(text, start, y, size) {
            self.fill(&path, color, 1.0);
        }
    }

    /// A line of text on a light plate, legible over anything; left out like a [`label`](Canvas::label).
    pub fn plate(&mut self, (x, y): Point, anchor: Anchor, size: f32, color: Color, text: &str) {
        if !self.is_readable(size) {
            return;
        }
        let (width, pad) = (font::width(text, size), size * 0.3);
        let left = match anchor {
            Anchor::Left => x,
            Anchor::Middle => x - width / 2.0,
            Anchor::Right => x - width,
        };
        self.rectangle((left - pad, y - size), (left + width + pad, y + pad), Color::WHITE, 0.85);
        self.label((left, y), Anchor::Left, size, color, text);
    }

    fn fill(&mut self, path: &Path, color: Color, opacity: f32) {
        let mut shader = skia(color);
        shader.apply_opacity(opacity);
        let mut paint = Paint::default();
        paint.set_color(shader);
        self.pixels.fill_path(path, &paint, FillRule::Winding, self.transform(), None);
    }

    fn stroke(&mut self, path: &Path, pen: Pen) {
        let mut paint = Paint::default();
        paint.set_color(skia(pen.color));
        let dash = if pen.dash > 0.0 { StrokeDash::new(vec![pen.dash, pen.dash], 0.0) } else { None };
        let (line_cap, line_join) = (LineCap::Butt, LineJoin::Round);
        let stroke = Stroke { width: pen.width, dash, line_cap, line_join, ..Stroke::default() };
        self.pixels.stroke_path(path, &paint, &stroke, self.transform(), None);
    }
}

/// The color as tiny-skia has it.
fn skia(Color([r, g, b]): Color) -> tiny_skia::Color {
    tiny_skia::Color::from_rgba8(r, g, b, 255)
}

fn path(points: &[Point], closed: bool) -> Option<Path> {
    let (first, rest) = points.split_first()?;
    let mut builder = PathBuilder::new();
    builder.move_to(first.0, first.1);
    for point in rest {
        builder.line_to(point.0, point.1);
    }
    if closed {
        builder.close();
    }
    builder.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_of_one_pixel_can_be_drawn_on() {
        let mut canvas = Canvas::new((1, 1), Color::WHITE).unwrap();
        canvas.fit(960.0, 720.0);
        canvas.line((0.0, 0.0), (960.0, 720.0), Pen::dashed(Color::BLACK, 2.0));
        canvas.arrow((0.0, 0.0), (0.0, 0.0), Pen::solid(Color::BLACK, 2.0));
        canvas.plate((480.0, 360.0), Anchor::Middle, 20.0, Color::BLACK, "t = ∞");
        assert!(canvas.pixel(0, 0).is_some() && canvas.pixel(1, 0).is_none());
    }

    #[test]
    fn every_pixel_is_shaded_in_its_place() {
        let mut canvas = Canvas::new((7, 45), Color::WHITE).unwrap();
        canvas.shade(|col, row| Color([col as u8, row as u8, 0]));
        for (col, row) in (0..7).flat_map(|col| (0..45).map(move |row| (col, row))) {
            assert_eq!(canvas.pixel(col, row), Some(Color([col as u8, row as u8, 0])));
        }
    }

    #[test]
    fn text_is_as_wide_as_its_letters() {
        assert!(font::width("t_close", 10.0) > font::width("t", 10.0));
        assert_eq!(font::width("", 10.0), 0.0);
    }
}

//! A window onto a plane, drawn into a part of a picture.

use crate::{Canvas, Pen};

/// Maps a rectangle of the plane (y upward) onto a rectangle of a canvas (y downward), keeping
/// circles round: the smaller of the two scales serves both axes, and the plane is centered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    scale: f64,
    x: f64,
    y: f64,
}

impl View {
    /// The view of the plane from (left, bottom) to (right, top), with left < right and bottom < top, within
    /// the part of a canvas from its top left corner `from` to its bottom right corner `to`, in drawing
    /// units.
    pub fn new(
        (left, bottom): (f64, f64),
        (right, top): (f64, f64),
        from: (f32, f32),
        to: (f32, f32),
    ) -> View {
        let (width, height) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
        let scale = (width / (right - left)).min(height / (top - bottom));
        let middle = (f64::from(from.0 + to.0) / 2.0, f64::from(from.1 + to.1) / 2.0);
        let (x, y) = (middle.0 - scale * (left + right) / 2.0, middle.1 + scale * (bottom + top) / 2.0);
        View { scale, x, y }
    }

    /// Where the point (x, y) of the plane lies on the canvas, in drawing units.
    pub fn at(&self, (x, y): (f64, f64)) -> (f32, f32) {
        ((self.x + self.scale * x) as f32, (self.y - self.scale * y) as f32)
    }

    /// The point of the plane that lies at a place on the canvas: the inverse of [`at`](View::at).
    pub fn plane(&self, (x, y): (f64, f64)) -> (f64, f64) {
        ((x - self.x) / self.scale, (self.y - y) / self.scale)
    }

    /// How far two places of the canvas are apart, in drawing units.
    pub fn apart(a: (f32, f32), b: (f32, f32)) -> f32 {
        let (x, y) = (a.0 - b.0, a.1 - b.1);
        (x * x + y * y).sqrt()
    }

    /// A length of the plane in drawing units.
    pub fn length(&self, length: f64) -> f32 {
        (self.scale * length) as f32
    }

    /// A line between two points of the plane.
    pub fn line(&self, canvas: &mut Canvas, from: (f64, f64), to: (f64, f64), pen: Pen) {
        canvas.line(self.at(from), self.at(to), pen);
    }

    /// An arrow between two points of the plane.
    pub fn arrow(&self, canvas: &mut Canvas, from: (f64, f64), to: (f64, f64), pen: Pen) {
        canvas.arrow(self.at(from), self.at(to), pen);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plane_is_centered_and_stands_upright() {
        let view = View::new((0.0, 0.0), (10.0, 5.0), (100.0, 0.0), (200.0, 100.0));
        assert_eq!(view.at((5.0, 2.5)), (150.0, 50.0));
        assert_eq!(view.at((0.0, 5.0)), (100.0, 25.0), "y upward");
        assert_eq!(view.plane((100.0, 25.0)), (0.0, 5.0));
        assert_eq!(view.length(1.0), 10.0);
    }
}

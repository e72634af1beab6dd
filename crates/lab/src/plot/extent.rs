//! Rectangles and lines: what overlaps, what crosses.

use super::svg::Point;

/// A rectangle, y downward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Extent {
    pub(super) fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Smaller by this much on every side; larger where it is below 0.
    pub(super) fn inset(&self, by: f64) -> Extent {
        Extent { left: self.left + by, top: self.top + by, right: self.right - by, bottom: self.bottom - by }
    }

    /// The area that two rectangles share.
    pub(super) fn overlap(&self, other: &Extent) -> f64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }

    /// Whether the other one lies within it.
    pub(super) fn holds(&self, inner: &Extent) -> bool {
        inner.left >= self.left
            && inner.right <= self.right
            && inner.top >= self.top
            && inner.bottom <= self.bottom
    }

    /// Whether a line passes through it.
    pub(super) fn is_crossed(&self, line: (Point, Point)) -> bool {
        let corners = [
            (self.left, self.top),
            (self.right, self.top),
            (self.right, self.bottom),
            (self.left, self.bottom),
        ];
        let is_inside = |p: Point| p.0 > self.left && p.0 < self.right && p.1 > self.top && p.1 < self.bottom;
        is_inside(line.0)
            || is_inside(line.1)
            || (0..4).any(|i| do_cross(line, (corners[i], corners[(i + 1) % 4])))
    }
}

/// How far two points are apart.
pub(super) fn length(a: Point, b: Point) -> f64 {
    ((a.0 - b.0) * (a.0 - b.0) + (a.1 - b.1) * (a.1 - b.1)).sqrt()
}

/// How far a point is from a line between two points.
pub(super) fn distance(point: Point, (a, b): (Point, Point)) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let square = dx * dx + dy * dy;
    let share = if square > 0.0 { ((point.0 - a.0) * dx + (point.1 - a.1) * dy) / square } else { 0.0 };
    let share = share.clamp(0.0, 1.0);
    length(point, (a.0 + share * dx, a.1 + share * dy))
}

/// Whether two lines cross, each between two points.
pub(super) fn do_cross((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let side = |p: Point, q: Point, r: Point| (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

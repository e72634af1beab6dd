//! A box around a polygon.

use math::{Real, Vector};

use super::Polygon;

impl<R: Real> Polygon<R> {
    /// Two corners of a box around all points of the plane that [`Polygon::hit`] takes for inside.
    ///
    /// On the axes of the outline that is the outline. Along the third the corners may be a little off the plane, so
    /// the box goes to where the plane passes over them: x_w = p_w − (n_u (x_u − p_u) + n_v (x_v − p_v))/n_w, whose
    /// few roundings are less than 8 units of the last digit of its largest part.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let [u, v] = self.axes;
        let w = 3 - u - v;
        let [p, n]: [[f64; 3]; 2] = [self.plane.point, self.plane.normal].map(Vector::in_f64);
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for corner in &self.corners {
            let x: [f64; 3] = corner.in_f64();
            let parts = [n[u] / n[w] * (x[u] - p[u]), n[v] / n[w] * (x[v] - p[v])];
            let off = 8.0 * f64::EPSILON * (p[w].abs() + parts[0].abs() + parts[1].abs());
            let over = p[w] - parts[0] - parts[1];
            for axis in 0..3 {
                let (least, most) = match () {
                    _ if axis != w => (x[axis], x[axis]),
                    // where the numbers overflow: anywhere
                    _ if over.is_nan() => (f64::NEG_INFINITY, f64::INFINITY),
                    _ => (over - off, over + off),
                };
                low[axis] = low[axis].min(least).min(x[axis]);
                high[axis] = high[axis].max(most).max(x[axis]);
            }
        }
        [low, high]
    }
}

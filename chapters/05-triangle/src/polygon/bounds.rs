//! A box around a polygon.

use math::{Real, Vector};

use super::Polygon;

impl<R: Real> Polygon<R> {
    /// Two corners of a box around all points of the plane that [`Polygon::hit`] takes for inside, the lowest
    /// coordinates first; infinite where the numbers overflow.
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

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use ray_plane::Plane;

    /// By hand, in the plane x + 2y + 4z = 12, seen along z, and the same with the axes in another order.
    #[test]
    fn the_box_goes_to_where_the_plane_is() {
        let corners = [[2.0, 1.0, 2.0], [6.0, 1.0, 1.0], [6.0, 5.0, -1.0], [2.0, 5.0, 0.0]];
        for turn in 0..3 {
            let turned = |mut corner: [f64; 3]| {
                corner.rotate_right(turn);
                corner
            };
            let polygon = Polygon::<f64>::new(corners.map(turned).map(DVec3::from).to_vec()).unwrap();
            let [low, high] = polygon.bounds();
            let ([least, most], w) = ([[2.0, 1.0, -1.0], [6.0, 5.0, 2.0]].map(turned), (2 + turn) % 3);
            // along z by 8 units of the last digit of its largest part, which is below 8
            let off = 64.0 * f64::EPSILON;
            for axis in 0..3 {
                let beyond = [least[axis] - low[axis], high[axis] - most[axis]];
                match axis == w {
                    true => assert!(beyond.iter().all(|beyond| (1e-16..off).contains(beyond)), "{beyond:?}"),
                    false => assert_eq!(beyond, [0.0; 2]),
                }
            }
        }
    }

    /// A corner beside the plane, by less than is refused: the box has it, and the plane under it.
    #[test]
    fn a_corner_beside_the_plane_is_in_the_box() {
        let up = 1e-5;
        let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, up], [0.0, 4.0, 0.0]];
        let polygon = Polygon::<f64>::new(corners.map(DVec3::from).to_vec()).unwrap();
        let [low, high] = polygon.bounds();
        let Plane { point, normal } = polygon.plane();
        for [x, y, z] in corners {
            // on the plane over the corner, and at the corner
            let over = point.z - (normal.x * (x - point.x) + normal.y * (y - point.y)) / normal.z;
            assert!(
                (low[2]..=high[2]).contains(&over) && (low[2]..=high[2]).contains(&z),
                "{low:?} {high:?}"
            );
        }
        assert_eq!(([low[0], low[1]], [high[0], high[1]]), ([0.0; 2], [4.0; 2]));
    }

    /// By hand, in the plane x + 2y + 4z = 12 again, with p̄ = (2, 1, 2): at (6, 5) the parts are ¼ · 4 and ½ · 4,
    /// and the box goes 8 · 2^−52 (2 + 1 + 2) below −1; at p̄ itself 8 · 2^−52 · 2 above 2. Neither is rounded.
    #[test]
    fn the_box_is_larger_by_the_sizes_of_all_parts() {
        let corners = [[2.0, 1.0, 2.0], [6.0, 1.0, 1.0], [6.0, 5.0, -1.0], [2.0, 5.0, 0.0]].map(DVec3::from);
        let [low, high] = Polygon::<f64>::new(corners.to_vec()).unwrap().bounds();
        assert_eq!([low[2], high[2]], [-1.0 - 40.0 * f64::EPSILON, 2.0 + 16.0 * f64::EPSILON]);
    }

    /// By hand, in the plane x − y + 2z = 0 with corners at ±M: from −M to M it is 2M, which overflows, so that both
    /// parts are infinite, and their difference is no number.
    #[test]
    fn a_box_that_overflows_goes_everywhere() {
        let m = 1.5 * 2.0_f64.powi(1023);
        let corners = [[-m, -m, 0.0], [m, m, 0.0], [m, -m, -m]].map(DVec3::from);
        let [low, high] = Polygon::<f64>::new(corners.to_vec()).unwrap().bounds();
        assert_eq!((low, high), ([-m, -m, f64::NEG_INFINITY], [m, m, f64::INFINITY]));
    }
}

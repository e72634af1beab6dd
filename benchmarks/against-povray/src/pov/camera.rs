//! The camera.

use math::{Grid, Real, Window};
use signature::Scene;

use super::number::vector;

/// POV-Ray sends a ray through the middle of each pixel: through location + direction + x right + y up, with
/// x and y from −½ to ½ across the picture. Ours is ē + x u + y v + f w.
pub(super) fn camera(scene: &Scene<f64>) -> String {
    let it = &scene.camera;
    let window = seen(it.window, scene.grid, scene.size);
    let (x, y) = window.center();
    let direction = it.u * x + it.v * y + it.w * it.f;
    let (right, up) = (it.u * (window.right - window.left), it.v * (window.top - window.bottom));
    let [location, direction, right, up] = [it.e, direction, right, up].map(|v| vector(f64::xyz(v)));
    format!("camera {{ perspective location {location} direction {direction} right {right} up {up} }}\n")
}

/// The window whose pixels' middles are the points of our grid.
fn seen(window: Window<f64>, grid: Grid, (columns, rows): (u32, u32)) -> Window<f64> {
    let Window { left, right, bottom, top } = window;
    let (columns, rows) = (f64::from(columns), f64::from(rows));
    match grid {
        Grid::Centers => window,
        // half a pixel to the left of the middles, and half a pixel above them
        Grid::Lattice => {
            let (x, y) = (0.5 * (right - left) / columns, 0.5 * (top - bottom) / rows);
            Window { left: left - x, right: right - x, bottom: bottom + y, top: top + y }
        }
        // the outermost middles lie on the edges: half a pixel more on every side
        Grid::Edges => {
            let (x, y) = (0.5 * (right - left) / (columns - 1.0), 0.5 * (top - bottom) / (rows - 1.0));
            Window { left: left - x, right: right + x, bottom: bottom - y, top: top + y }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middles_of_what_is_seen_are_the_points_of_the_grid() {
        let window = Window { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 };
        let size = (8, 5);
        for grid in [Grid::Centers, Grid::Lattice, Grid::Edges] {
            let seen = seen(window, grid, size);
            for pixel in [(0, 0), (7, 4), (3, 2)] {
                let (x, y) = grid.point(&window, size, pixel).unwrap();
                let middle = Grid::Centers.point(&seen, size, pixel).unwrap();
                // a few roundings of numbers below 4
                let bound = 8.0 * 4.0 * f64::EPSILON;
                assert!((middle.0 - x).abs() < bound && (middle.1 - y).abs() < bound, "{grid:?} {pixel:?}");
            }
        }
    }
}

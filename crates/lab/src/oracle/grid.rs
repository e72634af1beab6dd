//! The place of a pixel: a share of the way from one edge of the window to the other.

use math::{Grid, Window};
use stage::Precision;

use super::{Dyadic, ExactRoot};
use crate::Root;

/// The exact place (x, y) of a pixel on a grid, in camera coordinates, x right and y up; of [`math::Grid`]
/// only the names are used. Panics where a number of the window is not finite, for a size of 0, and for
/// `edges` with one column or row.
///
/// All three grids go an exact share of the way, from left to right and from top to bottom: of `count`
/// pixels number i lies at (i + ½)/count (`centers`), i/count (`lattice`, whose halves about the center
/// cancel) or i/(count − 1) (`edges`).
pub fn pixel(
    grid: Grid,
    window: &Window<f64>,
    size: (u32, u32),
    pixel: (u32, u32),
    precision: Precision,
) -> [Root; 2] {
    let share = |i: u32, count: u32| {
        let (i, count) = (u64::from(i), u64::from(count));
        match grid {
            Grid::Centers => (2 * i + 1, 2 * count),
            Grid::Lattice => (i, count),
            Grid::Edges => (i, count - 1),
        }
    };
    let x = on_the_way(window.left, window.right, share(pixel.0, size.0));
    let y = on_the_way(window.top, window.bottom, share(pixel.1, size.1));
    [x, y].map(|root| root.written(precision))
}

/// from + part/whole (to − from)
fn on_the_way(from: f64, to: f64, (part, whole): (u64, u64)) -> ExactRoot {
    let [from, to] = [from, to].map(Dyadic::of);
    let [part, whole] = [part, whole].map(|count| Dyadic::scaled(count, 0));
    ExactRoot::quotient(&(&whole * &from) + &(&part * &(&to - &from)), whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(
        grid: Grid,
        window: [f64; 4],
        size: (u32, u32),
        at: (u32, u32),
        precision: Precision,
    ) -> [f64; 2] {
        let [left, right, bottom, top] = window;
        pixel(grid, &Window { left, right, bottom, top }, size, at, precision).map(|root| root.nearest)
    }

    #[test]
    fn the_top_left_and_bottom_right_pixels_of_houses_picture() {
        let of = |grid, at| place(grid, [-2.5, 2.5, -1.5, 1.5], (5, 3), at, Precision::F64);
        // by hand: the pixels have side 1, or 5/4 by 3/2 from edge to edge
        assert_eq!([of(Grid::Centers, (0, 0)), of(Grid::Centers, (4, 2))], [[-2.0, 1.0], [2.0, -1.0]]);
        assert_eq!([of(Grid::Lattice, (0, 0)), of(Grid::Lattice, (4, 2))], [[-2.5, 1.5], [1.5, -0.5]]);
        assert_eq!([of(Grid::Edges, (0, 0)), of(Grid::Edges, (4, 2))], [[-2.5, 1.5], [2.5, -1.5]]);
        assert_eq!(of(Grid::Edges, (1, 1)), [-1.25, 0.0]);
    }

    #[test]
    fn places_are_rounded_once() {
        let of = |grid, precision| place(grid, [0.0, 1.0, 0.0, 1.0], (3, 7), (0, 1), precision);
        // by hand: 1/6, and 1 − 3/14, 1 − 1/7, 1 − 1/6
        assert_eq!(of(Grid::Centers, Precision::F64), [1.0 / 6.0, 11.0 / 14.0]);
        assert_eq!(of(Grid::Lattice, Precision::F64), [0.0, 6.0 / 7.0]);
        assert_eq!(of(Grid::Edges, Precision::F32), [0.0, f64::from(5.0_f32 / 6.0)]);
        // by hand: the last of 2^24 columns lies at 1 − 2^−25, which is halfway between two f32
        let wide = |precision| {
            place(Grid::Centers, [0.0, 1.0, 0.0, 1.0], (1 << 24, 1), ((1 << 24) - 1, 0), precision)
        };
        assert_eq!(wide(Precision::F64), [1.0 - 1.0 / f64::from(1 << 25), 0.5]);
        assert_eq!(wide(Precision::F32), [1.0, 0.5]);
    }
}

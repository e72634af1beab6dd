//! The three pixel grids: where in the window a pixel's sample lies.

use std::fmt;

use crate::{Real, Window};

/// How the pixels of a picture are laid over the window. Each of the three notes has its own.
///
/// Column 0 is the leftmost, row 0 the top row, as in a picture file. (House's row i counts from
/// the bottom: i = rows − 1 − row.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grid {
    /// House 4.1: the center of the pixel, (j + 0.5) w/N from the left edge.
    Centers,
    /// Gambetta, Listing 2-3: canvas coordinates C_x · V_w/C_w about the center of the window, so a
    /// corner of the pixel, half a pixel left of and above its center.
    Lattice,
    /// CSC418 11.2: Δu = (w_r − w_l)/(n_c − 1), from edge to edge.
    Edges,
}

/// A grid that cannot be laid: `edges` with a single column or row divides by zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoGrid;

impl fmt::Display for NoGrid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the grid `edges` needs at least two columns and two rows: Δu = (w_r − w_l)/(n_c − 1)")
    }
}

impl std::error::Error for NoGrid {}

impl Grid {
    /// Every grid, in the order of the notes.
    pub const ALL: [Grid; 3] = [Grid::Centers, Grid::Lattice, Grid::Edges];

    /// The name that `--method` takes.
    pub fn name(self) -> &'static str {
        match self {
            Grid::Centers => "centers",
            Grid::Lattice => "lattice",
            Grid::Edges => "edges",
        }
    }

    /// The camera coordinates (x right, y up) of pixel (`col`, `row`) of a picture of `size` pixels laid over `window`.
    ///
    /// Pixels outside the picture continue the grid. [`NoGrid`] for `Edges` with one column or row.
    pub fn point<R: Real>(
        self,
        window: &Window<R>,
        size: (u32, u32),
        pixel: (u32, u32),
    ) -> Result<(R, R), NoGrid> {
        match self {
            Grid::Centers => Ok(centers(window, size, pixel)),
            Grid::Lattice => Ok(lattice(window, size, pixel)),
            Grid::Edges => edges(window, size, pixel),
        }
    }
}

/// House's grid: p_x = left + (j + 0.5) w/N, and the row likewise from the top.
pub fn centers<R: Real>(window: &Window<R>, size: (u32, u32), pixel: (u32, u32)) -> (R, R) {
    let Window { left, right, bottom, top } = *window;
    let [width, height, col, row]: [R; 4] = numbers(size, pixel);
    let half = R::from(0.5);
    let x = left + (col + half) * (right - left) / width;
    let y = top - (row + half) * (top - bottom) / height;
    (x, y)
}

/// Gambetta's grid: V_x = C_x V_w/C_w with canvas coordinates C_x = col − C_w/2, C_y = C_h/2 − row,
/// about the center of the window. The halves are real quotients.
pub fn lattice<R: Real>(window: &Window<R>, size: (u32, u32), pixel: (u32, u32)) -> (R, R) {
    let Window { left, right, bottom, top } = *window;
    let [width, height, col, row]: [R; 4] = numbers(size, pixel);
    let half = R::from(0.5);
    let (c_x, c_y) = (col - width * half, height * half - row);
    let (center_x, center_y) = window.center();
    let x = center_x + c_x * (right - left) / width;
    let y = center_y + c_y * (top - bottom) / height;
    (x, y)
}

/// CSC418's grid: w_l + i Δu with Δu = (w_r − w_l)/(n_c − 1), w_t + j Δv with Δv = (w_b − w_t)/(n_r − 1).
pub fn edges<R: Real>(window: &Window<R>, size: (u32, u32), pixel: (u32, u32)) -> Result<(R, R), NoGrid> {
    let Window { left, right, bottom, top } = *window;
    let [width, height, col, row]: [R; 4] = numbers(size, pixel);
    if size.0 < 2 || size.1 < 2 {
        return Err(NoGrid);
    }
    let one = R::from(1.0);
    let x = left + col * (right - left) / (width - one);
    let y = top - row * (top - bottom) / (height - one);
    Ok((x, y))
}

fn numbers<R: Real>(size: (u32, u32), pixel: (u32, u32)) -> [R; 4] {
    [size.0, size.1, pixel.0, pixel.1].map(|n| R::round_from(f64::from(n)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// House's picture, M = 3 rows by N = 5 columns, with pixels of side 1: w = 5, h = 3.
    const HOUSE: Window<f64> = Window { left: -2.5, right: 2.5, bottom: -1.5, top: 1.5 };

    fn house(grid: Grid, col: u32, row: u32) -> (f64, f64) {
        grid.point(&HOUSE, (5, 3), (col, row)).unwrap()
    }

    #[test]
    fn centers_are_half_a_pixel_in() {
        // by hand: −2.5 + 0.5 and 1.5 − 0.5; the middle pixel of 5 × 3 sits at the center
        assert_eq!(house(Grid::Centers, 0, 0), (-2.0, 1.0));
        assert_eq!(house(Grid::Centers, 2, 1), (0.0, 0.0));
        assert_eq!(house(Grid::Centers, 4, 2), (2.0, -1.0));
    }

    #[test]
    fn the_lattice_keeps_the_left_and_top_ends_and_drops_the_others() {
        assert_eq!(house(Grid::Lattice, 0, 0), (-2.5, 1.5));
        assert_eq!(house(Grid::Lattice, 4, 2), (1.5, -0.5));
    }

    #[test]
    fn edges_run_from_edge_to_edge() {
        assert_eq!(house(Grid::Edges, 0, 0), (-2.5, 1.5));
        assert_eq!(house(Grid::Edges, 4, 2), (2.5, -1.5));
        assert_eq!(house(Grid::Edges, 1, 1), (-1.25, 0.0));
    }

    #[test]
    fn edges_with_one_column_are_refused() {
        assert_eq!(Grid::Edges.point(&HOUSE, (1, 3), (0, 0)), Err(NoGrid));
        assert_eq!(Grid::Edges.point(&HOUSE, (5, 1), (0, 0)), Err(NoGrid));
        assert!(Grid::Centers.point(&HOUSE, (1, 1), (0, 0)).is_ok());
    }

    #[test]
    fn the_lattice_is_centers_shifted_by_half_a_pixel() {
        for (col, row) in [(0, 0), (3, 1), (4, 2)] {
            let (x, y) = house(Grid::Centers, col, row);
            assert_eq!(house(Grid::Lattice, col, row), (x - 0.5, y + 0.5));
        }
    }
}

//! The three pixel grids: where in the window a pixel's sample lies.

use crate::{NoGrid, Real, Window};

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

    /// The camera coordinates (x right, y up) of `pixel`, a column and a row, of a picture laid over
    /// `window`. `size` is its columns and rows, neither of them 0.
    ///
    /// Pixels outside the picture continue the grid. [`NoGrid`] for `Edges` with one column or row.
    pub fn point<R: Real>(
        self,
        window: &Window<R>,
        size: (u32, u32),
        pixel: (u32, u32),
    ) -> Result<(R, R), NoGrid> {
        self.point_within(window, size, pixel, (R::from(0.5), R::from(0.5)))
    }

    /// The same for one of several samples of a pixel: `within` is how far across the pixel and down it the
    /// sample lies, from 0 to 1. At (½, ½) it is the pixel's own point, to the last bit; that of `lattice`
    /// and `edges` is a corner, and the samples lie about it.
    pub fn point_within<R: Real>(
        self,
        window: &Window<R>,
        size: (u32, u32),
        pixel: (u32, u32),
        within: (R, R),
    ) -> Result<(R, R), NoGrid> {
        let [col, row] = [pixel.0, pixel.1].map(|place| R::round_from(f64::from(place)));
        let half = R::from(0.5);
        let about = (col + (within.0 - half), row + (within.1 - half));
        match self {
            Grid::Centers => Ok(centers_at(window, size, (col + within.0, row + within.1))),
            Grid::Lattice => Ok(lattice_at(window, size, about)),
            Grid::Edges => edges_at(window, size, about),
        }
    }
}

/// House's grid: p_x = left + (j + 0.5) w/N, and the row likewise from the top. What it takes and returns is
/// as for [`Grid::point`].
pub fn centers<R: Real>(window: &Window<R>, size: (u32, u32), pixel: (u32, u32)) -> (R, R) {
    let ([col, row], half): ([R; 2], R) = (numbers(pixel), R::from(0.5));
    centers_at(window, size, (col + half, row + half))
}

fn centers_at<R: Real>(window: &Window<R>, size: (u32, u32), (col, row): (R, R)) -> (R, R) {
    let Window { left, right, bottom, top } = *window;
    let [width, height]: [R; 2] = numbers(size);
    let x = left + col * (right - left) / width;
    let y = top - row * (top - bottom) / height;
    (x, y)
}

/// Gambetta's grid: V_x = C_x V_w/C_w with canvas coordinates C_x = col − C_w/2, C_y = C_h/2 − row,
/// about the center of the window. The halves are real quotients. What it takes and returns is as for
/// [`Grid::point`].
pub fn lattice<R: Real>(window: &Window<R>, size: (u32, u32), pixel: (u32, u32)) -> (R, R) {
    let [col, row] = numbers(pixel);
    lattice_at(window, size, (col, row))
}

fn lattice_at<R: Real>(window: &Window<R>, size: (u32, u32), (col, row): (R, R)) -> (R, R) {
    let Window { left, right, bottom, top } = *window;
    let [width, height]: [R; 2] = numbers(size);
    let half = R::from(0.5);
    let (c_x, c_y) = (col - width * half, height * half - row);
    let (center_x, center_y) = window.center();
    let x = center_x + c_x * (right - left) / width;
    let y = center_y + c_y * (top - bottom) / height;
    (x, y)
}

/// CSC418's grid: w_l + i Δu with Δu = (w_r − w_l)/(n_c − 1), w_t + j Δv with Δv = (w_b − w_t)/(n_r − 1).
/// What it takes and returns is as for [`Grid::point`]: [`NoGrid`] with one column or row.
pub fn edges<R: Real>(window: &Window<R>, size: (u32, u32), pixel: (u32, u32)) -> Result<(R, R), NoGrid> {
    let [col, row] = numbers(pixel);
    edges_at(window, size, (col, row))
}

fn edges_at<R: Real>(window: &Window<R>, size: (u32, u32), (col, row): (R, R)) -> Result<(R, R), NoGrid> {
    let Window { left, right, bottom, top } = *window;
    let [width, height]: [R; 2] = numbers(size);
    let one = R::from(1.0);
    if size.0 < 2 || size.1 < 2 {
        return Err(NoGrid);
    }
    let x = left + col * (right - left) / (width - one);
    let y = top - row * (top - bottom) / (height - one);
    Ok((x, y))
}

fn numbers<R: Real>((x, y): (u32, u32)) -> [R; 2] {
    [x, y].map(|n| R::round_from(f64::from(n)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: two samples across a pixel 1 wide lie at a quarter and at three quarters of it, or a quarter beside its point.
    #[test]
    fn samples_lie_across_the_pixel_or_about_its_point() {
        let within = |grid: Grid, x| grid.point_within(&HOUSE, (5, 3), (1, 1), (x, 0.5)).unwrap().0;
        assert_eq!([within(Grid::Centers, 0.25), within(Grid::Centers, 0.75)], [-1.25, -0.75]);
        assert_eq!([within(Grid::Lattice, 0.25), within(Grid::Lattice, 0.75)], [-1.75, -1.25]);
        for grid in Grid::ALL {
            let point = grid.point(&HOUSE, (5, 3), (1, 1));
            assert_eq!(grid.point_within(&HOUSE, (5, 3), (1, 1), (0.5, 0.5)), point);
        }
    }

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

//! How this chapter shows and evaluates itself.

use math::{Camera, Degenerate, Grid, Handedness, NoGrid, Real, Window};
use stage::{About, Ask, Case, Chapter, Error, Row, Shown, TradeAsk, Traded, Transcript};

use crate::measure::{SCENES, measure};
use crate::{explain, picture, report};

/// House's picture: N = 5 columns by M = 3 rows.
pub(crate) const HOUSE_SIZE: (u32, u32) = (5, 3);

/// The stage `pinhole`.
pub struct Pinhole;

/// The chapter's stage. Here all of it is compiled for both precisions, and whoever runs it need not do so again.
pub static STAGE: &dyn stage::Stage = &Pinhole;

impl Chapter for Pinhole {
    fn about(&self) -> About {
        About {
            number: 1,
            name: "pinhole",
            teaches: "the pinhole camera: which ray belongs to a pixel, on three grids",
            notes: "House 4.1; Gambetta \"Canvas to Viewport\", Listings 2-2 and 2-3; CSC418 11.2",
            methods: Grid::ALL.map(Grid::name).to_vec(),
            size: (960, 720),
            picture: "Above, the pinhole's upside-down picture on the film behind it and the upright one on a \
                      view plane in front, by similar triangles; below, the three grids of pixels for \
                      House's 3 by 5 picture, drawn over each other. A pixel that is asked for is one of a picture \
                      of that size seen through Gambetta's viewport, 1 high at distance 1; the worked example is \
                      the top left pixel of House's picture.",
            flags: &[],
            inputs: &["width", "height", "col", "row", "left", "right", "bottom", "top", "distance"],
            words: &[],
            results: &["x", "y", "z", "reason"],
            trade: "What f32 and f64 cost on each grid, in pictures from an ordinary one to 16 million columns (the regimes): \
                    nanoseconds a point, and how many pixels it is off its exact place. Draws the two against each \
                    other, a panel a picture (trade.svg).",
            regimes: SCENES.iter().map(|scene| (scene.name, scene.what)).collect(),
        }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        let (grid, drawn) = (Grid::ALL[ask.method], ask.size_or(self.about().size)?);
        // The worked example is the top left pixel of House's picture, with z_p = 2: its center is 3 away.
        let (size, pixel, camera) = match ask.pixel {
            Some(pixel) => (drawn, pixel, camera(R::from(1.0), Window::around_axis(R::from(1.0), drawn))?),
            None => (HOUSE_SIZE, (0, 0), camera(R::from(2.0), house_window())?),
        };
        let mut transcript = Transcript::new(&self.about(), ask);
        explain::explain(&mut transcript, grid, &camera, size, pixel)?;
        explain::three_grids::<R>(&mut transcript);
        explain::similar_triangles::<R>(&mut transcript);
        explain::two_loops::<R>(&mut transcript);
        explain::general_camera::<R>(&mut transcript)?;
        explain::viewport::<R>(&mut transcript)?;
        Ok(Shown { transcript, picture: picture::draw::<R>(grid, drawn)?, ids: None })
    }

    fn eval<R: Real>(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        let numbers = case.numbers::<R, 9>()?;
        Ok(match point(Grid::ALL[ask.method], numbers) {
            Ok([x, y, z]) => Row::empty().number("x", x).number("y", y).number("z", z),
            Err(reason) => Row::empty().word("reason", reason),
        })
    }

    fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
        Ok(report::traded(&measure(ask)?, ask.seed))
    }
}

/// The point of a pixel on the view plane, in camera coordinates, or why there is none.
fn point<R: Real>(grid: Grid, numbers: [R; 9]) -> Result<[R; 3], &'static str> {
    let [width, height, col, row, left, right, bottom, top, distance] = numbers;
    if !numbers.iter().all(|number| number.is_finite()) {
        return Err(Degenerate::NotFinite.reason());
    }
    let [columns, rows, col, row]: [f64; 4] = [width, height, col, row].map(Into::into);
    match () {
        _ if [columns, rows, col, row].iter().any(|number| number.fract() != 0.0) => {
            Err("not-a-whole-number")
        }
        _ if columns < 1.0 || rows < 1.0 => Err("no-pixels"),
        _ if columns > MOST || rows > MOST => Err("too-many-pixels"),
        _ if col < 0.0 || row < 0.0 || col >= columns || row >= rows => Err("outside-picture"),
        _ if left >= right || bottom >= top => Err("empty-window"),
        _ if distance <= R::from(0.0) => Err("distance-not-positive"),
        _ => {
            let window = Window { left, right, bottom, top };
            let (size, pixel) = ((columns as u32, rows as u32), (col as u32, row as u32));
            let (x, y) = grid.point(&window, size, pixel).map_err(|NoGrid| "one-column-or-row")?;
            // The window's width may overflow, though its edges do not.
            if x.is_finite() && y.is_finite() { Ok([x, y, distance]) } else { Err("window-too-large") }
        }
    }
}

/// The most columns or rows that a grid counts.
const MOST: f64 = u32::MAX as f64;

/// House's window: w = 5 and h = 3, so that pixels have side 1.
pub(crate) fn house_window<R: Real>() -> Window<R> {
    let [left, right, bottom, top] = [-2.5, 2.5, -1.5, 1.5].map(R::from);
    Window { left, right, bottom, top }
}

/// A camera at the origin that looks along z, with y up and x right.
pub(crate) fn camera<R: Real>(f: R, window: Window<R>) -> Result<Camera<R>, Error> {
    let (zero, one) = (R::from(0.0), R::from(1.0));
    let [eye, forward, up] = [R::vec3(zero, zero, zero), R::vec3(zero, zero, one), R::vec3(zero, one, zero)];
    Ok(Camera::looking(eye, forward, up, Handedness::Left, f, window)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CASE: [f64; 9] = [5.0, 3.0, 0.0, 0.0, -2.5, 2.5, -1.5, 1.5, 2.0];

    fn with(changes: &[(usize, f64)]) -> [f64; 9] {
        let mut case = CASE;
        for &(place, number) in changes {
            case[place] = number;
        }
        case
    }

    #[test]
    fn a_case_is_the_contracts_formula() {
        // left + (col + ½)(right − left)/width and top − (row + ½)(top − bottom)/height, by hand
        assert_eq!(point(Grid::Centers, CASE), Ok([-2.0, 1.0, 2.0]));
        // about the window's center: here (1, 1)
        let shifted = with(&[(4, 0.0), (5, 2.0), (6, 0.0), (7, 2.0), (0, 4.0), (1, 4.0)]);
        assert_eq!(point(Grid::Lattice, shifted), Ok([0.0, 2.0, 2.0]));
        assert_eq!(point(Grid::Edges, with(&[(2, 4.0), (3, 2.0)])), Ok([2.5, -1.5, 2.0]));
    }

    #[test]
    fn impossible_cases_say_why() {
        for (changes, reason) in [
            (&[(0, f64::NAN)][..], "not-finite"),
            (&[(8, f64::INFINITY)], "not-finite"),
            (&[(0, 0.0)], "no-pixels"),
            (&[(0, 2.5)], "not-a-whole-number"),
            (&[(2, -1.0)], "outside-picture"),
            (&[(2, 1e300)], "outside-picture"),
            (&[(0, 1e300)], "too-many-pixels"),
            (&[(2, 5.0)], "outside-picture"),
            (&[(4, 2.5)], "empty-window"),
            (&[(8, 0.0)], "distance-not-positive"),
            (&[(0, 1.0)], "one-column-or-row"),
            (&[(4, -1e308), (5, 1e308)], "window-too-large"),
        ] {
            assert_eq!(point(Grid::Edges, with(changes)), Err(reason), "{changes:?}");
        }
    }
}

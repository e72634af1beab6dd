//! The extent of an object in the picture.
//!
//! CSC418 11.5: "we could project the extent onto the image plane so you don't need to cast rays to determine potential
//! for intersections." The eight corners of the object's box are projected, and the object is tried in the pixels of
//! the rectangle around them only: no ray is asked, two whole numbers are compared. It serves the rays of the eye and no
//! others.

use std::ops::RangeInclusive;

use math::{Grid, Real, Vector};
use signature::Scene;

use crate::Box3;

/// The pixels in which a box may be seen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rectangle {
    /// Columns.
    pub cols: RangeInclusive<u32>,
    /// Rows.
    pub rows: RangeInclusive<u32>,
}

/// The rectangle of a box; `None` where it lies outside the picture, or behind the eye.
///
/// All of the picture where a corner is level with the eye or behind it: such a corner has no place in the picture.
pub fn rectangle<R: Real>(scene: &Scene<R>, bounds: &Box3) -> Option<Rectangle> {
    let (width, height) = scene.size;
    let all = Rectangle { cols: 0..=width - 1, rows: 0..=height - 1 };
    let view = View::of(scene);
    let corners = (0..8).map(|corner| {
        std::array::from_fn(|axis| {
            f64::from(if corner >> axis & 1 == 0 { bounds.low[axis] } else { bounds.high[axis] })
        })
    });
    let [mut least, mut most] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    let (mut before, mut behind) = (0, 0);
    for corner in corners {
        match view.place(corner) {
            Place::Behind => behind += 1,
            Place::Level => return Some(all),
            Place::At(place) => {
                before += 1;
                for axis in 0..2 {
                    least[axis] = least[axis].min(place[axis]);
                    most[axis] = most[axis].max(place[axis]);
                }
            }
        }
    }
    if behind > 0 {
        return if before > 0 { Some(all) } else { None };
    }
    let cols = pixels([least[0], most[0]], view.off[0], width)?;
    let rows = pixels([least[1], most[1]], view.off[1], height)?;
    Some(Rectangle { cols, rows })
}

/// The pixels between two places, made larger by `off` on either side; `None` where none is in the picture.
fn pixels([least, most]: [f64; 2], off: f64, count: u32) -> Option<RangeInclusive<u32>> {
    let (first, last) = ((least - off).floor().max(0.0), (most + off).ceil().min(f64::from(count) - 1.0));
    // not finite: anywhere
    if !(least.is_finite() && most.is_finite()) {
        return Some(0..=count - 1);
    }
    (first <= last).then_some(first as u32..=last as u32)
}

/// Where a point is.
enum Place {
    /// Behind the plane of the eye.
    Behind,
    /// So near to it that rounding decides.
    Level,
    /// In the picture's plane: column and row, not rounded.
    At([f64; 2]),
}

/// The camera in `f64`, which holds the numbers of either precision.
struct View {
    e: [f64; 3],
    /// u, v, w: any point is e + x u + y v + z w.
    frame: [[f64; 3]; 3],
    f: f64,
    /// The place of column 0 and row 0, and how far the next ones are.
    first: [f64; 2],
    step: [f64; 2],
    /// By how many pixels the rays may be off.
    off: [f64; 2],
}

impl View {
    fn of<R: Real>(scene: &Scene<R>) -> View {
        let camera = &scene.camera;
        let frame = [camera.u, camera.v, camera.w].map(Vector::in_f64::<3>);
        let window = &camera.window;
        let [left, right, bottom, top, f] =
            [window.left, window.right, window.bottom, window.top, camera.f].map(Into::<f64>::into);
        let (width, height) = (f64::from(scene.size.0), f64::from(scene.size.1));
        let (first, step) = match scene.grid {
            Grid::Centers => {
                let step = [(right - left) / width, (bottom - top) / height];
                ([left + step[0] / 2.0, top + step[1] / 2.0], step)
            }
            Grid::Lattice => {
                let step = [(right - left) / width, (bottom - top) / height];
                ([left, top], step)
            }
            Grid::Edges => ([left, top], [(right - left) / (width - 1.0), (bottom - top) / (height - 1.0)]),
        };
        // What a ray of R is off: its x and y by four roundings of at most the window's edge, its direction by four more of
        // x u, y v, f w, and u, v, w are unit vectors at right angles but for four. The projection here is done in f64, with
        // no more of its own roundings. 16 units of each cover both, and a pixel more covers the ends.
        let unit = 2.0_f64.powi(-(R::DIGITS as i32));
        let reach = left.abs().max(right.abs()) + bottom.abs().max(top.abs()) + f;
        let off = step.map(|step| 1.0 + 16.0 * unit * reach / step.abs());
        View { e: camera.e.in_f64(), frame, f, first, step, off }
    }

    fn place(&self, point: [f64; 3]) -> Place {
        let from_eye: [f64; 3] = std::array::from_fn(|axis| point[axis] - self.e[axis]);
        let dot = |a: [f64; 3]| a[0] * from_eye[0] + a[1] * from_eye[1] + a[2] * from_eye[2];
        let [x, y, z] = self.frame.map(dot);
        // z is good but for a few roundings of its parts; half a pixel of 2^28 seen a window away is far more than those
        let size = from_eye.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        match z {
            _ if !size.is_finite() || z.abs() <= size * f64::from(f32::EPSILON) => Place::Level,
            ..0.0 => Place::Behind,
            _ => {
                let plane = [x * self.f / z, y * self.f / z];
                Place::At([0, 1].map(|axis| (plane[axis] - self.first[axis]) / self.step[axis]))
            }
        }
    }
}

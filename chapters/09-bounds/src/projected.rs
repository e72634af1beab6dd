//! The extent of an object in the picture.
//!
//! CSC418 11.5: "we could project the extent onto the image plane so you don't need to cast rays to determine
//! potential for intersections." The eight corners of the object's box are projected, and the object is tried
//! in the pixels of the rectangle around them only: no ray is asked, two whole numbers are compared. It
//! serves the rays of the eye and no others.

use std::ops::RangeInclusive;

use math::wide::scaled;
use math::{Grid, Real, Vector};
use signature::Scene;

use crate::Box3;

/// The pixels in which a box may be seen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rectangle {
    /// Columns, from 0 at the left.
    pub cols: RangeInclusive<u32>,
    /// Rows, from 0 at the top.
    pub rows: RangeInclusive<u32>,
}

/// The rectangles of objects, by rows of the picture.
#[derive(Debug)]
pub struct Extents {
    /// Those over all rows.
    tall: Vec<(usize, Rectangle)>,
    /// The others, for each so many rows: those that are in one of them.
    bands: Vec<Vec<(usize, Rectangle)>>,
    rows_each: u32,
}

impl Extents {
    /// The most bands: a picture may have 2^28 rows, and an object be in most of them.
    const MOST: u32 = 1024;

    /// Objects with their rectangles, which must lie in a picture of so many rows.
    pub fn new(height: u32, objects: impl IntoIterator<Item = (usize, Rectangle)>) -> Extents {
        let rows_each = height.div_ceil(Extents::MOST).max(1);
        let (mut tall, mut bands) = (Vec::new(), vec![Vec::new(); height.div_ceil(rows_each) as usize]);
        for (object, seen) in objects {
            let (first, last) = (*seen.rows.start(), *seen.rows.end());
            if first == 0 && last == height - 1 {
                tall.push((object, seen));
            } else {
                for band in first / rows_each..=last / rows_each {
                    bands[band as usize].push((object, seen.clone()));
                }
            }
        }
        Extents { tall, bands, rows_each }
    }

    /// All objects that may be seen in a row of the picture, and where there are many rows, some that are in
    /// one next to it.
    pub fn in_row(&self, row: u32) -> impl Iterator<Item = &(usize, Rectangle)> {
        self.tall.iter().chain(&self.bands[(row / self.rows_each) as usize])
    }
}

/// The rectangle of a box; `None` where it lies outside the picture, or behind the eye.
///
/// All of the picture where some corners are level with the eye or behind it: such a corner has no place in
/// the picture.
pub fn rectangle<R: Real>(scene: &Scene<R>, bounds: &Box3) -> Option<Rectangle> {
    let (width, height) = scene.size;
    let all = Rectangle { cols: 0..=width - 1, rows: 0..=height - 1 };
    let view = View::of(scene);
    let corners = (0..8).map(|corner| {
        std::array::from_fn(|axis| {
            // exercise corners: Of the corner with this number (0 to 7): on which of the two faces is it on this axis?
            f64::from(if corner >> axis & 1 == 0 { bounds.low[axis] } else { bounds.high[axis] })
            // end corners
        })
    });
    if !view.has_depth {
        return Some(all);
    }
    let [mut least, mut most] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    let (mut before, mut behind) = (0, 0);
    let (mut farthest, mut nearest) = (0.0_f64, f64::INFINITY);
    for corner in corners {
        match view.place(corner) {
            Place::Behind => behind += 1,
            Place::Level => return Some(all),
            Place::At { place, size, z } => {
                before += 1;
                (farthest, nearest) = (farthest.max(size), nearest.min(z));
                for axis in 0..2 {
                    // exercise grow: One more corner has its place: how far does the rectangle reach now?
                    least[axis] = least[axis].min(place[axis]);
                    most[axis] = most[axis].max(place[axis]);
                    // end grow
                }
            }
        }
    }
    if behind > 0 {
        // exercise behind: Some corners are behind the eye: in which pixels may the box be seen, if in any?
        return if before > 0 { Some(all) } else { None };
        // end behind
    }
    let off = view.off(farthest / nearest);
    let cols = pixels([least[0], most[0]], off[0], width)?;
    let rows = pixels([least[1], most[1]], off[1], height)?;
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
    /// In the picture's plane: column and row, not rounded; and how large its distance is on any axis, and
    /// along w.
    At { place: [f64; 2], size: f64, z: f64 },
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
    /// The longest way to a ray's point of the view plane, along the axes: |x| + |y| + f.
    reach: f64,
    /// By how much of that a ray's direction may be off.
    rounding: f64,
    /// Whether a ray's way into the scene, f, is more than what is rounded: else a ray may even go backward.
    has_depth: bool,
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
        // What a ray of R is off: its x and y by four roundings of at most the window's edge, its direction
        // by four more of x u, y v, f w, and u, v, w are unit vectors at right angles but for four. 16 units
        // cover all.
        let rounding = 16.0 * scaled(1.0, -(R::DIGITS as i32));
        let reach = left.abs().max(right.abs()) + bottom.abs().max(top.abs()) + f;
        let has_depth = rounding * reach <= f / 2.0;
        View { e: camera.e.in_f64(), frame, f, first, step, reach, rounding, has_depth }
    }

    /// By how many columns and rows a ray may pass beside the place where a point that it meets is projected.
    ///
    /// With δ for the rounding times the reach, x and y of a ray are off by δ, and so is f, by which they are
    /// divided: so the place is off by δ (1 + reach/f) f/(f − δ), which is at most twice δ (1 + reach/f). The
    /// corners of a box, up to `size_to_z` times as large as their z, are rounded here, in `f64`, by 8 units
    /// each. A pixel more covers the ends.
    fn off(&self, size_to_z: f64) -> [f64; 2] {
        let sideways = self.reach / self.f;
        let of_ray = 2.0 * self.rounding * self.reach * (1.0 + sideways);
        let of_corners = 8.0 * f64::EPSILON * size_to_z * (self.f + self.reach);
        self.step.map(|step| 1.0 + (of_ray + of_corners) / step.abs())
    }

    fn place(&self, point: [f64; 3]) -> Place {
        let from_eye: [f64; 3] = std::array::from_fn(|axis| point[axis] - self.e[axis]);
        let dot = |a: [f64; 3]| a[0] * from_eye[0] + a[1] * from_eye[1] + a[2] * from_eye[2];
        let [x, y, z] = self.frame.map(dot);
        // z is good but for a few roundings of its parts, in f64; this is far more than those
        let size = from_eye.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        match z {
            _ if !size.is_finite() || z.abs() <= size * f64::from(f32::EPSILON) => Place::Level,
            ..0.0 => Place::Behind,
            _ => {
                // exercise plane: Where does the way from the eye to the point go through the view plane?
                let plane: [f64; 2] = [x * self.f / z, y * self.f / z];
                // end plane
                // exercise place: Which column and which row is that, with fractions?
                let place: [f64; 2] = [0, 1].map(|axis| (plane[axis] - self.first[axis]) / self.step[axis]);
                // end place
                Place::At { place, size, z }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec3, Vec3};
    use math::{Camera, Handedness, Window};

    /// From the origin along z, a square window at distance 1 that reaches so far to each side, ten by ten pixels.
    fn before(half: f64, grid: Grid) -> Scene<f64> {
        let window = Window { left: -half, right: half, bottom: -half, top: half };
        let camera = Camera::looking(DVec3::ZERO, DVec3::Z, DVec3::Y, Handedness::Left, 1.0, window).unwrap();
        Scene { camera, grid, size: (10, 10), objects: Vec::new() }
    }

    /// What is seen of a box through a window of side 2.
    fn seen(low: [f32; 3], high: [f32; 3]) -> Option<Rectangle> {
        rectangle(&before(1.0, Grid::Centers), &Box3 { low, high })
    }

    /// By hand: a window 4 wide and 6 high, of 8 by 3 pixels, whose columns are ½ apart and whose rows are −2; or as far
    /// that the last ones are at the window's edges.
    #[test]
    fn the_first_place_and_the_steps_are_those_of_the_grid() {
        let window = Window { left: -1.0, right: 3.0, bottom: -4.0, top: 2.0 };
        let camera = Camera::looking(DVec3::ZERO, DVec3::Z, DVec3::Y, Handedness::Left, 1.0, window).unwrap();
        for (grid, first, step) in [
            (Grid::Centers, [-0.75, 1.0], [0.5, -2.0]),
            (Grid::Lattice, [-1.0, 2.0], [0.5, -2.0]),
            (Grid::Edges, [-1.0, 2.0], [4.0 / 7.0, -3.0]),
        ] {
            let scene = Scene::<f64> { camera, grid, size: (8, 3), objects: Vec::new() };
            let view = View::of(&scene);
            assert_eq!((view.first, view.step), (first, step), "{grid:?}");
            // the farthest of the window from its middle, and its distance
            assert_eq!(view.reach, 3.0 + 4.0 + 1.0);
        }
    }

    /// A view of `f32` numbers, at distance 2, of 8 by 3 pixels: its reach is 9, its steps ½ and −2.
    fn at_two() -> View {
        let window = Window { left: -1.0, right: 3.0, bottom: -4.0, top: 2.0 };
        let camera = Camera::looking(Vec3::ZERO, Vec3::Z, Vec3::Y, Handedness::Left, 2.0, window).unwrap();
        View::of(&Scene::<f32> { camera, grid: Grid::Centers, size: (8, 3), objects: Vec::new() })
    }

    /// By hand: δ = 16 · 2⁻²⁴ · 9, and 2 δ (1 + 9/2) is 99 · 2⁻²⁰; corners 2⁴⁰ times as large as their z are off by
    /// 8 · 2⁻⁵² · 2⁴⁰ (2 + 9) = 88 · 2⁻¹².
    #[test]
    fn a_ray_may_pass_that_far_beside_its_place() {
        let (of_ray, of_corners) = (99.0 * scaled(1.0, -20), 88.0 * scaled(1.0, -12));
        let both = of_ray + of_corners;
        assert_eq!(at_two().off(scaled(1.0, 40)), [1.0 + both / 0.5, 1.0 + both / 2.0]);
    }

    /// By hand: the point (3, −6, 6) is seen at (1, −2) of the view plane, in column (1 + ¾)/½ and row (−2 − 1)/−2.
    #[test]
    fn a_point_has_its_place_or_is_level_with_the_eye() {
        let view = at_two();
        let Place::At { place, size, z } = view.place([3.0, -6.0, 6.0]) else { panic!() };
        assert_eq!((place, size, z), ([3.5, 1.5], 6.0, 6.0));
        assert!(matches!(view.place([3.0, -6.0, -6.0]), Place::Behind));
        for (z, is_level) in [(1e-9, true), (-1e-9, true), (1e-6, false), (-1e-6, false)] {
            assert_eq!(matches!(view.place([1.0, 0.0, z]), Place::Level), is_level, "{z}");
        }
        assert!(matches!(view.place([1.0, f64::INFINITY, 1.0]), Place::Level));
    }

    /// By hand: at distance 1 a ray of `f64`, whose direction is off by 2⁻⁴⁹ of its reach, goes ahead for sure where
    /// that is at most ½. The reach is half a side for x, as much for y, and 1.
    #[test]
    fn a_window_that_is_too_large_has_no_depth() {
        for (half, has_depth) in [(1.5, true), (2.0, false), (4.0, false)] {
            let half = half * scaled(1.0, 46);
            assert_eq!(View::of(&before(half, Grid::Centers)).has_depth, has_depth, "{half:e}");
        }
    }

    #[test]
    fn pixels_are_those_between_two_places() {
        assert_eq!(pixels([2.5, 3.5], 1.0, 10), Some(1..=5));
        assert_eq!(pixels([-9.0, 99.0], 1.0, 10), Some(0..=9));
        assert_eq!((pixels([-9.0, -3.0], 1.0, 10), pixels([11.5, 99.0], 1.0, 10)), (None, None));
        for places in [[f64::NEG_INFINITY, 3.0], [3.0, f64::INFINITY], [f64::NAN; 2]] {
            assert_eq!(pixels(places, 1.0, 10), Some(0..=9), "anywhere");
        }
    }

    /// By hand, on a lattice of step ⅕ from −1: x = 2 · 10⁻¹⁶ at z = 10⁻⁶ is 10⁻⁹ of a column beyond the fifth. Where a
    /// corner is a million times as far aside, its place is off by more.
    #[test]
    fn a_rectangle_is_larger_where_its_corners_are_less_certain() {
        let scene = before(1.0, Grid::Lattice);
        let first = |right: f32| {
            let bounds = Box3 { low: [2e-16, 0.0, 1e-6], high: [right, 0.0, 1e-6] };
            *rectangle(&scene, &bounds).unwrap().cols.start()
        };
        assert_eq!((first(1e-6), first(1.0)), (4, 3));
    }

    /// By hand: at z = 2 the window is 4 wide, so x from 0 to 0.8 is columns 5 and 6, and one more on either
    /// side and what is rounded outward; y from 1.2 to 2 is rows 0 and 1.
    #[test]
    fn a_box_has_its_rectangle() {
        let Rectangle { cols, rows } = seen([0.0, 1.2, 2.0], [0.8, 2.0, 2.0]).unwrap();
        assert!(*cols.start() <= 5 && *cols.end() >= 6 && cols.count() <= 6);
        assert!(*rows.start() == 0 && *rows.end() >= 1 && rows.count() <= 4);
        assert_eq!(seen([9.0, 0.0, 2.0], [9.5, 1.0, 3.0]), None, "to the right of the picture");
        assert_eq!(seen([-1.0, -1.0, -3.0], [1.0, 1.0, -2.0]), None, "behind the eye");
    }

    /// The corner (1, 1, −1) would be at (−1, −1): a box from there to (2, 2, 4), seen up and to the right of
    /// the middle, would be projected to what is between (−1, −1) and (½, ½) and the pixels outside of it
    /// were not asked.
    #[test]
    fn as_printed_a_corner_behind_the_eye_is_projected_upside_down() {
        let project = |[x, y, z]: [f64; 3]| [x / z, y / z];
        assert_eq!(project([1.0, 1.0, -1.0]), [-1.0, -1.0]);
        assert_eq!(project([2.0, 2.0, 4.0]), [0.5, 0.5]);
        // and the ray through (0.9, 0.9) of the view plane is in the box at z = 2
        let all = Rectangle { cols: 0..=9, rows: 0..=9 };
        assert_eq!(seen([1.0, 1.0, -1.0], [2.0, 2.0, 4.0]), Some(all.clone()));
        assert_eq!(seen([1.0, 1.0, 0.0], [2.0, 2.0, 4.0]), Some(all), "level with it");
    }

    #[test]
    fn a_picture_of_very_many_rows_has_few_bands() {
        let whole = Rectangle { cols: 0..=0, rows: 0..=(1 << 28) - 1 };
        let low = Rectangle { cols: 0..=0, rows: 5 << 20..=(1 << 28) - 1 };
        let extents = Extents::new(1 << 28, [(7, low), (8, whole)]);
        assert_eq!(extents.bands.len(), 1024);
        let in_row = |row| extents.in_row(row).map(|(object, _)| *object).collect::<Vec<_>>();
        assert_eq!((in_row(0), in_row(6 << 20)), (vec![8], vec![8, 7]));
    }
}

//! Where the parts of the picture go: the scene, the section with its normals, the shaded pair.

use math::{Real, Window};
use stage::View;

/// A part of the drawing: its top left and its bottom right corner, in drawing units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Part {
    pub(crate) from: (f32, f32),
    pub(crate) to: (f32, f32),
}

impl Part {
    fn new(left: f32, top: f32, width: f32, height: f32) -> Part {
        Part { from: (left, top), to: (left + width, top + height) }
    }

    /// Whether a place lies in it.
    pub(crate) fn holds(&self, (x, y): (f64, f64)) -> bool {
        let within = |x: f64, from: f32, to: f32| f64::from(from) <= x && x < f64::from(to);
        within(x, self.from.0, self.to.0) && within(y, self.from.1, self.to.1)
    }

    /// The point that is `right` and `down` of its top left corner.
    pub(crate) fn at(&self, right: f32, down: f32) -> (f32, f32) {
        (self.from.0 + right, self.from.1 + down)
    }
}

/// The frame and its parts. The scene is drawn over the whole picture; its objects lie within its part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layout {
    pub(crate) frame: (f32, f32),
    pub(crate) scene: Part,
    pub(crate) section: Part,
    pub(crate) pair: Part,
}

/// The part of the view plane that the objects take, as (left, bottom) and (right, top).
const OBJECTS: ((f64, f64), (f64, f64)) = ((-0.75, -0.48), (0.75, 0.08));

/// What is below the scene: their widths and their common height.
const SECTION: f32 = 408.0;
const PAIR: f32 = 280.0;
const HEIGHT: f32 = 196.0;

/// A picture more than this many times as wide as high has its parts side by side.
const STRIP: f64 = 3.2;

impl Layout {
    /// Side by side in a strip, one below the other in a picture higher than wide; else the scene above and the
    /// other two below it.
    pub(crate) fn of((columns, rows): (u32, u32)) -> Layout {
        let aspect = f64::from(columns) / f64::from(rows);
        if aspect > STRIP {
            return Layout {
                frame: (1360.0, 250.0),
                section: Part::new(8.0, 46.0, SECTION, HEIGHT),
                scene: Part::new(SECTION + 16.0, 0.0, 640.0, 250.0),
                pair: Part::new(1352.0 - PAIR, 46.0, PAIR, HEIGHT),
            };
        }
        if aspect < 1.0 {
            return Layout {
                frame: (424.0, 640.0),
                scene: Part::new(0.0, 0.0, 424.0, 210.0),
                section: Part::new(8.0, 228.0, SECTION, HEIGHT),
                pair: Part::new((424.0 - PAIR) / 2.0, 436.0, PAIR, HEIGHT),
            };
        }
        Layout {
            frame: (720.0, 480.0),
            scene: Part::new(0.0, 0.0, 720.0, 264.0),
            section: Part::new(8.0, 276.0, SECTION, HEIGHT),
            pair: Part::new(712.0 - PAIR, 276.0, PAIR, HEIGHT),
        }
    }

    /// Where the view plane lies on the drawing.
    pub(crate) fn view(&self) -> View {
        View::new(OBJECTS.0, OBJECTS.1, self.scene.from, self.scene.to)
    }

    /// The window on the view plane that the whole picture of `size` pixels shows.
    pub(crate) fn window<R: Real>(&self, size: (u32, u32)) -> Window<R> {
        let (left, top) = self.view().plane(self.place(size, (0.0, 0.0)));
        let (right, bottom) = self.view().plane(self.place(size, (f64::from(size.0), f64::from(size.1))));
        let [left, right, bottom, top] = [left, right, bottom, top].map(R::round_from);
        Window { left, right, bottom, top }
    }

    /// Where the center of a pixel lies on the drawing.
    pub(crate) fn place_of(&self, size: (u32, u32), (col, row): (u32, u32)) -> (f64, f64) {
        self.place(size, (f64::from(col) + 0.5, f64::from(row) + 0.5))
    }

    /// Where a place given in pixels lies on the drawing: as [`stage::Canvas::fit`] lays the frame, as large as fits
    /// and in the middle.
    fn place(&self, size: (u32, u32), (x, y): (f64, f64)) -> (f64, f64) {
        let (columns, rows) = (f64::from(size.0), f64::from(size.1));
        let (width, height) = (f64::from(self.frame.0), f64::from(self.frame.1));
        let scale = (columns / width).min(rows / height);
        let (left, top) = ((columns - scale * width) / 2.0, (rows - scale * height) / 2.0);
        ((x - left) / scale, (y - top) / scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stage::{Canvas, Color};

    /// The pixel's ray goes through the place of the view plane that the pixel shows.
    #[test]
    fn the_window_is_what_the_canvas_shows() {
        for size in [(720, 480), (64, 48), (300, 900), (1600, 300), (1, 1)] {
            let layout = Layout::of(size);
            let mut canvas = Canvas::new(size, Color::WHITE).unwrap();
            canvas.fit(layout.frame.0, layout.frame.1);
            let window = layout.window::<f64>(size);
            for pixel in [(0, 0), (size.0 / 3, size.1 / 2), (size.0 - 1, size.1 - 1)] {
                let (x, y) = math::grid::centers(&window, size, pixel);
                assert_eq!(layout.place_of(size, pixel), canvas.place_of(pixel));
                let shown = layout.view().plane(canvas.place_of(pixel));
                assert!((x - shown.0).abs() < 1e-6 && (y - shown.1).abs() < 1e-6, "{size:?} {pixel:?}");
            }
        }
    }

    #[test]
    fn the_parts_lie_in_the_frame_and_do_not_overlap() {
        for size in [(720, 480), (300, 900), (1600, 300)] {
            let Layout { frame, scene, section, pair } = Layout::of(size);
            let parts = [scene, section, pair];
            for (i, part) in parts.iter().enumerate() {
                assert!(part.from.0 >= 0.0 && part.from.1 >= 0.0, "{size:?}");
                assert!(part.to.0 <= frame.0 && part.to.1 <= frame.1, "{size:?}");
                for other in &parts[..i] {
                    let apart_in_x = part.to.0 <= other.from.0 || other.to.0 <= part.from.0;
                    let apart_in_y = part.to.1 <= other.from.1 || other.to.1 <= part.from.1;
                    assert!(apart_in_x || apart_in_y, "{size:?} {i}");
                }
            }
        }
    }
}

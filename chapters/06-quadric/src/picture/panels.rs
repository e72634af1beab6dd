//! Six panels of one size, laid out as the picture's shape asks.

use math::{Camera, Degenerate, Ray3, Real};
use stage::View;

use super::area::Area;
use crate::Shape;
use crate::scene::{camera, eye};

/// What stands in a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Panel {
    /// A solid as its eye sees it, one ray a pixel.
    Seen(Shape),
    /// The cone as printed, seen by the cone's eye.
    AsPrinted,
    /// The upright plane that holds the explained ray of a solid, and the ray's candidates in it.
    Section(Shape),
    /// The true cone's outline and the printed one's.
    Outlines,
}

/// The panels by pairs: what is seen, and below or beside it its section.
const PAIRS: [[Panel; 2]; 3] = [
    [Panel::Seen(Shape::Cylinder), Panel::Section(Shape::Cylinder)],
    [Panel::Seen(Shape::Cone), Panel::Section(Shape::Cone)],
    [Panel::AsPrinted, Panel::Outlines],
];

/// Every panel.
pub(crate) const ALL: [Panel; 6] = {
    let [[a, b], [c, d], [e, f]] = PAIRS;
    [a, b, c, d, e, f]
};

/// A panel's width in drawing units.
pub(crate) const WIDTH: f32 = 240.0;
/// A panel's height in drawing units.
pub(crate) const HEIGHT: f32 = 270.0;
/// The panels in their places on a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layout {
    /// How many panels stand side by side.
    columns: u32,
    /// Pixels a drawing unit.
    scale: f64,
    /// Where the frame of all panels begins, in pixels.
    left: f64,
    top: f64,
}

impl Layout {
    /// The panels in one, two, three or six columns: whichever makes them largest.
    pub(crate) fn new((width, height): (u32, u32)) -> Layout {
        let with = |columns: u32| {
            let (wide, high) = frame(columns);
            let scale = (f64::from(width) / wide).min(f64::from(height) / high);
            let [left, top] = [(width, wide), (height, high)]
                .map(|(pixels, units)| (f64::from(pixels) - scale * units) / 2.0);
            Layout { columns, scale, left, top }
        };
        let larger = |best: Layout, next: Layout| if next.scale > best.scale { next } else { best };
        [2, 6, 1].map(with).into_iter().fold(with(3), larger)
    }

    /// The frame that holds them all, in drawing units: for [`stage::Canvas::fit`].
    pub(crate) fn frame(&self) -> (f32, f32) {
        let (width, height) = frame(self.columns);
        (width as f32, height as f32)
    }

    /// The top left corner of a panel, in drawing units.
    pub(crate) fn corner(&self, panel: Panel) -> (f32, f32) {
        let place = (0..6).find(|&place| self.panel(place) == panel).unwrap_or(0);
        ((place % self.columns) as f32 * WIDTH, (place / self.columns) as f32 * HEIGHT)
    }

    /// The panel in a place, counted row by row.
    fn panel(&self, place: u32) -> Panel {
        let (row, column) = (place / self.columns, place % self.columns);
        let [pair, half] = if self.columns == 3 { [column, row] } else { [place / 2, place % 2] };
        PAIRS[pair as usize][half as usize]
    }

    /// The panel that a pixel belongs to, and where the pixel's center lies in it, in drawing units from the
    /// panel's top left corner.
    pub(crate) fn place_of(&self, (col, row): (u32, u32)) -> (Panel, (f64, f64)) {
        let x = (f64::from(col) + 0.5 - self.left) / self.scale;
        let y = (f64::from(row) + 0.5 - self.top) / self.scale;
        let (column, line) = self.at((x, y));
        let corner = (f64::from(column) * f64::from(WIDTH), f64::from(line) * f64::from(HEIGHT));
        (self.panel(line * self.columns + column), (x - corner.0, y - corner.1))
    }

    /// The panel of a place on the canvas.
    pub(crate) fn panel_at(&self, (x, y): (f32, f32)) -> Panel {
        let (column, line) = self.at((f64::from(x), f64::from(y)));
        self.panel(line * self.columns + column)
    }

    /// The column and the line of panels at a place. The outer panels own what lies beyond them.
    fn at(&self, (x, y): (f64, f64)) -> (u32, u32) {
        let index =
            |at: f64, size: f32, count: u32| (at / f64::from(size)).clamp(0.0, f64::from(count - 1)) as u32;
        (index(x, WIDTH, self.columns), index(y, HEIGHT, 6 / self.columns))
    }
}

/// The size of so many columns of panels.
fn frame(columns: u32) -> (f64, f64) {
    (f64::from(WIDTH) * f64::from(columns), f64::from(HEIGHT) * f64::from(6 / columns))
}

impl Panel {
    /// The solid it is about.
    pub(crate) fn shape(self) -> Shape {
        match self {
            Panel::Seen(shape) | Panel::Section(shape) => shape,
            Panel::AsPrinted | Panel::Outlines => Shape::Cone,
        }
    }

    /// Its window onto the view plane, or onto the section, where the panel's top left corner is `corner`.
    pub(crate) fn view(self, corner: (f32, f32)) -> View {
        let ([left, bottom, right, top], area) = match self {
            Panel::Seen(_) | Panel::AsPrinted => {
                let half = self.half();
                ([-half, -half, half, half], Area::of_seen(corner))
            }
            Panel::Section(Shape::Cylinder) => ([-1.9, -1.3, 1.9, 2.05], Area::of_section(corner)),
            Panel::Section(Shape::Cone) | Panel::Outlines => {
                ([-1.0, -0.45, 1.0, 1.25], Area::of_section(corner))
            }
        };
        View::new((left, bottom), (right, top), area.from, area.to)
    }

    /// Half the window through which a solid is seen, at the solid's middle.
    fn half(self) -> f64 {
        match self.shape() {
            Shape::Cylinder => 1.6,
            Shape::Cone => 0.78,
        }
    }

    /// The camera of what is seen.
    pub(crate) fn camera<R: Real>(self) -> Result<Camera<R>, Degenerate> {
        camera(self.shape(), self.half())
    }

    /// The ray through a place of a panel, in drawing units from its top left corner. In a section that is the
    /// ray in the plane y = 0 from the solid's eye: the place is reached at λ = 1.
    pub(crate) fn ray<R: Real>(self, camera: &Camera<R>, view: &View, place: (f64, f64)) -> Ray3<R> {
        let point = |place| {
            let (x, y) = view.plane(place);
            (R::round_from(x), R::round_from(y))
        };
        match self {
            Panel::Seen(_) | Panel::AsPrinted => camera.ray(point(place)),
            Panel::Section(_) | Panel::Outlines => {
                // The eye stands outside the panel: a place within has a direction.
                let within = (place.0.clamp(0.0, f64::from(WIDTH)), place.1.clamp(0.0, f64::from(HEIGHT)));
                in_section(eye::<R>(self.shape()), point(within))
            }
        }
    }
}

/// From the eye to the point (x, 0, z).
fn in_section<R: Real>(eye: R::Vec3, (x, z): (R, R)) -> Ray3<R> {
    Ray3::new(eye, R::vec3(x, R::from(0.0), z) - eye)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_panels_stand_as_the_picture_is_shaped() {
        for (size, columns) in
            [((720, 540), 3), ((64, 48), 3), ((300, 900), 2), ((1600, 300), 6), ((100, 900), 1), ((1, 1), 3)]
        {
            assert_eq!(Layout::new(size).columns, columns, "{size:?}");
        }
    }

    #[test]
    fn a_place_in_a_panel_is_found_from_its_corner() {
        for size in [(720, 540), (480, 810), (1440, 270), (240, 1620)] {
            // one pixel a unit: the pixel 10 right of a panel's corner and 20 below has its center at 10.5, 20.5
            let layout = Layout::new(size);
            for panel in ALL {
                let (x, y) = layout.corner(panel);
                assert_eq!(
                    layout.place_of((x as u32 + 10, y as u32 + 20)),
                    (panel, (10.5, 20.5)),
                    "{size:?}"
                );
            }
        }
    }

    #[test]
    fn every_pixel_has_a_ray() {
        for size in [(61, 47), (9, 90), (90, 9), (1, 1)] {
            let layout = Layout::new(size);
            for (col, row) in (0..size.0).flat_map(|col| (0..size.1).map(move |row| (col, row))) {
                let (panel, place) = layout.place_of((col, row));
                let camera = panel.camera::<f32>().unwrap();
                let ray = panel.ray(&camera, &panel.view((0.0, 0.0)), place);
                assert_eq!(ray.check(), Ok(()), "{panel:?} {place:?}");
            }
        }
    }
}

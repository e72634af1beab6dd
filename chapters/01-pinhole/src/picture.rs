//! The picture: the pinhole turned round, and the three grids.

use math::grid::centers;
use math::{Grid, Real, Window};
use stage::{Anchor, Canvas, Color, Error, Pen, View};

use crate::stage::{HOUSE_SIZE, house_window};
use crate::{letter, project};

/// The drawing's frame.
const FRAME: (f32, f32) = (960.0, 720.0);

pub(crate) fn draw<R: Real>(grid: Grid, size: (u32, u32)) -> Result<Canvas, Error> {
    let mut canvas = Canvas::new(size, Color::WHITE)?;
    canvas.fit(FRAME.0, FRAME.1);
    side_view(&mut canvas);
    letters::<R>(&mut canvas);
    canvas.line((20.0, 336.0), (940.0, 336.0), Pen::solid(Color::PALE, 1.0));
    three_grids::<R>(&mut canvas, grid);
    Ok(canvas)
}

/// House's similar triangles, with the film behind the pinhole and the view plane in front.
fn side_view(canvas: &mut Canvas) {
    let Some(seen) = project(2.0, 4.0, 2.0) else { return };
    let view = View::new((-2.9, -1.75), (5.1, 2.45), (10.0, 40.0), (590.0, 325.0));
    canvas.label((20.0, 26.0), Anchor::Left, 16.0, Color::BLACK, "Similar triangles: y_p = y_0 z_p / z_0");

    view.arrow(canvas, (-2.8, 0.0), (5.0, 0.0), Pen::solid(Color::GRAY, 1.0));
    let z = view.at((5.0, 0.0));
    canvas.label((z.0 - 2.0, z.1 - 8.0), Anchor::Middle, 13.0, Color::GRAY, "z");

    // One ray, from the tip of the object through the pinhole to the film.
    view.line(canvas, (seen.z_0, seen.y_0), (-seen.z_p, seen.y_film), Pen::solid(Color::ORANGE, 1.8));
    for z in [-seen.z_p, seen.z_p] {
        view.line(canvas, (z, -1.45), (z, 1.45), Pen::dashed(Color::GRAY, 1.2));
    }
    let heights = [
        (seen.z_0, seen.y_0, Color::BLUE, "y_0"),
        (seen.z_p, seen.y_p, Color::GREEN, "y_p"),
        (-seen.z_p, seen.y_film, Color::VERMILLION, "−y_p"),
    ];
    for (z, y, color, name) in heights {
        view.arrow(canvas, (z, 0.0), (z, y), Pen::solid(color, 4.0));
        let at = view.at((z, y / 2.0));
        canvas.plate((at.0 + 12.0, at.1 + 5.0), Anchor::Left, 15.0, color, name);
    }
    canvas.disc(view.at((0.0, 0.0)), 5.0, Color::BLACK);
    let label = |canvas: &mut Canvas, z, y, text: &str| {
        canvas.plate(view.at((z, y)), Anchor::Middle, 13.0, Color::BLACK, text);
    };
    canvas.plate(view.at((-0.12, 0.2)), Anchor::Right, 13.0, Color::BLACK, "pinhole, eye");
    label(canvas, seen.z_0, 2.15, "object");
    label(canvas, seen.z_p, 1.55, "view plane: upright");
    label(canvas, -seen.z_p, 1.55, "film: upside down");
    measure(canvas, view, seen.z_p, -0.55, "z_p");
    measure(canvas, view, seen.z_0, -1.1, "z_0");
}

/// A distance from the eye, below the axis.
fn measure(canvas: &mut Canvas, view: View, z: f64, y: f64, name: &str) {
    let pen = Pen::solid(Color::GRAY, 1.0);
    view.arrow(canvas, (1.0, y), (0.0, y), pen);
    view.arrow(canvas, (1.0, y), (z, y), pen);
    let at = view.at((1.0, y));
    canvas.plate((at.0, at.1 + 5.0), Anchor::Middle, 14.0, Color::BLACK, name);
}

/// A letter through the pinhole, 21 rays by 21: on the film behind, and on the view plane in front.
fn letters<R: Real>(canvas: &mut Canvas) {
    canvas.label((610.0, 26.0), Anchor::Left, 16.0, Color::BLACK, "The same letter F, a ray a pixel");
    raster::<R>(canvas, (610.0, 80.0), Color::VERMILLION, -1.0);
    raster::<R>(canvas, (780.0, 80.0), Color::GREEN, 1.0);
    canvas.label((688.0, 262.0), Anchor::Middle, 13.0, Color::BLACK, "on the film behind");
    canvas.label((858.0, 262.0), Anchor::Middle, 12.5, Color::BLACK, "on the view plane in front");
    canvas.label(
        (610.0, 296.0),
        Anchor::Left,
        13.0,
        Color::GRAY,
        "Light crosses in the pinhole: up becomes down,",
    );
    canvas.label(
        (610.0, 314.0),
        Anchor::Left,
        13.0,
        Color::GRAY,
        "left becomes right. In front nothing is turned.",
    );
}

/// The picture on the view plane in front (`side` = 1) or on the film behind (`side` = −1): light that
/// arrives at (x, y) comes from the direction (x, y, 1) in front, and through the pinhole from
/// (−x, −y, 1) behind.
fn raster<R: Real>(canvas: &mut Canvas, (left, top): (f32, f32), color: Color, side: f64) {
    const PIXELS: u32 = 21;
    let window = Window::around_axis(R::from(1.0), (1, 1));
    let cell = 156.0 / PIXELS as f32;
    for row in 0..PIXELS {
        for col in 0..PIXELS {
            let (x, y) = centers(&window, (PIXELS, PIXELS), (col, row));
            let turned = R::round_from(side);
            let dark = letter::shade::<R>(letter::shoot::<R>(R::vec3(x * turned, y * turned, R::from(1.0))));
            let (x, y) = (left + col as f32 * cell, top + row as f32 * cell);
            let fill = if dark { color } else { Color::PALE };
            canvas.rectangle((x + 0.5, y + 0.5), (x + cell - 0.5, y + cell - 0.5), fill, 1.0);
        }
    }
}

/// How a grid's points are marked.
fn mark(canvas: &mut Canvas, grid: Grid, at: (f32, f32), chosen: bool) {
    let (radius, width) = if chosen { (8.0, 3.0) } else { (5.0, 1.8) };
    match grid {
        Grid::Centers => canvas.disc(at, radius * 0.85, Color::BLUE),
        Grid::Lattice => canvas.cross(at, radius * 0.8, Pen::solid(Color::VERMILLION, width)),
        Grid::Edges => canvas.circle(at, radius, Pen::solid(Color::BLACK, width * 0.7)),
    }
}

/// House's 3 × 5 picture with the points of all three grids; the chosen one's are larger.
fn three_grids<R: Real>(canvas: &mut Canvas, chosen: Grid) {
    let title = "House's 3 × 5 picture, sampled on the three grids";
    canvas.label((20.0, 364.0), Anchor::Left, 16.0, Color::BLACK, title);
    let view = View::new((-2.5, -1.5), (2.5, 1.5), (150.0, 400.0), (615.0, 680.0));
    for x in 0..=5 {
        let x = f64::from(x) - 2.5;
        view.line(canvas, (x, -1.5), (x, 1.5), Pen::solid(Color::PALE, 1.5));
    }
    for y in 0..=3 {
        let y = f64::from(y) - 1.5;
        view.line(canvas, (-2.5, y), (2.5, y), Pen::solid(Color::PALE, 1.5));
    }
    canvas.frame(view.at((-2.5, 1.5)), view.at((2.5, -1.5)), Pen::solid(Color::BLACK, 1.5));
    for row in 0..HOUSE_SIZE.1 {
        let at = view.at((-2.5, 1.0 - f64::from(row)));
        let house = HOUSE_SIZE.1 - 1 - row;
        canvas.label((at.0 - 18.0, at.1 - 2.0), Anchor::Right, 13.0, Color::BLACK, &format!("row {row}"));
        canvas.label(
            (at.0 - 18.0, at.1 + 15.0),
            Anchor::Right,
            12.0,
            Color::GRAY,
            &format!("House: i = {house}"),
        );
    }
    counted(canvas, view);
    for col in 0..HOUSE_SIZE.0 {
        let at = view.at((f64::from(col) - 2.0, 1.5));
        canvas.label((at.0, at.1 - 12.0), Anchor::Middle, 13.0, Color::BLACK, &format!("col {col}"));
    }
    for grid in Grid::ALL {
        for (col, row) in (0..HOUSE_SIZE.1).flat_map(|row| (0..HOUSE_SIZE.0).map(move |col| (col, row))) {
            let Ok((x, y)) = grid.point(&house_window::<R>(), HOUSE_SIZE, (col, row)) else { continue };
            mark(canvas, grid, view.at((x.into(), y.into())), grid == chosen);
        }
    }
    half_a_pixel(canvas, view);
    legend(canvas, chosen, R::NAME);
}

/// Which way the rows are counted: a file's downward, House's upward.
fn counted(canvas: &mut Canvas, view: View) {
    let ((x, top), (_, bottom)) = (view.at((-2.5, 1.1)), view.at((-2.5, -1.1)));
    canvas.arrow((x - 116.0, top), (x - 116.0, bottom), Pen::solid(Color::BLACK, 1.6));
    canvas.label((x - 116.0, top - 6.0), Anchor::Middle, 12.0, Color::BLACK, "row");
    canvas.arrow((x - 104.0, bottom), (x - 104.0, top), Pen::solid(Color::GRAY, 1.6));
    canvas.label((x - 104.0, bottom + 16.0), Anchor::Middle, 12.0, Color::GRAY, "i");
}

/// From the center of the middle pixel to its point on the lattice.
fn half_a_pixel(canvas: &mut Canvas, view: View) {
    view.arrow(canvas, (-0.1, 0.1), (-0.43, 0.43), Pen::solid(Color::PURPLE, 2.2));
    canvas.plate(view.at((0.0, 0.22)), Anchor::Left, 12.0, Color::BLACK, "½ pixel");
}

fn legend(canvas: &mut Canvas, chosen: Grid, precision: &str) {
    let entries = [
        (Grid::Centers, "centers (House)", "left + (col + ½) w/N: the middle of each pixel"),
        (Grid::Lattice, "lattice (Gambetta)", "(col − C_w/2) V_w/C_w: a corner of each pixel"),
        (Grid::Edges, "edges (CSC418)", "w_l + col Δu, Δu = (w_r − w_l)/(n_c − 1)"),
    ];
    for (place, (grid, name, formula)) in entries.into_iter().enumerate() {
        let y = 424.0 + 64.0 * place as f32;
        mark(canvas, grid, (652.0, y - 5.0), grid == chosen);
        canvas.label((672.0, y), Anchor::Left, 15.0, Color::BLACK, name);
        canvas.label((672.0, y + 19.0), Anchor::Left, 11.5, Color::GRAY, formula);
    }
    let rows = [
        "Rows: a picture file counts from the top,",
        "House from the bottom. As printed, his",
        "picture stands on its head.",
    ];
    for (place, text) in rows.into_iter().enumerate() {
        canvas.label((640.0, 622.0 + 18.0 * place as f32), Anchor::Left, 13.0, Color::BLACK, text);
    }
    let name = format!("{} · {precision}", chosen.name());
    canvas.label((940.0, 704.0), Anchor::Right, 13.0, Color::BLACK, &name);
}

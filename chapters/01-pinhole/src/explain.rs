//! The transcript: from a pixel to its ray, and what the page says about it.

use math::{Camera, Grid, Handedness, NoGrid, Real, Vector, Window};
use stage::{Error, Section, Transcript, Value};

use crate::gambetta::{canvas_coordinates, canvas_pixel, canvas_to_viewport, main_method};
use crate::house::{house_pixel, house_row, in_camera, raycast};
use crate::stage::{HOUSE_SIZE, camera, house_window};
use crate::{Csc418Pixel, GambettaPixel, HousePixel, cast_through, csc418, csc418_pixel, letter, project};

/// The way from a pixel to its ray, on one grid.
pub(crate) fn explain<R: Real>(
    transcript: &mut Transcript,
    grid: Grid,
    camera: &Camera<R>,
    size: (u32, u32),
    (col, row): (u32, u32),
) -> Result<(), Error> {
    let (columns, rows) = size;
    let (name, precision) = (grid.name(), R::NAME);
    let title = format!("pinhole · {name} · {precision} · pixel {col},{row} of {columns} × {rows}");
    let refused = |no_grid: NoGrid| Error::Request(format!("{no_grid}; the picture is {columns}x{rows}"));
    let (window, f) = (&camera.window, camera.f);
    match grid {
        Grid::Centers => {
            let pixel = house_pixel(window, f, size, (house_row(rows, row), col));
            house_steps(transcript.section(title, "House 4.1"), size, f, &pixel);
        }
        Grid::Lattice => {
            let pixel = canvas_to_viewport(window, f, size, canvas_coordinates(size, (col, row)));
            gambetta_steps(transcript.section(title, "Gambetta, Listing 2-3"), f, &pixel);
        }
        Grid::Edges => {
            let pixel = csc418_pixel(camera, size, (col, row)).map_err(refused)?;
            csc418_steps(transcript.section(title, "CSC418 11.2"), camera, size, &pixel);
        }
    }
    if let Some(section) = transcript.sections.last_mut() {
        closed_form(section, grid, window, f, size, (col, row));
    }
    Ok(())
}

fn whole(number: u32) -> Value {
    Value::F64(f64::from(number))
}

fn pair<R: Real>((x, y): (R, R)) -> Value {
    Value::Array([x, y].map(Value::number).to_vec())
}

fn house_steps<R: Real>(section: &mut Section, (columns, rows): (u32, u32), z_p: R, pixel: &HousePixel<R>) {
    let (w, h) = pixel.screen;
    section
        .step("M", "the pixels of a column", whole(rows))
        .step("N", "the pixels of a row", whole(columns))
        .number("w", "the width of the viewscreen", w)
        .number("h", "its height", h)
        .number("z_p", "its distance", z_p)
        .vector::<R>("c", "(c_x, c_y, −z_p), its center", pixel.c)
        .note("House's camera is aimed down −z")
        .step("i", "the row", whole(pixel.i))
        .note("from the bottom; a picture file counts from the top")
        .step("j", "the column", whole(pixel.j))
        .number("pixwidth", "w / N", pixel.pixwidth)
        .number("pixheight", "h / M", pixel.pixheight)
        .number("p_x", "c_x − w / 2 + pixwidth (j + 0.5)", pixel.p.x())
        .number("p_y", "c_y − h / 2 + pixheight (i + 0.5)", pixel.p.y())
        .vector::<R>("p", "(p_x, p_y, −z_p)", pixel.p)
        .vector::<R>("u_r", "p / ‖p‖", pixel.u_r);
}

/// The point as `eval` gives it, by the closed form of `math::grid`: the same on paper, and but for the
/// last digit in floating point.
fn closed_form<R: Real>(
    section: &mut Section,
    grid: Grid,
    window: &Window<R>,
    f: R,
    size: (u32, u32),
    pixel: (u32, u32),
) {
    let formula = match grid {
        Grid::Centers => "(left + (col + ½) w / N, top − (row + ½) h / M, distance)",
        Grid::Lattice => "about the center: ((col − C_w/2) w / C_w, (C_h/2 − row) h / C_h)",
        Grid::Edges => "(left + col w / (n_c − 1), top − row h / (n_r − 1), distance)",
    };
    if let Ok((x, y)) = grid.point(window, size, pixel) {
        section
            .vector::<R>("(x, y, z)", formula, R::vec3(x, y, f))
            .note("in camera coordinates, as eval answers");
    }
}

fn gambetta_steps<R: Real>(section: &mut Section, d: R, pixel: &GambettaPixel<R>) {
    section
        .step("C_w, C_h", "the canvas in pixels", pair(pixel.canvas))
        .step("V_w, V_h", "the viewport", pair(pixel.viewport))
        .number("d", "its distance", d)
        .number("C_x", "col − C_w/2", pixel.c_x)
        .number("C_y", "C_h/2 − row", pixel.c_y)
        .note("y grows upward, from the center of the canvas")
        .vector::<R>("V", "(C_x V_w/C_w, C_y V_h/C_h, d)", pixel.v)
        .vector::<R>("D", "V − O", pixel.v)
        .note("O = (0, 0, 0); not a unit vector: t = 1 on the viewport");
}

fn csc418_steps<R: Real>(
    section: &mut Section,
    camera: &Camera<R>,
    (n_c, n_r): (u32, u32),
    pixel: &Csc418Pixel<R>,
) {
    section
        .step("n_c, n_r", "columns, rows", Value::Array([n_c, n_r].map(whole).to_vec()))
        .step("i", "the column", whole(pixel.i))
        .note("House calls the row i and the column j")
        .step("j", "the row", whole(pixel.j))
        .number("w_l", "the window's left edge", camera.window.left)
        .number("w_t", "its top edge", camera.window.top)
        .number("f", "its distance", camera.f)
        .number("Δu", "(w_r − w_l) / (n_c − 1)", pixel.delta_u)
        .number("Δv", "(w_b − w_t) / (n_r − 1)", pixel.delta_v)
        .vector::<R>("p̄_C", "(w_l + i Δu, w_t + j Δv, f)", pixel.p_camera)
        .vector::<R>("p̄_W", "(u⃗ v⃗ w⃗) p̄_C + ē", pixel.p_world)
        .vector::<R>("d⃗", "p̄_W − ē", pixel.d)
        .note("the ray p̄_W + λ d⃗ starts on the view plane");
}

/// Every pixel of House's picture on every grid.
pub(crate) fn three_grids<R: Real>(transcript: &mut Transcript) {
    let window = house_window::<R>();
    let mut rows = Vec::new();
    for row in 0..HOUSE_SIZE.1 {
        for col in 0..HOUSE_SIZE.0 {
            let i = house_row(HOUSE_SIZE.1, row);
            let names = [format!("{col},{row}"), format!("i = {i}, j = {col}")].map(Value::text);
            let points = Grid::ALL.map(|grid| match grid.point(&window, HOUSE_SIZE, (col, row)) {
                Ok(point) => pair(point),
                Err(no_grid) => Value::text(no_grid.to_string()),
            });
            rows.push(names.into_iter().chain(points).collect());
        }
    }
    transcript
        .section("House's 3 × 5 picture on the three grids: (x, y) on the view plane, w = 5, h = 3", "")
        .table(&["pixel", "House", "centers", "lattice", "edges"], rows)
        .remark("The lattice lies half a pixel left of and above the centers; edges stretches to the border.")
        .remark(
            "House's row i = 0 is the bottom one. A file that begins with it shows the picture on its head.",
        );
}

/// Projecting a point and casting a ray through its picture are the same triangles.
pub(crate) fn similar_triangles<R: Real>(transcript: &mut Transcript) {
    let Some(seen) = project(R::from(2.0), R::from(4.0), R::from(2.0)) else { return };
    let cast = cast_through(&seen);
    transcript
        .section("Projecting a point, and casting a ray through its picture", "House 4.1")
        .number("y_0", "the object's height", seen.y_0)
        .number("z_0", "its distance", seen.z_0)
        .number("z_p", "the view plane's distance", seen.z_p)
        .number("y_p", "y_0 z_p / z_0", seen.y_p)
        .note("in front of the pinhole: upright")
        .number("y_film", "y_0 (−z_p) / z_0", seen.y_film)
        .note("on a film behind the pinhole: upside down")
        .vector::<R>("u_r", "(y_p, z_p) − (0, 0)", cast.ray.direction)
        .number("t", "z_0 / z_p", cast.t)
        .vector::<R>("x(t)", "p_r + t u_r", cast.point)
        .note("back at the object (y_0, z_0)")
        .number("residual", "‖x(t) − (y_0, z_0)‖", cast.residual);
}

/// One turn of a loop: which pixel, what the page calls it, and what its ray sees.
struct Visit {
    pixel: (u32, u32),
    name: String,
    seen: &'static str,
}

/// The turns of a loop by their pixels, row by row, each with its place in the loop from 1.
fn by_pixel(visits: Vec<Visit>) -> Vec<(usize, Visit)> {
    let mut numbered: Vec<(usize, Visit)> = (1..).zip(visits).collect();
    numbered.sort_by_key(|(_, visit)| (visit.pixel.1, visit.pixel.0));
    numbered
}

fn seen(on_letter: bool) -> &'static str {
    if on_letter { "letter" } else { "nothing" }
}

/// House's loop and Gambetta's over the same picture of the letter F, side by side.
pub(crate) fn two_loops<R: Real>(transcript: &mut Transcript) {
    let (window, z_p, size) = (house_window::<R>(), R::from(2.0), HOUSE_SIZE);
    let shoot = |u_r| letter::shoot::<R>(in_camera::<R>(u_r));
    let image = raycast(&window, z_p, size, shoot, letter::shade::<R>);
    let mut house = Vec::new();
    for (i, line) in (0..).zip(&image) {
        for (j, &color) in (0..).zip(line) {
            let name = format!("i = {i}, j = {j}");
            house.push(Visit { pixel: (j, house_row(size.1, i)), name, seen: seen(color) });
        }
    }
    let mut gambetta = Vec::new();
    let trace_ray = |direction| letter::shade::<R>(letter::shoot::<R>(direction));
    main_method(&window, z_p, size, trace_ray, |(x, y), color| {
        let name = format!("x = {}, y = {}", Value::number(x).to_text(), Value::number(y).to_text());
        gambetta.push(Visit { pixel: canvas_pixel(size, (x, y)), name, seen: seen(color) });
    });
    let (house, gambetta) = (by_pixel(house), by_pixel(gambetta));
    let same = house.iter().map(|(_, a)| a.pixel).eq(gambetta.iter().map(|(_, b)| b.pixel));
    let rows = house.iter().zip(&gambetta).map(|((turn_a, a), (turn_b, b))| {
        let (col, row) = a.pixel;
        let turn = |turn: &usize| turn.to_string();
        let cells = [format!("{col},{row}"), a.name.clone(), turn(turn_a), a.seen.to_string()];
        let more = [b.name.clone(), turn(turn_b), b.seen.to_string()];
        cells.into_iter().chain(more).map(Value::text).collect()
    });
    transcript
        .section("Two loops over the same pixels, with a letter F behind them", "House 4.1; Gambetta, Listing 2-2")
        .table(
            &["pixel", "image[i][j]", "turn", "shade(shoot(u_r))", "PutPixel(x, y)", "turn", "TraceRay(O, D)"],
            rows.collect(),
        )
        .remark(match same {
            true => "Both visit every pixel once, House row by row, Gambetta column by column, both from the bottom.",
            false => "They visit different pixels.",
        })
        .remark("House looks through the center of a pixel and Gambetta through a corner: they may see different things.");
}

/// The frame, the window and the field of view of a camera anywhere, and a pixel's way into the world.
pub(crate) fn general_camera<R: Real>(transcript: &mut Transcript) -> Result<(), Error> {
    let vector = |x, y, z| R::vec3(R::from(x), R::from(y), R::from(z));
    let (eye, forward, up) = (vector(2.0, 1.0, 2.0), vector(-2.0, -1.0, -2.0), vector(0.0, 1.0, 0.0));
    let (f, window) = (R::from(2.0), house_window());
    let camera = Camera::looking(eye, forward, up, Handedness::Right, f, window)?;
    let Window { left, right, bottom, top } = camera.window;
    let section = transcript.section(
        "A camera anywhere: the image plane r̄ + a u⃗ + b v⃗, here from (2, 1, 2) toward the origin",
        "CSC418 11.2",
    );
    section
        .vector::<R>("ē", "the eye", camera.e)
        .vector::<R>("u⃗", "right: w⃗ × up", camera.u)
        .vector::<R>("v⃗", "up: u⃗ × w⃗", camera.v)
        .vector::<R>("w⃗", "into the scene", camera.w)
        .number("f", "the view plane's distance", camera.f)
        .vector::<R>("r̄", "ē + f w⃗", camera.view_plane((R::from(0.0), R::from(0.0))))
        .step(
            "window",
            "w_l, w_r, w_b, w_t",
            Value::Array([left, right, bottom, top].map(Value::number).to_vec()),
        )
        .step(
            "field of view",
            "atan(w_r / f) − atan(w_l / f), in degrees",
            Value::F64(camera.field_of_view()),
        );
    if let Ok(pixel) = csc418_pixel(&camera, HOUSE_SIZE, (0, 0)) {
        section
            .vector::<R>("p̄_C", "pixel (0, 0) of 5 × 3 in camera coordinates", pixel.p_camera)
            .vector::<R>("p̄_W", "(u⃗ v⃗ w⃗) p̄_C + ē", pixel.p_world)
            .number("residual", "(p̄_W − r̄) · w⃗", csc418::off_image_plane(&camera, pixel.p_world));
    }
    Ok(())
}

/// Gambetta's V_w = V_h = d = 1.
pub(crate) fn viewport<R: Real>(transcript: &mut Transcript) -> Result<(), Error> {
    let one = R::from(1.0);
    let camera = camera(one, Window::around_axis(one, (1, 1)))?;
    transcript
        .section("Gambetta's viewport", "Gambetta, \"Basic Assumptions\"")
        .number("V_w", "the viewport's width", camera.window.right - camera.window.left)
        .number("V_h", "its height", camera.window.top - camera.window.bottom)
        .number("d", "its distance", camera.f)
        .step("field of view", "2 atan(V_w / 2d), in degrees", Value::F64(camera.field_of_view()))
        .note("the page: approximately 53°");
    Ok(())
}

//! How this chapter shows and evaluates itself.

use math::{Camera, Degenerate, Grid, Handedness, NoGrid, Real, Window};
use stage::{About, Ask, Case, Error, Precision, Row, Section, Shown, Stage, Transcript, Value};

use crate::{cast_through, csc418_pixel, gambetta, gambetta_pixel, house, house_pixel, picture, project};

/// House's picture: N = 5 columns by M = 3 rows.
pub(crate) const HOUSE_SIZE: (u32, u32) = (5, 3);

/// The stage `pinhole`.
pub struct Pinhole;

impl Stage for Pinhole {
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
                      House's 3 by 5 picture, drawn over each other.",
            inputs: &["width", "height", "col", "row", "left", "right", "bottom", "top", "distance"],
            results: &["x", "y", "z", "reason"],
        }
    }

    fn show(&self, ask: &Ask) -> Result<Shown, Error> {
        match ask.precision {
            Precision::F32 => show::<f32>(ask),
            Precision::F64 => show::<f64>(ask),
        }
    }

    fn eval(&self, ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
        match ask.precision {
            Precision::F32 => row::<f32>(ask, case),
            Precision::F64 => row::<f64>(ask, case),
        }
    }
}

fn row<R: Real>(ask: &Ask, case: &Case<'_>) -> Result<Row, Error> {
    let numbers = case.numbers::<R, 9>()?;
    Ok(match point(Grid::ALL[ask.method], numbers) {
        Ok([x, y, z]) => Row::empty().number("x", x).number("y", y).number("z", z),
        Err(reason) => Row::empty().word("reason", reason),
    })
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
            let point = grid.point(&window, size, pixel);
            point.map(|(x, y)| [x, y, distance]).map_err(|NoGrid| "one-column-or-row")
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
fn camera<R: Real>(f: R, window: Window<R>) -> Result<Camera<R>, Error> {
    let (zero, one) = (R::from(0.0), R::from(1.0));
    let [eye, forward, up] = [R::vec3(zero, zero, zero), R::vec3(zero, zero, one), R::vec3(zero, one, zero)];
    Camera::looking(eye, forward, up, Handedness::Left, f, window)
        .map_err(|degenerate| Error::Failed(degenerate.to_string()))
}

fn show<R: Real>(ask: &Ask) -> Result<Shown, Error> {
    let grid = Grid::ALL[ask.method];
    // The worked example is the top left pixel of House's picture, with z_p = 2: its center is 3 away.
    let (size, pixel, camera) = match ask.pixel {
        Some(pixel) => (ask.size, pixel, camera(R::from(1.0), Window::around_axis(R::from(1.0), ask.size))?),
        None => (HOUSE_SIZE, (0, 0), camera(R::from(2.0), house_window())?),
    };
    let mut transcript = Transcript::new(&Pinhole.about(), ask);
    explain(&mut transcript, grid, &camera, size, pixel)?;
    three_grids::<R>(&mut transcript);
    similar_triangles::<R>(&mut transcript);
    two_loops(&mut transcript);
    general_camera(&mut transcript, &camera);
    viewport::<R>(&mut transcript)?;
    Ok(Shown { transcript, picture: picture::draw::<R>(grid, ask.size)? })
}

/// The way from a pixel to its ray, on one grid.
fn explain<R: Real>(
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
        Grid::Centers => house_steps(
            transcript.section(title, "House 4.1"),
            window,
            &house_pixel(window, f, size, (col, row)),
        ),
        Grid::Lattice => gambetta_steps(
            transcript.section(title, "Gambetta, Listing 2-3"),
            window,
            &gambetta_pixel(window, f, size, (col, row)),
        ),
        Grid::Edges => {
            let pixel = csc418_pixel(camera, size, (col, row)).map_err(refused)?;
            csc418_steps(transcript.section(title, "CSC418 11.2"), &pixel);
        }
    }
    Ok(())
}

fn house_steps<R: Real>(section: &mut Section, window: &Window<R>, pixel: &house::HousePixel<R>) {
    section
        .number("w", "the width of the viewscreen", window.right - window.left)
        .number("h", "its height", window.top - window.bottom)
        .step("i", "the row", Value::text(pixel.i.to_string()))
        .note("from the bottom; a picture file counts from the top")
        .step("j", "the column", Value::text(pixel.j.to_string()))
        .number("pixwidth", "w / N", pixel.pixwidth)
        .number("pixheight", "h / M", pixel.pixheight)
        .vector::<R>("p", "c − (w/2, h/2, 0) + (w/N (j + 0.5), h/M (i + 0.5), 0)", pixel.p)
        .note("z into the scene; House's camera looks down −z")
        .vector::<R>("u_r", "p / ‖p‖", pixel.u_r);
}

fn gambetta_steps<R: Real>(section: &mut Section, window: &Window<R>, pixel: &gambetta::GambettaPixel<R>) {
    section
        .number("V_w", "the viewport's width", window.right - window.left)
        .number("V_h", "its height", window.top - window.bottom)
        .number("C_x", "col − C_w/2", pixel.c_x)
        .number("C_y", "C_h/2 − row", pixel.c_y)
        .note("y grows upward, from the center of the canvas")
        .vector::<R>("V", "(C_x V_w/C_w, C_y V_h/C_h, d)", pixel.v)
        .vector::<R>("D", "V − O", pixel.v)
        .note("O = (0, 0, 0); not normalised: t = 1 on the viewport");
}

fn csc418_steps<R: Real>(section: &mut Section, pixel: &crate::Csc418Pixel<R>) {
    section
        .number("Δu", "(w_r − w_l) / (n_c − 1)", pixel.delta_u)
        .number("Δv", "(w_b − w_t) / (n_r − 1)", pixel.delta_v)
        .vector::<R>("p̄_C", "(w_l + i Δu, w_t + j Δv, f)", pixel.p_camera)
        .note("pixel (i, j) is column i, row j")
        .vector::<R>("p̄_W", "(u⃗ v⃗ w⃗) p̄_C + ē", pixel.p_world)
        .vector::<R>("d⃗", "p̄_W − ē", pixel.d)
        .note("the ray p̄_W + λ d⃗ starts on the view plane");
}

/// Every pixel of House's picture on every grid.
fn three_grids<R: Real>(transcript: &mut Transcript) {
    let window = house_window::<R>();
    let mut rows = Vec::new();
    for row in 0..HOUSE_SIZE.1 {
        for col in 0..HOUSE_SIZE.0 {
            let i = house_pixel(&window, R::from(1.0), HOUSE_SIZE, (col, row)).i;
            let names = [format!("{col},{row}"), format!("i = {i}, j = {col}")].map(Value::text);
            let points = Grid::ALL.map(|grid| match grid.point(&window, HOUSE_SIZE, (col, row)) {
                Ok((x, y)) => Value::Array([x, y].map(Value::number).to_vec()),
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
fn similar_triangles<R: Real>(transcript: &mut Transcript) {
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

/// House's loop and Gambetta's, side by side.
fn two_loops(transcript: &mut Transcript) {
    let (mut house_visits, mut gambetta_visits) = (Vec::new(), Vec::new());
    house::raycast(HOUSE_SIZE, |i, j, row| house_visits.push((format!("i = {i}, j = {j}"), (j, row))));
    gambetta::main_method(HOUSE_SIZE, |x, y, pixel| {
        let [x, y] = [x, y].map(|number| Value::number(number).to_text());
        gambetta_visits.push((format!("x = {x}, y = {y}"), pixel));
    });
    let text =
        |(name, (col, row)): &(String, (u32, u32))| [name.clone(), format!("{col},{row}")].map(Value::text);
    let rows = house_visits.iter().zip(&gambetta_visits).enumerate().map(|(n, (house, gambetta))| {
        let number = Value::text((n + 1).to_string());
        [number].into_iter().chain(text(house)).chain(text(gambetta)).collect()
    });
    let rows: Vec<Vec<Value>> = rows.collect();
    let pixels = |visits: &[(String, (u32, u32))]| {
        let mut pixels: Vec<(u32, u32)> = visits.iter().map(|visit| visit.1).collect();
        pixels.sort_unstable();
        pixels
    };
    let same = pixels(&house_visits) == pixels(&gambetta_visits);
    transcript
        .section("Two loops over the same pixels", "House 4.1; Gambetta, Listing 2-2")
        .table(
            &[
                "",
                "House: image[i][j] = shade(shoot(u_r))",
                "pixel",
                "Gambetta: PutPixel(x, y, color)",
                "pixel",
            ],
            rows,
        )
        .remark(if same {
            "Both visit every pixel once, in different orders."
        } else {
            "They visit different pixels."
        });
}

/// The frame, the window and the field of view.
fn general_camera<R: Real>(transcript: &mut Transcript, camera: &Camera<R>) {
    let Window { left, right, bottom, top } = camera.window;
    transcript
        .section("The camera of this picture: r̄ = ē + a u⃗ + b v⃗ + f w⃗", "CSC418 11.2")
        .vector::<R>("ē", "the eye", camera.e)
        .vector::<R>("u⃗", "right", camera.u)
        .vector::<R>("v⃗", "up", camera.v)
        .vector::<R>("w⃗", "into the scene", camera.w)
        .number("f", "the view plane's distance", camera.f)
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
}

/// Gambetta's V_w = V_h = d = 1.
fn viewport<R: Real>(transcript: &mut Transcript) -> Result<(), Error> {
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
        ] {
            assert_eq!(point(Grid::Edges, with(changes)), Err(reason), "{changes:?}");
        }
    }
}

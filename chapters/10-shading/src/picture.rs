//! The picture: the terms of the chapter's scene one by one and together, and below them the small scene at
//! every scale, its second rays started by every method.

use bounds::Bounded;
use math::Real;
use stage::{Anchor, Ask, Canvas, Color, Error, Pen};

use crate::layout::{CELL, CELLS, COLUMNS, Part, SIZE, Term, What};
use crate::lighting::Again;
use crate::own::{self, SCALES};
use crate::render::{Rendered, Seen, render};
use crate::{Lighting, Rgb, Scene, Start, from_file};

/// What can be drawn of a pixel.
const TERMS: [Term; 5] = [Term::All, Term::Ambient, Term::Diffuse, Term::Specular, Term::Shadows];

/// The color of each of [`TERMS`] in a pixel.
type Drawn = Rendered<[[u8; 3]; TERMS.len()]>;

/// A scene lit in this chapter's way: every second ray is tried on everything, so that a start has to prove
/// itself.
pub(crate) fn lighting<'a, R: Real>(
    scene: &'a Scene<R>,
    bounded: &'a Bounded<'a, R>,
    start: Start,
) -> Lighting<'a, R> {
    Lighting { scene, bounded, start, idle_shadows: false, again: Again::Counted }
}

/// All parts, each with what is drawn in it. Terms of the scene that are drawn as large as each other are
/// rendered once.
pub(crate) fn all<R: Real>(
    ask: &Ask,
    file: &scene_file::Scene,
    parts: &[Part],
) -> Result<Vec<(Part, Drawn)>, Error> {
    let mut all: Vec<(Part, Drawn)> = Vec::new();
    for part in parts {
        let is_the_same = |other: &Part| {
            matches!((part.what, other.what), (What::Term(_), What::Term(_))) && other.size == part.size
        };
        let again = all.iter().find(|(other, _)| is_the_same(other)).map(|(_, rendered)| rendered.clone());
        let rendered = again.map_or_else(|| rendered::<R>(ask, file, part), Ok)?;
        all.push((*part, rendered));
    }
    Ok(all)
}

/// What is drawn in a part.
fn rendered<R: Real>(ask: &Ask, file: &scene_file::Scene, part: &Part) -> Result<Drawn, Error> {
    let samples = ask.samples.unwrap_or(1);
    let colors = |seen: &Seen| TERMS.map(|term| color(ask, of(term, seen)).0);
    match part.what {
        What::Term(_) => {
            let scene = from_file::scene::<R>(file, Some(part.size)).map_err(signature::stage::fault)?;
            let bounded = Bounded::new(&scene.geometry, bounds::Method::Auto);
            render(&lighting(&scene, &bounded, Start::ALL[ask.method]), samples, ask.threads, colors)
        }
        What::Cell(row, column) => {
            let scene = own::small::<f32>(SCALES[row], part.size)?;
            let bounded = Bounded::new(&scene.geometry, bounds::Method::Auto);
            render(&lighting(&scene, &bounded, COLUMNS[column]), samples, ask.threads, colors)
        }
    }
}

/// The color of radiance, as it was asked for.
pub(crate) fn color(ask: &Ask, Rgb(radiance): Rgb) -> Color {
    if ask.srgb { Color::from_linear_srgb(radiance) } else { Color::from_linear(radiance) }
}

/// All parts, each with what is drawn in it.
pub(crate) fn draw(size: (u32, u32), parts: &[(Part, Drawn)]) -> Result<Canvas, Error> {
    let mut canvas = Canvas::new(size, Color::WHITE)?;
    canvas.shade(|col, row| {
        let within =
            parts.iter().find_map(|(part, rendered)| Some((part, rendered.at(part.own((col, row))?))));
        within.map_or(Color::WHITE, |(part, colors)| Color(colors[place(part.what)]))
    });
    if parts.len() > 1 {
        canvas.fit(SIZE.0 as f32, SIZE.1 as f32);
        label(&mut canvas, parts);
    }
    Ok(canvas)
}

/// Where in the colors of a pixel that of a part stands.
fn place(what: What) -> usize {
    let term = if let What::Term(term) = what { term } else { Term::All };
    TERMS.iter().position(|other| *other == term).unwrap_or(0)
}

/// What a term is of what a pixel sees.
pub(crate) fn of(term: Term, seen: &Seen) -> Rgb {
    match term {
        Term::All => seen.e,
        Term::Ambient => seen.ambient,
        Term::Diffuse => seen.diffuse,
        Term::Specular => seen.specular,
        Term::Shadows => seen.lit,
    }
}

fn label(canvas: &mut Canvas, parts: &[(Part, Drawn)]) {
    for (part, _) in parts {
        if let What::Term(term) = part.what {
            let corner = canvas.place((f64::from(part.at.0), f64::from(part.at.1)));
            let (x, y) = (corner.0 as f32, corner.1 as f32);
            canvas.plate((x + 9.0, y + 20.0), Anchor::Left, 14.0, Color::BLACK, term.label());
        }
    }
    let (left, top) = (CELLS.0 as f32, CELLS.1 as f32);
    let (wide, high) = (CELL.0 as f32, CELL.1 as f32);
    let head = "A ball and a drum at five scales, f32: where does the ray to the light start?";
    canvas.label((8.0, top - 30.0), Anchor::Left, 17.0, Color::BLACK, head);
    for (column, start) in COLUMNS.into_iter().enumerate() {
        let x = left + wide * column as f32;
        let text = format!("{}: {}", start.name(), in_short(start));
        canvas.label((x, top - 7.0), Anchor::Left, 13.0, Color::BLACK, &text);
    }
    for (row, scale) in SCALES.into_iter().enumerate() {
        let y = top + high * row as f32 + high / 2.0;
        let text = if scale == 1.0 { "1".to_string() } else { format!("{scale:e}").replace('-', "−") };
        canvas.label((left - 10.0, y), Anchor::Right, 17.0, Color::BLACK, &text);
    }
}

/// What a method does, for the head of its column.
fn in_short(start: Start) -> &'static str {
    match start {
        Start::None => "λ > 0",
        Start::Fixed => "1e−3 skipped",
        Start::Scaled => "2ε |p| skipped",
        Start::Exclude => "not itself again",
        Start::Bound => "beyond its error",
    }
}

/// A ring around the pixel that is explained.
pub(crate) fn ring(canvas: &mut Canvas, (col, row): (u32, u32)) {
    canvas.fit(canvas.size().0 as f32, canvas.size().1 as f32);
    let at = (col as f32 + 0.5, row as f32 + 0.5);
    canvas.circle(at, 6.0, Pen::solid(Color::BLACK, 4.0));
    canvas.circle(at, 6.0, Pen::solid(Color::WHITE, 1.5));
}

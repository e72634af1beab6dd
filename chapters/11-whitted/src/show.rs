//! The transcript: the tree of a pixel's rays, down to the last term, and the rays of the picture.

mod angles;
mod names;
pub(crate) mod of_ray;
mod table;

use bounds::Parts;
use math::Real;
use shading::Rgb;
use signature::Method;
use stage::{Color, Section, Transcript, Value};

use crate::render::Rendered;
use crate::{Counts, Scene, Tree};

pub(crate) use angles::critical_angles;
pub(crate) use names::Names;
use of_ray::ray as of_ray;

/// As text a table of rays ends after so many: six levels of rays that all split in two.
pub(crate) const ROWS: usize = 64;
/// So many rays stand in the text term by term: the eye ray and those that bring most.
const FULL: usize = 6;
/// And so many in JSON.
const MOST: usize = 1024;

/// One pixel of a scene, and its rays.
pub(crate) struct Shot<'a, R: Real> {
    pub(crate) scene: &'a Scene<R>,
    pub(crate) parts: &'a Parts<'a, R>,
    pub(crate) names: &'a Names,
    pub(crate) pixel: (u32, u32),
    /// N, for N × N rays.
    pub(crate) samples: u32,
    pub(crate) srgb: bool,
    /// The rays of the one in the middle.
    pub(crate) tree: &'a Tree<R>,
}

/// A count as a step has it.
pub(crate) fn whole(count: u64) -> Value {
    Value::number(count as f64)
}

/// Red, green and blue.
pub(crate) fn rgb(Rgb(channels): Rgb) -> Value {
    Value::Array(channels.map(Value::number).to_vec())
}

/// The pixel: its ray, what its rays add up to, and its color, that of the `mean` of all rays through it.
pub(crate) fn pixel<R: Real>(transcript: &mut Transcript, method: Method, shot: &Shot<'_, R>, mean: Rgb) {
    let Shot { tree, pixel: (col, row), samples, .. } = *shot;
    let title = format!("whitted · {} · {} · pixel {col},{row}", method.name(), R::NAME);
    let section = transcript.section(title, "CSC418 11.7");
    let Some(eye) = tree.nodes.first() else { return };
    let through = if samples > 1 { "p̄ − ē, p̄ a point of the pixel" } else { "p̄_ij − ē" };
    section.vector::<R>("ē", "the eye", eye.sent.ray.origin).vector::<R>(
        "d⃗_ij",
        through,
        eye.sent.ray.direction,
    );
    if samples > 1 {
        let half = samples / 2 + 1;
        section.note(format!("of {samples} × {samples} rays the one in column {half} and row {half}"));
    }
    let counts = &tree.counts;
    section.step("rays", "that are sent for it", whole(counts.rays())).note(by_kind(counts));
    let all = counts.eye + counts.mirror + counts.refracted;
    let listed = tree.nodes.len() as u64;
    if listed < all {
        section.step("not listed", "rays that Σ w I has and the tables have not", whole(all - listed));
    }
    if counts.left_out > 0 {
        section.step("left out", "rays that are not sent, within the tolerance", whole(counts.left_out));
    }
    let off = |(e, sum): (f64, f64)| if e == sum { 0.0 } else { (e - sum).abs() };
    let off = eye.e.0.into_iter().zip(tree.sum.0).map(off).fold(0.0, f64::max);
    section
        .step("Σ w I", "the contributions of all rays", rgb(tree.sum))
        .step("E", "rayTrace(p̄_ij, d⃗_ij, 1)", rgb(eye.e))
        .note(match off {
            0.0 => "the same sum in another order, and the same number".to_string(),
            off => {
                format!("the same sum in another order: rounding differs by {}", Value::number(off).to_text())
            }
        });
    if samples > 1 {
        section.step("mean", "E of all rays through the pixel, divided by their number", rgb(mean));
    }
    let (Color(bytes), formula) = match shot.srgb {
        true => (Color::from_linear_srgb(mean.0), "round(255 sRGB(E)), E from 0 to 1"),
        false => (Color::from_linear(mean.0), "round(255 E), E from 0 to 1"),
    };
    section.step("pixel", formula, Value::Array(bytes.map(|byte| Value::number(f64::from(byte))).to_vec()));
}

/// How many rays of each kind.
fn by_kind(counts: &Counts) -> String {
    let Counts { eye, shadow, mirror, refracted, .. } = counts;
    format!("{eye} from the eye, {mirror} mirrored, {refracted} refracted, {shadow} to lights")
}

/// The rays of the pixel in tables: where they went, and what they brought.
pub(crate) fn tables<R: Real>(transcript: &mut Transcript, shot: &Shot<'_, R>) {
    table::rays(transcript, shot);
    table::sums(transcript, shot);
}

/// The ray from the eye, term by term.
pub(crate) fn eye_ray<R: Real>(transcript: &mut Transcript, shot: &Shot<'_, R>) {
    if !shot.tree.nodes.is_empty() {
        of_ray(transcript, shot, 0, true);
    }
}

/// The rays of the pixel, in tables and one by one.
pub(crate) fn rays<R: Real>(transcript: &mut Transcript, shot: &Shot<'_, R>) {
    tables(transcript, shot);
    let places = heaviest(shot.tree);
    let (full, most) = (places.len().min(FULL), places.len().min(MOST));
    let mut shown = places[..most].to_vec();
    shown.sort_unstable();
    for place in shown {
        of_ray(transcript, shot, place, places[..full].contains(&place));
    }
    if let Some(section) = transcript.sections.iter_mut().rfind(|section| section.in_text)
        && full < places.len()
    {
        section.remark(format!(
            "The {full} rays that bring most were shown; --format json shows {most} of {} term by term.",
            places.len()
        ));
    }
}

/// The places of the rays: the eye ray's first, then those that bring most by themselves.
fn heaviest<R: Real>(tree: &Tree<R>) -> Vec<usize> {
    let brings = |place: usize| tree.contribution(&tree.nodes[place]).largest();
    let mut places: Vec<usize> = (0..tree.nodes.len()).collect();
    if let Some(others) = places.get_mut(1..) {
        others.sort_by(|&a, &b| brings(b).total_cmp(&brings(a)).then(a.cmp(&b)));
    }
    places
}

/// The rays of the whole picture.
pub(crate) fn counts(transcript: &mut Transcript, rendered: &Rendered, tolerance: Option<f64>) {
    let Counts { eye, shadow, mirror, refracted, left_out, search } = rendered.counts;
    let section: &mut Section = transcript.section("The rays of the picture", "CSC418 11.7");
    section
        .step("eye", "rays from the eye", whole(eye))
        .step("shadow", "rays to lights", whole(shadow))
        .step("mirror", "rays in mirror directions", whole(mirror))
        .step("refracted", "rays through surfaces", whole(refracted))
        .step("rays", "all together", whole(rendered.counts.rays()));
    if let Some(e) = tolerance {
        let formula = format!("rays that are not sent, within {}", Value::number(e).to_text());
        section.step("left out", &formula, whole(left_out));
    }
    section.step("boxes", "tests of boxes", whole(search.boxes)).step(
        "tests",
        "tests of objects",
        whole(search.tests),
    );
    section.note(format!("{} of them hit, nearer than before", search.hits));
}

#[cfg(test)]
mod tests;

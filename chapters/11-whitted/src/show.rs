//! The transcript: the tree of a pixel's rays, down to the last term, and the rays of the picture.

mod of_ray;
mod table;

use bounds::Parts;
use math::Real;
use shading::Rgb;
use signature::Method;
use stage::{Color, Section, Transcript, Value};

use crate::render::Rendered;
use crate::{Counts, Scene, Tree, critical_angle};

pub(crate) use of_ray::ray as of_ray;

/// A table of rays ends after so many, and so many are shown term by term: six levels of rays that all split in two.
pub(crate) const ROWS: usize = 64;

/// One pixel of a scene, and its rays.
pub(crate) struct Shot<'a, R: Real> {
    pub(crate) scene: &'a Scene<R>,
    pub(crate) parts: &'a Parts<'a, R>,
    pub(crate) names: Names,
    pub(crate) pixel: (u32, u32),
    /// N, for N × N rays.
    pub(crate) samples: u32,
    pub(crate) srgb: bool,
    /// The rays of the one in the middle.
    pub(crate) tree: &'a Tree<R>,
}

/// What the objects and the materials of a scene are called.
pub(crate) struct Names {
    objects: Vec<String>,
    materials: Vec<String>,
}

impl Names {
    /// The names as the file has them.
    pub(crate) fn new<R: Real>(file: &scene_file::Scene, scene: &Scene<R>) -> Names {
        let materials: Vec<String> = file.materials.iter().map(|material| material.name.clone()).collect();
        let objects = scene.lit.geometry.objects.iter().zip(&scene.lit.painted).enumerate();
        let objects = objects.map(|(place, (object, painted))| {
            format!("{}, {} of {}", place + 1, object.shape.name(), materials[painted.material])
        });
        Names { objects: objects.collect(), materials }
    }

    /// An object: its place in the file, from 1, its shape and its material.
    pub(crate) fn object(&self, place: usize) -> &str {
        &self.objects[place]
    }

    /// A material.
    pub(crate) fn material(&self, place: usize) -> &str {
        &self.materials[place]
    }
}

/// A count as a step has it.
pub(crate) fn whole(count: u64) -> Value {
    Value::number(count as f64)
}

/// Red, green and blue.
pub(crate) fn rgb(Rgb(channels): Rgb) -> Value {
    Value::Array(channels.map(Value::number).to_vec())
}

/// The pixel: its ray, what its rays add up to, and its color.
pub(crate) fn pixel<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    shot: &Shot<'_, R>,
    rendered: &Rendered,
) {
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
        section.note(format!("the one in the middle of {} × {}, or after it", samples, samples));
    }
    let counts = &tree.counts;
    section.step("rays", "that are sent for it", whole(counts.rays())).note(by_kind(counts));
    if counts.left_out > 0 {
        section.step("left out", "rays that are not sent, within the tolerance", whole(counts.left_out));
    }
    let off = |(e, sum): (f64, f64)| if e == sum { 0.0 } else { (e - sum).abs() };
    let off = eye.e.0.into_iter().zip(tree.sum.0).map(off).fold(0.0, f64::max);
    section
        .step("Σ w I", "the contributions of all rays", rgb(tree.sum))
        .step("E", "rayTrace(p̄_ij, d⃗_ij, 1)", rgb(eye.e))
        .note(format!("the same sum in another order: it differs by {}", Value::number(off).to_text()));
    let mean = rendered.radiance[row as usize * rendered.size.0 as usize + col as usize];
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

/// The rays of the pixel, in tables and one by one.
pub(crate) fn rays<R: Real>(transcript: &mut Transcript, shot: &Shot<'_, R>) {
    table::rays(transcript, shot);
    table::sums(transcript, shot);
    for place in 0..shot.tree.nodes.len().min(ROWS) {
        of_ray(transcript, shot, place);
    }
}

/// θ_c for what lets light through in the scene; with the page's two examples, where they are asked for.
pub(crate) fn critical_angles<R: Real>(
    transcript: &mut Transcript,
    scene: &Scene<R>,
    names: &Names,
    with_examples: bool,
) {
    let mut rows = Vec::new();
    let mut row = |what: &str, n: f64| {
        let angle = critical_angle(n, 1.0).or(critical_angle(1.0, n));
        let from = if n < 1.0 { "outside" } else { "inside" };
        let angle = angle.map_or(Value::text("none"), |angle| Value::number((angle * 1e4).round() / 1e4));
        rows.push(vec![Value::text(what), Value::number(n), angle, Value::text(from)]);
    };
    if with_examples {
        row("water, as on the page", 1.33);
        row("dense flint, the page's glass (slip 28)", 1.8);
    }
    for (place, optics) in scene.optics.iter().enumerate() {
        let is_of = |object: usize| scene.lit.painted[object].material == place && scene.is_solid(object);
        if optics.transmit > 0.0 && (0..scene.lit.painted.len()).any(is_of) {
            row(names.material(place), optics.ior);
        }
    }
    if !rows.is_empty() {
        let section = transcript.section("Critical angles, against the air outside", "CSC418 11.7.3");
        section.table(&["material", "n", "θ_c", "from"], rows);
        section.remark(
            "In degrees: sin θ_c is the smaller index over the larger. Beyond θ_c nothing is refracted.",
        );
    }
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

//! The transcript: one pixel with its bounds, then every method on that pixel, then the picture.

use math::Real;
use signature::Scene;
use stage::{Transcript, Value};

use crate::method::CROSSOVER;
use crate::picture::Cost;
use crate::{Bounded, Counts, Method, Parts};

/// The bounds of the scene and what they save one ray.
pub(crate) fn explain<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    scene: &Scene<R>,
    bounded: &Bounded<'_, R>,
    (col, row): (u32, u32),
) {
    let title = format!("bounds · {} · {} · pixel {col},{row}", method.name(), R::NAME);
    let section = transcript.section(title, "CSC418 11.5");
    let (parts, ray) = (bounded.parts(), scene.ray((col, row)));
    section.step("objects", "in the scene", whole(scene.objects.len())).step(
        "parts",
        "each face of a mesh, every other object",
        whole(parts),
    );
    if method == Method::Auto {
        let required = Method::required(parts).name();
        let why = if parts < CROSSOVER { "fewer than" } else { "no fewer than" };
        section.step("method", "what the scene requires", Value::text(required));
        section.note(format!("{why} {CROSSOVER} parts, from which on it pays"));
    }
    section.vector::<R>("ē", "the eye", ray.origin).vector::<R>("d⃗_ij", "p̄_ij − ē", ray.direction);
    let mut counts = Counts::default();
    let first = bounded.seen((col, row), &mut counts);
    section
        .step("bounds", "tested", whole(counts.boxes))
        .step("tests", "objects tested", whole(counts.tests))
        .note(format!("of {parts}"))
        .step("hits", "tests that hit, nearer than before", whole(counts.hits));
    match first {
        None => {
            section.step("λ_ij", "the smallest λ* ≥ 0", Value::text("none"));
        }
        Some(first) => {
            let object = &scene.objects[first.object];
            section
                .number("λ_ij", "the smallest λ* ≥ 0", first.lambda)
                .note(format!("of object {}, the {}", first.object + 1, object.shape.name()))
                .vector::<R>("r̄(λ_ij)", "ē + λ_ij d⃗_ij", ray.at(first.lambda));
        }
    }
}

/// A count as a step has it.
fn whole(count: impl TryInto<u64>) -> Value {
    Value::number(count.try_into().unwrap_or(u64::MAX) as f64)
}

/// With more to test than this, making all the bounds for one pixel takes longer than the picture.
const MANY: usize = 100_000;

/// The same pixel with every kind of bound: the same object, by other counts.
pub(crate) fn every_method<R: Real>(transcript: &mut Transcript, scene: &Scene<R>, pixel: (u32, u32)) {
    if Parts::of(scene).count() > MANY {
        return;
    }
    let mut rows = Vec::new();
    for method in Method::ALL.into_iter().filter(|method| *method != Method::Auto) {
        let mut counts = Counts::default();
        let first = Bounded::new(scene, method).seen(pixel, &mut counts);
        let (object, lambda) = match first {
            Some(first) => (whole(first.object + 1), Value::number(first.lambda)),
            None => (Value::text("none"), Value::text("none")),
        };
        let Counts { boxes, tests, hits } = counts;
        rows.push(vec![Value::text(method.name()), whole(boxes), whole(tests), whole(hits), object, lambda]);
    }
    let section = transcript.section("The same pixel by every method", "");
    section.table(&["method", "bounds", "tests", "hits", "object", "λ_ij"], rows);
}

/// The picture's counts.
pub(crate) fn picture(transcript: &mut Transcript, cost: &Cost) {
    let (Counts { boxes, tests, hits }, pixels) = (cost.total(), cost.pixels());
    let a_ray = |count: u64| Value::number(hundredths(count as f64 / pixels as f64));
    let (dearest, (col, row)) = cost.dearest();
    let section = transcript.section("The picture: one ray a pixel", "CSC418 11.5");
    section
        .step("rays", "pixels of the picture", whole(pixels))
        .note(format!("{} of them hit", cost.seeing()))
        .step("bounds/ray", "bounds tested a ray", a_ray(boxes))
        .step("tests/ray", "objects tested a ray", a_ray(tests))
        .step("hits/test", "tests that hit", Value::number(hundredths(hits as f64 / tests.max(1) as f64)))
        .step("most", "bounds and objects tested by one ray", whole(dearest.boxes + dearest.tests))
        .note(format!("by the ray of pixel {col},{row}"));
}

/// Rounded to hundredths: more digits of a mean say nothing.
fn hundredths(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}

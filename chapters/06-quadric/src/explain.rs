//! The transcript: one ray against one solid by one method, and then the rays that try the formula.

mod as_printed;
mod slope;
mod tries;

use math::{Degenerate, Ray3, Real, Span};
use stage::{Section, Transcript, Value};

use crate::notes::{Candidate, Fate, Notes};
use crate::robust::{Place, Robust, Verdict};
use crate::{Hit3, Method, Part, Shape, Working};

pub(crate) use as_printed::as_printed;
pub(crate) use slope::along_the_slope;
pub(crate) use tries::tries;

/// The method's own steps, from its own struct; then the hit, its normal and its residual.
pub(crate) fn explain<R: Real>(transcript: &mut Transcript, method: Method, ray: &Ray3<R>, shape: Shape) {
    let [from, along] = [ray.origin, ray.direction].map(|v| Value::vector(v).to_text());
    let (name, solid) = (method.name(), shape.name());
    let source = match method {
        Method::Notes => "CSC418 11.3.5",
        Method::Robust => "robust.rs",
    };
    let title = format!("quadric · {name} · {} · the {solid} · {from} + λ {along}", R::NAME);
    let section = transcript.section(title, source);
    section.vector("ā", "where the ray starts", ray.origin).vector("d⃗", "its direction", ray.direction);
    let work = method.work(ray, shape);
    match &work {
        Working::Notes(work) => notes_steps(section, work),
        Working::Robust(work) => robust_steps(section, work),
    }
    let section = transcript.section("The hit and its normal, ∇f / ‖∇f‖", "CSC418 11.3.5, 11.6");
    hit_steps(section, shape, work.part(), work.hit(Span::ahead()));
}

/// The formulas of A, B and C in the page's symbols.
fn formulas(shape: Shape) -> [&'static str; 3] {
    match shape {
        Shape::Cylinder => ["d_x² + d_y²", "a_x d_x + a_y d_y", "a_x² + a_y² − 1"],
        Shape::Cone => {
            ["d_x² + d_y² − ¼d_z²", "a_x d_x + a_y d_y + ¼(1 − a_z) d_z", "a_x² + a_y² − ¼(1 − a_z)²"]
        }
    }
}

/// The wall's quadratic, the planes, and every candidate.
fn notes_steps<R: Real>(section: &mut Section, work: &Notes<R>) {
    let [a, b, c] = formulas(work.shape);
    section
        .number("A", a, work.a)
        .number("B", b, work.b)
        .number("C", c, work.c)
        .note("A λ² + 2 B λ + C = 0 on the wall")
        .number("D", "B² − A C", work.d)
        .note(decision(work));
    let [first, second, caps @ ..] = work.candidates() else { return };
    if work.a == R::from(0.0) {
        section.step("λ1", "−C / 2B", Value::maybe(first.lambda));
    } else if first.lambda.is_some() {
        section.step("λ1", "−B/A + √D/A", Value::maybe(first.lambda));
        section.step("λ2", "−B/A − √D/A", Value::maybe(second.lambda));
    }
    for cap in caps {
        let symbol = format!("λ_{}", cap.part.name());
        section.step(&symbol, plane_formula(cap.part), Value::maybe(cap.lambda));
        section.note(if cap.lambda.is_none() { "d_z = 0: parallel to the plane" } else { "" });
    }
    let names = ["wall, λ1", "wall, λ2"].into_iter().chain(caps.iter().map(|cap| cap.part.name()));
    let fates = (0..).map(|place| work.fate(place, Span::ahead()));
    let rows = names.zip(work.candidates()).zip(fates);
    let rows = rows.map(|((name, candidate), fate)| row(name, candidate, work.shape, fate)).collect();
    section.table(&["candidate", "λ", "p̄(λ)", "the page's test", "its value", "what becomes of it"], rows);
}

/// λ where a ray crosses the plane of a part; the wall has none.
fn plane_formula(part: Part) -> &'static str {
    match part {
        Part::Wall => "",
        Part::Top | Part::Apex => "(1 − a_z) / d_z",
        Part::Bottom => "(−1 − a_z) / d_z",
        Part::Base => "−a_z / d_z",
    }
}

/// What the coefficients decide.
fn decision<R: Real>(work: &Notes<R>) -> &'static str {
    let zero = R::from(0.0);
    match () {
        _ if work.a == zero && work.b == zero => "A = B = 0: no λ changes f, no root",
        _ if work.a == zero => "A = 0: linear, one root",
        _ if work.d < zero => "< 0: the line does not meet the wall",
        _ if work.d == zero && work.shape == Shape::Cone => {
            "= 0: it touches the wall, or passes through the apex"
        }
        _ if work.d == zero => "= 0: the line touches the wall",
        _ if work.a < zero => "> 0 and A < 0: it meets each half of the double cone once",
        _ => "> 0: the line meets the wall twice",
    }
}

/// One candidate: where it is, how it is tested, and what becomes of it.
fn row<R: Real>(name: &str, candidate: &Candidate<R>, shape: Shape, fate: Fate) -> Vec<Value> {
    let [x, y, z] = R::xyz(candidate.point);
    let (test, value) = match (candidate.part, shape) {
        (Part::Wall, Shape::Cylinder) => ("|z| ≤ 1", z),
        (Part::Wall, Shape::Cone) => ("0 ≤ z ≤ 1", z),
        (_, Shape::Cylinder) => ("x² + y² ≤ 1", x * x + y * y),
        (_, Shape::Cone) => ("x² + y² ≤ ¼", x * x + y * y),
    };
    let [lambda, point, value] = match candidate.lambda {
        Some(lambda) => [Value::number(lambda), Value::vector(candidate.point), Value::number(value)],
        None => ["none", "", ""].map(Value::text),
    };
    vec![Value::text(name), lambda, point, Value::text(test), value, Value::text(fate.meaning())]
}

/// The signs, what they say, and the one λ that is worked out.
fn robust_steps<R: Real>(section: &mut Section, work: &Robust<R>) {
    let [a, b, c] = formulas(work.shape);
    let discriminant = match work.shape {
        Shape::Cylinder => "A − (a_x d_y − a_y d_x)²",
        Shape::Cone => "u² + v² − (a_x d_y − a_y d_x)²",
    };
    let quadratic = work.quadratic();
    section
        .number("A", a, quadratic.a)
        .number("B", &format!("−({b})"), quadratic.b)
        .note("the page's with its sign turned: A λ² − 2 B λ + C = 0")
        .number("C", c, quadratic.c)
        .number("D", discriminant, quadratic.d)
        .note("B² − A C without that difference, which cancels");
    if work.shape == Shape::Cone {
        section.remark(
            "u = ½(a_x d_z + (1 − a_z) d_x) and v, the same with y, are 0 for a line through the apex.",
        );
    }
    section
        .step("verdict", "by signs alone", Value::text(verdict(work.verdict)))
        .note(work.certainty.meaning());
    if let Some(lambda) = work.lambda {
        section.number("λ*", formula(work), lambda).note(work.lambda_certainty.meaning());
    }
}

/// A verdict with its part.
fn verdict(verdict: Verdict) -> String {
    match verdict.part() {
        Some(part) => format!("{}: {}", verdict.meaning(), part.name()),
        None => verdict.meaning().to_string(),
    }
}

/// How λ* is worked out.
fn formula<R: Real>(work: &Robust<R>) -> &'static str {
    let (Place { plane, .. }, root) = match work.verdict {
        Verdict::Misses => return "",
        Verdict::Starts(_) => return "it starts there",
        Verdict::Enters(place) => (place, "(B − √D) / A"),
        Verdict::Leaves(place) => (place, "(B + √D) / A"),
    };
    match plane {
        Some(part) => plane_formula(part),
        None if work.quadratic().a == 0.0 => "C / 2B",
        None => root,
    }
}

/// The hit, the gradient, the normal, and what is left when the point is put back.
fn hit_steps<R: Real>(
    section: &mut Section,
    shape: Shape,
    part: Option<Part>,
    hit: Result<Option<Hit3<R>>, Degenerate>,
) {
    let (Some(part), Ok(Some(hit))) = (part, hit) else {
        section.step("λ*", "the smallest λ ≥ 0", Value::text("none")).note("the ray misses");
        return;
    };
    section.number("λ*", "the smallest λ ≥ 0", hit.t).note(format!("the {}", part.name()));
    section.vector("p̄", "ā + λ* d⃗", hit.point);
    let Some(height) = part.height() else {
        let (gradient, wall) = match shape {
            Shape::Cylinder => ("(x, y, 0)", "x² + y² − 1"),
            Shape::Cone => ("(x, y, ¼(1 − z))", "x² + y² − ¼(1 − z)²"),
        };
        section
            .vector("½∇f", gradient, shape.half_gradient::<R>(hit.point))
            .vector("n⃗", "∇f / ‖∇f‖", hit.normal)
            .number("residual", wall, shape.wall::<R>(hit.point));
        return;
    };
    let note = match part {
        Part::Apex => "the gradient is zero at the apex: up",
        _ => "the plane's, outward",
    };
    let (normal, residual) = match part {
        Part::Bottom => ("(0, 0, −1)", "z + 1"),
        Part::Base => ("(0, 0, −1)", "z"),
        _ => ("(0, 0, 1)", "z − 1"),
    };
    let from_plane = R::xyz(hit.point)[2] - R::from(height);
    section.vector("n⃗", normal, hit.normal).note(note).number("residual", residual, from_plane);
}

//! The transcript: one ray against one triangle by one method, then all of them side by side, then polygons and
//! meshes.

mod meshes;
mod parallel_rays;
mod polygons;
mod side_by_side;

use math::{Degenerate, Parallel, Ray3, Real, Span, Vector};
use stage::{Section, Transcript, Value};

use crate::{HalfPlanes, Hit3, Matrix, Method, Robust, Triangle, Working, scene};

/// Everything that `show` says of a ray against the triangle of the scene.
pub(crate) fn explain<R: Real>(transcript: &mut Transcript, method: Method, ray: &Ray3<R>) {
    let triangle = scene::triangle();
    one_method(transcript, method, ray, &triangle);
    side_by_side::every_method(transcript, ray, &triangle);
    parallel_rays::parallel_rays::<R>(transcript, method);
    side_by_side::determinants(transcript, ray, &triangle);
    polygons::polygons::<R>(transcript);
    meshes::meshes::<R>(transcript, method);
}

/// The method's own steps, from its own struct.
pub(crate) fn one_method<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    ray: &Ray3<R>,
    triangle: &Triangle<R>,
) {
    let [from, along] = [ray.origin, ray.direction].map(|v| Value::vector::<R>(v).to_text());
    let title = format!("triangle · {} · {} · {from} + λ {along}", method.name(), R::NAME);
    let source = if method == Method::Robust { "robust.rs" } else { "CSC418 11.3.1" };
    let section = transcript.section(title, source);
    section
        .vector::<R>("p̄1", "a corner", triangle.p1)
        .vector::<R>("p̄2", "a corner", triangle.p2)
        .vector::<R>("p̄3", "a corner", triangle.p3)
        .vector::<R>("ā", "where the ray starts", ray.origin)
        .note("p̄_ij, on the view plane")
        .vector::<R>("d⃗", "p̄_ij − ē", ray.direction)
        .note("the eye ē is the origin");
    let work = method.work(ray, triangle);
    let crosses = work.parallel().is_none();
    match &work {
        Working::HalfPlanes(work) => half_planes_steps(section, work, crosses),
        Working::Matrix(work) => matrix_steps(section, work, crosses),
        Working::Robust(work) => robust_steps(section, work),
    }
    outcome(section, &work, triangle);
}

/// `crosses`: d⃗ · n⃗ ≠ 0. Where it is 0, what follows from the division by it means nothing.
fn half_planes_steps<R: Real>(section: &mut Section, work: &HalfPlanes<R>, crosses: bool) {
    section
        .vector::<R>("n⃗", "(p̄2 − p̄1) × (p̄3 − p̄1)", plain::<R>(work.n))
        .number("(p̄1 − ā) · n⃗", "the dot product", work.to_p1_dot_n)
        .number("d⃗ · n⃗", "the dot product", work.d_dot_n)
        .note(slope(work.d_dot_n));
    if !crosses {
        return;
    }
    section.number("λ*", "(p̄1 − ā) · n⃗ / d⃗ · n⃗", work.lambda).note(ahead(work.lambda)).vector::<R>(
        "x",
        "r̄(λ*) = ā + λ* d⃗",
        work.x,
    );
    let formulas = ["((p̄2 − p̄1) × (x − p̄1)) · n⃗", "((p̄3 − p̄2) × (x − p̄2)) · n⃗", "((p̄1 − p̄3) × (x − p̄3)) · n⃗"];
    for ((symbol, formula), side) in ["side 1", "side 2", "side 3"].into_iter().zip(formulas).zip(work.sides)
    {
        section.number(symbol, formula, side).note(half_plane(side));
    }
    section.number("n⃗ · n⃗", "what the three sides sum to", work.n_dot_n);
    if let Some((alpha, beta)) = work.alpha_beta() {
        section.number("α", "side 3 / n⃗ · n⃗", alpha).number("β", "side 1 / n⃗ · n⃗", beta);
    }
}

fn matrix_steps<R: Real>(section: &mut Section, work: &Matrix<R>, crosses: bool) {
    section
        .vector::<R>("column 1 of M", "−(p̄2 − p̄1)", plain::<R>(work.m[0]))
        .vector::<R>("column 2 of M", "−(p̄3 − p̄1)", plain::<R>(work.m[1]))
        .vector::<R>("column 3 of M", "d⃗", work.m[2])
        .vector::<R>("b⃗", "p̄1 − ā", work.to_p1)
        .note("M (α, β, λ)ᵀ = b⃗")
        .number("det M", "|−(p̄2 − p̄1)  −(p̄3 − p̄1)  d⃗|", work.det)
        .note(if crosses { "not 0: one solution" } else { "= 0: M has no inverse" })
        .number("det_α", "b⃗ as column 1", work.det_alpha)
        .number("det_β", "b⃗ as column 2", work.det_beta)
        .number("det_λ", "b⃗ as column 3", work.det_lambda);
    if !crosses {
        return;
    }
    let (zero, one) = (R::from(0.0), R::from(1.0));
    let holds = |condition: &str, holds: bool| format!("{condition}{}", if holds { "" } else { ": not so" });
    section
        .number("α", "det_α / det M", work.alpha)
        .note(holds("α ≥ 0", work.alpha >= zero))
        .number("β", "det_β / det M", work.beta)
        .note(holds("β ≥ 0", work.beta >= zero))
        .number("α + β", "the sum", work.alpha + work.beta)
        .note(holds("α + β ≤ 1", work.alpha + work.beta <= one))
        .number("λ", "det_λ / det M", work.lambda)
        .note(holds("λ ≥ 0, which the page leaves out", work.lambda >= zero));
}

fn robust_steps<R: Real>(section: &mut Section, work: &Robust<R>) {
    for (symbol, formula, corner) in [
        ("A", "p̄1 − ā", work.triangle.p1),
        ("B", "p̄2 − ā", work.triangle.p2),
        ("C", "p̄3 − ā", work.triangle.p3),
    ] {
        section.vector::<R>(symbol, formula, plain::<R>(corner - work.ray.origin));
    }
    let [u, v, w] = work.volumes;
    section
        .step("u", "d⃗ · (B × C)", Value::F64(u))
        .note(volume(u, "p̄2p̄3"))
        .step("v", "d⃗ · (C × A)", Value::F64(v))
        .note(volume(v, "p̄3p̄1"))
        .step("w", "d⃗ · (A × B)", Value::F64(w))
        .note(volume(w, "p̄1p̄2"))
        .step("verdict", "the signs of u, v and w", Value::text(passes(work)))
        .note(work.certainty.meaning())
        .step("d⃗ · n⃗", "u + v + w", Value::F64(work.d_dot_n));
    if let Some(lambda) = work.lambda {
        section.number("λ", "(p̄1 − ā) · n⃗ / d⃗ · n⃗", lambda).note(ahead(lambda));
        if let Some((alpha, beta)) = work.alpha_beta() {
            section.number("α", "v / (u + v + w)", alpha).number("β", "w / (u + v + w)", beta);
        }
    }
}

fn slope<R: Real>(d_dot_n: R) -> &'static str {
    match () {
        _ if d_dot_n > R::from(0.0) => "> 0: along n⃗, from behind",
        _ if d_dot_n < R::from(0.0) => "< 0: against n⃗, from in front",
        _ => "= 0: along the plane",
    }
}

fn ahead<R: Real>(lambda: R) -> &'static str {
    if lambda >= R::from(0.0) { "≥ 0: ahead" } else { "< 0: behind the view plane" }
}

fn half_plane<R: Real>(side: R) -> &'static str {
    match () {
        _ if side > R::from(0.0) => "> 0: inside of this edge",
        _ if side < R::from(0.0) => "< 0: outside",
        _ => "= 0: on the edge",
    }
}

fn volume(volume: f64, edge: &str) -> String {
    match () {
        _ if volume > 0.0 => format!("> 0: passes right of {edge}, seen along d⃗"),
        _ if volume < 0.0 => format!("< 0: passes left of {edge}, seen along d⃗"),
        _ => format!("= 0: through the line of {edge}"),
    }
}

fn passes<R: Real>(work: &Robust<R>) -> &'static str {
    match (work.lambda, work.parallel()) {
        (Some(_), _) => "no two differ: through it",
        (None, None) => "two differ: past it",
        (None, Some(_)) => "along the plane",
    }
}

/// The point, its normal and the residual of putting it into the equation of the plane; or why there is none.
fn outcome<R: Real>(section: &mut Section, work: &Working<R>, triangle: &Triangle<R>) {
    match (work.hit(Span::ahead()), work.parallel()) {
        (Ok(Some(hit)), _) => {
            section
                .vector::<R>("x_hit", "ā + λ d⃗", hit.point)
                .vector::<R>("n", "n⃗ / ‖n⃗‖", plain::<R>(hit.normal))
                .number("residual", "(x_hit − p̄1) · n", residual(&hit, triangle));
        }
        (_, how) => {
            let missed = if is_inside(work) { "behind the view plane" } else { "outside of an edge" };
            let why = how.map_or(missed, Parallel::reason);
            section.step("x_hit", "ā + λ d⃗", Value::text("none")).note(why);
        }
    }
}

/// Whether the line of the ray passes through the triangle, by the method's own test.
fn is_inside<R: Real>(work: &Working<R>) -> bool {
    match work {
        Working::HalfPlanes(work) => work.is_inside(),
        Working::Matrix(work) => work.is_inside(),
        Working::Robust(work) => work.lambda.is_some(),
    }
}

/// A vector without minus zeros, which would puzzle a reader.
fn plain<R: Real>(v: R::Vec3) -> R::Vec3 {
    let zero = R::from(0.0);
    v + R::vec3(zero, zero, zero)
}

fn residual<R: Real>(hit: &Hit3<R>, triangle: &Triangle<R>) -> R {
    (hit.point - triangle.p1).dot(hit.normal)
}

/// A hit, or the reason why there is none.
fn verdict<R: Real>(hit: &Result<Option<Hit3<R>>, Degenerate>, parallel: Option<Parallel>) -> &'static str {
    match (hit, parallel) {
        (Ok(Some(_)), _) => "hit",
        (Ok(None), Some(how)) => how.reason(),
        (Ok(None), None) => "miss",
        (Err(degenerate), _) => degenerate.reason(),
    }
}

#[cfg(test)]
mod tests;

//! The transcript: one ray against one deformed object, the page's exercise, the normal, and what a bad condition
//! costs.

mod condition;
mod steps;
mod table;

use lab::angle;
use math::{Ray3, Real, Span, Vector, Wide};
use stage::{Section, Transcript, Value};

use crate::scene::Placed;
use crate::{Deformed, Found, Matrix3, Method};

pub(crate) use condition::condition;
pub(crate) use table::{five_rays, one_ray};

/// The method's own steps, from its own struct; then what can be said of the hit, if there is one.
pub(crate) fn explain<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    ray: &Ray3<R>,
    placed: &Placed<R>,
) {
    let deformed = &placed.deformed;
    let [from, along] = [ray.origin, ray.direction].map(|v| Value::vector::<R>(v).to_text());
    let title = format!("affine · {} · {} · {from} + λ {along}", method.name(), R::NAME);
    let source = match method {
        Method::Notes => "CSC418 11.3.4",
        Method::Solved => "CSC418 11.3.4, solved.rs",
        Method::Robust => "robust.rs",
    };
    let section = transcript.section(title, source);
    section
        .step("f", "the object in its own space", Value::text(equation(deformed)))
        .note(format!("the {}, {}", placed.name, placed.what));
    rows(section, "A", "ȳ = A x̄ + t⃗, by rows", &deformed.affine.a);
    section.vector::<R>("t⃗", "where its own origin goes", deformed.affine.t);
    let work = method.work(ray, deformed);
    steps::of(section, &work);

    let Ok(Some(found)) = work.found(Span::ahead()) else {
        let why = work.parallel().map_or("no root ≥ 0", |how| how.reason());
        section.step("λ*", "the smallest root ≥ 0", Value::text("none")).note(why);
        return;
    };
    section.number("λ*", "the smallest root ≥ 0", found.lambda).note("the same in both spaces");
    both_ways(transcript, method, ray, &found, deformed);
    normals(transcript, &found, deformed);
}

/// The object before it is deformed: f(x̄) = 0.
fn equation<R: Real>(deformed: &Deformed<R>) -> &'static str {
    use crate::Object::{Cone, Cylinder, Plane, Sphere, Triangle};
    match deformed.object {
        Sphere => "x² + y² + z² − 1 = 0",
        Cylinder => "x² + y² − 1 = 0 for |z| ≤ 1, and two caps",
        Cone => "x² + y² − ¼(1 − z)² = 0 for 0 ≤ z ≤ 1, and a base",
        Plane => "z = 0",
        Triangle => "z = 0 for x ≥ 0, y ≥ 0, x + y ≤ 1",
    }
}

/// A matrix, a row a step.
fn rows<R: Real>(section: &mut Section, symbol: &str, formula: &str, matrix: &Matrix3<R>) {
    for (i, row) in matrix.rows().into_iter().enumerate() {
        let [symbol, formula] = if i == 0 { [symbol, formula] } else { ["", ""] };
        section.step(symbol, formula, Value::Array(row.map(|x| Value::number(x + R::from(0.0))).to_vec())); // minus zero is zero
    }
}

/// "Exercise: Verify that, at the solution λ*, r̄(λ*) = A r̄′(λ*) + t⃗."
fn both_ways<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    ray: &Ray3<R>,
    found: &Found<R>,
    deformed: &Deformed<R>,
) {
    let both = found.verify(ray, deformed);
    let [x, y, difference] = [both.along_the_ray, both.through_the_object, both.difference].map(plain::<R>);
    let how = if method == Method::Robust { "from d″ and w" } else { "ā′ + λ* d⃗′" };
    transcript
        .section("The exercise: verify that r̄(λ*) = A r̄′(λ*) + t⃗", "CSC418 11.3.4")
        .vector::<R>("r̄′(λ*)", how, plain::<R>(found.p))
        .note("on the undeformed object")
        .vector::<R>("r̄(λ*)", "ā + λ* d⃗", x)
        .vector::<R>("ȳ", "A r̄′(λ*) + t⃗", y)
        .vector::<R>("difference", "ȳ − r̄(λ*)", difference)
        .note(if difference.is_zero() { "the same" } else { "the same on paper" });
}

/// 11.6.1: the tangent plane goes with the object, the normal does not go with A.
fn normals<R: Real>(transcript: &mut Transcript, found: &Found<R>, deformed: &Deformed<R>) {
    let a = &deformed.affine.a;
    let [n, deformed_n] = [found.n, found.a_inverse_transposed_n].map(plain::<R>);
    let [right, wrong] = [found.normal(), found.wrong_normal(deformed)].map(plain::<R>);
    let v = plain::<R>(tangent::<R>(n));
    let a_v = plain::<R>(a.times(v));
    transcript
        .section("The normal: A⁻ᵀ n⃗, and not A n⃗", "CSC418 11.6.1, Eq. (2)")
        .vector::<R>("n⃗", "of the undeformed object at r̄′(λ*)", n)
        .vector::<R>("A⁻ᵀ n⃗", "the plane's normal in (5)", deformed_n)
        .vector::<R>("A⁻ᵀ n⃗/‖A⁻ᵀ n⃗‖", "(2)", right)
        .note(side(deformed))
        .vector::<R>("A n⃗/‖A n⃗‖", "n⃗ deformed like a step", wrong)
        .note("not a normal")
        .step("∠", "between the two, in degrees", degrees::<R>(right, wrong))
        .vector::<R>("v⃗", "a step along the undeformed object", v)
        .note("n⃗ · v⃗ = 0")
        .vector::<R>("A v⃗", "the same step along the deformed one", a_v)
        .number("A⁻ᵀ n⃗ · A v⃗", "= n⃗ · A⁻¹ A v⃗ = n⃗ · v⃗", deformed_n.dot(a_v) + R::from(0.0))
        .note("0 on paper: at right angles")
        .number("A n⃗ · A v⃗", "= n⃗ · Aᵀ A v⃗", a.times(n).dot(a_v) + R::from(0.0))
        .remark("The last is zero for every n⃗ and v⃗ only where A does no more than turn, mirror and scale alike in all directions.");
}

/// To which side the normal points.
fn side<R: Real>(deformed: &Deformed<R>) -> &'static str {
    match () {
        _ if deformed.object.is_flat() => "to the side where z was above 0",
        _ if deformed.affine.a.determinant() < R::from(0.0) => "outward, though A mirrors",
        _ => "outward",
    }
}

/// A step at right angles to n: n × e for the axis e that n is least along.
fn tangent<R: Real>(n: R::Vec3) -> R::Vec3 {
    let [x, y, z] = R::xyz(n).map(|x| if x < R::from(0.0) { -x } else { x });
    let (zero, one) = (R::from(0.0), R::from(1.0));
    let axis = match () {
        _ if x <= y && x <= z => R::vec3(one, zero, zero),
        _ if y <= z => R::vec3(zero, one, zero),
        _ => R::vec3(zero, zero, one),
    };
    R::cross(axis, n)
}

/// Minus zero is zero, for a reader.
fn plain<R: Real>(v: R::Vec3) -> R::Vec3 {
    let zero = R::from(0.0);
    v + R::vec3(zero, zero, zero)
}

/// The angle between two vectors, to a tenth of a degree.
fn degrees<R: Real>(u: R::Vec3, v: R::Vec3) -> Value {
    let [u, v] = [u, v].map(Wide::vector::<R, 3>);
    angle(u, v)
        .map_or(Value::text("none"), |radians| Value::F64((radians.to_degrees() * 10.0).round() / 10.0))
}

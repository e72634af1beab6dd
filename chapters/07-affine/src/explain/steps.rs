//! Each method's own steps, up to the roots.

use math::{Real, Span};
use quadric::robust::{Place, Verdict};
use quadric::{Part, Shape};
use ray_sphere::HalfQuadratic;
use stage::{Section, Value};

use super::rows;
use crate::undeformed::Level;
use crate::{Notes, Object, Robust, Solved, Undeformed, Working};

/// What the method did, from its own struct.
pub(super) fn of<R: Real>(section: &mut Section, work: &Working<'_, R>) {
    match work {
        Working::Notes(work) => notes(section, work),
        Working::Solved(work) => solved(section, work),
        Working::Robust(work) => robust(section, work),
    }
}

fn notes<R: Real>(section: &mut Section, work: &Notes<'_, R>) {
    rows(section, "A⁻¹", "adj A / det A, stored", &work.deformed.inverse);
    section
        .vector::<R>("ā − t⃗", "", work.a_minus_t)
        .vector::<R>("ā′", "A⁻¹(ā − t⃗)", work.ray_prime.origin)
        .vector::<R>("d⃗′", "A⁻¹ d⃗", work.ray_prime.direction)
        .note("not of length 1, and not made so: λ would change");
    undeformed(section, &work.undeformed);
}

fn solved<R: Real>(section: &mut Section, work: &Solved<'_, R>) {
    let eliminated = &work.eliminated;
    section.vector::<R>("ā − t⃗", "", work.a_minus_t);
    for (i, row) in eliminated.u.into_iter().enumerate() {
        let [symbol, formula] = if i == 0 { ["U", "A, eliminated"] } else { ["", ""] };
        let equation = eliminated.order[i] + 1;
        section
            .step(symbol, formula, Value::Array(row.map(Value::number).to_vec()))
            .note(format!("from equation {equation}, pivot {}", Value::number(row[i]).to_text()));
    }
    let [a, d] = eliminated.b.map(|b| Value::Array(b.map(Value::number).to_vec()));
    section
        .step("b_a", "ā − t⃗, treated alike", a)
        .step("b_d", "d⃗, treated alike", d)
        .vector::<R>("ā′", "U ā′ = b_a, from the last row up", work.ray_prime.origin)
        .vector::<R>("d⃗′", "U d⃗′ = b_d", work.ray_prime.direction)
        .note("not of length 1, and not made so: λ would change");
    undeformed(section, &work.undeformed);
}

/// The object's own method for the ray ā′ + λ d⃗′.
fn undeformed<R: Real>(section: &mut Section, work: &Undeformed<R>) {
    match work {
        Undeformed::Sphere(work) => sphere(section, work),
        Undeformed::Plane(level) => plane(section, level),
        Undeformed::Triangle(level) => {
            plane(section, level);
            let [alpha, beta, _] = R::xyz(level.p);
            section
                .number("α", "x of r̄′(λ)", alpha)
                .number("β", "y of r̄′(λ)", beta)
                .number("α + β", "", alpha + beta)
                .note(if level.is_in_triangle() { "all within: a hit" } else { "outside" });
        }
        Undeformed::Solid(work) => solid(section, work),
    }
}

/// 11.3.3 with primes, for A is taken.
fn sphere<R: Real>(section: &mut Section, work: &HalfQuadratic<R>) {
    let zero = R::from(0.0);
    let decision = match () {
        _ if work.d > zero => "> 0: two intersections",
        _ if work.d == zero => "= 0: the ray grazes the sphere",
        _ => "< 0: no intersections",
    };
    section
        .number("A′", "d⃗′ · d⃗′", work.a)
        .number("B′", "ā′ · d⃗′", work.b)
        .number("C′", "ā′ · ā′ − 1", work.c)
        .note("f(ā′ + λ d⃗′) = A′ λ² + 2 B′ λ + C′ = 0")
        .number("D′", "B′² − A′ C′", work.d)
        .note(decision);
    if work.lambda_1.is_some() {
        section.step("λ1", "−B′/A′ + √D′/A′", Value::maybe(work.lambda_1)).step(
            "λ2",
            "−B′/A′ − √D′/A′",
            Value::maybe(work.lambda_2),
        );
    }
}

/// 11.3.5: the wall and the planes, every candidate with what becomes of it.
fn solid<R: Real>(section: &mut Section, work: &quadric::Notes<R>) {
    let [a, b, c] = match work.shape {
        Shape::Cylinder => ["d′_x² + d′_y²", "a′_x d′_x + a′_y d′_y", "a′_x² + a′_y² − 1"],
        Shape::Cone => [
            "d′_x² + d′_y² − ¼ d′_z²",
            "a′_x d′_x + a′_y d′_y + ¼(1 − a′_z) d′_z",
            "a′_x² + a′_y² − ¼(1 − a′_z)²",
        ],
    };
    section
        .number("A′", a, work.a)
        .number("B′", b, work.b)
        .number("C′", c, work.c)
        .note("the wall: A′ λ² + 2 B′ λ + C′ = 0")
        .number("D′", "B′² − A′ C′", work.d);
    let zero = R::from(0.0);
    section.note(match () {
        _ if work.a == zero => "A′ = 0: linear, one root or none",
        _ if work.d > zero => "> 0: the line meets the wall twice",
        _ if work.d == zero => "= 0: the line touches the wall",
        _ => "< 0: the line does not meet the wall",
    });
    let roots = match work.a == zero {
        true => ["−C′ / 2B′", ""],
        false => ["−B′/A′ + √D′/A′", "−B′/A′ − √D′/A′"],
    };
    for (place, candidate) in work.candidates().iter().enumerate() {
        let (symbol, formula) = match candidate.part {
            Part::Wall if place == 0 => ("λ1", roots[0]),
            Part::Wall => ("λ2", roots[1]),
            Part::Top | Part::Apex => ("λ_top", "(1 − a′_z) / d′_z"),
            Part::Bottom => ("λ_bottom", "(−1 − a′_z) / d′_z"),
            Part::Base => ("λ_base", "−a′_z / d′_z"),
        };
        section
            .step(symbol, formula, Value::maybe(candidate.lambda))
            .note(work.fate(place, Span::ahead()).meaning());
    }
}

fn plane<R: Real>(section: &mut Section, level: &Level<R>) {
    section.number("λ", "−a′_z / d′_z", level.lambda).vector::<R>("r̄′(λ)", "ā′ + λ d⃗′", level.p);
}

fn robust<R: Real>(section: &mut Section, work: &Robust<'_, R>) {
    let vector = |v: [f64; 3]| Value::Array(v.map(|x| Value::F64(x + 0.0)).to_vec()); // minus zero is zero
    let (adjugate, s) = work.adjugate();
    for (i, row) in adjugate.into_iter().enumerate() {
        let [symbol, formula] = if i == 0 { ["adj A", "times the sign of det A, by rows"] } else { ["", ""] };
        section.step(symbol, formula, vector(row));
    }
    let steps = &work.steps;
    section
        .step("s", "|det A|", Value::F64(s))
        .note("nothing is divided by it")
        .step("o″", "adj A (ā − t⃗) sgn det A", vector(steps.o))
        .step("d″", "adj A d⃗ sgn det A", vector(steps.d))
        .note("the ray beside the unit object at scale s")
        .step("w", "Aᵀ ((ā − t⃗) × d⃗)", vector(steps.w))
        .note("the line's moment: o″ × d″ = det A w");
    if let Some([a, b, c, d]) = steps.quadratic {
        let [a_formula, b_formula, c_formula, d_formula] = coefficients(work.deformed.object);
        section
            .step("A″", a_formula, Value::F64(a))
            .step("B″", b_formula, Value::F64(b))
            .step("C″", c_formula, Value::F64(c))
            .note("A″ λ² − 2 B″ λ + C″ = 0")
            .step("D″", d_formula, Value::F64(d));
    }
    if work.deformed.object == Object::Triangle {
        let sign = if work.deformed.affine.a.determinant() < R::from(0.0) { -1.0 } else { 1.0 };
        section.step("α", "−w_y / d″_z sgn det A", Value::F64(-sign * steps.w[1] / steps.d[2])).step(
            "β",
            "w_x / d″_z sgn det A",
            Value::F64(sign * steps.w[0] / steps.d[2]),
        );
    }
    section.step("verdict", "by signs alone", Value::text(verdict(work))).note(steps.certainty.meaning());
    if let Some(first) = work.first {
        section.number("λ", lambda_formula(work), first.lambda).note(steps.lambda_certainty.meaning());
    }
}

/// The quadratic's coefficients at scale s. D″ is written so that nothing large cancels.
fn coefficients(object: Object) -> [&'static str; 4] {
    match object {
        Object::Cylinder => {
            ["d″_x² + d″_y²", "−(o″_x d″_x + o″_y d″_y)", "o″_x² + o″_y² − s²", "s² (d″_x² + d″_y² − w_z²)"]
        }
        Object::Cone => [
            "d″_x² + d″_y² − ¼ d″_z²",
            "−(o″_x d″_x + o″_y d″_y + ¼(s − o″_z) d″_z)",
            "o″_x² + o″_y² − ¼(s − o″_z)²",
            "s² (¼((w_x + d″_y)² + (w_y − d″_x)²) − w_z²)",
        ],
        Object::Sphere | Object::Plane | Object::Triangle => {
            ["d″ · d″", "−o″ · d″", "o″ · o″ − s²", "s² (d″ · d″ − w · w)"]
        }
    }
}

/// What becomes of the ray. (In chapter 06's words a flat object is all base.)
fn verdict<R: Real>(work: &Robust<'_, R>) -> String {
    let by = |part: Part| match work.deformed.object {
        Object::Cylinder | Object::Cone => format!(" by the {}", part.name()),
        Object::Sphere | Object::Plane | Object::Triangle => String::new(),
    };
    match work.verdict {
        Verdict::Misses => "misses".to_string(),
        Verdict::Starts(_) => "starts on the surface".to_string(),
        Verdict::Enters(_) | Verdict::Leaves(_) if work.deformed.object.is_flat() => "hits".to_string(),
        Verdict::Enters(Place { part, .. }) => format!("enters{}", by(part)),
        Verdict::Leaves(Place { part, .. }) => format!("leaves{}", by(part)),
    }
}

fn lambda_formula<R: Real>(work: &Robust<'_, R>) -> &'static str {
    match work.verdict {
        Verdict::Misses | Verdict::Starts(_) => "0",
        Verdict::Enters(Place { plane: Some(part), .. })
        | Verdict::Leaves(Place { plane: Some(part), .. }) => match part.height() {
            Some(height) if height > 0.0 => "(s − o″_z) / d″_z",
            Some(height) if height < 0.0 => "(−s − o″_z) / d″_z",
            _ => "−o″_z / d″_z",
        },
        Verdict::Enters(_) => "(B″ − √D″) / A″ = C″ / (B″ + √D″)",
        Verdict::Leaves(_) => "(B″ + √D″) / A″ = C″ / (B″ − √D″)",
    }
}

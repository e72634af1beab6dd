//! Rays that try the formula, each by both methods.

use lab::{Subject, Truth};
use math::{Ray3, Real, Span, Vector};
use stage::{Precision, Section, Transcript, Value};

use crate::stage::Quadric;
use crate::{Method, Shape, notes};

/// A name, an origin and a direction.
type Try = (&'static str, [f64; 3], [f64; 3]);

/// Rays at the cylinder.
const CYLINDER: [Try; 7] = [
    ("along the axis", [0.5, 0.0, 3.0], [0.0, 0.0, -1.0]),
    ("beside it", [1.5, 0.0, 3.0], [0.0, 0.0, -1.0]),
    ("along a line of the wall", [1.0, 0.0, 3.0], [0.0, 0.0, -1.0]),
    ("from inside", [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
    ("grazing the wall", [1.0, -2.0, 0.0], [0.0, 1.0, 0.0]),
    ("grazing the rim", [0.0, 0.0, 2.0], [1.0, 0.0, -1.0]),
    ("in the top's plane", [-2.0, 0.0, 1.0], [1.0, 0.0, 0.0]),
];

/// Rays at the cone.
const CONE: [Try; 11] = [
    ("along the slope", [-0.5, 0.0, 1.0], [1.0, 0.0, -2.0]),
    ("down the slope, on it", [0.0, 0.0, 1.0], [1.0, 0.0, -2.0]),
    ("down through the other half", [-0.25, 0.0, 3.0], [0.0, 0.0, -1.0]),
    ("down to the apex", [0.0, 0.0, 3.0], [0.0, 0.0, -1.0]),
    ("across the apex", [-1.0, 0.0, 1.0], [1.0, 0.0, 0.0]),
    ("toward the apex, in tenths", [-0.1, -0.1, 1.4], [0.1, 0.1, -0.4]),
    ("in tenths, flatter", [-0.2, -0.1, 1.2], [0.2, 0.1, -0.2]),
    ("from inside", [0.0, 0.0, 0.25], [1.0, 0.0, 0.0]),
    ("grazing the rim", [1.0, 0.0, 0.5], [-1.0, 0.0, -1.0]),
    ("up through the base", [0.25, 0.0, -1.0], [0.0, 0.0, 1.0]),
    ("in the base's plane", [-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
];

/// The two tables. The last column is the oracle's, which is no method: it works in whole numbers of any length.
pub(crate) fn tries<R: Real>(transcript: &mut Transcript, precision: Precision) {
    table::<R>(transcript, precision, Shape::Cylinder, &CYLINDER)
        .remark("Along the axis A = B = 0: the wall has no root, and the caps decide. So along a line of the wall.")
        .remark("At the rim z = 1 and x² + y² = 1. With < in both tests, wall and cap both say no: the ray slips through.");
    table::<R>(transcript, precision, Shape::Cone, &CONE)
        .remark("Along the slope A = 0. On it C = B = 0 as well: every λ is a root, and the formula has none.")
        .remark("A < 0: steeper than the slope, so that one root is on the other half of the double cone, z > 1.")
        .remark("A tenth is rounded, so these rays pass close to the apex. D ≈ 0 has lost the digits that say on which side.");
}

fn table<'a, R: Real>(
    transcript: &'a mut Transcript,
    precision: Precision,
    shape: Shape,
    tries: &[Try],
) -> &'a mut Section {
    let rows = tries.iter().map(|&(name, origin, direction)| {
        let vector = |[x, y, z]: [f64; 3]| R::vec3(R::round_from(x), R::round_from(y), R::round_from(z));
        let ray = Ray3::<R>::new(vector(origin), vector(direction));
        let work = notes(&ray, shape);
        let given = [Value::text(name), Value::vector(ray.origin), Value::vector(ray.direction)];
        let numbers = [work.a, work.d].map(Value::number);
        let answers = Method::ALL.map(|method| Value::text(answer(method, &ray, shape)));
        given.into_iter().chain(numbers).chain(answers).chain([exactly(&ray, shape, precision)]).collect()
    });
    let title = format!("Rays that try the formula: the {}", shape.name());
    transcript
        .section(title, "CSC418 11.3.5")
        .table(&["a ray", "ā", "d⃗", "A", "D", "by notes", "by robust", "exactly"], rows.collect())
}

/// The part and λ, or a miss.
fn answer<R: Real>(method: Method, ray: &Ray3<R>, shape: Shape) -> String {
    let work = method.work(ray, shape);
    match (work.part(), work.hit(Span::ahead())) {
        (Some(part), Ok(Some(hit))) => format!("{}, λ = {}", part.name(), Value::number(hit.t).to_text()),
        _ => "misses".to_string(),
    }
}

/// The true λ, rounded once.
fn exactly<R: Real>(ray: &Ray3<R>, shape: Shape, precision: Precision) -> Value {
    let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.in_f64(), ray.direction.in_f64());
    let place = if shape == Shape::Cylinder { 0.0 } else { 1.0 };
    match Quadric.truth([ox, oy, oz, dx, dy, dz, place], precision) {
        Truth::Hit { t, .. } => Value::number(R::round_from(t.nearest)),
        Truth::Miss(_) => Value::text("misses"),
        Truth::Invalid(reason) => Value::text(reason),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::notes::Test;

    fn ray((_, origin, direction): Try) -> Ray3<f64> {
        Ray3::new(origin.into(), direction.into())
    }

    fn found(name: &str, tries: &[Try]) -> Ray3<f64> {
        ray(*tries.iter().find(|(other, ..)| *other == name).unwrap())
    }

    /// Slip 24: z ≤ 1 "or z < 1" for the wall, and x² + y² < 1 for the cap.
    #[test]
    fn as_printed_with_less_than_a_ray_slips_through_the_rim() {
        // by hand: (λ, 0, 2 − λ) meets the cylinder in (1, 0, 1) alone
        let work = notes(&found("grazing the rim", &CYLINDER), Shape::Cylinder);
        let kept: Vec<_> =
            work.candidates().iter().filter(|candidate| candidate.test == Test::OnSurface).collect();
        assert_eq!(kept.len(), 2, "with ≤ the wall and the top both have it");
        for candidate in kept {
            let [x, y, z] = f64::xyz(candidate.point);
            assert_eq!((candidate.lambda, x, y, z), (Some(1.0), 1.0, 0.0, 1.0));
            let (on_wall, on_cap) = (-1.0 < z && z < 1.0, x * x + y * y < 1.0);
            assert!(!on_wall && !on_cap, "with < neither has");
        }
    }

    #[test]
    fn robust_is_exact_where_the_formula_is_tried() {
        for (shape, tries) in [(Shape::Cylinder, CYLINDER.as_slice()), (Shape::Cone, CONE.as_slice())] {
            for &each in tries {
                let truth = exactly(&ray(each), shape, Precision::F64).to_text();
                let said = answer(Method::Robust, &ray(each), shape);
                let is_exact = said == truth || said.ends_with(&format!("λ = {truth}"));
                assert!(is_exact, "{}: {said}, exactly {truth}", each.0);
            }
        }
    }

    #[test]
    fn the_formula_fails_at_the_apex_and_down_the_slope() {
        // by hand: the first runs down to z = 0 at λ = 1.4/0.4, where x = y = 0.25: within the base
        let by_notes = |name| answer(Method::Notes, &found(name, &CONE), Shape::Cone);
        assert_eq!(by_notes("toward the apex, in tenths"), "base, λ = 3.4999999999999996");
        assert_eq!(by_notes("in tenths, flatter"), "misses");
        assert_eq!(by_notes("down the slope, on it"), "base, λ = 0.5");
    }
}

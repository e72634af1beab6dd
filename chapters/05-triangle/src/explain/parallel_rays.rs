//! The page's two questions about d⃗ · n⃗ = 0.

use math::{Ray3, Real, Span};
use stage::{Transcript, Value};

use super::verdict;
use crate::{Method, half_planes, scene};

/// 2^−20: how little the last of the rays leans toward the plane.
const LEAN: f32 = 1.0 / (1 << 20) as f32;

/// Rays against the triangle of the worked example, n⃗ = (0, 8, 12): a name, ā and d⃗.
const RAYS: [(&str, [f32; 3], [f32; 3]); 8] = [
    ("through it", [0.0, 0.5, -2.0], [0.0, 0.0, -1.0]),
    ("through it, from behind", [0.0, 0.5, -6.0], [0.0, 0.0, 1.0]),
    ("away from it", [0.0, 0.5, -2.0], [0.0, 0.0, 1.0]),
    ("beside its plane", [-4.0, 0.0, -1.0], [1.0, 0.0, 0.0]),
    ("in its plane, across it", [-4.0, 0.5, -4.0], [1.0, 0.0, 0.0]),
    ("in its plane, along an edge", [-4.0, -1.0, -3.0], [1.0, 0.0, 0.0]),
    ("in its plane, past it", [-4.0, 5.0, -7.0], [1.0, 0.0, 0.0]),
    ("all but parallel", [-1.0, 0.5, -4.0 + LEAN], [1.0, 0.0, -LEAN]),
];

/// "What does it mean when d⃗ · n⃗ = 0? What does it mean when d⃗ · n⃗ = 0 and (p̄1 − ā) · n⃗ = 0?" With cases.
pub(crate) fn parallel_rays<R: Real>(transcript: &mut Transcript, method: Method) {
    let triangle = scene::triangle::<R>();
    let rows = RAYS.map(|(name, origin, direction)| {
        let [origin, direction] = [origin, direction].map(|[x, y, z]| R::vec3(x.into(), y.into(), z.into()));
        let ray = Ray3::<R>::new(origin, direction);
        let printed = half_planes(&ray, &triangle);
        let work = method.work(&ray, &triangle);
        let quotient = match printed.d_dot_n == R::from(0.0) {
            true => Value::text(format!("{} / 0", Value::number(printed.to_p1_dot_n).to_text())),
            false => Value::number(printed.lambda),
        };
        let verdict = verdict(&work.hit(Span::ahead()), work.parallel());
        let numbers = [printed.to_p1_dot_n, printed.d_dot_n].map(Value::number);
        [Value::text(name)].into_iter().chain(numbers).chain([quotient, Value::text(verdict)]).collect()
    });
    transcript
        .section("What does it mean when d⃗ · n⃗ = 0? And when (p̄1 − ā) · n⃗ = 0 as well?", "CSC418 11.3.1")
        .table(&["a ray", "(p̄1 − ā) · n⃗", "d⃗ · n⃗", "λ* as printed", "verdict"], rows.to_vec())
        .remark("d⃗ · n⃗ = 0: n⃗ is at right angles to the plane, so the ray runs along it. λ* is divided by zero, and no λ solves it.")
        .remark("Both zero: the ray lies in the plane. Every λ solves it; the ray meets the triangle nowhere or along a stretch, edge-on.")
        .remark("Both are misses here, with a reason. A ray that leans ever so little is not parallel: = 0 is decided exactly.");
}

//! All five objects side by side: for the ray that is explained, and each hit by a ray of its own.

use math::{Ray3, Real, Span, Vector};
use stage::{Transcript, Value};

use super::{degrees, plain};
use crate::Method;
use crate::scene::{Placed, first};

/// What the ray that is explained does to each of the five.
pub(crate) fn one_ray<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    ray: &Ray3<R>,
    objects: &[Placed<R>],
) {
    let rows = objects.iter().map(|placed| {
        let deformed = &placed.deformed;
        let work = method.work(ray, deformed);
        let name = [Value::text(placed.name), Value::text(placed.what)];
        let none = || Value::text("none");
        let values = match work.found(Span::ahead()) {
            Ok(Some(found)) => [Value::number(found.lambda), Value::vector::<R>(plain::<R>(found.p))],
            _ => [none(), none()],
        };
        name.into_iter().chain(values).collect()
    });
    let columns = ["object", "its deformation", "λ*", "r̄′(λ*)"];
    let section = transcript.section("The five deformed objects against this ray", "CSC418 11.3.4");
    section.table(&columns, rows.collect());
    section.remark(match first(method, ray, objects) {
        Some((placed, found)) => {
            format!("first: the {}, at λ* = {}", placed.name, Value::number(found.lambda).to_text())
        }
        None => "first: none".to_string(),
    });
}

/// Each of the five hit by a ray of its own, aimed from the eye at a known point of it: on paper λ* = 1.
pub(crate) fn five_rays<R: Real>(
    transcript: &mut Transcript,
    method: Method,
    eye: R::Vec3,
    objects: &[Placed<R>],
) {
    let rows = objects.iter().map(|placed| {
        let deformed = &placed.deformed;
        let [x, y, z] = placed.seen.map(R::round_from);
        let aim = R::vec3(x, y, z);
        let ray = Ray3::<R>::new(eye, deformed.affine.apply(aim) - eye);
        let start = vec![
            Value::text(placed.name),
            Value::number(deformed.affine.a.determinant()),
            Value::vector::<R>(aim),
        ];
        let none = || Value::text("none");
        let rest = match method.work(&ray, deformed).found(Span::ahead()) {
            Ok(Some(found)) => {
                let difference: f64 = found.verify(&ray, deformed).difference.length().into();
                let (right, wrong) = (plain::<R>(found.normal()), found.wrong_normal(deformed));
                [
                    Value::number(found.lambda),
                    one_digit(difference),
                    Value::vector::<R>(right),
                    degrees::<R>(right, wrong),
                ]
            }
            _ => [none(), none(), none(), none()],
        };
        start.into_iter().chain(rest).collect()
    });
    let columns = ["object", "det A", "aimed at x̄", "λ*", "‖A r̄′ + t⃗ − r̄‖", "A⁻ᵀ n⃗/‖A⁻ᵀ n⃗‖", "∠ to A n⃗, °"];
    transcript
        .section("Five rays d⃗ = A x̄ + t⃗ − ē, one aimed at each: λ* = 1 on paper", "CSC418 11.3.4, 11.6.1")
        .table(&columns, rows.collect())
        .remark("The cone is mirrored, det A < 0: its normal by A⁻ᵀ n⃗ still points outward.")
        .remark("Of the plane and the triangle A n⃗ is the third column of A, which they do not feel at all.");
}

/// A small number for a reader, to one digit.
fn one_digit(x: f64) -> Value {
    Value::F64(format!("{x:.0e}").parse().unwrap_or(x))
}

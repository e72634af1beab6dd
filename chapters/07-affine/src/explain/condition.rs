//! The same sphere, squashed more and more: what is left of λ*.

use lab::oracle::{self, UnitObject};
use lab::{Truth, ulps};
use math::{Ray3, Real, Span, Vector, portable};
use stage::{Precision, Transcript, Value};

use crate::scene::{into_the_squashed, squashed_by};
use crate::{Affine, Deformed, Method, Object};

/// λ* at growing condition by every method, beside the exact one, and how many digits it loses.
pub(crate) fn condition<R: Real>(transcript: &mut Transcript) {
    let mut lambdas = Vec::new();
    let mut lost = Vec::new();
    for power in (0..).step_by(2) {
        let condition: f64 = format!("1e{power}").parse().unwrap_or(f64::INFINITY);
        if condition > most::<R>() {
            break;
        }
        let (ray, affine) = (into_the_squashed::<R>(condition), squashed_by::<R>(condition));
        let Ok(deformed) = Deformed::new(Object::Sphere, affine) else { break };
        let found = Method::ALL.map(|method| {
            let found = method.work(&ray, &deformed).found(Span::ahead());
            found.ok().flatten().map(|found| found.lambda)
        });
        let exact = match truth(&ray, &affine) {
            Truth::Hit { t, .. } => Some(t.nearest),
            _ => None,
        };
        let name = Value::text(format!("1e{power}"));
        let row = [name.clone(), Value::maybe(exact.map(R::round_from))];
        lambdas.push(row.into_iter().chain(found.map(Value::maybe)).collect());
        lost.push([name].into_iter().chain(found.map(|lambda| digits_lost(lambda, exact))).collect());
    }
    let [notes, solved, robust] = Method::ALL.map(Method::name);
    transcript
        .section("The sphere squashed ever more, a ray along its flat side: λ* = 0.8 on paper", "CSC418 11.3.4")
        .table(&["condition", "exact", notes, solved, robust], lambdas)
        .remark("A = 1 − (1 − 1/condition) q qᵀ with q = (2, −1, 2)/3, from (−2, −2, 1) + (0.8/condition) q along (2, 2, −1).")
        .remark("Exact is the λ* of these numbers as they are rounded: it moves away from 0.8 by itself, and no method can help that.");
    transcript
        .section("Decimal digits of λ* that the method loses", "")
        .table(&["condition", notes, solved, robust], lost)
        .remark("About as many as the condition has zeros, with A⁻¹ stored or solved for: both round A⁻¹(ā − t⃗), whose terms cancel.");
}

/// Beyond this condition the rounded numbers of A and ā have less than three digits for the thickness.
fn most<R: Real>() -> f64 {
    let digits = (0..R::DIGITS).fold(1.0, |power: f64, _| 2.0 * power);
    digits / 1e3
}

fn truth<R: Real>(ray: &Ray3<R>, affine: &Affine<R>) -> Truth {
    let [o, d, t]: [[f64; 3]; 3] = [ray.origin, ray.direction, affine.t].map(Vector::in_f64);
    let [x, y, z] = affine.a.rows().map(|row| row.map(Into::into));
    let numbers = [o, d, x, y, z, t].concat();
    oracle::affine(UnitObject::Sphere, std::array::from_fn(|i| numbers[i]), precision::<R>())
}

fn precision<R: Real>() -> Precision {
    if R::NAME == f32::NAME { Precision::F32 } else { Precision::F64 }
}

/// The logarithm of the error in ulps, to a tenth; 0 for the nearest number or its neighbor.
fn digits_lost<R: Real>(lambda: Option<R>, exact: Option<f64>) -> Value {
    match (lambda, exact) {
        (Some(lambda), Some(exact)) => {
            let off = ulps(lambda.into(), exact, precision::<R>()).max(1) as f64;
            Value::F64((10.0 * portable::ln(off) / std::f64::consts::LN_10).round() / 10.0)
        }
        (None, None) => Value::text("a miss"),
        (None, Some(_)) => Value::text("misses"),
        (Some(_), None) => Value::text("hits, wrongly"),
    }
}

//! The same ray by every method, and the determinants by the page's and by the usual formulas.

use math::{Ray3, Real, Span};
use stage::{Transcript, Value};

use super::{plain, verdict};
use crate::{Method, Triangle, matrix, moller_trumbore};

/// λ, α and β by every method.
pub(crate) fn every_method<R: Real>(transcript: &mut Transcript, ray: &Ray3<R>, triangle: &Triangle<R>) {
    let rows = Method::ALL.map(|method| {
        let work = method.work(ray, triangle);
        let hit = work.hit(Span::ahead());
        let t = hit.ok().flatten().map(|hit| hit.t);
        let (alpha, beta) = work.alpha_beta().filter(|_| work.parallel().is_none()).unzip();
        let verdict = Value::text(verdict(&hit, work.parallel()));
        vec![Value::text(method.name()), Value::maybe(t), Value::maybe(alpha), Value::maybe(beta), verdict]
    });
    transcript
        .section("The same ray by every method", "CSC418 11.3.1")
        .table(&["method", "λ", "α", "β", "verdict"], rows.to_vec())
        .remark("α and β of a miss are those of the point where its line meets the plane.");
}

/// Cramer's four determinants beside those of Möller and Trumbore.
pub(crate) fn determinants<R: Real>(transcript: &mut Transcript, ray: &Ray3<R>, triangle: &Triangle<R>) {
    let page = matrix(ray, triangle);
    let usual = moller_trumbore(ray, triangle);
    let row = |names: [&str; 3], page: R, usual: R| {
        let [of_page, columns, of_usual] = names.map(Value::text);
        vec![of_page, columns, Value::number(page), of_usual, Value::number(usual)]
    };
    let rows = vec![
        row(["det M", "−e1, −e2, d⃗", "P · e1"], page.det, usual.det),
        row(["det_α", "b⃗, −e2, d⃗", "P · s"], page.det_alpha, usual.det_alpha),
        row(["det_β", "−e1, b⃗, d⃗", "Q · d⃗"], page.det_beta, usual.det_beta),
        row(["det_λ", "−e1, −e2, b⃗", "Q · e2"], page.det_lambda, usual.det_lambda),
    ];
    transcript
        .section("Cramer's rule beside what programs have", "CSC418 11.3.1; Möller and Trumbore 1997")
        .vector::<R>("e1", "p̄2 − p̄1", plain::<R>(usual.e1))
        .vector::<R>("e2", "p̄3 − p̄1", plain::<R>(usual.e2))
        .vector::<R>("s", "ā − p̄1", plain::<R>(usual.s))
        .note("−b⃗")
        .vector::<R>("P", "d⃗ × e2", plain::<R>(usual.p))
        .vector::<R>("Q", "s × e1", plain::<R>(usual.q))
        .table(&["Cramer", "its columns", "its value", "the same, turned round", "its value"], rows)
        .remark("The same four numbers with the other sign, so the quotients are the same; P and Q save two of four cross products.");
}

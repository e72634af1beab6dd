//! Singular means det A = 0, and parallel means d · n = 0: exactly, on the numbers as read.
//!
//! A computed determinant may be off by more than it is, and so may a computed dot product. Here either is a
//! formula generic over [`math::Sure`]: tried in `f64` with a bound on its error, then with twice the digits,
//! and last exactly.

use std::cmp::Ordering;

use math::{Bounded, Exact, Parallel, Ray3, Real, Sure, TwoPart, Vector};

use crate::{Affine, Matrix3};

/// adj A, whose rows are b × c, c × a, a × b of the columns a, b, c of A, and det A.
pub(crate) fn adjugate_and_determinant<N: Sure>([a, b, c]: [[f64; 3]; 3]) -> ([[N; 3]; 3], N) {
    let minor =
        |u: [f64; 3], v: [f64; 3], i: usize, j: usize| N::product(u[i], v[j]) - N::product(u[j], v[i]);
    let cross = |u, v| [minor(u, v, 1, 2), minor(u, v, 2, 0), minor(u, v, 0, 1)];
    let rows = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = N::dot(&a.map(N::of), &rows[0]);
    (rows, determinant)
}

/// Whether det A is above, below or exactly zero. The numbers must be finite.
pub fn of_determinant<R: Real>(a: &Matrix3<R>) -> Ordering {
    let columns = a.columns.map(Vector::in_f64::<3>);
    surely([
        &|| adjugate_and_determinant::<Bounded<f64>>(columns).1.sign(),
        &|| adjugate_and_determinant::<Bounded<TwoPart>>(columns).1.sign(),
        &|| adjugate_and_determinant::<Exact>(columns).1.sign(),
    ])
}

/// How the ray runs along the deformed plane z = 0; `None` where it meets it at one λ. The numbers must be finite.
///
/// The plane's normal A⁻ᵀ e_z is, but for its length, A e_x × A e_y: the last row of the adjugate.
pub fn parallel<R: Real>(ray: &Ray3<R>, affine: &Affine<R>) -> Option<Parallel> {
    let columns = affine.a.columns.map(Vector::in_f64::<3>);
    let [origin, direction, t] = [ray.origin, ray.direction, affine.t].map(Vector::in_f64::<3>);
    let slope = surely([
        &|| along_normal::<Bounded<f64>>(columns, direction, [0.0; 3]).sign(),
        &|| along_normal::<Bounded<TwoPart>>(columns, direction, [0.0; 3]).sign(),
        &|| along_normal::<Exact>(columns, direction, [0.0; 3]).sign(),
    ]);
    if slope != Ordering::Equal {
        return None;
    }
    let height = surely([
        &|| along_normal::<Bounded<f64>>(columns, origin, t).sign(),
        &|| along_normal::<Bounded<TwoPart>>(columns, origin, t).sign(),
        &|| along_normal::<Exact>(columns, origin, t).sign(),
    ]);
    Some(if height == Ordering::Equal { Parallel::Within } else { Parallel::Apart })
}

/// (u − v) · (A e_x × A e_y)
fn along_normal<N: Sure>(columns: [[f64; 3]; 3], u: [f64; 3], v: [f64; 3]) -> N {
    let ([_, _, normal], _) = adjugate_and_determinant::<N>(columns);
    N::dot(&[0, 1, 2].map(|axis| N::difference(u[axis], v[axis])), &normal)
}

/// The first answer that is certain; the last way always is.
fn surely(ways: [&dyn Fn() -> Option<Ordering>; 3]) -> Ordering {
    ways.iter().find_map(|way| way()).unwrap_or(Ordering::Equal)
}

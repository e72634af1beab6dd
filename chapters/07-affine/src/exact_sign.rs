//! Singular means det A = 0, and parallel means d · n = 0: exactly, on the numbers as read.
//!
//! A computed determinant may be off by more than it is, and so may a computed dot product. Here either is a
//! formula generic over [`math::Sure`]: tried in `f64` with a bound on its error, then with twice the digits,
//! and last exactly.

use std::cmp::Ordering;

use math::{Bounded, Degenerate, Exact, Parallel, Ray3, Real, Sure, TwoPart, Vector};

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

impl<R: Real> Affine<R> {
    /// Refuses a deformation without an inverse: [`Degenerate::NotFinite`], [`Degenerate::Singular`], whichever
    /// comes first. Singular is det A = 0, exactly.
    pub fn check(&self) -> Result<(), Degenerate> {
        if !self.a.is_finite() || !self.t.is_finite() {
            return Err(Degenerate::NotFinite);
        }
        match of_determinant(&self.a) {
            Ordering::Equal => Err(Degenerate::Singular),
            _ => Ok(()),
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Deformed, Method, Object};
    use glam::DVec3;
    use math::Span;

    /// By hand: A e_x = (1, 0, 1) and A e_y = (0, 1, 0) span the plane through t = (0, 0, 2) whose normal is (−1, 0, 1).
    /// With the third column (0, 0, 1) det A = 1, with (0, 0, −1) it mirrors.
    #[test]
    fn along_the_plane_above_it_and_within_it() {
        for third in [1.0, -1.0] {
            let a = Matrix3::from_rows([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, third]]);
            let affine = Affine { a, t: DVec3::new(0.0, 0.0, 2.0) };
            let how = |z: f64, direction: [f64; 3]| {
                parallel(&Ray3::new(DVec3::new(1.0, 5.0, z), direction.into()), &affine)
            };
            assert_eq!(how(4.0, [1.0, 7.0, 1.0]), Some(Parallel::Apart));
            assert_eq!(how(3.0, [1.0, 7.0, 1.0]), Some(Parallel::Within));
            assert_eq!(how(3.0_f64.next_down(), [1.0, 7.0, 1.0]), Some(Parallel::Apart));
            assert_eq!(how(3.0, [1.0, 7.0, 1.0_f64.next_up()]), None, "up through it");
            assert_eq!(how(3.0, [1.0, 7.0, 1.0_f64.next_down()]), None, "down through it");

            // no method has a hit, and each says why
            for object in [Object::Plane, Object::Triangle] {
                let deformed = Deformed::new(object, affine).unwrap();
                let within = Ray3::new(DVec3::new(1.0, 5.0, 3.0), DVec3::new(1.0, -7.0, 1.0));
                for method in Method::ALL {
                    let work = method.work(&within, &deformed);
                    assert_eq!(work.hit(Span::ahead()), Ok(None), "{}", method.name());
                    assert_eq!(work.parallel(), Some(Parallel::Within));
                }
            }
            let sphere = Deformed::new(Object::Sphere, affine).unwrap();
            assert_eq!(sphere.parallel(&Ray3::new(DVec3::ZERO, DVec3::Y)), None, "a solid has no plane");
        }
    }

    /// The rows differ in the last digit of one number, or not at all.
    #[test]
    fn singular_is_det_0_and_nothing_else() {
        let det = |a33: f64| {
            of_determinant(&Matrix3::<f64>::from_rows([[0.1, 0.2, 0.3], [0.7, 0.1, 0.9], [0.1, 0.2, a33]]))
        };
        // by hand: det = (a33 − 0.3) (0.1 · 0.1 − 0.2 · 0.7), and the second factor is below zero
        assert_eq!(det(0.3), Ordering::Equal);
        assert_eq!(det(0.3_f64.next_up()), Ordering::Less);
        assert_eq!(det(0.3_f64.next_down()), Ordering::Greater);
    }
}

//! A deformed object, with what depends on it alone.

use std::cmp::Ordering;

use math::{Bounded, Degenerate, Parallel, Ray3, Real, TwoPart, Vector};

use crate::exact_sign::{self, adjugate_and_determinant};
use crate::robust::Stored;
use crate::{Affine, Matrix3, Object};

/// An object deformed by ȳ = A x̄ + t. What every ray against it needs is worked out once: A⁻¹ for the notes, and
/// the adjugate with twice the digits for the robust method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deformed<R: Real> {
    /// The object in its own space.
    pub object: Object,
    /// A and t.
    pub affine: Affine<R>,
    /// A⁻¹ = adj A / det A, rounded: not finite where [`Matrix3::inverse`] is not.
    pub inverse: Matrix3<R>,
    /// What [`mod@crate::robust`] keeps.
    pub(crate) stored: Stored,
}

impl<R: Real> Deformed<R> {
    /// The object `object` deformed. [`Degenerate::NotFinite`] and [`Degenerate::Singular`] as [`Affine::check`] says:
    /// det A = 0 is decided exactly.
    pub fn new(object: Object, affine: Affine<R>) -> Result<Deformed<R>, Degenerate> {
        affine.check()?;
        let inverse = affine.a.inverse();
        Ok(Deformed { object, affine, inverse, stored: Stored::of(&affine.a) })
    }

    /// The same for one question with a ray, whose faults are named first: [`Degenerate::NotFinite`] of any number,
    /// [`Degenerate::ZeroDirection`], [`Degenerate::Singular`].
    pub fn for_ray(ray: &Ray3<R>, object: Object, affine: Affine<R>) -> Result<Deformed<R>, Degenerate> {
        if !affine.a.is_finite() || !affine.t.is_finite() {
            return Err(Degenerate::NotFinite);
        }
        ray.check()?;
        Deformed::new(object, affine)
    }

    /// How the ray runs along the plane of a flat object, exactly; `None` where it meets it, and for a solid.
    /// The ray must be finite.
    #[inline]
    pub fn parallel(&self, ray: &Ray3<R>) -> Option<Parallel> {
        if self.object.is_flat() { exact_sign::parallel(ray, &self.affine) } else { None }
    }
}

impl Stored {
    /// What the robust method keeps of a matrix that is not singular.
    fn of<R: Real>(a: &Matrix3<R>) -> Stored {
        let columns = a.columns.map(Vector::in_f64::<3>);
        let (adjugate, determinant) = adjugate_and_determinant::<Bounded<TwoPart>>(columns);
        let mirrors = exact_sign::of_determinant(a) == Ordering::Less;
        let turned = |x: Bounded<TwoPart>| if mirrors { -x } else { x };
        Stored::new(adjugate.map(|row| row.map(turned)), turned(determinant), mirrors)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Matrix3;
    use glam::DVec3;

    /// A question with three faults, and with one less each time.
    #[test]
    fn the_faults_of_a_question_have_an_order() {
        let diagonal = |z: f64| Matrix3::from_rows([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, z]]);
        let of = |z: f64, t: f64, direction: DVec3| {
            let (ray, affine) =
                (Ray3::new(DVec3::ZERO, direction), Affine { a: diagonal(z), t: DVec3::X * t });
            Deformed::<f64>::for_ray(&ray, Object::Sphere, affine).err()
        };
        for [z, t] in [[f64::INFINITY, 0.0], [0.0, f64::NAN], [f64::INFINITY, f64::NAN]] {
            assert_eq!(of(z, t, DVec3::ZERO), Some(Degenerate::NotFinite), "{z} {t}");
        }
        assert_eq!(of(0.0, 0.0, DVec3::ZERO), Some(Degenerate::ZeroDirection));
        assert_eq!(of(0.0, 0.0, DVec3::X), Some(Degenerate::Singular));
        assert_eq!(of(1.0, 0.0, DVec3::X), None);
    }
}

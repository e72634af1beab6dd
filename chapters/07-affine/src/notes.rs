//! CSC418 11.3.4 and 11.6.1, with A⁻¹ stored.

use math::{Degenerate, Ray3, Real, Span};

use crate::{Deformed, Found, Hit3, Undeformed, undeformed};

/// Every number of the page's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Notes<'a, R: Real> {
    /// The ray a + λ d.
    pub ray: Ray3<R>,
    /// The deformed object, with A⁻¹.
    pub deformed: &'a Deformed<R>,
    /// a − t
    pub a_minus_t: R::Vec3,
    /// The ray r′(λ) = a′ + λ d′ in the object's own space: a′ = A⁻¹(a − t), d′ = A⁻¹ d.
    pub ray_prime: Ray3<R>,
    /// The object's own method for that ray.
    pub undeformed: Undeformed<R>,
}

/// Works out the page's method, for a direction of any length but zero.
///
/// A degenerate ray gives values that mean nothing; [`Notes::hit`] refuses it.
#[inline]
pub fn notes<'a, R: Real>(ray: &Ray3<R>, deformed: &'a Deformed<R>) -> Notes<'a, R> {
    let (a_inverse, t) = (&deformed.inverse, deformed.affine.t);

    // exercise a_prime: Where does the ray start in the object's own space: what is undone first, A or t?
    // F(r(λ)) = f(A⁻¹(a + λ d − t)) = f(a′ + λ d′)
    let a_minus_t: R::Vec3 = ray.origin - t;
    let a_prime: R::Vec3 = a_inverse.times(a_minus_t);
    // end a_prime
    // exercise d_prime: Which direction has the ray in that space, if λ is to be the same in both?
    let d_prime: R::Vec3 = a_inverse.times(ray.direction);
    // end d_prime
    let ray_prime = Ray3::new(a_prime, d_prime);

    let undeformed = undeformed(deformed.object, &ray_prime);
    Notes { ray: *ray, deformed, a_minus_t, ray_prime, undeformed }
}

impl<R: Real> Notes<'_, R> {
    /// The λ* of the nearest hit in `span`, in both spaces. `None` for a miss, and where A⁻¹ overflows;
    /// [`Degenerate`] as [`Ray3::check`] says.
    #[inline]
    pub fn found(&self, span: Span<R>) -> Result<Option<Found<R>>, Degenerate> {
        self.ray.check()?;
        if self.deformed.parallel(&self.ray).is_some() {
            return Ok(None);
        }
        let Some(hit) = self.undeformed.hit(span) else { return Ok(None) };
        // exercise normal: What is at right angles to the deformed surface, if n is to the undeformed one?
        // the normal by A⁻ᵀ, Eq. (2)
        let a_inverse_transposed_n = self.deformed.inverse.transposed_times(hit.normal);
        // end normal
        Ok(Found::brought_back(&self.ray, hit, a_inverse_transposed_n))
    }

    /// The nearest hit in `span`; `None` and [`Degenerate`] as [`Notes::found`] says.
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        Ok(self.found(span)?.map(|found| found.hit()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Affine, Matrix3, Object};
    use glam::DVec3;

    fn deformed(object: Object, rows: [[f64; 3]; 3], t: [f64; 3]) -> Deformed<f64> {
        Deformed::new(object, Affine { a: Matrix3::from_rows(rows), t: t.into() }).unwrap()
    }

    /// By hand: x²/4 + y² + z² = 1, moved by 10 along x. From the origin along x it is met at 8; from (10, 5, 0)
    /// downward at y = 1.
    #[test]
    fn an_ellipsoid_by_hand() {
        let ellipsoid =
            deformed(Object::Sphere, [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [10.0, 0.0, 0.0]);
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::X);
        let work = notes(&ray, &ellipsoid);
        assert_eq!((work.ray_prime.origin, work.ray_prime.direction), (DVec3::X * -5.0, DVec3::X * 0.5));
        let found = work.found(Span::ahead()).unwrap().unwrap();
        // the same λ in both spaces: −5 + 8/2 = −1
        assert_eq!((found.lambda, found.p, found.point), (8.0, -DVec3::X, DVec3::X * 8.0));
        assert_eq!(found.normal(), -DVec3::X);
        let down = Ray3::<f64>::new(DVec3::new(10.0, 5.0, 0.0), DVec3::new(0.0, -2.0, 0.0));
        let hit = notes(&down, &ellipsoid).hit(Span::ahead()).unwrap().unwrap();
        assert_eq!((hit.t, hit.point, hit.normal), (2.0, DVec3::new(10.0, 1.0, 0.0), DVec3::Y));
    }

    /// By hand, at p = (3/5, 4/5, 0) of the sphere stretched twofold along x: the surface x²/4 + y² + z² = 1 has the
    /// gradient (x/2, 2y) = (6/5 · 1/2, 8/5) at (6/5, 4/5), which is A⁻ᵀ n = (3/10, 4/5) times 2. A n = (6/5, 4/5) is
    /// not at right angles to the tangent (4/5, −3/10) · 2 there.
    #[test]
    fn a_deformed_normal_stays_a_normal() {
        let ellipsoid =
            deformed(Object::Sphere, [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]);
        let ray = Ray3::<f64>::new(DVec3::new(1.2, 5.0, 0.0), -DVec3::Y);
        let found = notes(&ray, &ellipsoid).found(Span::ahead()).unwrap().unwrap();
        let tangent = DVec3::new(1.6, -0.6, 0.0);
        assert!(found.normal().dot(tangent).abs() < 1e-15);
        // (6/5 · 8/5 − 4/5 · 3/5) / ‖A n‖ = (48 − 12)/25 / √(52/25)
        let wrong = found.wrong_normal(&ellipsoid).dot(tangent);
        assert!((wrong - 1.44 / 2.08_f64.sqrt()).abs() < 1e-15, "{wrong}");
    }

    /// A mirror swaps left and right, not inside and outside.
    #[test]
    fn a_mirrored_normal_points_outward() {
        for object in [Object::Sphere, Object::Cylinder, Object::Cone] {
            let mirrored =
                deformed(object, [[-1.0, 0.0, 0.0], [0.0, 2.0, 0.5], [0.0, 0.0, 3.0]], [1.0, 2.0, 3.0]);
            for from in [DVec3::new(9.0, 2.0, 3.5), DVec3::new(1.0, -9.0, 2.0), DVec3::new(4.0, 5.0, 9.0)] {
                // toward a point inside: what is entered is entered against its normal
                let direction = DVec3::new(1.0, 2.125, 3.75) - from;
                let hit = notes(&Ray3::new(from, direction), &mirrored).hit(Span::ahead()).unwrap().unwrap();
                assert!(hit.normal.dot(direction) < 0.0, "{}", object.name());
            }
        }
    }
}

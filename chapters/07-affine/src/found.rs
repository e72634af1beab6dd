//! What a method found, in both spaces.

use math::{Hit, Ray3, Real, Vector};

use crate::{Deformed, Hit3};

/// A solution λ*, in the object's own space and in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<R: Real> {
    /// λ*, the same in both spaces, in lengths of the direction as given.
    pub lambda: R,
    /// r′(λ*) = a′ + λ* d′, the point in the object's own space.
    pub p: R::Vec3,
    /// n, the outward unit normal of the undeformed object there.
    pub n: R::Vec3,
    /// A⁻ᵀ n, the normal of the deformed object (11.6.1, Eq. 2), of any length.
    pub a_inverse_transposed_n: R::Vec3,
    /// The point in the world: r(λ*) = a + λ* d, or, by the robust method, the image of the point in the object's space
    /// where that is the better one.
    pub point: R::Vec3,
}

/// The two sides of the page's exercise: "Verify that r(λ*) = A r′(λ*) + t."
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BothWays<R: Real> {
    /// r(λ*)
    pub along_the_ray: R::Vec3,
    /// A r′(λ*) + t
    pub through_the_object: R::Vec3,
    /// The second less the first: zero on paper.
    pub difference: R::Vec3,
}

impl<R: Real> Found<R> {
    /// A hit at λ* of the undeformed object, brought to the world. `None` where A⁻ᵀ n is no direction, because A⁻¹
    /// overflows or vanishes.
    #[inline]
    pub(crate) fn brought_back(
        ray: &Ray3<R>,
        Hit { t: lambda, point: p, normal: n }: Hit3<R>,
        a_inverse_transposed_n: R::Vec3,
    ) -> Option<Found<R>> {
        let is_direction = a_inverse_transposed_n.is_finite() && !a_inverse_transposed_n.is_zero();
        is_direction.then(|| Found { lambda, p, n, a_inverse_transposed_n, point: ray.at(lambda) })
    }

    /// A⁻ᵀ n / ‖A⁻ᵀ n‖, Eq. (2): outward, for A⁻ᵀ turns an outward normal into an outward one whatever the sign of
    /// det A. (A step v leaves the object where n · v > 0; deformed it is A v, and A⁻ᵀ n · A v = n · v.)
    #[inline]
    pub fn normal(&self) -> R::Vec3 {
        // exercise unit: A⁻ᵀ n has any length. Which one has a normal to be shaded with?
        self.a_inverse_transposed_n.normalized()
        // end unit
    }

    /// A n / ‖A n‖: n deformed as if it were a step from point to point. It is at right angles to the surface
    /// everywhere only where A does no more than turn, mirror and scale alike in all directions.
    pub fn wrong_normal(&self, deformed: &Deformed<R>) -> R::Vec3 {
        deformed.affine.a.times(self.n).normalized()
    }

    /// The page's exercise worked out for the ray that was asked for.
    ///
    /// (Not for `self.point`: a method may have found that by the right-hand side.)
    pub fn verify(&self, ray: &Ray3<R>, deformed: &Deformed<R>) -> BothWays<R> {
        // exercise verify: Which point of the world is λ* along the ray, and where does the deformation send p?
        let (along_the_ray, through_the_object) = (ray.at(self.lambda), deformed.affine.apply(self.p));
        // end verify
        BothWays { along_the_ray, through_the_object, difference: through_the_object - along_the_ray }
    }

    /// The hit in the world: t is λ*, the normal a unit vector.
    #[inline]
    pub fn hit(&self) -> Hit3<R> {
        // minus zero is zero
        Hit { t: self.lambda + R::from(0.0), point: self.point, normal: self.normal() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// Of A⁻¹ that overflowed or vanished nothing is left that a normal could be made of.
    #[test]
    fn without_a_normal_nothing_is_brought_back() {
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::X);
        let hit = Hit { t: 2.0, point: -DVec3::X, normal: -DVec3::X };
        let brought_back = |m| Found::brought_back(&ray, hit, m);
        assert_eq!(brought_back(DVec3::ZERO), None);
        assert_eq!(brought_back(DVec3::new(1.0, f64::INFINITY, 0.0)), None);
        let found = brought_back(DVec3::X * 3.0).unwrap();
        assert_eq!(
            (found.lambda, found.p, found.point, found.normal()),
            (2.0, -DVec3::X, DVec3::X * 2.0, DVec3::X)
        );
        let at_minus_zero = Found::brought_back(&ray, Hit { t: -0.0, ..hit }, DVec3::X).unwrap();
        assert_eq!(at_minus_zero.hit().t.to_bits(), 0);
    }
}

//! CSC418 11.3.3: the same equation with the twos divided out.

use math::{Degenerate, Ray3, Real, Roots, Span, Vector};

use crate::{Hit3, Sphere};

/// Every number of CSC418's method.
///
/// The page has the unit sphere; here C takes r² where the page has 1. The ray is a + λ d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfQuadratic<R: Real> {
    /// The ray a + λ d.
    pub ray: Ray3<R>,
    /// The sphere.
    pub sphere: Sphere<R>,
    /// A = d · d
    pub a: R,
    /// B = (a − c) · d, half of Gambetta's b
    pub b: R,
    /// C = (a − c) · (a − c) − r²
    pub c: R,
    /// D = B² − A C, a quarter of Gambetta's discriminant
    pub d: R,
    /// −B/A + √D/A, the larger root, in lengths of d. `None` where D < 0.
    pub lambda_1: Option<R>,
    /// −B/A − √D/A, the smaller root, likewise.
    pub lambda_2: Option<R>,
}

/// The page's cases when D > 0, for a ray that starts on the view plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Visibility {
    /// λ1 < 0 and λ2 < 0.
    Behind,
    /// λ1 > 0 and λ2 < 0. (The page says twice p(λ1); the one not visible is p(λ2).)
    Inside,
    /// λ1 > λ2 > 0.
    InFront,
    /// A root is exactly zero, which the page leaves out: a crossing lies on the view plane itself.
    Touching,
}

impl Visibility {
    /// What it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Visibility::Behind => "both behind the view plane, not visible",
            Visibility::Inside => "p(λ1) is visible, p(λ2) is behind the view plane",
            Visibility::InFront => "both in front, p(λ2) is the closest",
            Visibility::Touching => "one of them on the view plane",
        }
    }
}

/// Works out CSC418's method (11.3.3), for a direction of any length but zero.
///
/// A degenerate ray or sphere gives values that mean nothing; [`HalfQuadratic::hit`] refuses them.
#[inline]
pub fn half_quadratic<R: Real>(ray: &Ray3<R>, sphere: &Sphere<R>) -> HalfQuadratic<R> {
    let r = sphere.radius;
    let from_center = ray.origin - sphere.center;

    // exercise coefficients: Which A, B and C make A λ² + 2 B λ + C = 0 out of the sphere's equation?
    // A λ² + 2 B λ + C = 0
    let a = ray.direction.dot(ray.direction);
    let b = from_center.dot(ray.direction);
    let c = from_center.dot(from_center) - r * r;
    // end coefficients

    // exercise d: Without Gambetta's twos and fours, what is under the root, and when is there none?
    let d = b * b - a * c;
    let root: Option<R> = if d < R::from(0.0) { None } else { Some(d.sqrt()) };
    // end d
    // exercise lambdas: What are the two solutions now, λ1 the larger and λ2 the smaller?
    let lambda_1 = root.map(|root| -b / a + root / a);
    let lambda_2 = root.map(|root| -b / a - root / a);
    // end lambdas

    HalfQuadratic { ray: *ray, sphere: *sphere, a, b, c, d, lambda_1, lambda_2 }
}

impl<R: Real> HalfQuadratic<R> {
    /// λ2 and λ1, the smaller first; `None` for a miss.
    #[inline]
    pub fn roots(&self) -> Option<Roots<R>> {
        Some(Roots { near: self.lambda_2?, far: self.lambda_1? })
    }

    /// Which of the page's cases this is, for a ray that starts on the view plane; a grazing ray, with D = 0,
    /// counts by its one root. `None` for a miss. Means nothing for what [`Sphere::check`] refuses.
    pub fn visibility(&self) -> Option<Visibility> {
        let Roots { near, far } = self.roots()?;
        let zero = R::from(0.0);
        // exercise visibility: Which signs do λ2 and λ1 have in each case, and what is left for `Touching`?
        Some(match () {
            _ if far < zero => Visibility::Behind,
            _ if near > zero => Visibility::InFront,
            _ if near < zero && far > zero => Visibility::Inside,
            _ => Visibility::Touching,
        })
        // end visibility
    }

    /// The nearest hit in `span`.
    ///
    /// `None` for a miss, [`Degenerate`] for a question without an answer, see [`Sphere::check`].
    #[inline]
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        self.sphere.first_hit(&self.ray, self.roots(), span)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// The page's three cases, with the second p(λ1) read as p(λ2) (slip 12).
    #[test]
    fn three_cases_of_visibility() {
        let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
        for (z, near, far, case) in [
            (-3.0, -4.0, -2.0, Visibility::Behind),
            (0.5, -0.5, 1.5, Visibility::Inside),
            (3.0, 2.0, 4.0, Visibility::InFront),
            (1.0, 0.0, 2.0, Visibility::Touching),
            (-1.0, -2.0, 0.0, Visibility::Touching),
        ] {
            // by hand: the unit sphere around (0, 0, z) reaches from z − 1 to z + 1
            let work = half_quadratic(&ray, &Sphere { center: DVec3::new(0.0, 0.0, z), radius: 1.0 });
            assert_eq!(work.roots(), Some(Roots { near, far }));
            assert_eq!(work.visibility(), Some(case));
        }
        let inside = half_quadratic(&ray, &Sphere { center: DVec3::new(0.0, 0.0, 0.5), radius: 1.0 });
        let visible = inside.hit(Span::ahead()).unwrap().unwrap();
        assert_eq!(Some(visible.t), inside.lambda_1, "as printed, p(λ1) would be visible and not visible");
    }

    #[test]
    fn twos_divide_out() {
        let ray = Ray3::<f64>::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, -1.0, 2.0));
        let sphere = Sphere { center: DVec3::new(4.0, -1.0, 8.0), radius: 2.0 };
        let (half, full) = (half_quadratic(&ray, &sphere), crate::quadratic(&ray, &sphere));
        // small integers: every number here is exact
        assert_eq!((2.0 * half.b, half.c, 4.0 * half.d), (full.b, full.c, full.discriminant));
    }
}

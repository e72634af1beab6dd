//! Where does a ray meet a plane? The sign of a distance, and one division that may be by zero.
//!
//! The plane is a point p_0 and a normal n. [`signed_distance()`] says how far a point is above it,
//! d = n · (x − p_0). Put the ray x(t) = p_r + t u_r in and set d = 0: that is Equation 4.2. The page
//! then asks what happens when the ray is parallel, and leaves the answer to the reader; here it is
//! [`Meeting`]: [`parallel`] and apart, or within the plane, and both are n · u_r = 0, exactly.
//!
//! [`mod@notes`] is Equation 4.2 as printed, [`mod@robust`] the same with both dot products certain. Both
//! return a struct with every number on the way, whose `hit(span)` is the answer. [`mod@glance`] is no
//! method, but what can be said at once of a plane among many shapes; [`ground`] is the scene of the
//! picture.
//!
//! Three above the ground, looking down at a slant, and level:
//!
//! ```
//! use glam::DVec3;
//! use math::{Ray3, Span};
//! use ray_plane::{Plane, robust};
//!
//! let ground = Plane { point: DVec3::ZERO, normal: DVec3::Y };
//! let down = Ray3::<f64>::new(DVec3::new(0.0, 3.0, 0.0), DVec3::new(2.0, -1.0, 0.0));
//! let hit = robust(&down, &ground).hit(Span::ahead())?.expect("the ground is below");
//! assert_eq!((hit.t, hit.point), (3.0, DVec3::new(6.0, 0.0, 0.0)));
//!
//! let level = Ray3::new(down.origin, DVec3::X);
//! assert_eq!(robust(&level, &ground).hit(Span::ahead())?, None);
//! # Ok::<(), math::Degenerate>(())
//! ```

#[cfg(feature = "stage")]
pub mod figure;
pub mod glance;
pub mod ground;
#[cfg(feature = "stage")]
mod map;
#[cfg(feature = "stage")]
mod measure;
pub mod notes;
pub mod parallel;
#[cfg(feature = "stage")]
mod picture;
#[cfg(feature = "stage")]
pub mod regimes;
pub mod robust;
pub mod signed_distance;
#[cfg(feature = "stage")]
pub mod stage;

use math::{Degenerate, Hit, Parallel, Ray3, Real, Span, Vector};

pub use glance::glance;
pub use notes::{Notes, notes};
pub use robust::{Robust, robust};
pub use signed_distance::{Side, SignedDistance, signed_distance};

/// The plane through a point at right angles to a normal: n · (x − p_0) = 0 (House 4.3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<R: Real> {
    /// p_0, any point of the plane.
    pub point: R::Vec3,
    /// n, of any length but zero. House's has length 1; t does not depend on it.
    pub normal: R::Vec3,
}

/// A hit in space.
pub type Hit3<R> = Hit<R, <R as Real>::Vec3>;

/// Where the line of a ray meets a plane, or why there is no single t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meeting<R> {
    /// At one t, in lengths of the ray's direction, which may be negative.
    At(R),
    /// n · u_r = 0: the line never meets the plane, or lies within it.
    Never(Parallel),
}

impl<R: Real> Plane<R> {
    /// Refuses a question without an answer: [`Degenerate::NotFinite`], [`Degenerate::ZeroDirection`],
    /// [`Degenerate::ZeroNormal`], whichever comes first.
    #[inline(always)]
    pub fn check(&self, ray: &Ray3<R>) -> Result<(), Degenerate> {
        if ![ray.origin, ray.direction, self.point, self.normal].iter().all(|v| v.is_finite()) {
            return Err(Degenerate::NotFinite);
        }
        if ray.direction.is_zero() {
            return Err(Degenerate::ZeroDirection);
        }
        if self.normal.is_zero() {
            return Err(Degenerate::ZeroNormal);
        }
        Ok(())
    }

    /// n / ‖n‖, the unit normal that the page has, for a normal of any length but zero.
    #[inline(always)]
    pub fn unit_normal(&self) -> R::Vec3 {
        self.normal.normalized()
    }
}

/// The formulations of this chapter, by the names that `--method` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// House, Eq. 4.2.
    Notes,
    /// The same with the signs and digits of both dot products certain.
    Robust,
}

impl Method {
    /// Every method.
    pub const ALL: [Method; 2] = [Method::Notes, Method::Robust];

    /// The name that `--method` takes.
    pub fn name(self) -> &'static str {
        match self {
            Method::Notes => "notes",
            Method::Robust => "robust",
        }
    }

    /// Works the method out for one ray and one plane. Degenerate ones give values that mean nothing;
    /// [`Working::hit`] refuses them.
    pub fn work<R: Real>(self, ray: &Ray3<R>, plane: &Plane<R>) -> Working<R> {
        match self {
            Method::Notes => Working::Notes(notes(ray, plane)),
            Method::Robust => Working::Robust(robust(ray, plane)),
        }
    }
}

/// One method's intermediate values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Working<R: Real> {
    /// By House's method.
    Notes(Notes<R>),
    /// By the robust one.
    Robust(Robust<R>),
}

impl<R: Real> Working<R> {
    /// Where the line of the ray meets the plane. Means nothing for what [`Plane::check`] refuses.
    pub fn meeting(&self) -> Meeting<R> {
        match self {
            Working::Notes(work) => work.meeting(),
            Working::Robust(work) => work.meeting(),
        }
    }

    /// The signed distance of the ray's origin from the plane, in units of the scene whatever ‖n‖ is. Means
    /// nothing for what [`Plane::check`] refuses.
    pub fn distance(&self) -> R {
        match self {
            Working::Notes(work) => work.distance(),
            Working::Robust(work) => work.distance(),
        }
    }

    /// The hit, where its t lies in `span`. The normal is n / ‖n‖, on whichever side the ray comes from.
    ///
    /// `None` for a miss, which a ray within the plane is, too; [`Degenerate`] for a question without an
    /// answer, see [`Plane::check`].
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        match self {
            Working::Notes(work) => work.hit(span),
            Working::Robust(work) => work.hit(span),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: the plane x + 2y − 2z = 3 through (1, 2, 1), ‖n‖ = 3. (5, 6, 1) is 12 above it in lengths of
    /// n, along (−2, −1, 1) that falls by 6 a unit, and (1, 4, 3) is in the plane.
    fn assert_meets_a_slanted_plane<R: Real>(length: f64) {
        let vector = |[x, y, z]: [f64; 3]| R::vec3(R::round_from(x), R::round_from(y), R::round_from(z));
        let n = [1.0, 2.0, -2.0];
        let plane = Plane::<R> { point: vector([1.0, 2.0, 1.0]), normal: vector(n.map(|x| x * length)) };
        let ray = Ray3::<R>::new(vector([5.0, 6.0, 1.0]), vector([-2.0, -1.0, 1.0]));
        // n / ‖n‖ is off by a few roundings, each of half a unit of the last digit
        let few = 4.0 * 0.5_f64.powi(R::DIGITS as i32);
        for method in Method::ALL {
            let (work, says) = (method.work(&ray, &plane), format!("{} {length:e}", method.name()));
            assert_eq!(work.meeting(), Meeting::At(R::from(2.0)), "{says}");
            assert!((work.distance().into() - 4.0).abs() <= few * 4.0, "{says}: {:?}", work.distance());
            let hit = work.hit(Span::ahead()).unwrap().unwrap();
            assert_eq!((hit.t, hit.point), (R::from(2.0), vector([1.0, 4.0, 3.0])), "{says}");
            for (got, want) in R::xyz(hit.normal).into_iter().zip(n) {
                assert!((got.into() - want / 3.0).abs() <= few, "{says}: {got:?}");
            }
        }
    }

    /// Of the short normals no product is left to plain numbers.
    #[test]
    fn every_method_meets_a_slanted_plane() {
        assert_meets_a_slanted_plane::<f32>(1.0);
        assert_meets_a_slanted_plane::<f64>(1.0);
        assert_meets_a_slanted_plane::<f32>(2.0_f64.powi(-120));
        assert_meets_a_slanted_plane::<f64>(2.0_f64.powi(-600));
    }

    #[test]
    fn methods_have_the_names_that_are_asked_for() {
        assert_eq!(Method::ALL.map(Method::name), ["notes", "robust"]);
    }
}

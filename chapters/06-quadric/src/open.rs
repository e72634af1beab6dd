//! The cone and the cylinder of a scene file: a wall between two circles, without caps and without an inside.
//!
//! Haines's NFF gives a base point, an apex point and a radius at each. At the height s = (x − b)·v / (v·v) along the
//! axis v = apex − base the wall has the radius
//!
//! ```text
//! r(s) = r_b + s (r_a − r_b),   0 ≤ s ≤ 1
//! ```
//!
//! Equal radii make a cylinder, a radius of zero makes a cone with a tip. Between the ends r(s) is never below zero:
//! where both radii are not, their mixture is not, so that the other nappe of the cone never counts. The wall is seen
//! from both sides: a ray that comes in through an open end meets it from within. A ray that lies in the wall, along
//! one of its straight lines, hits where it first touches it (by [`mod@robust`]; the notes find no root
//! there).
//!
//! [`mod@notes`] carries the page's quadratic (CSC418 11.3.5) to any axis and tests both roots. [`mod@robust`] asks
//! signs first, as for the unit solids, and works out one root. [`OpenCone::normal`] is the side away from the axis,
//! [`OpenCone::bounds`] a box around it all.

mod at_once;
mod bounds;
mod crossing;
pub mod glance;
mod line;
mod normal;
pub mod notes;
mod place;
mod plain;
pub mod robust;
#[cfg(all(test, feature = "stage"))]
mod sweep;
#[cfg(test)]
mod tests;
mod verdict;

use math::{Degenerate, Ray3, Real, Vector};

pub use glance::glance;
pub use notes::{Candidate, Notes, Test, notes};
pub use robust::{Robust, robust};
pub use verdict::Verdict;

/// NFF's cone: the points at the height s from 0 to 1 whose distance from the axis is r(s). A surface, not
/// a solid. Its measures are in units of the scene; s is in lengths of the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenCone<R: Real> {
    /// b, the middle of the circle at s = 0.
    pub base: R::Vec3,
    /// r_b ≥ 0
    pub base_radius: R,
    /// b + v, the middle of the circle at s = 1. It is not the base.
    pub apex: R::Vec3,
    /// r_a ≥ 0: larger than r_b, equal, smaller, or zero; not both are zero.
    pub apex_radius: R,
}

/// An end of the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// s = 0
    Base,
    /// s = 1
    Apex,
}

impl End {
    /// The other one.
    #[inline(always)]
    pub fn other(self) -> End {
        match self {
            End::Base => End::Apex,
            End::Apex => End::Base,
        }
    }
}

impl<R: Real> OpenCone<R> {
    /// A cone of these measures, taken as they are; [`OpenCone::check`] refuses what is none.
    pub fn new(base: R::Vec3, base_radius: R, apex: R::Vec3, apex_radius: R) -> Self {
        OpenCone { base, base_radius, apex, apex_radius }
    }

    /// Refuses a question without an answer, whichever comes first: [`Degenerate::NotFinite`],
    /// [`Degenerate::ZeroDirection`], [`Degenerate::RadiusNotPositive`] for a radius below zero or two that are zero,
    /// [`Degenerate::NoHeight`] for an apex that is the base.
    #[inline(always)]
    pub fn check(&self, ray: &Ray3<R>) -> Result<(), Degenerate> {
        let radii = [self.base_radius, self.apex_radius];
        if !(self.base.is_finite() && self.apex.is_finite() && radii.iter().all(|r| r.is_finite())) {
            return Err(Degenerate::NotFinite);
        }
        ray.check()?;
        let zero = R::from(0.0);
        if radii.iter().any(|&r| r < zero) || radii.iter().all(|&r| r == zero) {
            return Err(Degenerate::RadiusNotPositive);
        }
        if self.base == self.apex {
            return Err(Degenerate::NoHeight);
        }
        Ok(())
    }

    /// The middle of the circle at an end.
    #[inline(always)]
    pub fn middle(&self, end: End) -> R::Vec3 {
        match end {
            End::Base => self.base,
            End::Apex => self.apex,
        }
    }

    /// The radius of the circle at an end.
    #[inline(always)]
    pub fn radius(&self, end: End) -> R {
        match end {
            End::Base => self.base_radius,
            End::Apex => self.apex_radius,
        }
    }

    /// The end at which the wall comes together in a tip; `None` where neither radius is zero.
    #[inline(always)]
    pub fn tip(&self) -> Option<End> {
        [End::Base, End::Apex].into_iter().find(|&end| self.radius(end) == R::from(0.0))
    }

    /// The same measures in `f64`, which holds every `f32`.
    #[inline(always)]
    pub(crate) fn in_f64(&self) -> OpenCone<f64> {
        let [base, apex] = [self.base, self.apex].map(|middle| {
            let [x, y, z] = middle.in_f64::<3>();
            f64::vec3(x, y, z)
        });
        OpenCone { base, base_radius: self.base_radius.into(), apex, apex_radius: self.apex_radius.into() }
    }
}

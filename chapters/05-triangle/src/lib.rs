//! Where does a ray meet a triangle? A plane and three half-planes, or one system of three equations.
//!
//! The triangle has the corners p̄1, p̄2, p̄3, the ray is r̄(λ) = ā + λ d. CSC418 11.3.1 has two ways.
//! [`mod@half_planes`] meets the plane first and then asks on which side of each edge the point lies.
//! [`mod@matrix`] asks for the point as p̄1 + α (p̄2 − p̄1) + β (p̄3 − p̄1) and solves for α, β and λ at once.
//! On paper they agree; in floating point both are wrong about rays near an edge, and a mesh leaks along the
//! edges that its triangles share. [`mod@robust`] says why, and what to do about it.
//!
//! Each method takes a [`Ray3`] and a [`Triangle`] and returns a struct with every number on the way; its
//! `hit(span)` is the answer, its `parallel()` the page's question what d · n = 0 means. [`Method`] lists
//! them all.
//!
//! All of a triangle is hit, its edges and corners too, and from either side.
//!
//! [`polygon::Polygon`] has any number of corners in a plane (11.3.2), and two rules for what is inside;
//! [`mesh::Mesh`] many triangles that share theirs, and normals to shade them with (11.6).
//!
//! [`mod@parallel`] answers the page's question exactly, and [`area`] whether there is a triangle at all.
//! [`mod@moller_trumbore`] is the matrix as most programs have it, and [`mod@glance`] what can be said at
//! once of a triangle among many shapes; neither is in the list. [`scene`] is the worked example.
//!
//! A quarter of the way along two sides:
//!
//! ```
//! use glam::DVec3;
//! use math::{Ray3, Span};
//! use triangle::{Triangle, matrix};
//!
//! let triangle = Triangle::<f64> {
//!     p1: DVec3::new(0.0, 0.0, 2.0),
//!     p2: DVec3::new(1.0, 0.0, 2.0),
//!     p3: DVec3::new(0.0, 1.0, 2.0),
//! };
//! let work = matrix(&Ray3::new(DVec3::new(0.25, 0.25, 0.0), DVec3::Z), &triangle);
//! assert_eq!((work.alpha, work.beta, work.lambda), (0.25, 0.25, 2.0));
//! assert!(work.hit(Span::ahead())?.is_some());
//! # Ok::<(), math::Degenerate>(())
//! ```

pub mod area;
#[cfg(feature = "stage")]
mod explain;
#[cfg(feature = "stage")]
pub mod figure;
pub mod glance;
pub mod half_planes;
#[cfg(feature = "stage")]
mod leaks;
pub mod matrix;
#[cfg(feature = "stage")]
mod measure;
pub mod mesh;
pub mod moller_trumbore;
pub mod parallel;
#[cfg(feature = "stage")]
mod picture;
pub mod polygon;
#[cfg(feature = "stage")]
pub mod regimes;
pub mod robust;
pub mod scene;
#[cfg(feature = "stage")]
pub mod stage;
mod volumes;

use math::{Degenerate, Hit, Parallel, Ray3, Real, Span, Vector};

pub use glance::glance;
pub use half_planes::{HalfPlanes, half_planes};
pub use matrix::{Matrix, matrix};
pub use moller_trumbore::{MollerTrumbore, moller_trumbore};
pub use robust::{Robust, robust};

/// The points p̄1 + α (p̄2 − p̄1) + β (p̄3 − p̄1) with α ≥ 0, β ≥ 0 and α + β ≤ 1: edges and corners belong to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<R: Real> {
    /// p̄1: α = β = 0.
    pub p1: R::Vec3,
    /// p̄2: α = 1.
    pub p2: R::Vec3,
    /// p̄3: β = 1.
    pub p3: R::Vec3,
}

/// A hit in space.
pub type Hit3<R> = Hit<R, <R as Real>::Vec3>;

impl<R: Real> Triangle<R> {
    /// n = (p̄2 − p̄1) × (p̄3 − p̄1), as long as twice the area, not normalized. Seen from where it points,
    /// the corners run counterclockwise. It is rounded: whether it is zero, [`area::has_area`] tells.
    #[inline(always)]
    pub fn normal(&self) -> R::Vec3 {
        R::cross(self.p2 - self.p1, self.p3 - self.p1)
    }

    /// The corners p̄1, p̄2, p̄3.
    #[inline(always)]
    pub fn corners(&self) -> [R::Vec3; 3] {
        [self.p1, self.p2, self.p3]
    }

    /// Refuses a question without an answer: [`Degenerate::NotFinite`], [`Degenerate::ZeroDirection`],
    /// [`Degenerate::NoArea`], whichever comes first. Decided on the numbers as given, exactly.
    pub fn check(&self, ray: &Ray3<R>) -> Result<(), Degenerate> {
        if ![ray.origin, ray.direction, self.p1, self.p2, self.p3].iter().all(|v| v.is_finite()) {
            return Err(Degenerate::NotFinite);
        }
        if ray.direction.is_zero() {
            return Err(Degenerate::ZeroDirection);
        }
        if !area::has_area(self) {
            return Err(Degenerate::NoArea);
        }
        Ok(())
    }
}

/// The formulations of this chapter, by the names that `--method` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// CSC418 11.3.1, the first way.
    HalfPlanes,
    /// CSC418 11.3.1, the second way.
    Matrix,
    /// Right where the others are not.
    Robust,
}

impl Method {
    /// Every method, in the order of the notes.
    pub const ALL: [Method; 3] = [Method::HalfPlanes, Method::Matrix, Method::Robust];

    /// The name that `--method` takes.
    pub fn name(self) -> &'static str {
        match self {
            Method::HalfPlanes => "half-planes",
            Method::Matrix => "matrix",
            Method::Robust => "robust",
        }
    }

    /// Works the method out for one ray and one triangle. Degenerate ones give values that mean nothing;
    /// [`Working::hit`] refuses them.
    pub fn work<R: Real>(self, ray: &Ray3<R>, triangle: &Triangle<R>) -> Working<R> {
        match self {
            Method::HalfPlanes => Working::HalfPlanes(half_planes(ray, triangle)),
            Method::Matrix => Working::Matrix(matrix(ray, triangle)),
            Method::Robust => Working::Robust(robust(ray, triangle)),
        }
    }
}

/// One method's intermediate values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Working<R: Real> {
    /// By the plane and three half-planes.
    HalfPlanes(HalfPlanes<R>),
    /// By the system of three equations.
    Matrix(Matrix<R>),
    /// By the robust one.
    Robust(Robust<R>),
}

impl<R: Real> Working<R> {
    /// How the ray runs along the triangle's plane; `None` where d · n ≠ 0. Decided exactly, as
    /// [`parallel::parallel`] has it. Means nothing for what [`Triangle::check`] refuses.
    pub fn parallel(&self) -> Option<Parallel> {
        match self {
            Working::HalfPlanes(work) => work.parallel(),
            Working::Matrix(work) => work.parallel(),
            Working::Robust(work) => work.parallel(),
        }
    }

    /// Where the line of the ray meets the plane: α and β of p̄1 + α (p̄2 − p̄1) + β (p̄3 − p̄1), inside the
    /// triangle or not, ahead or behind. `None` where there is no such point. Means nothing for what
    /// [`Triangle::check`] refuses.
    pub fn alpha_beta(&self) -> Option<(R, R)> {
        match self {
            Working::HalfPlanes(work) => work.alpha_beta(),
            Working::Matrix(work) => work.alpha_beta(),
            Working::Robust(work) => work.alpha_beta(),
        }
    }

    /// The hit, where its t lies in `span`, from either side. The normal is n / ‖n‖, not turned toward the
    /// ray.
    ///
    /// `None` for a miss, which a ray along the plane is, too; [`Degenerate`] for a question without an
    /// answer, see [`Triangle::check`].
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        match self {
            Working::HalfPlanes(work) => work.hit(span),
            Working::Matrix(work) => work.hit(span),
            Working::Robust(work) => work.hit(span),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What `--method` takes is part of the command line, and is not to change by accident.
    #[test]
    fn the_names_that_method_takes() {
        assert_eq!(Method::ALL.map(Method::name), ["half-planes", "matrix", "robust"]);
    }
}

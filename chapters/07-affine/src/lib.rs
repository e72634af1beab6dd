//! How does a ray hit an object that is stretched, squashed, turned and moved? By hitting the object before.
//!
//! CSC418 11.3.4: the deformed object is F(ȳ) = f(A⁻¹(ȳ − t)) = 0, where f(x̄) = 0 is the object and ȳ = A x̄ + t the
//! deformation ([`Affine`]). Put the ray a + λ d in, and it is the undeformed object against another ray,
//! a′ + λ d′ with a′ = A⁻¹(a − t) and d′ = A⁻¹ d. The λ found is the same in both spaces. The normal is not: that of
//! the deformed object is A⁻ᵀ n, normalized (11.6.1), and A n is wrong ([`Found::wrong_normal`]).
//!
//! [`mod@notes`] does this with A⁻¹ stored, [`mod@solved`] solves A a′ = a − t and A d′ = d for every ray,
//! and [`mod@robust`] never divides by det A before the end. All take a [`Ray3`] and a [`Deformed`], in which
//! what depends on the object alone is worked out once. The first two meet the object before by its own
//! chapter's formulas ([`mod@undeformed`]).
//!
//! Whether A has an inverse, and whether a ray runs along a flat object, is decided exactly, whatever the
//! method ([`mod@exact_sign`]). [`scene`] is where five such objects are seen from.
//!
//! A unit sphere, stretched to twice its width:
//!
//! ```
//! use affine::{Affine, Deformed, Matrix3, Object, notes};
//! use glam::DVec3;
//! use math::{Ray3, Span};
//!
//! let a = Matrix3::from_rows([[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
//! let wide = Deformed::<f64>::new(Object::Sphere, Affine { a, t: DVec3::ZERO })?;
//! let ray = Ray3::new(DVec3::new(5.0, 0.0, 0.0), -DVec3::X);
//! let hit = notes(&ray, &wide).hit(Span::ahead())?.expect("it is ahead");
//! assert_eq!((hit.t, hit.normal), (3.0, DVec3::X));
//! # Ok::<(), math::Degenerate>(())
//! ```

mod deformed;
pub mod exact_sign;
#[cfg(all(test, feature = "stage"))]
mod exercise;
#[cfg(feature = "stage")]
mod explain;
#[cfg(feature = "stage")]
pub mod figure;
mod found;
pub mod matrix;
#[cfg(feature = "stage")]
mod measure;
pub mod notes;
#[cfg(feature = "stage")]
mod picture;
#[cfg(feature = "stage")]
pub mod regimes;
pub mod robust;
pub mod scene;
pub mod solved;
#[cfg(feature = "stage")]
pub mod stage;
pub mod undeformed;

use math::{Degenerate, Hit, Parallel, Ray3, Real, Span};

pub use deformed::Deformed;
pub use found::{BothWays, Found};
pub use matrix::{Affine, Matrix3};
pub use notes::{Notes, notes};
pub use robust::{Robust, robust};
pub use solved::{Solved, solved};
pub use undeformed::{Undeformed, undeformed};

/// A hit in space.
pub type Hit3<R> = Hit<R, <R as Real>::Vec3>;

/// The unit objects: what is deformed, each in a space of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Object {
    /// ‖x‖ = 1
    Sphere,
    /// x² + y² = 1 for |z| ≤ 1, closed by its two caps.
    Cylinder,
    /// x² + y² = ¼(1 − z)² for 0 ≤ z ≤ 1, closed by its base.
    Cone,
    /// z = 0, with the normal (0, 0, 1).
    Plane,
    /// The triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), with the normal (0, 0, 1).
    ///
    /// Any triangle is this one deformed, by the matrix whose columns are its sides p̄2 − p̄1 and p̄3 − p̄1 and any third
    /// vector that is not in its plane, moved by p̄1. Then x and y of a′ + λ d′ are α and β of 11.3.1: A a′ = a − t
    /// and A d′ = d are chapter 05's matrix method again.
    Triangle,
}

impl Object {
    /// Every object, in the order of the words of a case file.
    pub const ALL: [Object; 5] =
        [Object::Sphere, Object::Cylinder, Object::Cone, Object::Plane, Object::Triangle];

    /// The word in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Object::Sphere => "sphere",
            Object::Cylinder => "cylinder",
            Object::Cone => "cone",
            Object::Plane => "plane",
            Object::Triangle => "triangle",
        }
    }

    /// Whether it is a plane or a triangle: they have no inside, and a ray can run along them.
    pub fn is_flat(self) -> bool {
        matches!(self, Object::Plane | Object::Triangle)
    }
}

/// The formulations of this chapter, by the names that `--method` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// CSC418 11.3.4, with A⁻¹ stored.
    Notes,
    /// The same with A a′ = a − t and A d′ = d solved for every ray.
    Solved,
    /// Right where the others are not.
    Robust,
}

impl Method {
    /// Every method.
    pub const ALL: [Method; 3] = [Method::Notes, Method::Solved, Method::Robust];

    /// The name that `--method` takes.
    pub fn name(self) -> &'static str {
        match self {
            Method::Notes => "notes",
            Method::Solved => "solved",
            Method::Robust => "robust",
        }
    }

    /// Works the method out for one ray and one deformed object. A degenerate ray gives values that mean
    /// nothing; [`Working::hit`] refuses it.
    pub fn work<'a, R: Real>(self, ray: &Ray3<R>, deformed: &'a Deformed<R>) -> Working<'a, R> {
        match self {
            Method::Notes => Working::Notes(notes(ray, deformed)),
            Method::Solved => Working::Solved(solved(ray, deformed)),
            Method::Robust => Working::Robust(robust(ray, deformed)),
        }
    }
}

/// One method's intermediate values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Working<'a, R: Real> {
    /// With A⁻¹ stored.
    Notes(Notes<'a, R>),
    /// With A a′ = a − t solved.
    Solved(Solved<'a, R>),
    /// By the robust one.
    Robust(Robust<'a, R>),
}

impl<R: Real> Working<'_, R> {
    /// The λ* of the nearest hit in `span`, in both spaces; `None` for a miss, [`Degenerate`] for a question without
    /// an answer.
    pub fn found(&self, span: Span<R>) -> Result<Option<Found<R>>, Degenerate> {
        match self {
            Working::Notes(work) => work.found(span),
            Working::Solved(work) => work.found(span),
            Working::Robust(work) => work.found(span),
        }
    }

    /// The nearest hit in `span`; `None` for a miss, [`Degenerate`] for a question without an answer.
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        match self {
            Working::Notes(work) => work.hit(span),
            Working::Solved(work) => work.hit(span),
            Working::Robust(work) => work.hit(span),
        }
    }

    /// How the ray runs along a flat object; `None` where it meets its plane, and for a solid. By every
    /// method exactly. The ray must be finite.
    pub fn parallel(&self) -> Option<Parallel> {
        let (ray, deformed) = match self {
            Working::Notes(work) => (&work.ray, work.deformed),
            Working::Solved(work) => (&work.ray, work.deformed),
            Working::Robust(work) => (&work.ray, work.deformed),
        };
        deformed.parallel(ray)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_has_its_own_name() {
        for mut names in [Object::ALL.map(Object::name).to_vec(), Method::ALL.map(Method::name).to_vec()] {
            let count = names.len();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), count, "{names:?}");
        }
    }
}

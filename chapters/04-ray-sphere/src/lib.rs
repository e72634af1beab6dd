//! Where does a ray hit a sphere? Rival roads to the same two numbers.
//!
//! The ray is p_r + t u_r, the sphere ‖x − c‖ = r. [`mod@closest_approach`] is House's geometry: walk to
//! the point nearest to the center, then back by Pythagoras. [`mod@quadratic`] is Gambetta's algebra: put
//! the ray into the sphere's equation and solve for t. [`mod@half_quadratic`] is CSC418's, with the
//! twos divided out. On paper they agree; in floating point each fails somewhere else. [`mod@robust`]
//! says why, and what to do about it. [`mod@shortcut`] is House's way as most programs have it, and
//! [`mod@batched`] is CSC418's for many rays at once.
//!
//! Each method takes a [`Ray3`] and a [`Sphere`] and returns a struct with every number on the way;
//! its `roots()` are the two crossings and its `hit(span)` the answer. [`Method`] lists them all.
//!
//! [`mod@glance`] is no method, but what can be said at once of a sphere among many shapes. [`scene`] is
//! Gambetta's three spheres and his `TraceRay`.
//!
//! Straight at a sphere of radius 1, five away:
//!
//! ```
//! use glam::DVec3;
//! use math::{Ray3, Span};
//! use ray_sphere::{Sphere, closest_approach};
//!
//! let ray = Ray3::<f64>::new(DVec3::ZERO, DVec3::Z);
//! let work = closest_approach(&ray, &Sphere { center: DVec3::new(0.0, 0.0, 5.0), radius: 1.0 });
//! assert_eq!((work.t_close, work.d, work.a), (5.0, 0.0, Some(1.0)));
//! let hit = work.hit(Span::ahead())?.expect("it is ahead");
//! assert_eq!((hit.t, hit.normal), (4.0, -DVec3::Z));
//! # Ok::<(), math::Degenerate>(())
//! ```

pub mod batched;
pub mod closest_approach;
#[cfg(feature = "stage")]
mod explain;
#[cfg(feature = "stage")]
pub mod figure;
pub mod glance;
pub mod half_quadratic;
#[cfg(feature = "stage")]
mod inspect;
#[cfg(feature = "stage")]
mod map;
#[cfg(feature = "stage")]
mod measure;
#[cfg(feature = "stage")]
mod picture;
pub mod quadratic;
#[cfg(feature = "stage")]
pub mod regimes;
#[cfg(feature = "stage")]
mod reject;
pub mod robust;
pub mod scene;
pub mod shortcut;
#[cfg(feature = "stage")]
pub mod stage;

use math::{Degenerate, Hit, Ray3, Real, Roots, Span, Vector};

pub use batched::{Batched, batched};
pub use closest_approach::{ClosestApproach, closest_approach, closest_approach_of_unit};
pub use glance::{Line, glance};
pub use half_quadratic::{HalfQuadratic, half_quadratic};
pub use quadratic::{Quadratic, quadratic};
pub use robust::{Robust, robust};
pub use shortcut::{Shortcut, shortcut};

/// The points at distance `radius` from `center`: ‖x − c‖ = r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<R: Real> {
    /// c
    pub center: R::Vec3,
    /// r, greater than zero.
    pub radius: R,
}

/// A hit in space.
pub type Hit3<R> = Hit<R, <R as Real>::Vec3>;

impl<R: Real> Sphere<R> {
    /// Refuses a question without an answer: [`Degenerate::NotFinite`], [`Degenerate::ZeroDirection`],
    /// [`Degenerate::RadiusNotPositive`], whichever comes first.
    #[inline]
    pub fn check(&self, ray: &Ray3<R>) -> Result<(), Degenerate> {
        if ![ray.origin, ray.direction, self.center].iter().all(|v| v.is_finite()) || !self.radius.is_finite()
        {
            return Err(Degenerate::NotFinite);
        }
        if ray.direction.is_zero() {
            return Err(Degenerate::ZeroDirection);
        }
        if self.radius <= R::from(0.0) {
            return Err(Degenerate::RadiusNotPositive);
        }
        Ok(())
    }

    /// The hit at the smaller of two roots that lies in `span`: x = p_r + t u_r, n = (x − c) / r.
    ///
    /// The roots are in lengths of the ray's direction. `None` where the line misses (no roots) or both roots
    /// lie outside the span, [`Degenerate`] where [`Sphere::check`] refuses.
    #[inline]
    pub fn first_hit(
        &self,
        ray: &Ray3<R>,
        roots: Option<Roots<R>>,
        span: Span<R>,
    ) -> Result<Option<Hit3<R>>, Degenerate> {
        self.check(ray)?;
        let Some(t) = roots.and_then(|roots| roots.first_within(span)) else { return Ok(None) };
        Ok(Some(self.hit_at(t, ray.at(t))))
    }

    /// The hit at a point of the sphere, with its outward normal n = (x − c) / r. t and the point are taken
    /// as they are; n has length 1 as nearly as the point is on the sphere.
    #[inline]
    pub fn hit_at(&self, t: R, point: R::Vec3) -> Hit3<R> {
        Hit { t, point, normal: (point - self.center) / self.radius }
    }
}

/// The formulations of this chapter, by the names that `--method` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// House 4.4.
    ClosestApproach,
    /// The same in scalars, as most programs have it.
    Shortcut,
    /// Gambetta, Listing 2-5.
    Quadratic,
    /// CSC418 11.3.3.
    HalfQuadratic,
    /// The same for many rays at once.
    Batched,
    /// Right where the others are not.
    Robust,
}

impl Method {
    /// Every method, in the order of the notes.
    pub const ALL: [Method; 6] = [
        Method::ClosestApproach,
        Method::Shortcut,
        Method::Quadratic,
        Method::HalfQuadratic,
        Method::Batched,
        Method::Robust,
    ];

    /// The name that `--method` takes.
    pub fn name(self) -> &'static str {
        match self {
            Method::ClosestApproach => "closest-approach",
            Method::Shortcut => "shortcut",
            Method::Quadratic => "quadratic",
            Method::HalfQuadratic => "half-quadratic",
            Method::Batched => "batched",
            Method::Robust => "robust",
        }
    }

    /// Works the method out for one ray and one sphere. Degenerate ones give values that mean nothing;
    /// [`Working::hit`] refuses them.
    pub fn work<R: Real>(self, ray: &Ray3<R>, sphere: &Sphere<R>) -> Working<R> {
        match self {
            Method::ClosestApproach => Working::ClosestApproach(closest_approach(ray, sphere)),
            Method::Shortcut => Working::Shortcut(shortcut(ray, sphere)),
            Method::Quadratic => Working::Quadratic(quadratic(ray, sphere)),
            Method::HalfQuadratic => Working::HalfQuadratic(half_quadratic(ray, sphere)),
            Method::Batched => Working::Batched(batched(ray, sphere)),
            Method::Robust => Working::Robust(robust(ray, sphere)),
        }
    }
}

/// One method's intermediate values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Working<R: Real> {
    /// By House's method.
    ClosestApproach(ClosestApproach<R>),
    /// By the scalar shortcut.
    Shortcut(Shortcut<R>),
    /// By Gambetta's.
    Quadratic(Quadratic<R>),
    /// By CSC418's.
    HalfQuadratic(HalfQuadratic<R>),
    /// In one lane of a batch.
    Batched(Batched<R>),
    /// By the robust one.
    Robust(Robust<R>),
}

impl<R: Real> Working<R> {
    /// The two crossings, in lengths of the direction as given; either may be negative. `None` where the line
    /// misses. Means nothing for what [`Sphere::check`] refuses.
    pub fn roots(&self) -> Option<Roots<R>> {
        match self {
            Working::ClosestApproach(work) => work.roots(),
            Working::Shortcut(work) => work.roots(),
            Working::Quadratic(work) => work.roots(),
            Working::HalfQuadratic(work) => work.roots(),
            Working::Batched(work) => work.roots(),
            Working::Robust(work) => work.roots(),
        }
    }

    /// The nearest hit in `span`: for a ray that starts inside, where it leaves. The normal points outward.
    ///
    /// `None` for a miss, [`Degenerate`] for a question without an answer, see [`Sphere::check`].
    pub fn hit(&self, span: Span<R>) -> Result<Option<Hit3<R>>, Degenerate> {
        match self {
            Working::ClosestApproach(work) => work.hit(span),
            Working::Shortcut(work) => work.hit(span),
            Working::Quadratic(work) => work.hit(span),
            Working::HalfQuadratic(work) => work.hit(span),
            Working::Batched(work) => work.hit(span),
            Working::Robust(work) => work.hit(span),
        }
    }
}

//! Whitted's recursive ray tracer (CSC418 11.7).
//!
//! ```text
//! rayTrace(ā, b⃗, depth):  what the ray hits first (findFirstHit), then rtShade there
//! rtShade(OBJ, p̄, n⃗, d⃗_e, depth):  the local model of chapter 10, and if depth < maxDepth
//!     a ray in the mirror direction and one in the refracted direction
//! ```
//!
//! [`Tracer`] is those three functions of the page, in [`mod@ray_trace`]. The two directions are
//! [`mod@mirror`] and [`mod@refract`], and [`mod@media`] knows in which solid a ray is. What the functions
//! tell while they run goes to a [`Witness`]: nobody, who costs nothing; the [`Counts`]; or the [`tree`] of
//! all rays of one pixel, down to the last term.
//!
//! Only what the scene requires is modeled: see [`mod@requirements`]. And what can change nothing that
//! anybody wants to know may be left out: see [`mod@tolerance`]. `render` traces a whole picture, `from_file`
//! takes a scene from a file, and `scenes` has the chapter's own.
//!
//! From glass into air: straight through at a right angle, and not at all beyond the critical angle.
//!
//! ```
//! use glam::DVec3;
//! use whitted::{critical_angle, refract};
//!
//! let straight = refract::<f64>(-DVec3::Y, DVec3::Y, 1.5, 1.0);
//! assert_eq!(straight.t, Some(-DVec3::Y));
//!
//! assert_eq!(critical_angle(1.5, 1.0).map(f64::round), Some(42.0));
//! let slanted = refract::<f64>(DVec3::new(0.8, -0.6, 0.0), DVec3::Y, 1.5, 1.0);
//! assert!(slanted.sin2_theta2 > 1.0 && slanted.t.is_none());
//! ```

#[cfg(feature = "stage")]
mod auto;
pub mod counts;
#[cfg(feature = "stage")]
mod explain;
#[cfg(feature = "stage")]
pub mod figure;
#[cfg(feature = "stage")]
pub mod from_file;
#[cfg(feature = "stage")]
mod inspect;
#[cfg(feature = "stage")]
pub mod measure;
pub mod media;
pub mod mirror;
#[cfg(feature = "stage")]
mod picture;
pub mod ray_trace;
pub mod refract;
#[cfg(feature = "stage")]
pub mod render;
#[cfg(feature = "stage")]
pub mod report;
pub mod requirements;
pub mod scene;
#[cfg(feature = "stage")]
pub mod scenes;
#[cfg(feature = "stage")]
mod show;
#[cfg(feature = "stage")]
pub mod stage;
pub mod tolerance;
pub mod tree;
pub mod witness;

pub use counts::Counts;
pub use media::Media;
pub use mirror::{Mirror, mirror};
pub use ray_trace::{Path, Tracer};
pub use refract::{Refraction, critical_angle, refract};
pub use requirements::{Feature, Requirements};
pub use scene::{Optics, Scene};
pub use tolerance::Tolerance;
pub use tree::Tree;
pub use witness::{Kind, Sent, Witness};

#[cfg(all(test, feature = "stage"))]
mod by_hand;
#[cfg(all(test, feature = "stage"))]
mod lit_scenes;

//! How much light leaves a surface, as seen from a ray that hit it.
//!
//! CSC418 11.6 and 11.7: at the hit point p̄ with the normal n⃗ ([`mod@normal`]) the local model gives
//!
//! ```text
//! E = r_a I_a C + Σ V [ r_d I C max(0, n⃗·s⃗) + r_s I max(0, c⃗·m⃗)^α ]
//! ```
//!
//! term by term in [`mod@phong`], with the color C from a texture where there is one ([`mod@texture`]), and
//! with V = 0 for a light that p̄ does not see ([`mod@shadow`]). [`mod@landing`] is p̄ and its normals for a
//! ray, [`mod@lighting`] the sum over all lights. A [`Scene`] is chapter 08's, with what its objects are made
//! of and what shines on them; light is linear ([`Rgb`]).
//!
//! To ask whether p̄ sees the light is to send a second ray, and there the page has a gap. p̄ is rounded: it lies a
//! little before its surface or behind it, and from behind the surface shades itself. [`mod@start`] has the remedies
//! that people use and the one that follows from how large the error can be.
//!
//! A light straight above a matte surface, seen from straight above:
//!
//! ```
//! use glam::DVec3;
//! use shading::{Material, Rgb, phong};
//!
//! let red = Rgb([1.0, 0.0, 0.0]);
//! let matte = Material { color: red, ambient: 0.1, diffuse: 0.5, specular: 0.0, shininess: 32.0 };
//! let work = phong::<f64>(&matte, red, Rgb::WHITE, DVec3::Y, DVec3::new(0.0, 7.0, 0.0), DVec3::Y);
//! assert_eq!(work.n_dot_s, 1.0);
//! assert_eq!(work.diffuse, Rgb([0.5, 0.0, 0.0]));
//! ```

#[cfg(feature = "stage")]
mod explain;
#[cfg(feature = "stage")]
pub mod from_file;
pub mod landing;
#[cfg(feature = "stage")]
mod layout;
pub mod lighting;
pub mod material;
#[cfg(feature = "stage")]
mod measure;
pub mod normal;
#[cfg(feature = "stage")]
mod own;
pub mod phong;
#[cfg(feature = "stage")]
mod picture;
#[cfg(feature = "stage")]
mod render;
#[cfg(feature = "stage")]
mod report;
pub mod rgb;
pub mod scene;
pub mod shadow;
#[cfg(feature = "stage")]
pub mod stage;
pub mod start;
pub mod texture;

pub use landing::Landing;
pub use lighting::{Fate, Lighting, Point};
pub use material::Material;
pub use phong::{Phong, phong};
pub use rgb::Rgb;
pub use scene::{Light, Painted, Scene};
pub use start::{Start, Starts};
pub use texture::{Texture, Textured};

#[cfg(all(test, feature = "stage"))]
mod tests;

//! Scenes read from files: plain data, and for every value the place where it stands.
//!
//! A scene file says what there is: a camera, lights, materials, objects. [`Scene::read`] takes it in TOML or
//! in Haines's NFF, with the meshes (OBJ) and the pictures (PNG) that it names. It knows no mathematics: a
//! chapter takes from a [`Scene`] what its own model needs, and where a value means nothing to it (a matrix
//! without an inverse, a camera that looks nowhere) it says so with [`Scene::fault`], which points at the
//! line.
//!
//! ```
//! # use std::path::Path;
//! let text = "[camera]\neye = [0, 1, -6]\nlookat = [0, 0, 0]\n";
//! let error = scene_file::Scene::from_toml("my.toml", text, Path::new("")).unwrap_err();
//! assert!(error.to_string().starts_with("my.toml:3:1: unknown key `lookat` in this camera"));
//! assert!(error.remedy().starts_with("write `look_at`"));
//! ```
//!
//! Nothing here panics, and no memory is taken that was not bounded before: see `limits.rs`.

mod assets;
mod camera;
mod error;
mod excerpt;
mod file;
mod limits;
mod nff;
mod obj;
mod object;
mod picture;
mod place;
mod read;
mod source;
mod toml;
mod word;

pub use camera::{Camera, Extent, Grid, Handedness, View};
pub use error::Error;
pub use object::{Mesh, Object, Shape, Transform};
pub use place::{At, Place};

/// All that a scene file says, or implies by leaving it out.
#[derive(Clone, Debug)]
pub struct Scene {
    /// rayTrace's maxDepth, 1 to 1000.
    pub max_depth: u32,
    /// What a ray sees that meets nothing, linear RGB, from 0 up.
    pub background: [f64; 3],
    /// The ambient light I_a, linear RGB, from 0 up.
    pub ambient: [f64; 3],
    /// From where the scene is seen.
    pub camera: Camera,
    /// The point lights, in the order of the file.
    pub lights: Vec<Light>,
    /// The materials, in the order of the file.
    pub materials: Vec<Material>,
    /// The objects, in the order of the file: on a tie the earlier one is seen.
    pub objects: Vec<Object>,
    /// The file.
    source: std::sync::Arc<source::Source>,
}

/// A point light.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Where it is, in the world.
    pub position: At<[f64; 3]>,
    /// I_d and I_s, linear RGB, from 0 up.
    pub intensity: [f64; 3],
}

/// How a surface answers light. Coefficients and colors are 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name in the file; of an NFF file, the number of its `f`, from 1.
    pub name: String,
    /// Multiplies the ambient and the diffuse term, linear RGB.
    pub color: [f64; 3],
    /// r_a
    pub ambient: f64,
    /// r_d
    pub diffuse: f64,
    /// r_s
    pub specular: f64,
    /// α, from 0 up.
    pub shininess: f64,
    /// r_g
    pub mirror: f64,
    /// refractiveReflCoef
    pub transmit: f64,
    /// The index of refraction of the inside, above 0.
    pub ior: f64,
    /// Multiplies the color where there is one.
    pub texture: Option<At<Texture>>,
}

/// What varies over a surface, in its (u, v).
#[derive(Clone, Debug, PartialEq)]
pub enum Texture {
    /// Two colors in turns, linear RGB.
    Checker {
        /// The one at (0, 0), and the other.
        colors: [[f64; 3]; 2],
        /// The side of a square, above 0.
        scale: f64,
    },
    /// A picture, repeated.
    Image {
        /// Columns and rows.
        size: (u32, u32),
        /// Red, green and blue as the file has them, from 0 to 255, row by row from the top; what they mean,
        /// linear or not, is for whoever uses them.
        pixels: std::sync::Arc<[[u8; 3]]>,
        /// How much of (u, v) it covers, above 0.
        scale: f64,
    },
}

//! A scene for the recursive tracer from what a file says: all of it.

use math::Real;
use scene_file::Error;

use crate::{Optics, Scene};

/// The scene of a file, for a picture of `size` pixels, traced to `max_depth`; `None`: as the file says.
///
/// An [`Error`] with its place as [`shading::from_file::scene`] gives it.
pub fn scene<R: Real>(
    file: &scene_file::Scene,
    size: Option<(u32, u32)>,
    max_depth: Option<u32>,
) -> Result<Scene<R>, Error> {
    let optics = |it: &scene_file::Material| Optics { mirror: it.mirror, transmit: it.transmit, ior: it.ior };
    Ok(Scene {
        lit: shading::from_file::scene(file, size)?,
        optics: file.materials.iter().map(optics).collect(),
        max_depth: max_depth.unwrap_or(file.max_depth),
    })
}

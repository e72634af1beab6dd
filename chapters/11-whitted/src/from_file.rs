//! A scene for the recursive tracer from what a file says: all of it.

use math::Real;
use scene_file::Error;
use shading::{Rgb, Texture, Textured};

use crate::{Optics, Scene};

/// The scene of a file, for a picture of `size` = (columns, rows), traced to `max_depth` ≥ 1; `None`: as the
/// file says.
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

/// Puts a white texture on every object of a scene that has none and a shape with (u, v): then (u, v) is
/// worked out wherever it can be, and the colors are the same. `file` is where the scene is from.
pub fn idle_textures<R: Real>(scene: &mut Scene<R>, file: &scene_file::Scene) {
    let white = Texture::Checker { colors: [Rgb::WHITE; 2], scale: 1.0 };
    for (painted, it) in scene.lit.painted.iter_mut().zip(&file.objects) {
        if painted.texture.is_none() {
            let mapping = shading::from_file::mapping(it);
            painted.texture = mapping.map(|mapping| Box::new(Textured { mapping, texture: white.clone() }));
        }
    }
}

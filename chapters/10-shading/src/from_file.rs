//! A scene with light from what a file says: of its materials what the local model needs, and its lights.

use affine::Affine;
use math::{Real, Vector};
use scene_file::{Error, Shape};
use signature::deform;
use signature::from_file::transform;

use crate::texture::{Back, Mapping};
use crate::{Light, Material, Painted, Rgb, Scene, Texture, Textured};

/// The scene of a file, for a picture of `size` pixels; `None`: of the size that the file says.
///
/// An [`Error`] with its place as [`signature::from_file::scene`] gives it, and where a light is too far away
/// for R.
pub fn scene<R: Real>(file: &scene_file::Scene, size: Option<(u32, u32)>) -> Result<Scene<R>, Error> {
    Ok(Scene {
        geometry: signature::from_file::scene(file, size)?,
        painted: file.objects.iter().map(|it| painted(file, it)).collect(),
        materials: file.materials.iter().map(material).collect(),
        lights: file.lights.iter().map(|it| light(file, it)).collect::<Result<_, _>>()?,
        ambient: Rgb(file.ambient),
        background: Rgb(file.background),
    })
}

fn material(it: &scene_file::Material) -> Material {
    Material {
        color: Rgb(it.color),
        ambient: it.ambient,
        diffuse: it.diffuse,
        specular: it.specular,
        shininess: it.shininess,
    }
}

fn light<R: Real>(file: &scene_file::Scene, it: &scene_file::Light) -> Result<Light<R>, Error> {
    let [x, y, z] = it.position.value.map(R::round_from);
    let position = R::vec3(x, y, z);
    if !position.is_finite() {
        let problem = format!("the light is too far away for {}", R::NAME);
        return Err(file.fault(it.position.place, &problem, "bring it nearer, or take --precision f64"));
    }
    Ok(Light { position, intensity: Rgb(it.intensity) })
}

fn painted(file: &scene_file::Scene, it: &scene_file::Object) -> Painted {
    let texture = file.materials[it.material].texture.as_ref().and_then(|texture| {
        Some(Box::new(Textured { mapping: mapping(it)?, texture: pattern(&texture.value) }))
    });
    Painted { material: it.material, texture }
}

/// How an object gets its (u, v); `None` for a shape that has none: all but planes, spheres and triangles.
pub fn mapping(it: &scene_file::Object) -> Option<Mapping> {
    let steps: Vec<_> = it.transform.iter().map(|step| transform(step.value)).collect();
    let by: Affine<f64> = deform::composed(&steps);
    let back = (!steps.is_empty()).then(|| Back::of(&by));
    match it.shape {
        Shape::Plane { point, normal } => Some(Mapping::plane(point, normal, back)),
        Shape::Sphere { center, radius } => Some(Mapping::Sphere { back, center, radius }),
        Shape::Triangle { .. } => Some(Mapping::Triangle),
        _ => None,
    }
}

fn pattern(it: &scene_file::Texture) -> Texture {
    match it {
        scene_file::Texture::Checker { colors, scale } => {
            Texture::Checker { colors: colors.map(Rgb), scale: *scale }
        }
        scene_file::Texture::Image { size, pixels, scale } => {
            Texture::Image { size: *size, pixels: pixels.clone(), scale: *scale }
        }
    }
}

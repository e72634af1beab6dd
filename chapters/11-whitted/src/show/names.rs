//! What things are called.

use math::Real;

use crate::Scene;

/// What the objects and the materials of a scene are called.
pub(crate) struct Names {
    objects: Vec<String>,
    materials: Vec<String>,
}

impl Names {
    /// The names as the file has them.
    pub(crate) fn new<R: Real>(file: &scene_file::Scene, scene: &Scene<R>) -> Names {
        // those of an NFF file are numbers
        let name =
            |it: &str| if it.parse::<u32>().is_ok() { format!("material {it}") } else { it.to_string() };
        let materials: Vec<String> = file.materials.iter().map(|material| name(&material.name)).collect();
        let objects = scene.lit.geometry.objects.iter().zip(&scene.lit.painted).enumerate();
        let objects = objects.map(|(place, (object, painted))| {
            let name = object.shape.name();
            let name =
                name.strip_suffix(", deformed").map_or(name.to_string(), |it| format!("deformed {it}"));
            format!("{}, {name} of {}", place + 1, materials[painted.material])
        });
        Names { objects: objects.collect(), materials }
    }

    /// An object: its place in the file, from 1, its shape and its material.
    pub(crate) fn object(&self, place: usize) -> &str {
        &self.objects[place]
    }

    /// A stack of media: the solids' places, from 1, and materials.
    pub(crate) fn media(&self, solids: &[usize]) -> String {
        let short = |&solid: &usize| self.objects[solid].clone();
        format!("[{}]", solids.iter().map(short).collect::<Vec<String>>().join("; "))
    }

    /// A material.
    pub(crate) fn material(&self, place: usize) -> &str {
        &self.materials[place]
    }
}

//! The scenes that are part of this chapter.

use signature::stage::fault;
use stage::Error;

/// A scene that is part of the program.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// Its name, for `--regime`.
    pub name: &'static str,
    /// What it is, in half a sentence.
    pub what: &'static str,
    /// Its file, from the project's root: for `--scene`.
    pub path: &'static str,
    /// What is in the file.
    bytes: &'static [u8],
}

impl BuiltIn {
    /// The scene. An [`Error`] where the file is no scene, which a test rules out.
    pub fn file(&self) -> Result<scene_file::Scene, Error> {
        let teapot: &[u8] = include_bytes!("../../08-signature/scenes/teapot.obj");
        let files = [(self.path, self.bytes), ("../../08-signature/scenes/teapot.obj", teapot)];
        scene_file::Scene::built_in(self.path, &files).map_err(fault)
    }
}

macro_rules! built_in {
    ($name:literal, $path:literal, $what:literal) => {
        BuiltIn { name: $name, what: $what, path: $path, bytes: include_bytes!(concat!("../../../", $path)) }
    };
}

/// The chapter's own scene first.
pub const SCENES: [BuiltIn; 9] = [
    built_in!(
        "whitted",
        "chapters/11-whitted/scenes/whitted.toml",
        "a thin ball of glass before a mirror, after Whitted 1980"
    ),
    built_in!("gambetta", "chapters/11-whitted/scenes/gambetta.toml", "Gambetta's four spheres, mirroring"),
    built_in!("water", "chapters/11-whitted/scenes/water.toml", "an eye under water, the critical angle"),
    built_in!(
        "hall-of-mirrors",
        "chapters/11-whitted/scenes/hall-of-mirrors.toml",
        "two mirrors that face each other, depth 50"
    ),
    built_in!("chess", "chapters/11-whitted/scenes/chess.toml", "pieces of transformed solids, one of glass"),
    built_in!(
        "buckyball",
        "chapters/11-whitted/scenes/buckyball.toml",
        "60 atoms and 90 bonds around a ball of glass"
    ),
    built_in!(
        "teapot",
        "chapters/11-whitted/scenes/teapot.toml",
        "Newell's teapot, smooth, on polished stone"
    ),
    built_in!("balls3", "chapters/11-whitted/scenes/balls3.nff", "Haines's sphere flake of 820 mirrors"),
    built_in!(
        "mount4",
        "chapters/08-signature/scenes/mount4.nff",
        "Haines's mountain under four balls of glass"
    ),
];

/// One of the chapter's own scenes, by the name that `--regime` takes.
///
/// [`Error::Request`] where there is none of that name.
pub fn built_in(name: &str) -> Result<scene_file::Scene, Error> {
    match SCENES.iter().find(|scene| scene.name == name) {
        Some(scene) => scene.file(),
        None => Err(Error::Request(format!("there is no scene `{name}` in chapter 11"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::from_file;

    /// The same as from the file, for both precisions.
    #[test]
    fn every_scene_is_one() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        for scene in SCENES {
            let built_in = scene.file().unwrap();
            let read = scene_file::Scene::read(&root.join(scene.path)).unwrap();
            assert_eq!(built_in.objects.len(), read.objects.len(), "{}", scene.name);
            let double = from_file::scene::<f64>(&built_in, None, None).unwrap();
            assert!(from_file::scene::<f32>(&built_in, None, None).is_ok(), "{}", scene.name);
            let read = from_file::scene::<f64>(&read, None, None).unwrap();
            assert_eq!(double.lit.geometry, read.lit.geometry, "{}", scene.name);
        }
    }
}

//! The scenes that are part of this chapter.

use std::path::Path;

use stage::Error;

use crate::stage::fault;

/// A scene whose text is part of the program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BuiltIn {
    /// Its name, for `--regime`.
    pub(crate) name: &'static str,
    /// What it is, in half a sentence.
    pub(crate) what: &'static str,
    /// The name of its file.
    file: &'static str,
    text: &'static str,
}

macro_rules! built_in {
    ($name:literal, $file:literal, $what:literal) => {
        BuiltIn { name: $name, what: $what, file: $file, text: include_str!(concat!("../../scenes/", $file)) }
    };
}

/// The chapter's own scene first.
pub(crate) const SCENES: [BuiltIn; 11] = [
    built_in!("signature", "signature.toml", "each shape of chapters 03 to 07 once"),
    built_in!("spheres", "spheres.toml", "Gambetta's three spheres on his lattice, Figure 2-10"),
    built_in!("far", "far.toml", "six objects, ten thousand radii away"),
    built_in!("shifted", "shifted.toml", "five objects, everything moved by 1e5"),
    built_in!("tiny", "tiny.toml", "four objects of a millionth of a millimeter"),
    built_in!("teapot", "teapot.toml", "Newell's teapot, 992 triangles, on a plane"),
    built_in!("balls2", "balls2.nff", "Haines's balls: 91 spheres on a square"),
    built_in!("rings2", "rings2.nff", "Haines's rings: 150 spheres, 150 open cylinders"),
    built_in!("tetra4", "tetra4.nff", "Haines's tetrahedron of 256 triangles"),
    built_in!("mount4", "mount4.nff", "Haines's mountain: 512 triangles, four spheres"),
    built_in!("gears1", "gears1.nff", "Haines's gears: 147 polygons, two of 144 corners"),
];

impl BuiltIn {
    /// The scene.
    pub(crate) fn file(&self) -> Result<scene_file::Scene, Error> {
        let scene = if self.file.ends_with(".nff") {
            scene_file::Scene::from_nff(self.file, self.text)
        } else {
            let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");
            scene_file::Scene::from_toml(self.file, self.text, Path::new(folder))
        };
        scene.map_err(fault)
    }
}

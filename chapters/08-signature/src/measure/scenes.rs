//! The scenes that are part of this chapter.

use stage::Error;

use crate::stage::fault;

/// A scene that is part of the program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BuiltIn {
    /// Its name, for `--regime`.
    pub(crate) name: &'static str,
    /// What it is, in half a sentence.
    pub(crate) what: &'static str,
    /// The name of its file.
    file: &'static str,
}

impl BuiltIn {
    const fn new(name: &'static str, file: &'static str, what: &'static str) -> BuiltIn {
        BuiltIn { name, what, file }
    }

    /// The scene.
    pub(crate) fn file(&self) -> Result<scene_file::Scene, Error> {
        scene_file::Scene::built_in(self.file, &FILES).map_err(fault)
    }
}

/// The chapter's own scene first.
pub(crate) const SCENES: [BuiltIn; 11] = [
    BuiltIn::new("signature", "signature.toml", "each shape of chapters 03 to 07 once"),
    BuiltIn::new("spheres", "spheres.toml", "Gambetta's three spheres on his lattice, Figure 2-10"),
    BuiltIn::new("far", "far.toml", "six objects, ten thousand radii away"),
    BuiltIn::new("shifted", "shifted.toml", "five objects, everything moved by 1e5"),
    BuiltIn::new("tiny", "tiny.toml", "four objects of a few billionths"),
    BuiltIn::new("teapot", "teapot.toml", "Newell's teapot, 992 triangles, on a plane"),
    BuiltIn::new("balls2", "balls2.nff", "Haines's balls: 91 spheres on a square"),
    BuiltIn::new("rings2", "rings2.nff", "Haines's rings: 150 spheres, 150 open cylinders"),
    BuiltIn::new("tetra4", "tetra4.nff", "Haines's tetrahedron of 256 triangles"),
    BuiltIn::new("mount4", "mount4.nff", "Haines's mountain: 512 triangles, four spheres"),
    BuiltIn::new("gears1", "gears1.nff", "Haines's gears: 147 polygons, two of 144 corners"),
];

macro_rules! files {
    ($($name:literal)*) => { [$(($name, include_bytes!(concat!("../../scenes/", $name)))),*] };
}

/// The folder `scenes`.
const FILES: [(&str, &[u8]); 13] = files!(
    "signature.toml" "octahedron.obj" "spheres.toml" "far.toml" "shifted.toml" "tiny.toml" "teapot.toml" "teapot.obj"
    "balls2.nff" "rings2.nff" "tetra4.nff" "mount4.nff" "gears1.nff"
);

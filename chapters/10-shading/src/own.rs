//! The scenes of this chapter.

use math::Real;
use signature::stage::fault;
use stage::Error;

use crate::{Scene, from_file};

/// The scene that is shown when none is asked for, and the files that it names.
const FILES: [(&str, &[u8]); 3] = [
    ("shading.toml", include_bytes!("../scenes/shading.toml")),
    ("sail.png", include_bytes!("../scenes/sail.png")),
    ("../../08-signature/scenes/teapot.obj", include_bytes!("../../08-signature/scenes/teapot.obj")),
];

/// The chapter's own scene.
pub(crate) fn file() -> Result<scene_file::Scene, Error> {
    scene_file::Scene::built_in("shading.toml", &FILES).map_err(fault)
}

/// The scales of the small scene.
pub(crate) const SCALES: [f64; 5] = [1e-6, 1e-3, 1.0, 1e3, 1e6];

/// Where the small scene stands, in scales: as scenes do, not at the origin, so that its coordinates have
/// something to round.
const AWAY: [f64; 3] = [-31.0, 17.0, 23.0];

/// What second rays have to get right, all of it `scale` times as large: a ball on the ground, a drum beside
/// it, and their shadows, in a picture of `size` pixels.
///
/// [`Error::Request`] where the grid has no such picture.
pub(crate) fn small<R: Real>(scale: f64, size: (u32, u32)) -> Result<Scene<R>, Error> {
    let text = small_text(scale);
    let file = scene_file::Scene::from_toml("the small scene", &text, std::path::Path::new(""));
    from_file::scene(&file.map_err(fault)?, Some(size)).map_err(fault)
}

/// The small scene as one would write it down.
fn small_text(scale: f64) -> String {
    let at_home = |[x, y, z]: [f64; 3]| format!("[{:e}, {:e}, {:e}]", x * scale, y * scale, z * scale);
    let at = |[x, y, z]: [f64; 3]| at_home([x + AWAY[0], y + AWAY[1], z + AWAY[2]]);
    format!(
        "background = [0.45, 0.6, 0.8]
[camera]
eye = {eye}
look_at = {look_at}
window = [-0.4, 0.4, -0.2, 0.2]
[[light]]
position = {light}
intensity = [1, 1, 1]
[material.ground]
color = [0.85, 0.83, 0.75]
[material.ball]
color = [0.9, 0.45, 0.3]
specular = 0.4
[material.drum]
color = [0.45, 0.62, 0.55]
[[object]]
plane = {{ point = {ground}, normal = [0.02, 1, 0.03] }}
material = \"ground\"
[[object]]
sphere = {{ center = {ball}, radius = {radius:e} }}
material = \"ball\"
[[object]]
cylinder = {{}}
transform = [{{ scale = {wide} }}, {{ rotate = {{ axis = [1, 0, 0], degrees = 90 }} }}, {{ translate = {drum} }}]
material = \"drum\"
",
        eye = at([3.0, 2.2, 7.0]),
        look_at = at([0.0, 0.45, 0.0]),
        light = at([-6.0, 7.0, 4.0]),
        ground = at([0.0, 0.0, 0.0]),
        ball = at([-0.8, 0.9, 0.0]),
        radius = 0.9 * scale,
        // sunk a little into the ground
        wide = at_home([0.7, 0.7, 0.4]),
        drum = at([1.2, 0.3, 0.5]),
    )
}

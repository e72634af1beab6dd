//! A scene of ours in POV-Ray's language.
//!
//! World coordinates stay as they are. POV-Ray calls its axes left-handed, but a camera that is given by its
//! own vectors (`location`, `direction`, `right`, `up`) sees through them whatever they are called.
//!
//! What a hit point returns is E of our model, term by term: `ambient`, `diffuse` and `phong` are r_a, r_d
//! and r_s, `phong_size` is α, `reflection` r_g. See `material.rs` for what lets light through, and the
//! crate's README for what POV-Ray cannot be told.

mod camera;
mod material;
mod number;
mod shape;

use std::fmt::Write;

use scene_file::{Error, Scene};

use number::vector;

/// What the picture is to be, where it is not what the file says.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wanted {
    /// Columns and rows.
    pub size: Option<(u32, u32)>,
    /// rayTrace's maxDepth.
    pub depth: Option<u32>,
    /// Whether what lets light through casts a whole shadow all the same, as ours does: an opaque copy of it
    /// is added that nothing but shadow rays meet. So the pictures are the same; it is not how one would time
    /// POV-Ray.
    pub whole_shadows: bool,
}

/// The text of a `.pov` file that draws the scene.
///
/// An [`Error`] with its place where the scene has no picture (a camera without a frame, a flat transform)
/// and where it says what POV-Ray would draw differently: a texture, or a surface that lets all light through
/// and returns some as well.
pub fn scene(file: &Scene, wanted: Wanted) -> Result<String, Error> {
    let world = signature::from_file::scene::<f64>(file, wanted.size)?;
    let depth = wanted.depth.unwrap_or(file.max_depth);
    let mut text = String::from("#version 3.7;\n");
    let _ = writeln!(
        text,
        "global_settings {{ assumed_gamma 1 max_trace_level {depth} adc_bailout 0 ambient_light rgb {} }}",
        vector(file.ambient)
    );
    let _ = writeln!(text, "background {{ rgb {} }}", vector(file.background));
    text += &camera::camera(&world);
    for light in &file.lights {
        let (position, intensity) = (vector(light.position.value), vector(light.intensity));
        let _ = writeln!(text, "light_source {{ {position} rgb {intensity} }}");
    }
    for (place, it) in file.materials.iter().enumerate() {
        let _ = writeln!(text, "#declare M{place} = {}", material::material(it));
    }
    for (it, placed) in file.objects.iter().zip(&world.objects) {
        let material = &file.materials[it.material];
        material::check(file, it, material)?;
        let surface =
            format!("texture {{ M{} }}{}", it.material, material::interior(&placed.shape, material));
        let is_patch = matches!(it.shape, scene_file::Shape::Patch { .. });
        text += &shape::shape(&placed.shape, &surface, is_patch);
        if wanted.whole_shadows && material.transmit > 0.0 {
            text += &shape::shape(&placed.shape, "no_image no_reflection", is_patch);
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    const SMALL: &str = "
        max_depth = 4
        background = [0.25, 0.5, 0.75]
        ambient = [0.5, 0.5, 1]
        [camera]
        eye = [0, 1, -6]
        forward = [0, 0, 2]
        handedness = \"left\"
        window = [-2, 4, -1, 2]
        distance = 3
        size = [60, 30]
        [[light]]
        position = [5, 10, -5]
        intensity = [1, 0.5, 2]
        [material.glass]
        color = [1, 0.5, 0]
        ambient = 0.125
        diffuse = 0.25
        specular = 0.5
        shininess = 20
        mirror = 0.1
        transmit = 0.75
        ior = 1.5
        [[object]]
        sphere = { center = [0, 1, 0], radius = 2 }
        material = \"glass\"
    ";

    fn lines(wanted: Wanted) -> Vec<String> {
        let file = Scene::from_toml("small.toml", SMALL, Path::new("")).unwrap();
        scene(&file, wanted).unwrap().lines().map(String::from).collect()
    }

    #[test]
    fn a_small_scene_line_by_line() {
        // forward z, up y, and up × forward = x to the right. The window's center is (1, ½), so the direction
        // is 3 w + 1 u + ½ v; its width is 6, its height 3. A quarter of ambient and diffuse is left by
        // transmit ¾, so they are written four times as large.
        let settings = "assumed_gamma 1 max_trace_level 4 adc_bailout 0 ambient_light rgb <0.5,0.5,1>";
        let want = [
            "#version 3.7;",
            &format!("global_settings {{ {settings} }}"),
            "background { rgb <0.25,0.5,0.75> }",
            "camera { perspective location <0,1,-6> direction <1,0.5,3> right <6,0,0> up <0,3,0> }",
            "light_source { <5,10,-5> rgb <1,0.5,2> }",
            "#declare M0 = texture { pigment { rgbt <1,0.5,0,0.75> } \
             finish { ambient 0.5 diffuse 1 phong 0.5 phong_size 20 reflection { rgb 0.1 } } }",
            "sphere { <0,1,0>, 2 texture { M0 } interior { ior 1.5 } }",
        ];
        assert_eq!(lines(Wanted::default()), want);
    }

    #[test]
    fn what_is_wanted_goes_before_what_the_file_says() {
        let wanted = Wanted { size: Some((20, 20)), depth: Some(2), whole_shadows: true };
        let lines = lines(wanted);
        assert!(lines[1].contains("max_trace_level 2 "), "{}", lines[1]);
        assert_eq!(lines.last().unwrap(), "sphere { <0,1,0>, 2 no_image no_reflection }");
    }
}

//! Scenes for tests: the chapter's own ones, and those of chapter 08 with lights and with materials that
//! mirror and let through.

use bounds::Parts;
use math::Real;
use scene_file::{At, Light, Scene as File};
use signature::Method;

use crate::render::{Rendered, render};
use crate::{Counts, Requirements, Tolerance, Tracer, from_file};

/// The scenes of chapter 08 by name.
pub(crate) const OF_CHAPTER_08: [&str; 11] = [
    "signature",
    "spheres",
    "far",
    "shifted",
    "tiny",
    "teapot",
    "balls2",
    "rings2",
    "tetra4",
    "mount4",
    "gears1",
];

/// The chapter's own scenes, and each of chapter 08's as it is, with materials that bend, and with such as do
/// not.
pub(crate) fn all() -> Vec<(String, File)> {
    let own = crate::scenes::SCENES.iter().map(|scene| (scene.name.to_string(), scene.file().unwrap()));
    let mut all: Vec<(String, File)> = own.collect();
    for name in OF_CHAPTER_08 {
        let file = signature::stage::built_in(name).unwrap();
        all.push((name.to_string(), lit(file.clone())));
        all.push((format!("{name}, bent"), with(file.clone(), 0.3, 0.5, 1.4)));
        all.push((format!("{name}, unbent"), with(file, 0.3, 0.5, 1.0)));
    }
    all
}

/// With two lights more: one at the eye, and one as far to the side as the eye is from the origin.
fn lit(mut file: File) -> File {
    let eye = file.camera.eye.value;
    let far = eye.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let aside = [eye[0] + far, eye[1] + far, eye[2]];
    let place = file.camera.eye.place;
    for (position, intensity) in [(eye, [0.4; 3]), (aside, [0.6, 0.5, 0.4])] {
        file.lights.push(Light { position: At { value: position, place }, intensity });
    }
    file
}

/// The same, and every material with these coefficients.
fn with(file: File, mirror: f64, transmit: f64, ior: f64) -> File {
    let mut file = lit(file);
    for material in &mut file.materials {
        (material.mirror, material.transmit, material.ior) = (mirror, transmit, ior);
    }
    file
}

/// A small picture of a scene, with what `more` makes of its requirements, and within a tolerance.
pub(crate) fn picture<R: Real>(
    file: &File,
    method: Method,
    depth: u32,
    more: impl Fn(Requirements) -> Requirements,
    tolerance: Option<f64>,
) -> Rendered {
    let size = (16, 12);
    let mut scene = from_file::scene::<R>(file, Some(size), Some(depth)).unwrap();
    let required = more(Requirements::of(&scene, Parts::of(&scene.lit.geometry).count()));
    if required.idle_textures {
        from_file::idle_textures(&mut scene, file);
    }
    let bounded = required.bounded(method, &scene.lit.geometry);
    let tolerance = tolerance.map(|e| Tolerance::new(&scene, e));
    let tracer = Tracer::new(&scene, &bounded, &required, tolerance);
    render(&tracer, size, 1, Some(2), None).unwrap()
}

/// What a small picture of each of them takes and shows: the rays by kind, the tests, and the sum of all pixels, to its last
/// digit.
#[test]
fn what_a_picture_takes() {
    fn line<R: Real>(name: &str, file: &File) -> String {
        let Rendered { radiance, counts, .. } = picture::<R>(file, Method::Robust, 5, |it| it, None);
        let sum = |channel: usize| radiance.iter().map(|e| e.0[channel]).sum::<f64>();
        let Counts { eye, shadow, mirror, refracted, left_out, search } = counts;
        let bounds::Counts { boxes, tests, hits } = search;
        format!(
            "{name} {}: {eye} eye, {shadow} shadow, {mirror} mirror, {refracted} refracted, {left_out} left out; {boxes} boxes, \
             {tests} tests, {hits} hits\n  E {:?}, {:?}, {:?}\n",
            R::NAME,
            sum(0),
            sum(1),
            sum(2)
        )
    }
    let of = |(name, file): (String, File)| line::<f32>(&name, &file) + &line::<f64>(&name, &file);
    insta::assert_snapshot!(all().into_iter().map(of).collect::<String>());
}

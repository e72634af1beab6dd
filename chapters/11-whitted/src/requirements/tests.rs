use math::Real;
use scene_file::Scene as File;
use shading::Rgb;
use signature::Method;

use super::*;
use crate::lit_scenes::{all, picture};
use crate::render::Rendered;

/// The first pixel that is not the same to the last bit.
fn first_difference(a: &Rendered, b: &Rendered) -> Option<(usize, Rgb, Rgb)> {
    let bits = |e: &Rgb| e.0.map(f64::to_bits);
    let mut pairs = a.radiance.iter().zip(&b.radiance).enumerate();
    pairs.find(|(_, (a, b))| bits(a) != bits(b)).map(|(at, (a, b))| (at, *a, *b))
}

/// What a scene requires at a depth; without one, at its own.
fn requires<R: Real>(file: &File, depth: Option<u32>) -> Requirements {
    let scene = crate::from_file::scene::<R>(file, None, depth).unwrap();
    Requirements::of(&scene, bounds::Parts::of(&scene.lit.geometry).count())
}

fn is_the_same_whatever_is_modeled<R: Real>() {
    for (name, file) in all() {
        let requires = requires::<R>(&file, Some(4));
        for method in Method::ALL {
            let required = picture::<R>(&file, method, 4, |required| required, None);
            let of = |more: &dyn Fn(Requirements) -> Requirements| picture::<R>(&file, method, 4, more, None);
            // what the scene has anyway is no more
            let more = Feature::ALL.into_iter().filter(|feature| requires.and(*feature) != requires);
            for feature in more {
                let modeled = of(&|required| required.and(feature));
                assert_eq!(
                    first_difference(&modeled, &required),
                    None,
                    "{name} {method:?} {} and {feature:?}",
                    R::NAME
                );
            }
            let modeled = of(&|required| required.everything());
            assert_eq!(
                first_difference(&modeled, &required),
                None,
                "{name} {method:?} {} and everything",
                R::NAME
            );
        }
    }
}

#[test]
fn the_radiance_is_the_same_whatever_is_modeled_in_f64() {
    is_the_same_whatever_is_modeled::<f64>();
}

#[test]
fn the_radiance_is_the_same_whatever_is_modeled_in_f32() {
    is_the_same_whatever_is_modeled::<f32>();
}

/// What is not required is not modeled.
#[test]
fn a_scene_requires_what_it_has() {
    let of = |text: &str| {
        let file = File::from_toml("scene.toml", text, std::path::Path::new("")).unwrap();
        requires::<f64>(&file, None)
    };
    let sphere = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\n[[object]]\nmaterial = \"m\"\n\
                  sphere = { center = [0, 0, 0], radius = 1 }\n";
    let light = "[[light]]\nposition = [0, 9, 0]\nintensity = [1, 1, 1]\n";
    let nothing = of(&format!("{sphere}[material.m]\n"));
    let features = |it: Requirements| {
        [it.shadows, it.mirror, it.refraction, it.media, it.textures, it.transforms, it.tree]
    };
    assert_eq!(features(nothing), [false; 7]);
    for (material, expected) in [
        ("mirror = 0.5", [true, true, false, false, false, false, false]),
        ("transmit = 0.5", [true, false, true, false, false, false, false]),
        ("transmit = 0.5\nior = 1.5", [true, false, true, true, false, false, false]),
        ("ior = 1.5", [true, false, false, false, false, false, false]),
        ("diffuse = 0", [false; 7]),
        (
            "texture = { checker = [[1, 1, 1], [0, 0, 0]], scale = 1 }",
            [true, false, false, false, true, false, false],
        ),
    ] {
        assert_eq!(
            features(of(&format!("{sphere}{light}[material.m]\n{material}\n"))),
            expected,
            "{material}"
        );
    }
    let deep =
        of(&format!("max_depth = 1\n{sphere}{light}[material.m]\nmirror = 0.5\ntransmit = 0.5\nior = 1.5\n"));
    assert_eq!(features(deep), [true, false, false, false, false, false, false], "local shading only");
}

/// A light in the plane that leans: whether a point faces it is a matter of rounding.
#[test]
fn a_light_on_a_surface_is_the_same_whatever_is_modeled() {
    let text = "[camera]\neye = [0.3, 2, 4]\nlook_at = [0, 0, 0]\n\
                [[light]]\nposition = [2.7, -1.35, 2.7]\nintensity = [1, 1, 1]\n\
                [material.m]\nambient = 0\n[[object]]\nmaterial = \"m\"\n\
                plane = { point = [0, 0, 0], normal = [0.3, 1, 0.2] }\n";
    let file = scene_file::Scene::from_toml("scene.toml", text, std::path::Path::new("")).unwrap();
    let required = picture::<f64>(&file, Method::Robust, 4, |required| required, None);
    let modeled = picture::<f64>(&file, Method::Robust, 4, |required| required.everything(), None);
    assert_eq!(first_difference(&modeled, &required), None);
    let required = picture::<f32>(&file, Method::Robust, 4, |required| required, None);
    let modeled = picture::<f32>(&file, Method::Robust, 4, |required| required.everything(), None);
    assert_eq!(first_difference(&modeled, &required), None);
}

/// A solid that bends and lets nothing through, and a plane that lets all through and bends nothing: no stack is needed.
#[test]
fn media_are_for_solids_that_let_light_in() {
    let text = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\n\
                [[object]]\nmaterial = \"dark\"\nsphere = { center = [0, 0, 0], radius = 1 }\n\
                [[object]]\nmaterial = \"clear\"\nplane = { point = [0, -2, 0], normal = [0, 1, 0] }\n\
                [material.dark]\nior = 1.5\n[material.clear]\ntransmit = 1\n";
    let file = scene_file::Scene::from_toml("scene.toml", text, std::path::Path::new("")).unwrap();
    let scene = crate::from_file::scene::<f64>(&file, None, None).unwrap();
    let required = Requirements::of(&scene, 2);
    assert_eq!((required.refraction, required.media), (true, false));
}

#[test]
fn each_feature_has_its_own_name() {
    let mut names = Feature::ALL.map(Feature::name).to_vec();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Feature::ALL.len());
}

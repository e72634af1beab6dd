use super::*;
use crate::from_file;
use stage::{Ask, Chapter};

/// What is said of a scene with one material, `m`: feature, required, why; and the remarks.
fn said(text: &str) -> (Vec<[String; 3]>, Vec<String>) {
    let camera = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\n";
    let file =
        scene_file::Scene::from_toml("m.toml", &format!("{text}{camera}"), std::path::Path::new("")).unwrap();
    let scene = from_file::scene::<f64>(&file, None, None).unwrap();
    let required = Requirements::of(&scene, Parts::of(&scene.lit.geometry).count());
    let mut transcript = Transcript::new(&crate::stage::Whitted.about(), &Ask::default());
    requirements(&mut transcript, &file, &scene, &required, None);
    let section = transcript.sections.remove(0);
    let row = |row: &Vec<Value>| [0, 1, 2].map(|cell| row[cell].to_text());
    (section.table.unwrap().rows.iter().map(row).collect(), section.remarks)
}

fn why(text: &str, feature: &str) -> (bool, String) {
    let (rows, _) = said(text);
    let [_, required, why] = rows.into_iter().find(|row| row[0] == feature).unwrap();
    (required == "yes", why)
}

const BALL: &str = "[[object]]\nmaterial = \"m\"\nsphere = { center = [0, 0, 0], radius = 1 }\n";
const LIGHT: &str = "[[light]]\nposition = [0, 9, 0]\nintensity = [1, 1, 1]\n";

#[test]
fn each_feature_has_its_reason() {
    let of = |material: &str, feature| why(&format!("{BALL}{LIGHT}[material.m]\n{material}\n"), feature);
    let no = |why: &str| (false, why.to_string());
    let yes = |why: &str| (true, why.to_string());
    assert_eq!(of("", "refraction"), no("no material transmits"));
    assert_eq!(of("", "mirror"), no("no material mirrors"));
    assert_eq!(of("", "media stack"), no("nothing goes through a surface"));
    assert_eq!(of("transmit = 0.5", "media stack"), no("every index of refraction is 1: nothing is bent"));
    assert_eq!(of("transmit = 0.5", "refraction"), yes("1 of 1 objects: to depth 5"));
    assert_eq!(of("", "shadows"), yes("there is a light, and every material answers it"));
    assert_eq!(of("diffuse = 0", "shadows"), no("no material answers a light: r_d + r_s = 0"));
    assert_eq!(of("", "texture"), no("no object has a texture: no (u, v) is worked out"));
    assert_eq!(why("", "shadows"), no("there is no light: only what is ambient is seen; [[light]] adds one"));
    assert_eq!(why("", "shapes"), no("there are no objects: all is background"));
    let pane = "[material.m]\ntransmit = 1\nior = 2\n[[object]]\nmaterial = \"m\"\nplane = { point = [0, 0, 0], normal = [0, 0, 1] }\n";
    assert_eq!(why(pane, "media stack"), no("what lets light through has no inside"));
    let flat = format!("max_depth = 1\n{BALL}[material.m]\nmirror = 1\n");
    assert_eq!(why(&flat, "mirror"), no("maxDepth is 1: local shading only"));
    let far = format!("{BALL}[[light]]\nposition = [0, 1e300, 0]\nintensity = [1, 1, 1]\n[material.m]\n");
    assert_eq!(why(&far, "precision").1, "the scene has numbers that f32 cannot hold");
}

#[test]
fn coefficients_whose_sum_exceeds_one_are_allowed_and_said() {
    let of = |material: &str| said(&format!("{BALL}[material.m]\n{material}\n")).1;
    assert!(of("").is_empty(), "0.1 + 0.9");
    let one = of("mirror = 0.25");
    assert_eq!(
        one,
        ["Material m: r_a + r_d + r_s + r_g + r_t = 1.25 exceeds 1: more light may leave it than comes in."]
    );
    // of a material that nothing is made of nothing leaves
    assert!(said("[material.m]\nmirror = 1\n").1.is_empty());
}

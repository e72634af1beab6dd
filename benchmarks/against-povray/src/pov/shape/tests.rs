use std::path::Path;

use super::*;

/// What a shape is written as, with `…` for its surface.
fn written(text: &str, is_nff: bool) -> String {
    let file = match is_nff {
        true => scene_file::Scene::from_nff("it.nff", text),
        false => scene_file::Scene::from_toml("it.toml", text, Path::new("")),
    };
    let file = file.unwrap();
    let scene = signature::from_file::scene::<f64>(&file, None).unwrap();
    let is_patch = matches!(file.objects[0].shape, scene_file::Shape::Patch { .. });
    shape(&scene.objects[0].shape, "…", is_patch)
}

fn toml(object: &str) -> String {
    let start =
        "[camera]\neye = [0, 0, 9]\nlook_at = [0, 0, 0]\n[material.any]\n[[object]]\nmaterial = \"any\"\n";
    written(&format!("{start}{object}"), false)
}

fn nff(statement: &str) -> String {
    let view = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 9 9\nf 1 1 1 1 0 1 0 1\n";
    written(&format!("{view}{statement}"), true)
}

#[test]
fn a_plane_is_its_unit_normal_and_its_distance() {
    // (0, −1, 0) · (7, 5, 6)
    let want = "plane { <0,-1,0>, -5 … }\n";
    assert_eq!(toml("plane = { point = [7, 5, 6], normal = [0, -4, 0] }"), want);
}

#[test]
fn a_polygon_closes_where_it_began() {
    let want = "polygon { 5, <0,0,1>, <2,0,1>, <2,2,1>, <0,2,1>, <0,0,1> … }\n";
    assert_eq!(toml("polygon = { vertices = [[0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1]] }"), want);
}

#[test]
fn corners_beside_the_plane_of_a_polygon_are_brought_to_it() {
    // Newell's normal of this square: the cross product of its diagonals (2, 2, 1e-5) and (−2, 2, −1e-5),
    // which is (−4e-5, 0, 8)/… of slope 5e-6 along x. The third corner lies as high as that plane at x = 2;
    // the two others lie off it by 1e-5 and 0, and only what is off by more than a rounding moves.
    let text = toml("polygon = { vertices = [[0, 0, 0], [2, 0, 0], [2, 2, 0.00001], [0, 2, 0]] }");
    let numbers: Vec<f64> =
        text.split(|c: char| "<>, ".contains(c)).filter_map(|word| word.parse().ok()).collect();
    let corners: Vec<&[f64]> = numbers[1..].chunks(3).collect();
    assert_eq!(corners.len(), 5);
    let (a, b, c, d) = (corners[0], corners[1], corners[2], corners[3]);
    let volume = |p: &[f64], q: &[f64], r: &[f64]| {
        p[0] * (q[1] * r[2] - q[2] * r[1])
            + p[1] * (q[2] * r[0] - q[0] * r[2])
            + p[2] * (q[0] * r[1] - q[1] * r[0])
    };
    assert_eq!(a, [0.0; 3]);
    // the first corner is the origin: what is in one plane with it has no volume, up to the roundings of a
    // product of three numbers of at most 2
    assert!(volume(b, c, d).abs() < 16.0 * f64::EPSILON, "{corners:?}");
    // and before: det((2,0,0), (2,2,1e-5), (0,2,0)) = −2 · 2 · 1e-5
    let before = volume(&[2.0, 0.0, 0.0], &[2.0, 2.0, 1e-5], &[0.0, 2.0, 0.0]);
    assert!((before + 4e-5).abs() < 1e-18);
}

#[test]
fn a_transform_is_the_columns_of_a_then_t() {
    // a quarter turn about z takes x to y and y to −x
    let want = "cylinder { <0,0,-1>, <0,0,1>, 1 matrix <0,2,0,-2,0,0,0,0,2,5,6,7> … }\n";
    let steps =
        "[{ scale = [2, 2, 2] }, { rotate = { axis = [0, 0, 1], degrees = 90 } }, { translate = [5, 6, 7] }]";
    assert_eq!(toml(&format!("cylinder = {{}}\ntransform = {steps}")), want);
    assert_eq!(toml("cone = {}"), "cone { <0,0,0>, 0.5, <0,0,1>, 0 … }\n");
}

#[test]
fn the_cones_of_nff_are_open() {
    assert_eq!(nff("c 0 0 0 1 0 0 2 0.5"), "cone { <0,0,0>, 1, <0,0,2>, 0.5 open … }\n");
    assert_eq!(nff("c 0 0 0 1 0 0 2 1"), "cylinder { <0,0,0>, <0,0,2>, 1 open … }\n");
}

#[test]
fn a_patch_is_its_faces_with_their_normals() {
    let want = "smooth_triangle { <0,0,0>, <0,0,1>, <1,0,0>, <0,1,0>, <1,1,0>, <1,0,0> … }\n\
                smooth_triangle { <0,0,0>, <0,0,1>, <1,1,0>, <1,0,0>, <0,1,0>, <0,0,1> … }\n";
    assert_eq!(nff("pp 4\n0 0 0 0 0 1\n1 0 0 0 1 0\n1 1 0 1 0 0\n0 1 0 0 0 1"), want);
}

//! Scenes in NFF that read.

use scene_file::*;

const VIEW: &str = "v\nfrom 0 1 -6\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 48\n";

fn nff(text: &str) -> Scene {
    Scene::from_nff("scene.nff", &format!("{VIEW}{text}")).unwrap()
}

#[test]
fn words_are_read_not_lines() {
    let line = nff("f 1 0 0 .7 .2 32 0 0 c 0 0 0 1 0 0 1 0.5 s 0 0 0 1 # end");
    let lines = nff("# begin\nf 1 0 0\n.7 .2\n32 0 0\nc\n0 0 0\n1\n\n0 0 1\n+5e-1\ns 0 0 0\n1\n");
    let shapes = |scene: Scene| scene.objects.into_iter().map(|object| object.shape).collect::<Vec<_>>();
    let expected = [
        Shape::OpenCone { base: [0.0; 3], base_radius: 1.0, apex: [0.0, 0.0, 1.0], apex_radius: 0.5 },
        Shape::Sphere { center: [0.0; 3], radius: 1.0 },
    ];
    assert_eq!((shapes(line), shapes(lines)), (expected.to_vec(), expected.to_vec()));
}

#[test]
fn what_is_not_said() {
    let scene = nff("");
    assert_eq!((scene.max_depth, scene.background, scene.ambient), (5, [0.0; 3], [1.0; 3]));
    let camera = scene.camera;
    assert_eq!((camera.extent.value, camera.size.value), (Extent::Angle(45.0), (64, 48)));
    assert_eq!((camera.grid.value, camera.handedness), (Grid::Centers, Handedness::Right));
    assert_eq!(camera.view.value, View::At([0.0; 3]));
}

#[test]
fn lights_share_what_they_do_not_say() {
    let lights = nff("l 0 0 0 l 1 1 1 2 0 0 l 2 2 2 b 0.5 2 0\nl 3 3 3").lights;
    let intensities: Vec<_> = lights.iter().map(|light| light.intensity).collect();
    assert_eq!(intensities, [[0.5; 3], [2.0, 0.0, 0.0], [0.5; 3], [0.5; 3]]);
}

#[test]
fn an_opaque_material_has_no_ior() {
    let materials = nff("f 1 .5 0 .7 .2 32 0 0 f 1 1 1 0 0 0 0 -3 f 1 1 1 0 .1 9 .8 1.5").materials;
    let red = &materials[0];
    assert_eq!((red.name.as_str(), red.color, red.ambient), ("1", [1.0, 0.5, 0.0], 0.0));
    assert_eq!((red.diffuse, red.specular, red.mirror, red.shininess), (0.7, 0.2, 0.2, 32.0));
    let optics: Vec<_> = materials.iter().map(|material| (material.transmit, material.ior)).collect();
    assert_eq!(optics, [(0.0, 1.0), (0.0, 1.0), (0.8, 1.5)]);
}

#[test]
fn polygons_patches_and_ids() {
    let scene = nff("f 1 1 1 1 0 1 0 0 p 3 0 0 0 1 0 0 0 1 0\npp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 1 1\n");
    assert_eq!(
        scene.objects[0].shape,
        Shape::Polygon { vertices: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] }
    );
    let Shape::Patch { vertices, normals } = &scene.objects[1].shape else { panic!() };
    assert_eq!((vertices[2], normals[2]), ([0.0, 1.0, 0.0], [0.0, 1.0, 1.0]));
    assert_eq!((scene.objects[0].id, scene.objects[1].id), (Some(1), Some(2)));
    assert_eq!(&scene.text()[scene.objects[0].place.range()], "p 3 0 0 0 1 0 0 0 1 0");
    let many = nff(&format!("f 1 1 1 1 0 1 0 0\n{}", "s 0 0 0 1\n".repeat(65536)));
    assert_eq!((many.objects[65534].id, many.objects[65535].id), (Some(65535), None));
}

/// Haines's scenes as the generators write them, and the counts that their README gives.
#[test]
fn real_scenes() {
    let folder = std::path::Path::new("../../chapters/08-signature/scenes");
    for (name, objects, lights) in
        [("balls2", 92, 3), ("tetra4", 256, 1), ("mount4", 516, 1), ("rings2", 301, 3), ("gears1", 147, 5)]
    {
        let scene = Scene::read(&folder.join(name).with_extension("nff")).unwrap();
        assert_eq!((scene.objects.len(), scene.lights.len()), (objects, lights), "{name}");
    }
    let teapot = std::fs::read_to_string(folder.join("teapot.obj")).unwrap();
    let teapot = Mesh::from_obj("teapot.obj", &teapot).unwrap();
    assert_eq!((teapot.faces.len(), teapot.normals.len()), (992, 0));
}

//! Scenes in TOML that read.

use scene_file::*;

use crate::{Folder, toml};

/// The scene of the contract, with each of its shapes and steps an object of its own.
const CONTRACT: &str = include_str!("../scenes/contract.toml");

#[test]
fn the_scene_of_the_contract() {
    let scene = toml(CONTRACT).unwrap();
    let camera = &scene.camera;
    assert_eq!((scene.max_depth, scene.background, scene.ambient), (5, [1.0; 3], [1.0; 3]));
    assert_eq!((camera.eye.value, camera.view.value), ([0.0, 1.0, -6.0], View::At([0.0, 0.5, 0.0])));
    assert_eq!(
        (camera.extent.value, camera.size.value),
        (Extent::Window([-0.5, 0.5, -0.5, 0.5]), (640, 480))
    );
    assert_eq!(scene.lights[0].intensity, [1.0; 3]);
    assert_eq!((scene.materials.len(), scene.materials[0].name.as_str()), (1, "red"));
    assert_eq!(scene.objects[0].shape, Shape::Sphere { center: [0.0, 1.0, 0.0], radius: 1.0 });
    assert_eq!((scene.objects[0].id, scene.objects[0].material), (Some(3), 0));
}

#[test]
fn the_smallest_scene_is_a_camera() {
    let scene = toml("[camera]\neye = [0, 0, 0]\nforward = [0, 0, 1]\n").unwrap();
    let camera = &scene.camera;
    assert_eq!((scene.max_depth, scene.background, scene.ambient), (5, [0.0; 3], [1.0; 3]));
    assert!(scene.lights.is_empty() && scene.materials.is_empty() && scene.objects.is_empty());
    assert_eq!((camera.view.value, camera.up.value), (View::Forward([0.0, 0.0, 1.0]), [0.0, 1.0, 0.0]));
    assert_eq!((camera.handedness, camera.distance.value), (Handedness::Right, 1.0));
    assert_eq!((camera.extent.value, camera.size.value), (Extent::Height1, (640, 480)));
    assert_eq!(camera.grid.value, Grid::Centers);
}

#[test]
fn what_a_material_does_not_say() {
    let scene = toml("[camera]\neye = [0, 0, 0]\nforward = [0, 0, 1]\n[material.a]\n").unwrap();
    let expected = Material {
        name: "a".to_string(),
        color: [1.0; 3],
        ambient: 0.1,
        diffuse: 0.9,
        specular: 0.0,
        shininess: 32.0,
        mirror: 0.0,
        transmit: 0.0,
        ior: 1.0,
        texture: None,
    };
    assert_eq!(scene.materials, [expected]);
}

#[test]
fn every_shape_and_every_step() {
    let text = "camera = { eye = [0, 0, 0], forward = [0, 0, 1], grid = \"lattice\", handedness = \"left\" }
        material.z.color = [1, 0, 0]
        material.a.texture = { checker = [[1,1,1],[0.1,0.1,0.1]] }
        [[object]]
        plane = { point = [0,0,0], normal = [0,2,0] }
        material = \"a\"
        [[object]]
        triangle.vertices = [[0,0,0],[1,0,0],[0,1,0]]
        material = \"a\"
        id = 65535
        [[object]]
        material = \"z\"
        polygon.vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]]
        transform = [ { scale = [2,1,1] }, { rotate = { axis = [0,1,0], degrees = 30 } }, { translate = [0,0,5] } ]
        [[object]]
        cylinder = {}
        material = \"z\"
        transform = [ { matrix = [[1,2,3],[4,5,6],[7,8,0x9]] } ]
        [[object]]
        cone = {}
        material = \"z\"
        transform = []
    ";
    let scene = toml(text).unwrap();
    assert_eq!((scene.camera.grid.value, scene.camera.handedness), (Grid::Lattice, Handedness::Left));
    let names: Vec<_> = scene.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["z", "a"], "in the order of the file");
    let ids: Vec<_> = scene.objects.iter().map(|object| object.id.unwrap()).collect();
    assert_eq!(ids, [1, 65535, 3, 4, 5]);
    let materials: Vec<_> = scene.objects.iter().map(|object| object.material).collect();
    assert_eq!(materials, [1, 1, 0, 0, 0]);
    let steps: Vec<_> = scene.objects[2].transform.iter().map(|step| step.value).collect();
    let rotate = Transform::Rotate { axis: [0.0, 1.0, 0.0], degrees: 30.0 };
    assert_eq!(steps, [Transform::Scale([2.0, 1.0, 1.0]), rotate, Transform::Translate([0.0, 0.0, 5.0])]);
    let matrix = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]];
    assert_eq!(scene.objects[3].transform[0].value, Transform::Matrix(matrix));
    assert_eq!((&scene.objects[4].shape, scene.objects[4].transform.len()), (&Shape::Cone, 0));
    let shape = &scene.text()[scene.objects[2].place.range()];
    assert!(shape.starts_with("polygon.vertices") || shape.starts_with("polygon"), "{shape}");
    assert_eq!(&scene.text()[scene.objects[2].transform[2].place.range()], "{ translate = [0,0,5] }");
}

#[test]
fn a_chapter_points_at_what_it_cannot_use() {
    let scene = toml("[camera]\neye = [0, 0, 0]\nlook_at = [0, 0, 0]\n").unwrap();
    let error =
        scene.fault(scene.camera.view.place, "the camera looks nowhere", "write a point that is not its eye");
    assert_eq!(
        (error.status(), error.line(), error.column(), error.text()),
        (2, Some(3), Some(11), "[0, 0, 0]")
    );
    crate::assert_snapshot("fault", &error.to_string());
}

#[test]
fn a_mesh_is_read_once() {
    let folder = Folder::new("mesh");
    folder.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let object = "[[object]]\nmaterial = \"red\"\nmesh = { file = \"a.obj\", smooth = true }\n";
    let text = format!("[camera]\neye = [0,0,0]\nforward = [0,0,1]\n[material.red]\n{object}{object}");
    let scene = Scene::read(&folder.put("scene.toml", text)).unwrap();
    let [Shape::Mesh { mesh: one, smooth: true }, Shape::Mesh { mesh: two, .. }] =
        [&scene.objects[0].shape, &scene.objects[1].shape]
    else {
        panic!("{:?}", scene.objects)
    };
    assert!(std::sync::Arc::ptr_eq(one, two));
}

#[test]
fn obj_as_programs_write_it() {
    let text = "# a quad, a triangle from the end, and a line\r
mtllib missing.mtl\r
o thing\r
v 0 0 0 1.0\r
v 1 0 0 0.5 0.5 0.5\r
v 1 1 0\r
v 0 1 0\r
vt 0 0\r
g one\r
usemtl red\r
s off\r
f 1 2/1 3//  4\r
vn 0 0 2\r
f -4//-1 -3/1/1 \\\r
  -2//1 # the rest\r
l 1 2\r
f 1 3 5\r
v 5 5 5";
    let mesh = Mesh::from_obj("a.obj", text).unwrap();
    assert_eq!(mesh.vertices.len(), 5);
    assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3], [0, 1, 2], [0, 2, 4]]);
    let n = Some([0.0, 0.0, 2.0]);
    assert_eq!(mesh.normals, [[None; 3], [None; 3], [n, n, n], [None; 3]]);
    let plain = Mesh::from_obj("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n").unwrap();
    assert!(plain.normals.is_empty());
}

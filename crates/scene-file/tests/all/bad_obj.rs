//! Meshes that are refused, and what is said.

use std::fmt::Write;

use scene_file::{Mesh, Scene};

use crate::{Folder, assert_snapshot};

#[test]
fn meshes() {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let mut said = String::new();
    for text in [
        "",
        "# nothing\n",
        corners,
        "v 0 0\n",
        "v 0 zero 0\n",
        "v 0 0 nan\n",
        "v 1e999 0 0\n",
        "vn 0 0\n",
        "f 1 2 3\n",
        "v 0 0 0\r\nf 1 2 \\\r\n 3\r\n",
        &format!("{corners}f 1 2\n"),
        &format!("{corners}f\n"),
        &format!("{corners}f 1 2 0\n"),
        &format!("{corners}f 1 2 4\n"),
        &format!("{corners}f 1 2 -4\n"),
        &format!("{corners}f 1 2 -9223372036854775808\n"),
        &format!("{corners}f 1 2 99999999999999999999\n"),
        &format!("{corners}f 1 2 3.0\n"),
        &format!("{corners}f 1 2 three\n"),
        &format!("{corners}f 1/1 2/1 3/1\n"),
        &format!("{corners}f 1//1 2//1 3//1\n"),
        &format!("{corners}vn 0 0 1\nf 1//1 2//1 3//2\n"),
        &format!("{corners}f 1/2/3/4 2 3\n"),
        &format!("{corners}f /1 2 3\n"),
        &format!("{corners}face 1 2 3\n"),
        "solid teapot\n",
        "<html>\n",
    ] {
        let error = Mesh::from_obj("mesh.obj", text).expect_err(text);
        assert_eq!((error.status(), error.file()), (2, "mesh.obj"));
        writeln!(said, "error: {error}\n").unwrap();
    }
    assert_snapshot("obj", &said);
}

#[test]
fn an_error_in_a_mesh_says_which_scene_wants_it() {
    let folder = Folder::new("bad-mesh");
    folder.put("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n");
    let scene = "[camera]\neye = [0, 1, -6]\nlook_at = [0, 0, 0]\n[material.red]\n\n[[object]]\nmaterial = \"red\"\n\
                 mesh = { file = \"broken.obj\" }\n";
    let error = Scene::read(&folder.put("scene.toml", scene)).unwrap_err();
    assert!(error.file().ends_with("broken.obj"));
    assert_snapshot("obj-in-scene", &folder.without(&error));
}

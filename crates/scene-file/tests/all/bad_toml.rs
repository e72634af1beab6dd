//! Scenes in TOML that are refused, and what is said.

use std::fmt::Write;

use crate::{assert_snapshot, toml};

/// The smallest camera.
const CAMERA: &str = "[camera]\neye = [0, 1, -6]\nlook_at = [0, 0, 0]\n";

/// Refuses each text, and shows all messages together. `before` is put before each text.
fn refuse(name: &str, before: &str, texts: &[&str]) {
    let mut said = String::new();
    for text in texts {
        let text = format!("{before}{text}");
        let error = toml(&text).expect_err(&text);
        assert_eq!(error.status(), 2);
        assert!(!error.problem().is_empty() && !error.remedy().is_empty());
        assert_eq!(error.file(), "scene.toml");
        let (line, column) = (error.line().unwrap(), error.column().unwrap());
        let first = format!("scene.toml:{line}:{column}: {}\n", error.problem());
        assert!(error.to_string().starts_with(&first), "{error}");
        let marked =
            text.lines().nth(line - 1).unwrap_or_default().chars().skip(column - 1).collect::<String>();
        assert!(marked.starts_with(error.text()), "{error}");
        writeln!(said, "error: {error}\n").unwrap();
    }
    assert_snapshot(name, &said);
}

#[test]
fn syntax() {
    let texts = [
        "max_depth = five\n",
        "max_depth = 5 6\n",
        "max_depth =\n",
        "max_depth\n",
        "max_depth: 5\n",
        "// a comment\n",
        "max_depth = 5, ambient = [1, 1, 1]\n",
        "max_depth = 5\nmax_depth = 6\n",
        "max_depth = 05\n",
        "max_depth = 5_\n",
        "background = [1.0 1.0 1.0]\n",
        "background = [1.0, 1.0, 1.0\n",
        "background = (1.0, 1.0, 1.0)\n",
        "[camera]\neye = [0, 1, -6\nlook_at = [0, 0, 0]\n",
        "[camera\n",
        "[camera]\n[camera]\n",
        "[camera]\ngrid = \"centers\n",
        "[camera]\ngrid = centers\n",
        "[[object]]\nmesh = { file = \"scenes\\teapot.obj\" }\n",
        "[[object]]\nmesh = { file = \"scenes\\meshes\\teapot.obj\" }\n",
        "[[object]]\nsphere = { center = [0, 0, 0] radius = 1 }\n",
        "[[object]]\nid = 1\n[object]\nid = 2\n",
        "[camera]\neye = [.5, 0, 0]\n",
        "größe = 5\n",
    ];
    refuse("toml-syntax", "", &texts);
    let (deep, dotted) = ("[".repeat(1000), "a.".repeat(1000));
    refuse("toml-deep", "", &[&format!("max_depth = {deep}\n"), &format!("{dotted}a = 1\n")]);
}

#[test]
fn the_scene() {
    let texts = [
        "",
        "max_depth = 5\n",
        "camera = 5\n",
        "[[camera]]\neye = [0, 0, 0]\n",
        "max_dept = 5\n",
        "[lights]\n",
        "[colour]\n",
        "max_depth = 0\n",
        "max_depth = 1001\n",
        "max_depth = 99999999999999999999\n",
        "max_depth = 5.0\n",
        "max_depth = \"5\"\n",
        "max_depth = 1979-05-27\n",
        "background = [1, 1]\n",
        "background = [1, 1, -0.1]\n",
        "background = \"white\"\n",
        "ambient = 1\n",
        "ambient = [1, inf, 1]\n",
        "ambient = [nan, 1, 1]\n",
        "ambient = [1e400, 1, 1]\n",
        "ambient = [1, 1, \"1\"]\n",
    ];
    refuse("toml-scene", "", &texts);
}

#[test]
fn the_camera() {
    let texts = [
        "",
        "eye = [0, 0, 0]\n",
        "look_at = [0, 0, 0]\n",
        "eye = [0, 0, 0]\nlookat = [0, 0, 0]\n",
        "eye = [0, 0, 0]\nlook_at = [0, 0, 0]\nforward = [0, 0, 1]\n",
        "eye = [0, 0, 0]\nforward = [0, 0, 1]\nlook_at = [0, 0, 0]\n",
        "eye = [0, 0, 0]\nforward = [0, 0, 0]\n",
        "eye = [0, 0]\nforward = [0, 0, 1]\n",
        "eye = [0, 0, 0, 1]\nforward = [0, 0, 1]\n",
        "eye = \"here\"\nforward = [0, 0, 1]\n",
        "eye = { x = 1 }\nforward = [0, 0, 1]\n",
    ];
    refuse("toml-camera-view", "[camera]\n", &texts);
    let texts = [
        "up = [0, 0, 0]\n",
        "handedness = \"Right\"\n",
        "handedness = true\n",
        "distance = 0\n",
        "distance = -1.0\n",
        "window = [0.5, -0.5, -0.5, 0.5]\n",
        "window = [-0.5, 0.5, 0.5, 0.5]\n",
        "window = [-0.5, 0.5]\n",
        "size = [640, 0]\n",
        "size = [640]\n",
        "size = [640.0, 480.0]\n",
        "size = [-640, 480]\n",
        "size = [100000, 100000]\n",
        "size = [4294967296, 1]\n",
        "size = \"640x480\"\n",
        "grid = \"center\"\n",
        "grid = \"edges\"\nsize = [1, 480]\n",
        "fov = 45\n",
    ];
    refuse("toml-camera", CAMERA, &texts);
}

#[test]
fn lights() {
    let texts = [
        "[light]\nposition = [0, 0, 0]\nintensity = [1, 1, 1]\n",
        "[[light]]\nintensity = [1, 1, 1]\n",
        "[[light]]\nposition = [0, 0, 0]\n",
        "[[light]]\nposition = [0, 0, 0]\nintensity = 1.0\n",
        "[[light]]\nposition = [0, 0, 0]\nintensity = [1, 1, -1]\n",
        "[[light]]\nposition = [0, 0, 0]\ncolor = [1, 1, 1]\n",
    ];
    refuse("toml-lights", CAMERA, &texts);
}

#[test]
fn materials() {
    let texts = [
        "[[material]]\ncolor = [1, 0, 0]\n",
        "[material]\ncolor = [1, 0, 0]\n",
        "[material.red]\ncolour = [1, 0, 0]\n",
        "[material.red]\ncolor = [2, 0, 0]\n",
        "[material.red]\ncolor = \"red\"\n",
        "[material.red]\nambient = -0.1\n",
        "[material.red]\ndiffuse = 1.1\n",
        "[material.red]\nspecular = nan\n",
        "[material.red]\nshininess = -1\n",
        "[material.red]\nmirror = 2\n",
        "[material.red]\ntransmit = [0.5]\n",
        "[material.red]\nior = 0\n",
        "[material.red]\ntexture = \"wood.png\"\n",
        "[material.red]\ntexture = {}\n",
        "[material.red]\ntexture = { checker = [[1, 1, 1]] }\n",
        "[material.red]\ntexture = { checker = [[1, 1, 1], [0, 0, 7]] }\n",
        "[material.red]\ntexture = { checker = [[1, 1, 1], [0, 0, 0]], scale = 0 }\n",
        "[material.red]\ntexture = { checker = [[1, 1, 1], [0, 0, 0]], image = \"wood.png\" }\n",
        "[material.red]\ntexture = { image = \"wood.png\" }\n",
        "[material.red]\ntexture = { image = 5 }\n",
    ];
    refuse("toml-materials", CAMERA, &texts);
}

#[test]
fn objects() {
    let before =
        format!("{CAMERA}[material.red]\n[material.tiles]\ntexture = {{ checker = [[1,1,1],[0,0,0]] }}\n");
    let texts = [
        "[object]\ncone = {}\nmaterial = \"red\"\n",
        "[[objects]]\ncone = {}\nmaterial = \"red\"\n",
        "[[object]]\nmaterial = \"red\"\n",
        "[[object]]\ncone = {}\n",
        "[[object]]\ncone = {}\nmaterial = \"rad\"\n",
        "[[object]]\ncone = {}\nmaterial = \"blue\"\n",
        "[[object]]\ncone = {}\nmaterial = \"dark blue\"\n",
        "[[object]]\ncone = {}\nmaterial = \"\"\n",
        "[[object]]\ncone = {}\nmaterial = \"\\u0007\\nblue\"\n",
        "[[object]]\ncone = {}\nmaterial = 1\n",
        "[[object]]\ncone = {}\nsphere = { center = [0, 0, 0], radius = 1 }\nmaterial = \"red\"\n",
        "[[object]]\nbox = {}\nmaterial = \"red\"\n",
        "[[object]]\nradius = 1\nmaterial = \"red\"\n",
        "[[object]]\ncone = {}\nmaterial = \"tiles\"\n",
        "[[object]]\npolygon = { vertices = [[0,0,0], [1,0,0], [0,1,0]] }\nmaterial = \"tiles\"\n",
        "[[object]]\ncone = { height = 2 }\nmaterial = \"red\"\n",
        "[[object]]\ncone = true\nmaterial = \"red\"\n",
    ];
    refuse("toml-objects", &before, &texts);
    let texts = [
        "sphere = { center = [0, 0, 0] }\n",
        "sphere = { center = [0, 0, 0], radius = 0 }\n",
        "sphere = { center = [0, 0, 0], radius = -0.0 }\n",
        "sphere = { center = [0, 0, 0], r = 1 }\n",
        "[object.sphere]\ncenter = [0, 0]\nradius = 1\n",
        "plane = { point = [0, 0, 0], normal = [0, 0, 0] }\n",
        "plane = { normal = [0, 1, 0] }\n",
        "triangle = { vertices = [[0,0,0], [1,0,0]] }\n",
        "triangle = { vertices = [[0,0,0], [1,0,0], [0,1,0], [1,1,0]] }\n",
        "triangle = { vertices = [[0,0,0], [1,0,0], [-0.0,0,0]] }\n",
        "triangle = { vertices = [[0,0,0], [1,0,0], [0,1]] }\n",
        "triangle = { vertices = [0,0,0] }\n",
        "polygon = { vertices = [[0,0,0], [1,0,0]] }\n",
        "mesh = { file = \"teapot.obj\" }\n",
        "mesh = { file = \"\" }\n",
        "mesh = { smooth = true }\n",
        "mesh = { file = \"teapot.obj\", smooth = 1 }\n",
        "mesh = \"teapot.obj\"\n",
    ];
    refuse("toml-shapes", &format!("{before}[[object]]\nmaterial = \"red\"\n"), &texts);
}

#[test]
fn ids() {
    let before = format!("{CAMERA}[material.red]\n");
    let object = |id: &str| format!("[[object]]\n{id}\ncone = {{}}\nmaterial = \"red\"\n");
    let texts = [
        object("id = 0"),
        object("id = 65536"),
        object("id = -1"),
        object("id = 1.0"),
        object("id = 7") + &object("id = 7"),
        object("id = 2") + &object(""),
        object("") + &object("id = 1"),
    ];
    refuse("toml-ids", &before, &texts.each_ref().map(|text| &**text));
    let many = format!("{before}{}", object("").repeat(65536));
    let error = toml(&many).unwrap_err();
    assert_eq!(error.problem(), "this is the 65536th object, and there are 65535 ids");
}

#[test]
fn transforms() {
    let before = format!("{CAMERA}[material.red]\n[[object]]\ncone = {{}}\nmaterial = \"red\"\n");
    let texts = [
        "transform = { scale = [2, 1, 1] }\n",
        "transform = [{}]\n",
        "transform = [[2, 1, 1]]\n",
        "transform = [{ scale = [2, 1, 1], translate = [0, 0, 5] }]\n",
        "transform = [{ scale = [2, 0, 1] }]\n",
        "transform = [{ scale = 2 }]\n",
        "transform = [{ shear = [2, 1, 1] }]\n",
        "transform = [{ rotate = [0, 1, 0] }]\n",
        "transform = [{ rotate = { axis = [0, 1, 0] } }]\n",
        "transform = [{ rotate = { axis = [0, 0, 0], degrees = 30 } }]\n",
        "transform = [{ rotate = { axis = [0, 1, 0], angle = 30 } }]\n",
        "transform = [{ translate = [0, 0, 1e999] }]\n",
        "transform = [{ matrix = [[1, 0, 0], [0, 1, 0]] }]\n",
        "transform = [{ matrix = [[1, 0, 0], [0, 1, 0], [0, 0, \"1\"]] }]\n",
    ];
    refuse("toml-transforms", &before, &texts);
}

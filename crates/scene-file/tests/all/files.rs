//! Files that are none, and files that are no scenes.

use std::fmt::Write;
use std::path::Path;

use scene_file::Scene;

use crate::{Folder, assert_snapshot};

const CAMERA: &str = "[camera]\neye = [0, 1, -6]\nlook_at = [0, 0, 0]\n";

fn nff() -> &'static str {
    "v from 0 1 -6 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 64 48"
}

#[test]
fn what_is_no_scene_file_is_refused_with_status_2() {
    let folder = Folder::new("files");
    std::fs::create_dir_all(folder.0.join("folder.toml")).unwrap();
    folder.put("latin1.toml", b"# fa\xe7ade\n[camera]\n");
    folder.put("utf16.toml", b"\xff\xfe[\0c\0a\0m\0e\0r\0a\0]\0");
    folder.put("picture.nff", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR");
    folder.put("zipped.nff.gz", b"\x1f\x8b\x08\0");
    folder.put("nff.toml", nff());
    folder.put("toml.nff", CAMERA);
    let mut said = String::new();
    for name in [
        "missing.toml",
        "folder.toml",
        "latin1.toml",
        "utf16.toml",
        "picture.nff",
        "zipped.nff.gz",
        "nff.toml",
        "toml.nff",
    ] {
        let error = Scene::read(&folder.0.join(name)).unwrap_err();
        assert_eq!(error.status(), 2, "{error}");
        writeln!(said, "error: {}\n", folder.without(&error)).unwrap();
    }
    assert_snapshot("files", &said);
}

#[test]
fn meshes_and_pictures_are_files_as_well() {
    let folder = Folder::new("assets");
    folder.put("bytes.obj", b"v 0 0 0\nv \xff 0 0\n");
    folder.put("text.png", "a text");
    folder.put("cut.png", &PNG[..60]);
    folder.put("deep.png", include_bytes!("../pictures/16-bit.png"));
    folder.put("huge.png", include_bytes!("../pictures/huge.png"));
    let mut said = String::new();
    for object in [
        "material = \"red\"\nmesh = { file = \"missing.obj\" }",
        "material = \"red\"\nmesh = { file = \".\" }",
        "material = \"red\"\nmesh = { file = \"a\\u0000b\" }",
        "material = \"red\"\nmesh = { file = \"bytes.obj\" }",
        "material = \"red\"\nmesh = { file = \"text.png\" }",
        "[material.blue]\ntexture = { image = \"text.png\" }",
        "[material.blue]\ntexture = { image = \"cut.png\" }",
        "[material.blue]\ntexture = { image = \"deep.png\" }",
        "[material.blue]\ntexture = { image = \"huge.png\" }",
        "[material.blue]\ntexture = { image = \"missing.png\" }",
    ] {
        let object = object.replace("material = ", "[[object]]\nmaterial = ");
        let scene = format!("{CAMERA}[material.red]\n{object}\n");
        let error = Scene::read(&folder.put("scene.toml", scene)).unwrap_err();
        assert_eq!(error.status(), 2, "{error}");
        writeln!(said, "error: {}\n", folder.without(&error)).unwrap();
    }
    assert_snapshot("assets", &said);
}

/// 2 × 1 pixels, red and green, 8 bits a channel.
const PNG: &[u8] = include_bytes!("../pictures/red-green.png");

#[test]
fn a_picture_is_read_from_the_folder_of_the_scene() {
    let folder = Folder::new("picture");
    folder.put("two.png", PNG);
    let scene = format!("{CAMERA}[material.red]\ntexture = {{ image = \"two.png\", scale = 2 }}\n");
    let scene = Scene::read(&folder.put("scene.toml", scene)).unwrap();
    let texture = scene.materials[0].texture.as_ref().unwrap();
    let scene_file::Texture::Image { size, pixels, scale } = &texture.value else { panic!("{texture:?}") };
    assert_eq!((*size, &**pixels, *scale), ((2, 1), &[[255, 0, 0], [0, 255, 0]][..], 2.0));
}

#[test]
fn a_byte_order_mark_is_none_of_the_scene() {
    let scene = Scene::from_toml("a", &format!("\u{feff}{CAMERA}"), Path::new("")).unwrap();
    assert!(scene.text().starts_with("[camera]"));
    assert!(Scene::from_nff("a", &format!("\u{feff}{}", nff())).is_ok());
}

#[cfg(unix)]
#[test]
fn what_has_no_end_is_not_begun() {
    let folder = Folder::new("endless");
    let pipe = folder.0.join("pipe.toml");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    for path in [&*pipe, Path::new("/dev/zero"), Path::new("/dev/tty")] {
        let error = Scene::read(path).unwrap_err();
        assert_eq!(error.status(), 2);
        assert!(
            error.problem().contains("not a regular file") || error.problem().contains("no such"),
            "{error}"
        );
    }
}

/// Holes cost no disk: these files are as long as they say, and empty.
#[cfg(unix)]
#[test]
fn what_is_too_long_is_not_read() {
    let folder = Folder::new("long");
    for (name, length, limit) in [("a.toml", 1 << 30, "8 MiB"), ("a.nff", 1 << 30, "256 MiB")] {
        let path = folder.0.join(name);
        std::fs::File::create(&path).unwrap().set_len(length).unwrap();
        let start = std::time::Instant::now();
        let error = Scene::read(&path).unwrap_err();
        assert_eq!(error.problem(), format!("it is longer than {limit}"));
        assert!(start.elapsed().as_millis() < 1000);
    }
}

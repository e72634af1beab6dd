//! The pictures, pixel by pixel.
//!
//! `pictures/NAME.png` is the picture of the stage NAME at its default request. Where a stage draws
//! another one, `NAME.actual.png` and `NAME.difference.png` are left beside it, and the failure
//! names them. Look at them; where the new picture is right, accept it with
//!
//! ```text
//! UPDATE_PICTURES=1 cargo test -p tests pictures
//! ```

use std::path::{Path, PathBuf};

use image::{Rgb, RgbImage};
use stage::{Ask, Canvas};
use tests::{Folder, STAGES, compare};

use crate::process::run;
use crate::shown::by_default;

fn rgb(picture: &Canvas) -> RgbImage {
    let (width, height) = picture.size();
    RgbImage::from_raw(width, height, picture.to_rgb().unwrap()).expect("three bytes a pixel")
}

fn committed() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("pictures")
}

#[test]
fn every_stage_draws_its_committed_picture() {
    let update = std::env::var_os("UPDATE_PICTURES").is_some_and(|value| value == "1");
    let mut failures = Vec::new();
    for stage in STAGES {
        let name = stage.about().name;
        let picture = rgb(&by_default(*stage).picture);
        if update {
            picture.save(committed().join(format!("{name}.png"))).unwrap();
        }
        failures.extend(compare(&committed(), name, &picture).err());
    }
    let hint = "to accept what came: UPDATE_PICTURES=1 cargo test -p tests pictures";
    assert!(failures.is_empty(), "{}\n{hint}", failures.join("\n"));
}

#[test]
fn the_file_holds_the_picture() {
    for stage in STAGES {
        let (folder, name) = (Folder::new(), stage.about().name);
        let shown = run(folder.path(), name, &["--size", "120x90", "--out", "picture.png"]);
        assert_eq!(shown.status, 0, "{}", shown.errors);
        let file = image::open(folder.path().join("picture.png")).unwrap();
        assert_eq!(file.color(), image::ColorType::Rgb8);
        let ask = Ask { size: Some((120, 90)), ..Ask::default() };
        assert!(file.to_rgb8() == rgb(&stage.show(&ask).unwrap().picture), "{name}");
    }
}

#[test]
fn a_picture_has_the_size_that_was_asked_for() {
    for stage in STAGES {
        let about = stage.about();
        for method in &about.methods {
            for (width, height) in [(1, 1), (64, 48), (37, 91), (1, 50), (50, 1)] {
                let (folder, size) = (Folder::new(), format!("{width}x{height}"));
                let args = ["--method", method, "--size", &size, "--out", "picture.png"];
                let shown = run(folder.path(), about.name, &args);
                // The grid `edges` divides by width − 1 and height − 1, and may refuse.
                if *method == "edges" && (width == 1 || height == 1) && shown.status == 2 {
                    assert!(folder.names().is_empty(), "{args:?}");
                    continue;
                }
                assert_eq!(shown.status, 0, "{} {args:?}: {}", about.name, shown.errors);
                assert_eq!(folder.names(), ["picture.png"]);
                let found = image::image_dimensions(folder.path().join("picture.png")).unwrap();
                assert_eq!(found, (width, height), "{} {args:?}", about.name);
            }
        }
    }
}

#[test]
fn a_picture_that_is_one_shade_off_is_found_out() {
    let folder = Folder::new();
    let right = RgbImage::from_fn(20, 10, |col, row| Rgb([col as u8, row as u8, 7]));
    right.save(folder.path().join("doctored.png")).unwrap();
    assert_eq!(compare(folder.path(), "doctored", &right), Ok(()));

    let mut doctored = right.clone();
    doctored.put_pixel(4, 3, Rgb([4, 3, 8]));
    doctored.put_pixel(5, 3, Rgb([255, 3, 7]));
    let message = compare(folder.path(), "doctored", &doctored).unwrap_err();
    let says = "2 pixels differ, the first at column 4, row 3: want [4, 3, 7], got [4, 3, 8]";
    for part in [says, "doctored.actual.png", "doctored.difference.png"] {
        assert!(message.contains(part), "{message}");
    }
    assert_eq!(folder.names(), ["doctored.actual.png", "doctored.difference.png", "doctored.png"]);
    let sheet = image::open(folder.path().join("doctored.difference.png")).unwrap().to_rgb8();
    let difference = 2 * (20 + 8);
    assert_eq!(sheet.dimensions(), (difference + 20, 10));
    assert_eq!(*sheet.get_pixel(4, 3), Rgb([4, 3, 7]), "want");
    assert_eq!(*sheet.get_pixel(20 + 8 + 4, 3), Rgb([4, 3, 8]), "got");
    assert_eq!(*sheet.get_pixel(difference + 4, 3), Rgb([0, 0, 128]), "a difference of 1 is seen");
    assert_eq!(*sheet.get_pixel(difference + 6, 3), Rgb([0, 0, 0]), "no difference");

    assert_eq!(compare(folder.path(), "doctored", &right), Ok(()));
    assert_eq!(folder.names(), ["doctored.png"], "what an earlier failure left is gone");
}

#[test]
fn a_picture_of_another_size_or_none_is_found_out() {
    let folder = Folder::new();
    let picture = RgbImage::new(4, 3);
    let message = compare(folder.path(), "new", &picture).unwrap_err();
    assert!(message.contains("there is no") && message.contains("new.actual.png"), "{message}");
    RgbImage::new(4, 2).save(folder.path().join("short.png")).unwrap();
    let message = compare(folder.path(), "short", &picture).unwrap_err();
    assert!(message.contains("want 4x2, got 4x3") && message.contains("4 pixels differ"), "{message}");
}

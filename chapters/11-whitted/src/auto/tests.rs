use super::*;
use scene_file::Scene as File;

fn of_chapter_08(name: &str) -> File {
    signature::stage::built_in(name).unwrap()
}

#[test]
fn the_sample_is_spread_over_the_picture() {
    let places = sample((320, 96));
    assert_eq!(places.len(), 1024);
    for (at, &(col, row)) in (0_u32..).zip(&places) {
        assert_eq!((col / 10, row / 3), (at % 32, at / 32));
    }
    assert_eq!(sample((3, 2)), [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)], "all of a small picture");
    assert_eq!(sample((1, 1 << 28)).len(), 32);
}

#[test]
fn f32_is_taken_where_nothing_visible_is_lost() {
    let found = found(&crate::stage::read(None).unwrap(), &Ask::default()).unwrap();
    assert_eq!((found.pixels, found.colors, found.objects, found.fits), (1024, 0, 0, true));
    assert!(found.largest > 0.0 && found.largest < 0.5 / 255.0, "{}", found.largest);
    assert_eq!(found.precision(), Precision::F32);
}

/// Ten thousand radii away f32 has no digits left for the notes' discriminant (chapter 04).
#[test]
fn f64_is_taken_where_f32_sees_other_objects() {
    let notes = Ask { method: 1, ..Ask::default() };
    let found = found(&of_chapter_08("far"), &notes).unwrap();
    assert!(found.objects > 50 && found.paths >= found.objects && found.colors > 0, "{found:?}");
    assert_eq!(found.precision(), Precision::F64);
}

#[test]
fn f64_is_taken_where_f32_cannot_hold_the_numbers() {
    let text = "[camera]\neye = [0, 0, 1e300]\nlook_at = [0, 0, 0]\n";
    let far = File::from_toml("far.toml", text, std::path::Path::new("")).unwrap();
    let found = found(&far, &Ask::default()).unwrap();
    assert_eq!((found.fits, found.pixels, found.precision()), (false, 0, Precision::F64));
}

/// One pixel of another color is one too many.
#[test]
fn what_is_visible_decides() {
    let same = Found { pixels: 1024, fits: true, paths: 7, largest: 1e-3, ..Found::default() };
    assert_eq!(same.precision(), Precision::F32, "another path alone is not seen");
    assert_eq!(Found { colors: 1, ..same }.precision(), Precision::F64);
    assert_eq!(Found { objects: 1, ..same }.precision(), Precision::F64);
}

#[test]
fn a_pixel_outside_is_refused() {
    let ask = Ask { pixel: Some((5000, 0)), ..Ask::default() };
    assert!(matches!(found(&crate::stage::read(None).unwrap(), &ask), Err(Error::Request(_))));
}

use super::*;
use scene_file::Scene as File;

fn of_chapter_08(name: &str) -> File {
    signature::stage::built_in(name).unwrap()
}

#[test]
fn the_sample_is_spread_over_the_picture() {
    let places = sample::drawn((960, 288));
    assert_eq!(places.len(), 96 * 96);
    for (at, &(col, row)) in (0_u32..).zip(&places) {
        assert_eq!((col / 10, row / 3), (at % 96, at / 96));
    }
    assert_eq!(sample::drawn((1, 1 << 28)).len(), 96);
}

/// What is right of x = 100.3 is seen by other rays: from the middle of 99 or 100 it is halved toward.
#[test]
fn an_edge_is_found_to_the_last_digit() {
    let seen = |places: &[Place]| -> Result<Vec<Seen>, Error> {
        let is_right = |&((col, _), x): &Place| f64::from(col) + x > 100.3;
        let rays = |place| Rays { all: u64::from(is_right(place)), ..Rays::default() };
        Ok(places.iter().map(|place| Seen { rays: rays(place), ..Seen::default() }).collect())
    };
    let (drawn, edges) = sample::sample((640, 480), &seen).unwrap();
    assert_eq!(drawn.places.len(), 96 * 96);
    // between the middles of columns 99 and 100
    let found = sample::halved(&edges, &seen).unwrap();
    assert!(found.len() > 4 && found.iter().all(|edge| (edge.at - 0.3 - 1.0).abs() < 2e-7), "{found:?}");
    let (all, none) = sample::sample((128, 128), &seen).unwrap();
    assert_eq!((all.places.len(), none.len()), (128 * 128, 0), "all of a small picture");
}

#[test]
fn f32_is_taken_where_nothing_visible_is_lost() {
    let gambetta = crate::scenes::built_in("gambetta").unwrap();
    for (size, pixels) in [((100, 75), 7500), ((320, 240), 96 * 96)] {
        let found = found(&gambetta, &Ask { size: Some(size), ..Ask::default() }).unwrap();
        let drawn = &found.drawn;
        assert_eq!((drawn.pixels, drawn.visible, found.fits), (pixels, 0, true));
        assert_eq!((found.is_whole, found.edges == 0), (pixels == 7500, pixels == 7500));
        assert!(drawn.largest > 0.0 && drawn.largest < 0.5 / 255.0, "{}", drawn.largest);
        assert_eq!(found.precision(), Precision::F32);
    }
}

/// Of its 307,200 pixels 25 are off by more than a level: of 9216 that are drawn less than one. The edges tell.
#[test]
fn what_is_too_rare_to_be_drawn_is_found_at_edges() {
    let water = crate::scenes::built_in("water").unwrap();
    let found = found(&water, &Ask { size: Some((640, 480)), ..Ask::default() }).unwrap();
    assert!(found.drawn.visible == 0 && found.expected > NONE, "{found:?}");
    assert_eq!(found.precision(), Precision::F64);
}

/// Ten thousand radii away f32 has no digits left for the notes' discriminant (chapter 04).
#[test]
fn f64_is_taken_where_f32_sees_other_objects() {
    let notes = Ask { method: 1, ..Ask::default() };
    let found = found(&of_chapter_08("far"), &notes).unwrap();
    let drawn = &found.drawn;
    assert!(drawn.objects > 50 && drawn.paths >= drawn.objects && drawn.visible > 0, "{found:?}");
    assert_eq!(found.precision(), Precision::F64);
}

#[test]
fn f64_is_taken_where_f32_cannot_hold_the_numbers() {
    let text = "[camera]\neye = [0, 0, 1e300]\nlook_at = [0, 0, 0]\nsize = [4, 4]\n";
    let far = File::from_toml("far.toml", text, std::path::Path::new("")).unwrap();
    let found = found(&far, &Ask::default()).unwrap();
    assert_eq!((found.fits, found.drawn.pixels, found.precision()), (false, 0, Precision::F64));
}

/// One pixel that is visibly another is one too many; and no more is said than what was measured.
#[test]
fn what_is_visible_decides() {
    let drawn = Differences { pixels: 1024, colors: 2, objects: 1, paths: 7, largest: 1e-3, visible: 0 };
    let same = Found { fits: true, is_whole: false, drawn, edges: 90, expected: 0.25 };
    assert_eq!(same.precision(), Precision::F32, "another path and a level are not seen");
    assert_eq!(
        same.said(),
        "f32: none of 1024 pixels is visibly another: with 95 % certainty fewer than 3 in 1024 are"
    );
    let one = Found { drawn: Differences { visible: 1, ..drawn }, ..same };
    assert_eq!(one.precision(), Precision::F64);
    assert_eq!(one.said(), "f64: in f32 1 of 1024 pixels are visibly others");
    assert_eq!(Found { expected: 0.75, ..same }.precision(), Precision::F64);
}

/// By one level: 0.5 / 255 lies on the border between two bytes.
#[test]
fn one_level_is_how_two_roundings_of_the_same_differ() {
    let seen = |level: f64| Seen { e: shading::Rgb([level / 255.0, 0.0, 0.0]), ..Seen::default() };
    let between = |a, b| Differences::between(&[seen(a)], &[seen(b)], false);
    let [near, far] = [between(7.49, 7.51), between(7.4, 8.6)];
    assert_eq!((near.colors, near.visible), (1, 0));
    assert_eq!((far.colors, far.visible), (1, 1));
}

#[test]
fn a_pixel_outside_is_refused() {
    let ask = Ask { pixel: Some((5000, 0)), ..Ask::default() };
    assert!(matches!(found(&crate::stage::read(None).unwrap(), &ask), Err(Error::Request(_))));
}

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

/// What is right of x = 100.3 is seen by other rays, and what is below y = 200.7: halved toward from the
/// middles before.
#[test]
fn an_edge_is_found_to_the_last_digit() {
    let seen = |places: &[Place]| -> Result<Vec<Seen>, Error> {
        let point = |place: &Place| match *place {
            Place::Pixel((col, row)) => [f64::from(col) + 0.5, f64::from(row) + 0.5],
            Place::Point((col, row), [x, y]) => [f64::from(col) + x, f64::from(row) + y],
        };
        let quarter = |[x, y]: [f64; 2]| u64::from(x > 100.3) + 2 * u64::from(y > 200.7);
        let rays = |place| Rays { all: quarter(point(place)), ..Rays::default() };
        Ok(places.iter().map(|place| Seen { rays: rays(place), ..Seen::default() }).collect())
    };
    let (drawn, edges) = sample::sample((640, 480), &seen).unwrap();
    assert_eq!(drawn.places.len(), 96 * 96);
    let found = sample::halved(&edges, &seen).unwrap();
    // from 99.5 across, and from 200.5 down
    for (way, at) in [(0, 0.8), (1, 0.2)] {
        let found: Vec<_> = found.iter().filter(|edge| edge.way == way).collect();
        assert!(found.len() > 4 && found.iter().all(|edge| (edge.at - at).abs() < 2e-7), "{found:?}");
    }
    let (all, none) = sample::sample((128, 128), &seen).unwrap();
    assert_eq!((all.places.len(), none.len()), (128 * 128, 0), "all of a small picture");
}

#[test]
fn f32_is_taken_where_nothing_visible_is_lost() {
    let gambetta = crate::scenes::built_in("gambetta").unwrap();
    for (size, pixels) in [((100, 75), 7500), ((200, 150), 96 * 96)] {
        let found = found(&gambetta, &Ask { size: Some(size), ..Ask::default() }).unwrap();
        let drawn = &found.drawn;
        assert_eq!((drawn.pixels, drawn.visible, found.fits), (pixels, 0, true));
        assert_eq!((found.is_whole, found.edges == 0), (pixels == 7500, pixels == 7500));
        assert!(drawn.largest > 0.0 && drawn.largest < 0.5 / 255.0, "{}", drawn.largest);
        assert_eq!(found.precision(), Precision::F32);
    }
}

/// Of 307,200 pixels 25 and 1 are off by more than a level: of 9216 that are drawn none or one. The edges
/// tell.
#[test]
fn what_is_too_rare_to_be_drawn_is_found_at_edges() {
    for name in ["water", "whitted"] {
        let file = crate::scenes::built_in(name).unwrap();
        let found = found(&file, &Ask { size: Some((640, 480)), ..Ask::default() }).unwrap();
        assert!(found.drawn.visible < 2 && found.expected > 5.0 * FEW, "{name}: {found:?}");
        assert_eq!(found.precision(), Precision::F64);
    }
}

/// With 3 × 3 rays a pixel nine times as many are beside an edge.
#[test]
fn more_rays_see_more_edges() {
    let gambetta = crate::scenes::built_in("gambetta").unwrap();
    let of = |samples| {
        let ask = Ask { size: Some((200, 150)), samples: Some(samples), ..Ask::default() };
        found(&gambetta, &ask).unwrap()
    };
    let [one, three] = [of(1), of(3)];
    assert_eq!((one.precision(), three.precision()), (Precision::F32, Precision::F64));
    assert!(three.expected > 5.0 * one.expected, "{} {}", one.expected, three.expected);
    assert_ne!(one.drawn.largest, three.drawn.largest, "the drawn pixels have nine rays too");
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
    let same = Found { fits: true, is_whole: false, drawn, edges: 90, expected: 0.0123 };
    assert_eq!(same.precision(), Precision::F32, "another path and a level are not seen");
    assert_eq!(
        same.said(),
        "f32: none of 1024 pixels is visibly another, and by where its edges are 0.013 of the picture: less than 0.05"
    );
    let one = Found { drawn: Differences { visible: 1, ..drawn }, ..same };
    assert_eq!(one.precision(), Precision::F64);
    assert_eq!(one.said(), "f64: in f32 1 of 1024 pixels are visibly others");
    let edges = Found { expected: 0.75, ..same };
    assert_eq!(edges.precision(), Precision::F64);
    assert_eq!(
        edges.said(),
        "f64: by where f32 puts edges 0.75 pixels may visibly be others, more than 0.05"
    );
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

/// Not one pixel is visibly another where f32 is taken, however many samples it has.
#[test]
fn no_pixel_is_visibly_another_where_f32_is_taken() {
    let mut taken = 0;
    for (name, samples) in [("gambetta", 1), ("gambetta", 2), ("whitted", 1), ("water", 1)] {
        let file = crate::scenes::built_in(name).unwrap();
        let ask = Ask { size: Some((120, 90)), samples: Some(samples), ..Ask::default() };
        let found = found(&file, &ask).unwrap();
        if found.precision() == Precision::F32 {
            assert_eq!(visible(&file, &ask), 0, "{name} {samples} {found:?}");
            taken += 1;
        }
    }
    assert!(taken > 0);
}

/// How many pixels of the whole picture are visibly others.
fn visible(file: &File, ask: &Ask) -> u64 {
    let size = ask.size.unwrap();
    let all = (0..size.1).flat_map(|row| (0..size.0).map(move |col| Place::Pixel((col, row))));
    let all: Vec<Place> = all.collect();
    let narrow = traced::<f32, _>(file, ask, size, |seen| seen(&all)).unwrap();
    let wide = traced::<f64, _>(file, ask, size, |seen| seen(&all)).unwrap();
    Differences::between(&narrow, &wide, ask.srgb).visible
}

/// Against whole pictures of all scenes, as large as they are seen: f32 is never taken where a pixel would show it.
#[test]
#[ignore = "it draws 54 whole pictures, which takes minutes: .ci/full runs it"]
fn where_f32_is_taken_no_pixel_shows_it() {
    let mut shown = 0;
    for scene in &crate::scenes::SCENES {
        let file = scene.file().unwrap();
        for (size, samples) in [((320, 240), 1), ((640, 480), 1), ((640, 480), 3)] {
            let ask = Ask { size: Some(size), samples: Some(samples), ..Ask::default() };
            let found = found(&file, &ask).unwrap();
            let (taken, truly) = (found.precision(), visible(&file, &ask));
            let name = scene.name;
            assert!(
                taken == Precision::F64 || truly == 0,
                "{name} {size:?} {samples}: f32 is taken, {truly} pixels show it, {} were expected",
                found.expected
            );
            shown += u32::from(truly > 0);
        }
    }
    assert!(shown > 0, "no scene shows f32, so nothing was tested");
}

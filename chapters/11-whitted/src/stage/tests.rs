use std::path::PathBuf;

use stage::Stage;

use super::*;

const SMALL: Option<(u32, u32)> = Some((48, 36));

fn shown(ask: &Ask) -> Shown {
    Stage::show(&Whitted, ask).unwrap()
}

fn value(shown: &Shown, symbol: &str) -> f64 {
    let steps = shown.transcript.sections.iter().flat_map(|section| &section.steps);
    match steps.filter(|step| step.symbol == symbol).map(|step| &step.value).next() {
        Some(stage::Value::F64(x)) => *x,
        other => panic!("{symbol}: {other:?}"),
    }
}

fn own_scene(name: &str) -> Option<PathBuf> {
    Some(PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/")).join(name))
}

/// Transcript, counts among it, and picture.
#[test]
fn all_is_the_same_on_any_number_of_threads() {
    for scene in [None, own_scene("water.toml"), own_scene("balls3.nff")] {
        let on = |threads| {
            let ask = Ask {
                threads: Some(threads),
                size: SMALL,
                samples: Some(2),
                scene: scene.clone(),
                ..Ask::default()
            };
            let Shown { transcript, picture, .. } = shown(&ask);
            (transcript, picture)
        };
        let one = on(1);
        assert!([2, 5].into_iter().all(|threads| on(threads) == one), "{scene:?}");
    }
}

#[test]
fn the_flags_do_what_they_say() {
    let plain = shown(&Ask { size: SMALL, ..Ask::default() });
    assert_eq!(value(&plain, "eye"), 48.0 * 36.0);
    let sampled = shown(&Ask { size: SMALL, samples: Some(3), ..Ask::default() });
    assert_eq!(value(&sampled, "eye"), 9.0 * 48.0 * 36.0);
    let flat = shown(&Ask { size: SMALL, depth: Some(1), ..Ask::default() });
    assert_eq!((value(&flat, "mirror"), value(&flat, "refracted")), (0.0, 0.0));
    let tolerant = shown(&Ask { size: SMALL, tolerance: Some(0.1), ..Ask::default() });
    assert!(value(&tolerant, "rays") <= value(&plain, "rays") && value(&tolerant, "left out") > 0.0);
    assert!(value(&tolerant, "mirror") < value(&plain, "mirror"));
    let srgb = shown(&Ask { size: SMALL, srgb: true, ..Ask::default() });
    assert_eq!(srgb.transcript.sections[1..], plain.transcript.sections[1..], "the same rays");
    let [dark, bright] = [&plain, &srgb].map(|shown| shown.picture.pixel(0, 0).unwrap().0);
    assert!(dark.iter().zip(bright).all(|(dark, bright)| bright > *dark));
}

/// E of the transcript, times 255 and rounded, is what the picture shows: in every pixel.
#[test]
fn the_pixel_of_the_transcript_is_the_picture_s() {
    let size = (8, 6);
    for srgb in [false, true] {
        for pixel in (0..6).flat_map(|row| (0..8).map(move |col| (col, row))) {
            let it = shown(&Ask {
                size: Some(size),
                pixel: Some(pixel),
                srgb,
                samples: Some(2),
                ..Ask::default()
            });
            let step = it.transcript.sections[0].steps.last().unwrap();
            let bytes =
                it.picture.pixel(pixel.0, pixel.1).unwrap().0.map(|byte| stage::Value::F64(byte.into()));
            assert_eq!((step.symbol.as_str(), &step.value), ("pixel", &stage::Value::Array(bytes.to_vec())));
        }
    }
}

#[test]
fn the_worked_pixel_is_within_the_picture() {
    assert_eq!(worked(true, SIZE), WORKED);
    // by hand: 470/960 and 230/720 of it
    assert_eq!(worked(true, (96, 72)), (47, 23));
    assert_eq!(
        (worked(true, (1, 1)), worked(false, (1, 1)), worked(false, (640, 480))),
        ((0, 0), (0, 0), (320, 240))
    );
}

/// A stage that is left to choose says what it found, and computes in it.
#[test]
fn the_precision_is_chosen_and_said() {
    let it = shown(&Ask { auto: true, size: SMALL, ..Ask::default() });
    let found =
        it.transcript.sections.iter().find(|section| section.title == "What f32 would get wrong").unwrap();
    let taken = &found.steps.last().unwrap().value;
    assert_eq!(taken, &stage::Value::text(it.transcript.precision));
}

#[test]
fn a_scene_that_is_none_is_refused_with_its_place() {
    let camera = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\n";
    let object = "[[object]]\nmaterial = \"m\"\nsphere = { center = [0, 0, 0], radius = 1 }\n";
    let path = std::env::temp_dir().join(format!("whitted-{}.toml", std::process::id()));
    for (text, place) in [
        ("max_depth = 0\n".to_string() + camera, ":1:13"),
        ("max_depth = 1001\n".to_string() + camera, ":1:13"),
        (format!("{camera}[material.m]\nmirror = 1.5\n{object}"), ":5:10"),
        (format!("{camera}[material.m]\ntransmit = -0.1\n{object}"), ":5:12"),
        (format!("{camera}[material.m]\nior = 0\n{object}"), ":5:7"),
        (format!("{camera}[material.m]\nshininess = -1\n{object}"), ":5:13"),
        (format!("{camera}[material.m]\nrefraction = 1\n{object}"), ":5:1"),
        (format!("{camera}{object}"), ":5:12"),
        (format!("{camera}[[light]]\nposition = [0, 0, 0]\nintensity = [-1, 0, 0]\n"), ":6:"),
        (
            format!(
                "{camera}[material.m]\ntexture = {{ checker = [[1, 1, 1], [0, 0, 0]] }}\n[[object]]\nmaterial = \"m\"\ncone = {{}}\n"
            ),
            ":",
        ),
    ] {
        std::fs::write(&path, &text).unwrap();
        let refused = Stage::show(&Whitted, &Ask { scene: Some(path.clone()), ..Ask::default() });
        let Err(Error::Request(said)) = refused else { panic!("{text}") };
        assert!(said.contains(&format!("{}{place}", path.display())), "{text}: {said}");
    }
    std::fs::remove_file(&path).unwrap();
    assert!(Stage::show(&Whitted, &Ask { scene: Some(path), ..Ask::default() }).is_err(), "there is none");
}

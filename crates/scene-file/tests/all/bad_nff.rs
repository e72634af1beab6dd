//! Scenes in NFF that are refused, and what is said.

use std::fmt::Write;

use scene_file::Scene;

use crate::assert_snapshot;

const VIEW: &str = "v\nfrom 0 1 -6\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 48\n";
const FILL: &str = "f 1 0 0 0.7 0.2 32 0 0\n";

/// Refuses each text, and shows all messages together. `before` is put before each text.
fn refuse(name: &str, before: &str, texts: &[&str]) {
    let mut said = String::new();
    for text in texts {
        let text = format!("{before}{text}");
        let error = Scene::from_nff("scene.nff", &text).expect_err(&text);
        assert_eq!((error.status(), error.file()), (2, "scene.nff"));
        writeln!(said, "error: {error}\n").unwrap();
    }
    assert_snapshot(name, &said);
}

#[test]
fn views() {
    let texts = [
        "",
        "b 1 1 1\n",
        "from 0 1 -6\n",
        "v\nfrom 0 1 -6\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\n",
        "v\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 48\n",
        "v\nfrom 0 1 -6\nfrom 0 1 -6\n",
        "v\nfrom 0 1\nat 0 0 0\n",
        "v\nfrom 0 1 inf\n",
        "v\nup 0 0 0\n",
        "v\nangle 180\n",
        "v\nangle 0\n",
        "v\nresolution 0 48\n",
        "v\nresolution 64.0 48\n",
        "v\nresolution 100000 100000\n",
        "v\nresolution 18446744073709551615 18446744073709551615\n",
        "v\nresolution 99999999999999999999 1\n",
    ];
    refuse("nff-views", "", &texts);
    refuse("nff-twice", VIEW, &[VIEW, "b 1 1 1 b 0 0 0\n"]);
}

#[test]
fn statements() {
    let texts = [
        "t 1 2 3\n",
        "S 0 0 0 1\n",
        "b 1 1\n",
        "b 1 1 -1\n",
        "b 1 1 1 1\n",
        "l 1 2\n",
        "l 1 2 3 1\n",
        "l 1 2 3 1 1 -1\n",
        "f 1 0 0 0.7 0.2 32 0\n",
        "f 1 0 2 0.7 0.2 32 0 0\n",
        "f 1 0 0 0.7 1.2 32 0 0\n",
        "f 1 0 0 0.7 0.2 -32 0 0\n",
        "f 1 0 0 0.7 0.2 32 -1 0\n",
        "f 1 0 0 0.7 0.2 32 0.5 0\n",
        "f red 0.7 0.2 32 0 0\n",
        "s 0 0 0 1\n",
        "f 1 0 0 0.7 0.2 32 0 nan\n",
    ];
    refuse("nff-statements", VIEW, &texts);
}

#[test]
fn shapes() {
    let texts = [
        "s 0 0 0\n",
        "s 0 0 0 0\n",
        "s 0 0 0 -1\n",
        "s 0 0 0 1e999\n",
        "s 0 0 0 # the radius\n",
        "s 0 0 zero 1\n",
        "c 0 0 0 1 0 0 1 -1\n",
        "c 0 0 0 -1\n0 0 1 1\n",
        "c 0 0 0 0 0 0 1 0\n",
        "c 0 0 0 1 0 0 0 1\n",
        "p 2 0 0 0 1 0 0\n",
        "p 0\n",
        "p -3\n",
        "p 3.5 0 0 0\n",
        "p 1000000000\n0 0 0\n1 0 0\n0 1 0\n",
        "p 99999999999999999999 0 0 0\n",
        "p 4\n0 0 0\n1 0 0\n0 1 0\ns 0 0 0 1\n",
        "p 3\n0 0 0\n1 0 0\n0 1\n",
        "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0\n",
        "pp 1000000000 0 0 0\n",
    ];
    refuse("nff-shapes", &format!("{VIEW}{FILL}"), &texts);
}

#[test]
fn absurd_counts_are_refused_at_once() {
    let start = std::time::Instant::now();
    let text = format!("{VIEW}{FILL}p 1000000000 0 0 0 ");
    for _ in 0..100 {
        assert!(Scene::from_nff("scene.nff", &text).is_err());
    }
    assert!(start.elapsed().as_millis() < 1000, "{:?} for 100", start.elapsed());
}

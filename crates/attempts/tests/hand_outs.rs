//! Hand-outs as a student has them: they compile at once, say what to do next, fail their tests where they
//! ask, and pass them with the reference put in.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use homework::{Catalog, Exercise};

/// Where hand-outs of the tests are written: within `target`, so that what is built stays built.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("hand-outs").join(name.replace('/', "-"));
    let _ = fs::remove_dir_all(&folder);
    folder
}

/// Runs cargo in a hand-out. All hand-outs share a folder for what is built: crates from elsewhere are built
/// once.
fn cargo(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO"))
        .args(arguments)
        .arg("--target-dir")
        .arg(PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("hand-outs-target"))
        .current_dir(folder)
        .env_remove("CARGO_TARGET_DIR")
        .output()
        .expect("cargo runs, for it runs this test")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Hands an exercise out, builds it without a warning, and runs it: it asks its first question.
fn asks(exercise: &Exercise) -> PathBuf {
    let name = &exercise.manifest.name;
    let folder = folder(name);
    homework::start(name, &folder, &mut Vec::new()).unwrap();
    let run = cargo(&folder, &["run"]);
    let (said, errors) = (text(&run.stdout), text(&run.stderr));
    assert!(run.status.success(), "{name} does not build:\n{errors}");
    assert!(!errors.contains("warning:"), "{name}: {errors}");
    assert!(said.contains(" asks:\n"), "{name} asks nothing:\n{said}");
    assert!(said.contains(&format!("src/{}:", exercise.manifest.file)), "{name}:\n{said}");
    folder
}

#[test]
fn the_first_hand_out_of_each_chapter_builds_and_asks() {
    let catalog = Catalog::read().unwrap();
    let mut chapters: Vec<&str> = Vec::new();
    for exercise in &catalog.exercises {
        if !chapters.contains(&exercise.manifest.chapter.as_str()) {
            chapters.push(&exercise.manifest.chapter);
            asks(exercise);
        }
    }
    assert_eq!(chapters.len(), 11, "{chapters:?}");
}

/// Minutes: `.ci/full` asks for it.
#[test]
#[ignore = "it builds every hand-out twice, which takes minutes: .ci/full runs it"]
fn every_hand_out_fails_where_it_asks_and_passes_with_the_reference() {
    let catalog = Catalog::read().unwrap();
    for exercise in &catalog.exercises {
        let name = &exercise.manifest.name;
        let folder = asks(exercise);
        let untouched = cargo(&folder, &["test"]);
        assert!(!untouched.status.success(), "{name}: untouched it passes");
        assert!(text(&untouched.stdout).contains("not yet implemented"), "{name}");
        let solved = exercise.manifest.library(&catalog.source, &Default::default()).unwrap();
        // holes may be in several files
        for (file, _) in exercise.manifest.asks(&catalog.source).unwrap() {
            fs::write(folder.join("src").join(&file), &solved[&file]).unwrap();
        }
        let tested = cargo(&folder, &["test"]);
        assert!(tested.status.success(), "{name}: {}", text(&tested.stdout));
        let said = text(&cargo(&folder, &["run"]).stdout);
        assert!(said.contains("Every value is as it should be"), "{name}: {said}");
    }
}

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

/// Where hand-outs are built. They share it, so that crates from elsewhere are built once; two that are built at the same
/// time have two.
#[derive(Clone, Copy, PartialEq)]
enum Bench {
    Left,
    Right,
}

/// Runs cargo in a hand-out. It is built once, and nobody looks for its lines.
fn cargo(bench: Bench, folder: &Path, arguments: &[&str]) -> Output {
    let target = if bench == Bench::Left { "hand-outs-target" } else { "hand-outs-target-2" };
    Command::new(env!("CARGO"))
        .args(arguments)
        .arg("--target-dir")
        .arg(PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(target))
        .current_dir(folder)
        .env_remove("CARGO_TARGET_DIR")
        .env("CARGO_INCREMENTAL", "0")
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .output()
        .expect("cargo runs, for it runs this test")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Hands an exercise out, builds it without a warning, and runs it: it asks its first question.
fn asks(bench: Bench, exercise: &Exercise) -> PathBuf {
    let name = &exercise.manifest.name;
    let folder = folder(name);
    homework::start(name, &folder, &mut Vec::new()).unwrap();
    let run = cargo(bench, &folder, &["run"]);
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
    let mut firsts: Vec<&Exercise> = catalog.exercises.iter().collect();
    firsts.dedup_by_key(|exercise| &exercise.manifest.chapter);
    assert_eq!(firsts.len(), 11, "{:?}", firsts.iter().map(|it| &it.manifest.name).collect::<Vec<_>>());
    // every other one: a later chapter takes longer, as all before it come along
    let firsts = &firsts;
    std::thread::scope(|scope| {
        for (bench, first) in [(Bench::Left, 0), (Bench::Right, 1)] {
            let half = firsts.iter().skip(first).step_by(2);
            scope.spawn(move || half.for_each(|exercise| drop(asks(bench, exercise))));
        }
    });
}

/// Minutes: `.ci/full` asks for it.
#[test]
#[ignore = "it builds every hand-out twice, which takes minutes: .ci/full runs it"]
fn every_hand_out_fails_where_it_asks_and_passes_with_the_reference() {
    let catalog = Catalog::read().unwrap();
    for exercise in &catalog.exercises {
        let name = &exercise.manifest.name;
        let folder = asks(Bench::Left, exercise);
        let untouched = cargo(Bench::Left, &folder, &["test"]);
        assert!(!untouched.status.success(), "{name}: untouched it passes");
        assert!(text(&untouched.stdout).contains("not yet implemented"), "{name}");
        let solved = exercise.manifest.library(&catalog.source, &Default::default()).unwrap();
        // holes may be in several files
        for (file, _) in exercise.manifest.asks(&catalog.source).unwrap() {
            fs::write(folder.join("src").join(&file), &solved[&file]).unwrap();
        }
        let tested = cargo(Bench::Left, &folder, &["test"]);
        assert!(tested.status.success(), "{name}: {}", text(&tested.stdout));
        let said = text(&cargo(Bench::Left, &folder, &["run"]).stdout);
        assert!(said.contains("Every value is as it should be"), "{name}: {said}");
    }
}

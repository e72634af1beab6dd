//! Requests that are refused, and requests that cannot be done: what is said, and the exit status.

use std::fmt::Write;

use tests::{Folder, STAGES};

use crate::assert_snapshot;
use crate::process::run;

/// A folder, a file and nothing else.
fn furnished() -> Folder {
    let folder = Folder::new();
    std::fs::create_dir(folder.path().join("folder.png")).unwrap();
    folder.put("file.txt", "a regular file");
    folder
}

/// The requests, and the exit status of each.
const REQUESTS: &[(&[&str], i32)] = &[
    (&["wander"], 2),
    (&["show", "extra"], 2),
    (&["--color"], 2),
    (&["--method", "guess"], 2),
    (&["eval", "--method", "guess"], 2),
    (&["--precision", "f16"], 2),
    (&["--format", "yaml"], 2),
    (&["--format", "csv"], 2),
    (&["--format", "csv", "show"], 2),
    (&["show", "--format", "csv"], 2),
    (&["eval", "--format", "csv"], 2),
    (&["--size", "0x0"], 2),
    (&["--size", "640x0"], 2),
    (&["--size", "100000000x100000000"], 2),
    (&["--size", "99999999999999999999x1"], 2),
    (&["--size", "large"], 2),
    (&["--size", "640"], 2),
    (&["--size=-640x400"], 2),
    (&["--size", ""], 2),
    (&["--size", "64x48", "--pixel", "64,0"], 2),
    (&["--size", "64x48", "--pixel", "0,48"], 2),
    (&["--pixel", "4000000000,4000000000"], 2),
    (&["--pixel", "99999999999,0"], 2),
    (&["--pixel", "3"], 2),
    (&["--pixel", "3;4"], 2),
    (&["--pixel=-1,0"], 2),
    (&["--pixel", "1.5,0"], 2),
    (&["--out"], 2),
    (&["--out", ""], 2),
    (&["--out", "picture"], 2),
    (&["--out", "picture.jpg"], 2),
    (&["--out", "missing/picture.png"], 1),
    (&["--out", "folder.png"], 1),
    (&["--out", "file.txt/picture.png"], 1),
];

#[test]
fn a_bad_request_is_refused_and_leaves_nothing() {
    for stage in STAGES {
        let name = stage.about().name;
        let mut said = String::new();
        for (args, status) in REQUESTS {
            let folder = furnished();
            let run = run(folder.path(), name, args);
            assert_eq!(run.status, *status, "{name} {args:?}: {}", run.errors);
            assert!(run.output.is_empty() && run.errors.starts_with("error: "), "{name} {args:?}");
            assert_eq!(folder.names(), ["file.txt", "folder.png"], "{name} {args:?}");
            let empty = std::fs::read_dir(folder.path().join("folder.png")).unwrap().next().is_none();
            assert!(empty, "{name} {args:?}");
            let args: Vec<_> = args.iter().map(|arg| if arg.is_empty() { "''" } else { arg }).collect();
            writeln!(said, "$ {name} {}\n{}exit status {}\n", args.join(" "), run.errors, run.status)
                .unwrap();
        }
        assert_snapshot(&format!("{name}.bad-requests"), &said);
    }
}

#[test]
fn where_the_ids_cannot_be_kept_there_is_no_picture_either() {
    for name in ["signature", "bounds"] {
        for (ids, status, cause) in [
            ("missing/ids.png", 1, "there is no folder missing"),
            ("folder.png", 1, "it is a folder"),
            ("file.txt/ids.png", 1, "file.txt is not a folder"),
            ("ids.tif", 2, "ends in .png"),
            ("./picture.png", 2, "name two files"),
        ] {
            let folder = furnished();
            let args = ["--size", "16x12", "--out", "picture.png", "--ids", ids];
            let run = run(folder.path(), name, &args);
            assert_eq!((run.status, run.output.as_str()), (status, ""), "{name} {ids}: {}", run.errors);
            assert!(run.errors.contains(cause), "{name} {ids}: {}", run.errors);
            assert_eq!(folder.names(), ["file.txt", "folder.png"], "{name} {ids}");
        }
    }
}

/// An id has 16 bits, and 0 is nothing.
#[test]
fn an_object_without_an_id_is_not_written_as_nothing() {
    let sky = "v from 0 0 -4 at 0 0 0 up 0 1 0 angle 40 hither 1 resolution 4 4\nf 1 1 1 1 0 1 0 0\n";
    let scene = format!("{sky}{}s 0 0 0 3\n", "s 0 0 900 1\n".repeat(65535));
    let folder = Folder::new();
    folder.put("scene.nff", &scene);
    let args = ["--scene", "scene.nff", "--out", "picture.png"];
    let with_ids = run(folder.path(), "bounds", &[&args[..], &["--ids", "ids.png"]].concat());
    assert_eq!(with_ids.status, 2);
    assert!(with_ids.errors.starts_with("error: --ids: 16 pixels see an object that has no id"));
    assert_eq!(folder.names(), ["scene.nff"]);
}

#[test]
fn a_file_named_out_is_in_the_way_of_the_folder() {
    for stage in STAGES {
        let folder = Folder::new();
        folder.put("out", "a regular file");
        for args in [&[][..], &["trade"]] {
            let run = run(folder.path(), stage.about().name, args);
            assert_eq!((run.status, run.output.as_str()), (1, ""));
            assert!(run.errors.starts_with("error: cannot make the folder out"), "{}", run.errors);
            assert!(run.errors.contains("--out"), "what would help: {}", run.errors);
            assert_eq!(folder.names(), ["out"]);
        }
    }
}

/// What was measured is printed, and the other drawings are there.
#[test]
fn a_drawing_that_cannot_be_written_costs_no_numbers() {
    for stage in STAGES {
        let about = stage.about();
        let folder = Folder::new();
        std::fs::create_dir(folder.path().join("picture-trade.svg")).unwrap();
        let some = ["--regime", about.regimes[0].0, "--precision", "f64"];
        let args = [&["trade", "--quick", "--cases", "1", "--out", "picture.png"], &some[..]].concat();
        let run = run(folder.path(), about.name, &args);
        assert_eq!(run.status, 1);
        assert!(run.errors.starts_with("error: cannot write picture-trade.svg: "), "{}", run.errors);
        assert!(run.output.contains("\nWhat to take"), "{}", run.output);
        let mut listed: Vec<&str> =
            run.output.lines().filter_map(|line| line.strip_prefix("drawing: ")).collect();
        listed.push("picture-trade.svg");
        listed.sort_unstable();
        assert_eq!(listed, folder.names());
    }
}

/// Where not even root may make a file: what a missing permission is for others.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_may_not_be_written_to_is_a_failure() {
    for stage in STAGES {
        let folder = Folder::new();
        for out in ["/proc/picture.png", "/sys/picture.png"] {
            let run = run(folder.path(), stage.about().name, &["--out", out]);
            assert_eq!((run.status, run.output.as_str()), (1, ""));
            assert!(run.errors.starts_with(&format!("error: cannot write {out}: ")), "{}", run.errors);
        }
        assert!(folder.names().is_empty());
    }
}

#[test]
fn the_old_picture_survives_a_bad_request() {
    for stage in STAGES {
        let folder = Folder::new();
        folder.put("picture.png", "an old file");
        let run = run(folder.path(), stage.about().name, &["--out", "picture.png", "--size", "0x0"]);
        assert_eq!(run.status, 2);
        assert_eq!(std::fs::read(folder.path().join("picture.png")).unwrap(), b"an old file");
    }
}

/// The grid `edges` divides by width − 1 and height − 1.
#[test]
fn a_pixel_of_one_column_has_no_place_on_the_grid_of_edges() {
    for stage in STAGES.iter().filter(|stage| stage.about().methods.contains(&"edges")) {
        let folder = Folder::new();
        for size in ["1x1", "1x5", "5x1"] {
            let args = ["--method", "edges", "--size", size, "--pixel", "0,0", "--out", "picture.png"];
            let run = run(folder.path(), stage.about().name, &args);
            assert_eq!((run.status, run.output.as_str()), (2, ""), "{size}: {}", run.errors);
            assert!(run.errors.contains("at least two columns and two rows"), "{}", run.errors);
        }
        assert!(folder.names().is_empty());
    }
}

//! The commands that are in order.

use std::path::Path;

use stage::{Ask, report};
use tests::{Folder, STAGES, with_cases};

use crate::assert_snapshot;
use crate::cases::{answers, header, plain_row};
use crate::process::{run, run_with_input};
use crate::shown::by_default;

#[test]
fn show_is_what_a_stage_does_by_itself() {
    for stage in STAGES {
        let (folder, name) = (Folder::new(), stage.about().name);
        let small = ["--size", "64x48"];
        let named = [&["show"], small.as_slice()].concat();
        let [bare, named] = [small.as_slice(), &named].map(|args| run(folder.path(), name, args));
        assert_eq!((bare.status, bare.errors.as_str()), (0, ""));
        assert_eq!(bare.output, named.output);
        assert!(bare.output.ends_with(&format!("\npicture: out/{name}.png\n")), "{}", bare.output);
        assert_eq!(folder.names(), ["out"]);
        let pictures = std::fs::read_dir(folder.path().join("out")).unwrap();
        let pictures: Vec<_> = pictures.map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(pictures, [format!("{name}.png").as_str()]);
    }
}

#[test]
fn show_prints_json() {
    for stage in STAGES {
        let (folder, name) = (Folder::new(), stage.about().name);
        let said = report(by_default(*stage), Path::new("picture.png"), true);
        assert_snapshot(&format!("{name}.json"), &said);
        let shown = run(
            folder.path(),
            name,
            &["show", "--format", "json", "--size", "64x48", "--out", "picture.png"],
        );
        assert_eq!((shown.status, shown.errors.as_str()), (0, ""));
        let small = stage.show(&Ask { size: Some((64, 48)), ..Ask::default() }).unwrap();
        assert_eq!(shown.output, report(&small, Path::new("picture.png"), true));
    }
}

#[test]
fn flags_stand_before_or_after_the_verb() {
    for stage in STAGES {
        let (folder, name) = (Folder::new(), stage.about().name);
        let [before, after] = [
            ["--precision", "f32", "--size", "64x48", "--pixel", "63,47", "--out", "a.png", "show"],
            ["show", "--precision", "f32", "--size", "64x48", "--pixel", "63,47", "--out", "a.png"],
        ]
        .map(|args| run(folder.path(), name, &args));
        assert_eq!((before.status, before.errors.as_str()), (0, ""));
        assert_eq!(before.output, after.output);
    }
}

#[test]
fn flags_of_trade_stand_before_or_after_the_verb_too() {
    for stage in STAGES {
        let (folder, about) = (Folder::new(), stage.about());
        let flags = ["--format", "csv", "--method", about.methods[1], "--precision", "f64", "--out", "a.png"];
        let own = ["trade", "--quick", "--cases", "20", "--regime", about.regimes[0].0];
        for args in [[flags.as_slice(), &own].concat(), [own.as_slice(), &flags].concat()] {
            let run = run(folder.path(), about.name, &args);
            assert_eq!((run.status, run.errors.as_str()), (0, ""), "{args:?}");
            let lines: Vec<&str> = run.output.lines().collect();
            let record = format!("{},f64,{},", about.methods[1], about.regimes[0].0);
            // whole pictures are measured in many settings
            let is_one = lines.len() == 2 || (lines.len() > 2 && about.name == "whitted");
            assert!(is_one, "{args:?}: {}", run.output);
            assert!(lines[1..].iter().all(|line| line.starts_with(&record)), "{args:?}: {}", run.output);
        }
    }
}

#[test]
fn a_new_picture_takes_the_place_of_the_old_one() {
    for stage in STAGES {
        let (folder, name) = (Folder::new(), stage.about().name);
        folder.put("picture.PNG", "an old file");
        let shown = run(folder.path(), name, &["--size", "64x48", "--out", "picture.PNG"]);
        assert_eq!((shown.status, folder.names()), (0, vec!["picture.PNG".to_string()]), "{}", shown.errors);
        let picture = image::open(folder.path().join("picture.PNG")).unwrap();
        assert_eq!((picture.width(), picture.height()), (64, 48));
    }
}

#[test]
fn cases_come_from_a_file_or_through_a_pipe() {
    for stage in with_cases() {
        let (folder, name) = (Folder::new(), stage.about().name);
        let (header, row) = (header(stage), plain_row(stage));
        let plain = format!("{header}\n{row}\n");
        folder.put("cases.csv", &plain);
        let file = run(folder.path(), name, &["eval", "--cases", "cases.csv"]);
        let pipe = run_with_input(folder.path(), name, &["eval"], plain.as_bytes());
        assert_eq!((file.status, file.errors.as_str()), (0, ""));
        assert_eq!(file.output, pipe.output);
        let dash = run_with_input(folder.path(), name, &["eval", "--cases", "-"], plain.as_bytes());
        assert_eq!((dash.status, dash.errors.as_str()), (0, ""));
        assert_eq!(dash.output, pipe.output, "`-` is standard input");
        let lines: Vec<&str> = file.output.lines().collect();
        assert_eq!((lines[0], lines.len()), (stage.about().results.join(",").as_str(), 2));
        assert_eq!(folder.names(), ["cases.csv"], "eval writes no file");
    }
}

#[test]
fn the_form_of_a_case_file_does_not_matter() {
    for stage in with_cases() {
        let (header, row) = (header(stage), plain_row(stage));
        let plain = answers(stage, &format!("{header}\n{row}\n{row}\n"));
        let quoted = row.split(',').map(|field| format!("\"{field}\"")).collect::<Vec<_>>().join(",");
        let [backward_header, backward_row] =
            [&header, &row].map(|line| line.split(',').rev().collect::<Vec<_>>().join(","));
        for (form, text) in [
            ("lines end with CR LF", format!("{header}\r\n{row}\r\n{row}\r\n")),
            ("a byte order mark", format!("\u{feff}{header}\n{row}\n{row}\n")),
            ("no line end after the last row", format!("{header}\n{row}\n{row}")),
            ("blank lines", format!("\n{header}\n\n{row}\n  \n{row}\n\n")),
            ("quotes", format!("{header}\n{quoted}\n{quoted}\n")),
            ("spaces around the numbers", format!("{header}\n{}\n{row}\n", row.replace(',', " , "))),
            ("more columns", format!("remark,{header},t\n\"a, \"\"b\"\"\",{row},\nabc,{row},nan\n")),
            ("another order", format!("{backward_header}\n{backward_row}\n{backward_row}\n")),
        ] {
            assert_eq!(answers(stage, &text), plain, "{}: {form}", stage.about().name);
        }
    }
}

#[test]
fn a_header_alone_is_a_file_without_cases() {
    for stage in with_cases() {
        assert!(answers(stage, &header(stage)).is_empty());
    }
}

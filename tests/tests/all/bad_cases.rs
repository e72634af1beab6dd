//! Case files that are wrong: the message, its place, the exit status.

use std::fmt::Write;

use stage::Stage;
use tests::{Folder, with_cases};

use crate::assert_snapshot;
use crate::cases::{answers, field, header, plain_row, row_with};
use crate::process::{run, run_with_input};

/// A case file, what is wrong with it, and the line and column that the message names.
struct Bad {
    what: &'static str,
    file: Vec<u8>,
    place: String,
}

/// The bad case files of a stage. Where a row is bad, one good row comes before it.
fn bad_files(stage: &dyn Stage) -> Vec<Bad> {
    let (header, row) = (header(stage), plain_row(stage));
    let start = format!("{header}\n{row}\n");
    let [first, second] = [0, 1].map(|i| stage.about().inputs[i]);
    let with = |column, text| format!("{start}{}\n", row_with(stage, column, text));
    let (first_columns, last_column) = header.rsplit_once(',').unwrap();
    let (first_fields, _) = row.rsplit_once(',').unwrap();
    // Columns are counted in bytes from 1.
    let second_column = row.find(',').unwrap() + 2;
    let last_but_one_column = first_fields.rfind(',').unwrap() + 2;
    let bad = |what, file: &dyn AsRef<[u8]>, (line, column): (usize, usize)| Bad {
        what,
        file: file.as_ref().to_vec(),
        place: format!("{line}:{column}"),
    };
    let mut files = vec![
        bad("an empty file", &"", (1, 1)),
        bad("blank lines only", &"\n\n\n", (1, 1)),
        bad("no header row", &format!("{row}\n"), (1, 1)),
        bad("one column missing", &format!("{first_columns}\n{first_fields}\n"), (1, 1)),
        bad("all columns missing but one", &format!("{last_column}\n1\n"), (1, 1)),
        bad("a short row", &format!("{start}{first_fields}\n"), (3, last_but_one_column)),
        bad("a long row", &format!("{start}{row},7\n"), (3, row.len() + 2)),
        bad("a word", &with(first, "abc"), (3, 1)),
        bad("a word in the second column", &with(second, "abc"), (3, second_column)),
        bad("an empty field", &with(first, ""), (3, 1)),
        bad("a comma for a point", &with(first, "\"0,5\""), (3, 1)),
        bad("two numbers in a field", &with(first, "1 2"), (3, 1)),
        bad("a hexadecimal number", &with(first, "0x10"), (3, 1)),
        bad("an unclosed quote", &format!("{start}\"{row}\n{row}\n"), (3, row.len() + 1)),
        bad("binary garbage", &garbage(4096), (1, 1)),
        bad("UTF-16", &utf_16(&start), (1, 1)),
        bad("binary garbage after the rows", &[start.as_bytes(), b"\xff\x00\x1b[31m,\x07"].concat(), (3, 9)),
        bad("lines that end with CR", &format!("{header}\r{row}\r"), (1, header.len() + 1)),
        bad("a CR inside a row", &format!("{start}{row}\rjunk,7\n"), (3, row.len() + 1)),
        bad("a column that stands twice", &format!("{header},{first}\n{row},1\n"), (1, header.len() + 2)),
        bad("a very long header row", &vec![b'x'; 3 << 20], (1, 1 << 20)),
        bad("a very long row", &[start.as_bytes(), &vec![b'1'; 3 << 20]].concat(), (3, 1 << 20)),
    ];
    for (column, _) in stage.about().words {
        let place = stage.about().inputs.iter().position(|name| name == column).unwrap();
        let at = 1 + row.split(',').take(place).map(|field| field.len() + 1).sum::<usize>();
        files.push(bad("a word that there is not", &with(column, "teapot"), (3, at)));
        files.push(bad("a number for a word", &with(column, "0"), (3, at)));
        files.push(bad("a word in capitals", &with(column, "SPHERE"), (3, at)));
    }
    files
}

/// Bytes of every kind, the same on every run (Knuth's MMIX generator).
fn garbage(length: usize) -> Vec<u8> {
    let mut state: u64 = 1;
    let mut byte = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 56) as u8
    };
    (0..length).map(|_| byte()).collect()
}

/// A text as some spreadsheets save it.
fn utf_16(text: &str) -> Vec<u8> {
    "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect()
}

#[test]
fn a_bad_case_file_is_refused_with_its_place() {
    for stage in with_cases() {
        let name = stage.about().name;
        let mut said = String::new();
        for Bad { what, file, place } in bad_files(stage) {
            let folder = Folder::new();
            folder.put("cases.csv", &file);
            let run = run(folder.path(), name, &["eval", "--cases", "cases.csv"]);
            assert_eq!(run.status, 2, "{name}: {what}: {}", run.errors);
            let start = format!("error: cases.csv:{place}: ");
            assert!(run.errors.starts_with(&start), "{name}: {what}: want {start}, got {}", run.errors);
            assert_eq!(run.errors.lines().count(), 1, "{name}: {what}: one line of cause: {}", run.errors);
            assert!(!run.errors.trim_end().chars().any(char::is_control), "{name}: {what}: {:?}", run.errors);
            assert_eq!(folder.names(), ["cases.csv"], "{name}: {what}");
            if place.starts_with('3') {
                assert_eq!(run.output.lines().count(), 2, "{name}: {what}: the good row is answered");
            }
            writeln!(said, "{what}\n{}exit status {}\n", run.errors, run.status).unwrap();
        }
        assert_snapshot(&format!("{name}.bad-cases"), &said);
    }
}

#[test]
fn a_case_file_that_cannot_be_read_is_named() {
    for stage in with_cases() {
        let (folder, name) = (Folder::new(), stage.about().name);
        for file in ["missing.csv", "missing/cases.csv"] {
            let run = run(folder.path(), name, &["eval", "--cases", file]);
            assert_eq!((run.status, run.output.as_str()), (2, ""));
            assert!(run.errors.starts_with(&format!("error: cannot read {file}: ")), "{}", run.errors);
        }
        // A folder can be opened but not read.
        let run = run(folder.path(), name, &["eval", "--cases", "."]);
        assert_eq!((run.status, run.output.as_str()), (2, ""));
        assert_eq!(run.errors, "error: cannot read .: it is a folder; name a CSV file\n");
        assert!(folder.names().is_empty());
    }
}

#[test]
fn standard_input_is_named_too() {
    for stage in with_cases() {
        let (folder, name) = (Folder::new(), stage.about().name);
        let (header, first) = (header(stage), stage.about().inputs[0]);
        let cases = format!("{header}\n{}\n", row_with(stage, first, "abc"));
        for args in [&["eval"][..], &["eval", "--cases", "-"]] {
            let run = run_with_input(folder.path(), name, args, cases.as_bytes());
            assert_eq!(run.status, 2);
            let start = format!("error: standard input:2:1: `abc` in column `{first}` is not a number");
            assert!(run.errors.starts_with(&start), "{args:?}: {}", run.errors);
        }
    }
}

#[test]
fn what_is_not_finite_is_an_invalid_case_and_no_error() {
    for stage in with_cases() {
        let about = stage.about();
        let is_word = |column: &str| about.words.iter().any(|(name, _)| *name == column);
        for column in about.inputs.iter().filter(|column| !is_word(column)) {
            for number in ["nan", "NaN", "inf", "-inf", "1e400", "-1e400"] {
                let row = row_with(stage, column, number);
                let cases = format!("{}\n{row}\n{}\n", header(stage), plain_row(stage));
                let rows = answers(stage, &cases);
                let what = format!("{}: {column} = {number}: {rows:?}", about.name);
                assert_eq!(rows.len(), 2, "{what}");
                assert!(field(stage, &rows[0], "hit").is_none_or(|hit| hit == "invalid"), "{what}");
                assert!(field(stage, &rows[0], "reason").is_some_and(|reason| !reason.is_empty()), "{what}");
                let empty = |name: &&str| field(stage, &rows[0], name) == Some("");
                assert!(
                    about.results.iter().filter(|name| !["hit", "reason"].contains(name)).all(empty),
                    "{what}"
                );
                assert!(field(stage, &rows[1], "hit").is_none_or(|hit| hit != "invalid"), "{what}");
                assert_eq!(field(stage, &rows[1], "reason"), Some(""), "{what}");
            }
        }
    }
}

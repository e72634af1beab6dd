//! What README.md shows is what a reader gets.

use std::fs;
use std::path::Path;

use tests::{Folder, STAGES, stage_named};

use crate::process::run;

fn readme() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md")).unwrap()
}

/// The fenced blocks of a page in order: their language and their text.
pub(crate) fn blocks(page: &str) -> Vec<(&str, String)> {
    let (mut blocks, mut open): (Vec<(&str, String)>, bool) = (Vec::new(), false);
    for line in page.lines() {
        match line.strip_prefix("```") {
            Some(_) if open => open = false,
            Some(language) => {
                blocks.push((language, String::new()));
                open = true;
            }
            None if open => {
                let (_, text) = blocks.last_mut().unwrap();
                text.push_str(line);
                text.push('\n');
            }
            None => {}
        }
    }
    blocks
}

/// Does what a line of a shell block asks for, and gives what it prints. `None` for the commands that
/// concern the whole workspace or take long.
pub(crate) fn printed(line: &str, folder: &Folder) -> Option<String> {
    let words = line.split('#').next().unwrap().trim();
    if let Some(rest) = words.strip_prefix("printf '") {
        let (text, name) = rest.split_once("' > ").expect("printf 'TEXT' > FILE");
        folder.put(name, text.replace("\\n", "\n"));
        return Some(String::new());
    }
    let words: Vec<&str> = words.split_whitespace().collect();
    let args = match words.as_slice() {
        // `.ci/full` builds the book
        [] | ["cargo", "run", "--release"] | ["cargo", "test"] | ["cargo", "run", "-p", "book"] => {
            return None;
        }
        // times, which are never the same; `trade.rs` runs it quickly
        // and a page of some megabytes, which `.ci/full` reads in a browser
        ["cargo", "run", "--release", "-p", stage, "--", "trade"]
        | ["cargo", "run", "--release", "-p", stage, "--", "--inspect", _] => {
            assert!(stage_named(stage).is_some(), "{line}");
            return None;
        }
        ["cargo", "run", "-q", rest @ ..] | ["cargo", "run", rest @ ..] => rest,
        _ => panic!("a command that this test does not know: {line}"),
    };
    let (stage, args) = match args {
        ["-p", stage] => (stage, &[][..]),
        ["-p", stage, "--", args @ ..] => (stage, args),
        _ => panic!("a command that this test does not know: {line}"),
    };
    // a scene of the reader's own, of which nothing is shown but that it is drawn, is drawn small
    let is_any_size = args.contains(&"my.toml") && !args.contains(&"--pixel");
    let args = [args, if is_any_size { &["--size", "64x48"] } else { &[] }].concat();
    let run = run(folder.path(), stage, &args);
    assert_eq!((run.status, run.errors.as_str()), (0, ""), "{line}");
    Some(run.output)
}

#[test]
fn the_commands_print_what_is_shown() {
    let (folder, mut output, mut commands, mut shown) = (Folder::new(), String::new(), 0, 0);
    for (language, text) in blocks(&readme()) {
        match language {
            "sh" => {
                let answers: Vec<String> = text.lines().filter_map(|line| printed(line, &folder)).collect();
                commands += answers.len();
                output = answers.concat();
            }
            // a scene, and the same with a mistake: `my.toml` and `wrong.toml`
            "toml" => {
                folder.put("my.toml", &text);
                folder.put("wrong.toml", text.replace("radius", "radus"));
            }
            "text" if text.starts_with("error: ") => {
                let run = run(folder.path(), "signature", &["--scene", "wrong.toml"]);
                assert_eq!((run.status, run.errors.as_str()), (2, text.as_str()));
                shown += 1;
            }
            "text" => {
                assert!(output.contains(&text), "the commands before do not print this:\n{text}");
                shown += 1;
            }
            _ => panic!("a block in a language that this test does not know: {language}"),
        }
    }
    assert!(commands > 4 && shown > 1, "{commands} commands, {shown} outputs");
}

#[test]
fn the_table_lists_every_stage_with_its_methods() {
    let page = readme();
    for stage in STAGES {
        let about = stage.about();
        let start = format!("| {:02} | [`{}`]", about.number, about.name);
        let row = page.lines().find(|line| line.starts_with(&start)).expect(&start);
        let methods: Vec<String> = about.methods.iter().map(|method| format!("`{method}`")).collect();
        assert!(row.ends_with(&format!("| {} |", methods.join(" "))), "{row}\n{methods:?}");
    }
}

#[test]
fn every_link_leads_to_a_file() {
    let (page, root) = (readme(), Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
    let links = page.split("](").skip(1).map(|rest| rest.split(')').next().unwrap());
    let files: Vec<&str> = links.filter(|link| !link.starts_with("https://")).collect();
    assert!(files.len() > 4, "{files:?}");
    for file in files {
        assert!(root.join(file).exists(), "README.md leads to {file}, which is not there");
    }
}

//! One page: its lines in double braces filled, its mathematics marked, its blocks of code judged.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use cutter::named::Sources;

use crate::figures::Figures;
use crate::shown::Shown;
use crate::{Fault, code, exercises, math, pictures, shown, trade};

/// A page as mdBook gets it, and what else it needs.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Page {
    /// The Markdown.
    pub text: String,
    /// The stages whose pictures it shows.
    pub pictures: BTreeSet<String>,
}

/// What the lines of a page are filled from.
pub(crate) struct Filler<'a> {
    /// The project's root.
    pub root: &'a Path,
    /// The crates' sources, to look names up in.
    pub sources: &'a Sources,
    /// The interactive figures.
    pub figures: Figures,
    /// What stages printed so far.
    pub shown: Shown,
}

impl Filler<'_> {
    /// Fills a page; `file` is where it stands, as seen from the root. All faults at once.
    pub(crate) fn page(&self, file: &Path, text: &str) -> Result<Page, Vec<Fault>> {
        let (mut page, mut faults) = (Page::default(), Vec::new());
        let mut fence: Option<&str> = None;
        // how many bars the rows of the table have that is being read
        let mut bars: Option<usize> = None;
        for (number, line) in text.lines().enumerate() {
            let wrong = |what: String| Fault::new(file, number + 1, what);
            if let Some(language) = line.trim_start().strip_prefix("```") {
                fence = match fence {
                    Some(_) => None,
                    None => {
                        faults.extend(from_nowhere(language).map(wrong));
                        Some(language)
                    }
                };
                page.text += line;
            } else if let Some(language) = fence {
                if language == "sh" {
                    faults.extend(command(line).err().map(wrong));
                }
                page.text += line;
            } else if let Some(words) =
                line.trim().strip_prefix("{{").and_then(|line| line.strip_suffix("}}"))
            {
                match self.filled(words, &mut page.pictures) {
                    Ok(text) => page.text += &text,
                    Err(what) => faults.push(wrong(what)),
                }
            } else {
                let found = bars_of(line);
                if let (Some(found), Some(bars)) = (found, bars)
                    && found != bars
                {
                    faults.push(wrong(format!(
                        "a row with {found} bars in a table of {bars}; a bar within a cell is \\|"
                    )));
                }
                bars = found.map(|found| bars.unwrap_or(found));
                if line.starts_with('|') && line.contains("::") {
                    let cell = line.trim_end_matches([' ', '|']).rsplit('|').next().unwrap_or_default();
                    faults.extend(self.sources.faults(cell).into_iter().map(wrong));
                    if file.ends_with("coverage.md") {
                        faults.extend(uncovered(line, self.sources.name_a_test(cell)).map(wrong));
                    }
                }
                if line.contains("{{") && !line.contains("`{{") {
                    faults.push(wrong(
                        "what is in double braces is fetched where it has a line of its own".into(),
                    ));
                }
                page.text += &math::line(line);
            }
            page.text.push('\n');
        }
        if fence.is_some() {
            faults.push(Fault::new(file, 0, "a block of code has no end"));
        }
        if faults.is_empty() { Ok(page) } else { Err(faults) }
    }

    /// What a line in double braces fetches.
    fn filled(&self, line: &str, drawn: &mut BTreeSet<String>) -> Result<String, String> {
        let mut parts = line.split('|').map(str::trim);
        let words: Vec<&str> = parts.next().unwrap_or_default().split_whitespace().collect();
        let titles: Vec<&str> = parts.collect();
        match words.as_slice() {
            ["code", file, names @ ..] if !names.is_empty() => {
                let text = code::items(self.root, file, names)?;
                Ok(format!("```rust,ignore\n{text}```\n<p class=\"from\">from <code>{file}</code></p>\n"))
            }
            ["text", file] => {
                let text = std::fs::read_to_string(self.root.join(file))
                    .map_err(|error| format!("{file} cannot be read: {error}"))?;
                // a snapshot says first where it is from
                let text = match text.strip_prefix("---\n").and_then(|rest| rest.split_once("\n---\n")) {
                    Some((_, shown)) if file.ends_with(".snap") => shown,
                    _ => &text,
                };
                Ok(format!("```text\n{text}```\n"))
            }
            ["show", words @ ..] => self.shown.markdown(self.root, words, &titles),
            ["picture", name] => {
                drawn.insert(name.to_string());
                pictures::markdown(name)
            }
            ["figure", name] => {
                drawn.insert(name.to_string());
                self.figures.markdown(name)
            }
            ["trade", stage, regime, best @ ..] if best.is_empty() || best == ["pareto"] => {
                let columns: Vec<&str> = titles.iter().flat_map(|names| names.split_whitespace()).collect();
                trade::markdown(self.root, stage, regime, &columns, !best.is_empty())
            }
            ["exercises", chapter] => exercises::markdown(self.root, chapter),
            _ => Err(format!(
                "nothing is known of {{{{{line}}}}}; there are {{{{code FILE NAME…}}}}, {{{{text FILE}}}}, {{{{show STAGE [FLAGS]… [| TITLE]…}}}}, \
                 {{{{picture STAGE}}}}, {{{{figure STAGE}}}}, {{{{trade STAGE REGIME [pareto] | COLUMN…}}}} and {{{{exercises STAGE}}}}"
            )),
        }
    }
}

/// How many bars a row of a table has between its cells and around them; `None` where a line is no row.
fn bars_of(line: &str) -> Option<usize> {
    line.starts_with('|').then(|| line.replace("\\|", "").matches('|').count())
}

/// What a row of the coverage of the notes lacks: a place in the book, a test.
fn uncovered(row: &str, has_test: bool) -> Option<String> {
    if !row.contains(".md#") {
        return Some("this row names no place in the book".into());
    }
    (!has_test).then(|| "this row names no test".into())
}

/// What is wrong with a block of code in this language: code of ours is fetched, not typed.
fn from_nowhere(language: &str) -> Option<String> {
    match language.split(',').next().unwrap_or_default() {
        "sh" | "text" | "toml" | "csv" | "json" | "yaml" => None,
        "rust" => Some("Rust that nobody runs: fetch it from a file with {{code FILE NAME}}".into()),
        other => Some(format!("a block in {other:?}; there are sh, text, toml, csv, json and yaml")),
    }
}

/// Whether a line of a shell block is one that works: a command of a stage with flags that it has.
fn command(line: &str) -> Result<(), String> {
    let line = line.split(" #").next().unwrap_or_default().split(" > ").next().unwrap_or_default();
    let words: Vec<&str> = line.split_whitespace().collect();
    let settings = words.iter().take_while(|word| is_setting(word)).count();
    let words = match &words[settings..] {
        ["cargo", "run", words @ ..] => words,
        ["cargo", "test", words @ ..] => return packages_are_there(words),
        _ => return Ok(()),
    };
    let own = words.iter().position(|word| *word == "--").unwrap_or(words.len());
    let (cargo, arguments) = (&words[..own], words.get(own + 1..).unwrap_or_default());
    let package = cargo.iter().position(|word| *word == "-p").and_then(|at| cargo.get(at + 1));
    match package {
        None => {
            let line = std::iter::once("workbench").chain(arguments.iter().copied());
            let parsed = workbench::command().try_get_matches_from(line);
            parsed
                .map(drop)
                .or_else(|usage| if usage.exit_code() == 0 { Ok(()) } else { Err(usage.to_string()) })
        }
        Some(&"book") if arguments.is_empty() || matches!(arguments, ["--out", _]) => Ok(()),
        Some(&"against-obvhs") => Ok(()),
        // what a loop of the shell goes through
        Some(name) if name.starts_with('$') => Ok(()),
        Some(name) if arguments.contains(&"--help") => shown::named(name).map(drop),
        Some(name) => shown::parsed(shown::named(name)?, arguments).map(drop),
    }
}

/// `NAME=value` before a command.
fn is_setting(word: &str) -> bool {
    let name = word.split('=').next().unwrap_or_default();
    word.contains('=')
        && !name.is_empty()
        && name.chars().all(|sign| sign.is_ascii_uppercase() || sign == '_')
}

/// Whether the packages that a `cargo test` names are the project's.
fn packages_are_there(words: &[&str]) -> Result<(), String> {
    let ours = [
        "math",
        "lab",
        "stage",
        "scene-file",
        "cutter",
        "exercise",
        "homework",
        "attempts",
        "workbench",
        "tests",
        "book",
    ];
    let named = words.windows(2).filter(|pair| pair[0] == "-p").map(|pair| pair[1]);
    let mut others = named.filter(|name| !ours.contains(name) && shown::named(name).is_err());
    others.next().map_or(Ok(()), |name| Err(format!("there is no package {name}")))
}

/// Where the pages are, as seen from the root.
pub(crate) fn place(page: &Path) -> PathBuf {
    Path::new("book/src").join(page)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fill(text: &str) -> Result<Page, Vec<String>> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let sources = Sources::read(root).unwrap();
        let filled =
            Filler { root, sources: &sources, figures: Figures::none(root), shown: Shown::default() }
                .page(Path::new("a.md"), text);
        filled.map_err(|faults| faults.iter().map(ToString::to_string).collect())
    }

    #[test]
    fn lines_are_filled_and_the_rest_stays() {
        let page = fill("# A $t$\n\n{{code crates/math/src/span.rs Span}}\n{{picture ray-wall}}\n").unwrap();
        assert!(
            page.text.starts_with("# A <span class=\"math\">t</span>\n\n```rust,ignore\n///"),
            "{}",
            page.text
        );
        assert!(page.text.contains("from <code>crates/math/src/span.rs</code>"));
        assert_eq!(page.pictures, BTreeSet::from(["ray-wall".to_string()]));
    }

    /// All but what the stages show, of which `shown.rs` has a test.
    #[test]
    fn every_page_of_the_book_can_be_filled() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let sources = Sources::read(root).unwrap();
        let filler =
            Filler { root, sources: &sources, figures: Figures::none(root), shown: Shown::default() };
        let mut pages = 0;
        for folder in ["book/src", "book/src/trade"] {
            for entry in std::fs::read_dir(root.join(folder)).unwrap() {
                let path = entry.unwrap().path();
                if path.extension().is_some_and(|it| it == "md") {
                    let text = std::fs::read_to_string(&path).unwrap();
                    let unshown: Vec<&str> = text
                        .lines()
                        .map(|line| if line.starts_with("{{show ") { "" } else { line })
                        .collect();
                    let faults = filler.page(path.strip_prefix(root).unwrap(), &unshown.join("\n")).err();
                    let told: Vec<String> = faults.iter().flatten().map(ToString::to_string).collect();
                    assert!(told.is_empty(), "{told:#?}");
                    pages += 1;
                }
            }
        }
        assert!(pages > 20, "{pages}");
    }

    #[test]
    fn every_fault_has_its_line() {
        let text = "{{code crates/math/src/span.rs Spam}}\n{{shoe ray-wall}}\n```rust\nlet x = 1;\n```\n\
                    ```sh\ncargo run -p ray-wall -- --metod x\ncargo run -p ray-ball\ncargo run -- lost\n```\n\
                    | 1 | `ray-wall`, `notes::tests::no_such_test` |\n| |z| | 2 |\n\n- {{picture ray-wall}}\n\
                    ```sh\ncargo test -p ray-ball\nSEED=7 cargo run -p ray-wall -- --metod x\n```\n";
        let faults = fill(text).unwrap_err();
        let starts =
            ["a.md:1: ", "a.md:2: nothing is known of {{shoe ray-wall}}", "a.md:3: Rust that nobody runs"];
        let more = [
            "a.md:7: ",
            "a.md:8: there is no stage ray-ball",
            "a.md:9: ",
            "a.md:11: `notes::tests::no_such_test`",
            "a.md:12: a row with 5 bars in a table of 3",
            "a.md:14: what is in double braces",
            "a.md:16: there is no package ray-ball",
            "a.md:17: ",
        ];
        let all: Vec<&str> = starts.into_iter().chain(more).collect();
        assert_eq!(faults.len(), all.len(), "{faults:#?}");
        for (fault, start) in faults.iter().zip(all) {
            assert!(fault.starts_with(start), "{fault}");
        }
    }

    #[test]
    fn a_row_of_the_coverage_has_a_place_and_a_test() {
        let row = "| Eq. 4.2 | [03](ray-plane.md#equation-42) | `notes::notes` |";
        assert_eq!(uncovered(row, true), None);
        assert_eq!(uncovered(row, false).as_deref(), Some("this row names no test"));
        let nowhere = "| Eq. 4.2 | [03](ray-plane.md) | `notes::notes` |";
        assert_eq!(uncovered(nowhere, true).as_deref(), Some("this row names no place in the book"));
    }

    #[test]
    fn commands_that_work_are_let_through() {
        let text = "```sh\ncargo run --release\ncargo test\ncargo run -q -p ray-sphere -- eval --cases cases.csv   # rows\n\
                    cargo run --release -p whitted -- trade --quick\ncargo run -p book\ncargo run -- list\n```\n";
        assert_eq!(fill(text).unwrap().text, text);
    }
}

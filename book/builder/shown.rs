//! What a stage prints when it is asked what a page asks.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::Path;
use std::rc::Rc;

use stage::{Ask, Stage, Transcript, asked, command_line};
use workbench::stages;

/// The stage of that name.
pub(crate) fn named(name: &str) -> Result<&'static dyn Stage, String> {
    let names = stages::names().join(", ");
    let stage = stages::ALL.iter().find(|stage| stage.about().name == name);
    stage.copied().ok_or_else(|| format!("there is no stage {name}; there are {names}"))
}

/// What a command line asks of a stage. The error is clap's own.
pub(crate) fn parsed(stage: &dyn Stage, arguments: &[&str]) -> Result<Ask, String> {
    let about = stage.about();
    let words = std::iter::once(about.name).chain(arguments.iter().copied());
    let matches = command_line(&about).try_get_matches_from(words).map_err(|error| error.to_string())?;
    Ok(asked(&about, &matches))
}

/// What stages printed so far: a page asks for a section here and for another one there, and a picture takes its time.
#[derive(Default)]
pub(crate) struct Shown(RefCell<BTreeMap<String, Rc<Transcript>>>);

impl Shown {
    /// A command and what it prints, as Markdown: all of it, or the sections whose titles begin so.
    ///
    /// An error where there is no such stage, flag or section, where the stage refuses, and where there is an accepted
    /// snapshot of this very request and the stage prints something else.
    pub(crate) fn markdown(&self, root: &Path, words: &[&str], titles: &[&str]) -> Result<String, String> {
        let (name, arguments) =
            words.split_first().ok_or("name a stage: {{show STAGE [FLAGS]… [| TITLE]…}}")?;
        let transcript = self.transcript(root, name, arguments)?;
        let text =
            if titles.is_empty() { transcript.to_string() } else { sections(name, &transcript, titles)? };
        let flags = if arguments.is_empty() { String::new() } else { format!(" -- {}", arguments.join(" ")) };
        Ok(format!("```sh\ncargo run -p {name}{flags}\n```\n\n```text\n{}\n```\n", text.trim_end()))
    }

    fn transcript(&self, root: &Path, name: &str, arguments: &[&str]) -> Result<Rc<Transcript>, String> {
        let command = [&[name], arguments].concat().join(" ");
        if let Some(transcript) = self.0.borrow().get(&command) {
            return Ok(Rc::clone(transcript));
        }
        let stage = named(name)?;
        let ask = parsed(stage, arguments)?;
        let shown = stage.show(&in_root(root, ask.clone())).map_err(|error| error.to_string())?;
        fresh(root, stage, &ask, &shown.transcript.to_string())?;
        let transcript = Rc::new(shown.transcript);
        self.0.borrow_mut().insert(command, Rc::clone(&transcript));
        Ok(transcript)
    }
}

/// The sections of a transcript whose titles begin so, in the order asked for.
fn sections(name: &str, transcript: &Transcript, titles: &[&str]) -> Result<String, String> {
    let mut parts = Vec::new();
    for title in titles {
        let sections = transcript.sections.iter().filter(|section| section.in_text);
        let there: Vec<&str> = sections.clone().map(|section| section.title.as_str()).collect();
        let before = parts.len();
        parts.extend(sections.filter(|it| it.title.starts_with(title)).map(ToString::to_string));
        if parts.len() == before {
            return Err(format!("{name} prints no section “{title}”; it prints “{}”", there.join("”, “")));
        }
    }
    Ok(parts.join("\n"))
}

/// The same request for whoever stands elsewhere: a scene's name is seen from the root.
fn in_root(root: &Path, ask: Ask) -> Ask {
    Ask { scene: ask.scene.map(|scene| root.join(scene)), ..ask }
}

/// Whether a stage prints what was accepted; a request that differs from the default in more than method and precision has
/// no snapshot.
fn fresh(root: &Path, stage: &dyn Stage, ask: &Ask, printed: &str) -> Result<(), String> {
    if *ask != (Ask { method: ask.method, precision: ask.precision, ..Ask::default() }) {
        return Ok(());
    }
    let about = stage.about();
    let name = [about.name, about.methods[ask.method], ask.precision.name()].join(".");
    let file = format!("tests/snapshots/{name}.snap");
    let snapshot = match std::fs::read_to_string(root.join(&file)) {
        Ok(snapshot) => snapshot,
        Err(error) if *ask == Ask::default() => return Err(format!("{file}: {error}")),
        // of a whole scene only the default request has one at this size
        Err(_) => return Ok(()),
    };
    let accepted = snapshot.splitn(3, "---\n").nth(2).unwrap_or_default();
    match accepted.trim_end() == printed.trim_end() {
        true => Ok(()),
        false => {
            Err(format!("{} prints something else than {file}: accept it, or mend the stage", about.name))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root() -> &'static Path {
        Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
    }

    #[test]
    fn a_section_is_what_the_stage_prints() {
        let text = Shown::default().markdown(root(), &["ray-wall"], &[]).unwrap();
        assert!(
            text.starts_with("```sh\ncargo run -p ray-wall\n```\n\n```text\nray-wall · notes · f64"),
            "{text}"
        );
        let some = Shown::default()
            .markdown(root(), &["ray-sphere", "--precision", "f32"], &["Both roots"])
            .unwrap();
        assert!(some.contains("cargo run -p ray-sphere -- --precision f32\n"), "{some}");
        assert!(some.contains("```text\nBoth roots of the red sphere"), "{some}");
        assert!(!some.contains("Table 2-1"), "{some}");
    }

    #[test]
    fn what_cannot_be_shown_is_told() {
        let error =
            |words: &[&str], titles: &[&str]| Shown::default().markdown(root(), words, titles).unwrap_err();
        assert!(error(&["ray-ball"], &[]).starts_with("there is no stage ray-ball; there are pinhole, "));
        assert!(error(&["ray-wall", "--metod", "notes"], &[]).contains("--metod"));
        assert!(error(&["ray-wall"], &["Nothing"]).starts_with("ray-wall prints no section “Nothing”"));
    }

    /// Everything that the pages show of the stages, as somebody has read it beside the text:
    /// `INSTA_UPDATE=always cargo test -p book` accepts what came.
    #[test]
    fn what_the_pages_show_was_accepted() {
        let (shown, mut text) = (Shown::default(), String::new());
        let entries = std::fs::read_dir(root().join("book/src")).unwrap().map(|entry| entry.unwrap().path());
        let mut pages: Vec<_> =
            entries.filter(|path| path.extension().is_some_and(|it| it == "md")).collect();
        pages.sort();
        for page in pages {
            let content = std::fs::read_to_string(&page).unwrap();
            let asked = content.lines().filter_map(|line| line.strip_prefix("{{show ")?.strip_suffix("}}"));
            for line in asked {
                let mut parts = line.split('|').map(str::trim);
                let words: Vec<&str> = parts.next().unwrap().split_whitespace().collect();
                let titles: Vec<&str> = parts.collect();
                let name = page.file_name().unwrap().to_string_lossy();
                let answer = shown.markdown(root(), &words, &titles).unwrap();
                text += &format!("=== {name}: {line}\n{answer}\n");
            }
        }
        assert!(text.matches("=== ").count() > 80);
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path("../snapshots");
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| insta::assert_snapshot!("shown", text));
    }

    #[test]
    fn a_stale_snapshot_is_found() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(folder.path().join("tests/snapshots")).unwrap();
        let file = folder.path().join("tests/snapshots/ray-wall.notes.f64.snap");
        std::fs::write(&file, "---\nsource: x\n---\nray-wall · notes · f64\n").unwrap();
        let error = Shown::default().markdown(folder.path(), &["ray-wall"], &[]).unwrap_err();
        assert!(error.starts_with("ray-wall prints something else than tests/snapshots/ray-wall"), "{error}");
    }
}

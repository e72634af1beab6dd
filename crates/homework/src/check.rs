//! Checks an attempt on the student's own machine.

use std::fs::{self, File};
use std::io::{self, IsTerminal, Write};
use std::path::Path;

use cutter::source::Files;
use stage::Error;

use crate::attempt::{Outcome, in_the_open};
use crate::report::{Report, Status, json_of};
use crate::start::hand_out;
use crate::submission::Submission;
use crate::{Catalog, Exercise, folder, placed};

/// How an attempt is looked at.
#[derive(Clone, Copy, Debug, Default)]
pub struct CheckAsk {
    /// An object for other programs instead of a text.
    pub json: bool,
    /// Whether a method that is right is measured beside the chapter's; only for an exercise that has one.
    pub trade: bool,
}

/// Builds and runs the attempt in a folder, and says what the first wrong value is. `Ok(true)` where all is
/// right. What is built is kept in the folder's `target`; with [`CheckAsk::trade`] the drawing goes to its
/// `trade.svg`. There is no sandbox: the attempt can do all that we can.
///
/// [`Error::Request`] where the folder is no hand-out, has files that are not taken, or is measured for an
/// exercise that has no method; [`Error::Failed`] where [`Catalog::read`] fails, where cargo cannot be run,
/// or a file not be read or written; [`Error::PipeClosed`] where nobody reads the output.
pub fn check(attempt: &Path, ask: CheckAsk, output: &mut dyn Write) -> Result<bool, Error> {
    let catalog = Catalog::read()?;
    let exercise = catalog.find(&folder::exercise_of(attempt)?)?;
    if ask.trade && exercise.manifest.method.is_none() {
        let why = "it adds no method to its chapter, so there is nothing to measure; leave --trade out";
        return Err(Error::Request(format!("{}: {why}", exercise.manifest.name)));
    }
    let students = folder::students(attempt)?;
    exercise.has_part(&catalog, &students)?;
    // the student's files in a hand-out as it was, so that nothing else matters
    let mut files = hand_out(&catalog, exercise)?;
    let changed = changed(attempt, &files, &exercise.manifest.file);
    files.extend(students.iter().map(|(name, text)| (format!("src/{name}"), text.clone())));
    let sheet = exercise.sheet();
    let colors = !ask.json && io::stderr().is_terminal();
    let outcome = in_the_open(&attempt.join("target/checked"), &files, exercise, &sheet, colors)?;
    let mut report = Report::of(&Submission::at(attempt), exercise, &sheet, &outcome);
    if let Some(note) = &changed {
        report.output += &format!("\n\n{note}");
    }
    let right = report.status == Status::Right;
    if ask.json {
        output.write_all(json_of(&report).as_bytes()).map_err(Error::from_output)?;
    } else {
        say(exercise, &report, &outcome, output).map_err(Error::from_output)?;
        if let (Some(note), Outcome::NotBuilt(_)) = (&changed, &outcome) {
            writeln!(output, "\n{note}").map_err(Error::from_output)?;
        }
    }
    if matches!(outcome, Outcome::Answered(_)) {
        remember(attempt, report.score, report.points);
        if !ask.json {
            progress(&catalog, attempt, output).map_err(Error::from_output)?;
        }
    }
    if right && ask.trade {
        // on standard error, where an object for other programs goes to standard output
        let mut errors = io::stderr();
        placed::trade(&catalog, exercise, attempt, &students, if ask.json { &mut errors } else { output })?;
    }
    Ok(right)
}

/// The files that are put there anew and that a student may take for theirs.
const GIVEN: [&str; 4] = ["src/lib.rs", "src/main.rs", "src/probe.rs", "Cargo.toml"];

/// What is said of given files that are not as they were handed out: it does not count, here or in a grade.
fn changed(attempt: &Path, hand_out: &Files, part: &str) -> Option<String> {
    let differs = |name: &&str| {
        let (Ok(here), Some(given)) = (folder::text(&attempt.join(name)), hand_out.get(*name)) else {
            return false;
        };
        // an editor may have its own ends of lines
        !here.trim_end().lines().eq(given.trim_end().lines())
    };
    let names: Vec<&str> = GIVEN.into_iter().filter(differs).collect();
    let remedy = format!("a module of your own is declared in src/{part}, where it is used");
    (!names.is_empty()).then(|| {
        format!("Not as handed out, so put there anew, as in grading: {}. ({remedy}.)", names.join(", "))
    })
}

fn say(exercise: &Exercise, report: &Report, outcome: &Outcome, output: &mut dyn Write) -> io::Result<()> {
    match outcome {
        // in the compiler's own colors
        Outcome::NotBuilt(words) => {
            eprintln!("{words}");
            return writeln!(output, "It does not compile; the compiler's words are above.");
        }
        Outcome::Refused(why) => return writeln!(output, "It cannot be checked: {why}."),
        Outcome::Answered(_) => {}
    }
    let (name, page) = (&exercise.manifest.name, &exercise.manifest.page);
    writeln!(output, "{name} · {page} · {} of {} points\n", report.score, report.points)?;
    let widest = report.properties.iter().map(|it| it.name.chars().count()).max().unwrap_or(0);
    for it in &report.properties {
        writeln!(output, "  {:widest$}  {} of {}", it.name, it.score, it.points)?;
    }
    writeln!(output, "\n{}", report.output)
}

/// Keeps what an attempt earned, for the progress; where it cannot, nothing is lost.
fn remember(attempt: &Path, earned: u32, points: u32) {
    if let Ok(mut file) = File::create(attempt.join("target/points.txt")) {
        let _ = writeln!(file, "{earned} {points}");
    }
}

/// What is solved among the hand-outs that stand beside this one.
fn progress(catalog: &Catalog, attempt: &Path, output: &mut dyn Write) -> io::Result<()> {
    let Ok(attempt) = attempt.canonicalize() else { return Ok(()) };
    let Some(Ok(entries)) = attempt.parent().map(fs::read_dir) else { return Ok(()) };
    let mut best = std::collections::BTreeMap::new();
    for entry in entries.flatten() {
        let Ok(points) = fs::read_to_string(entry.path().join("target/points.txt")) else { continue };
        let numbers: Vec<u32> = points.split_whitespace().filter_map(|it| it.parse().ok()).collect();
        if let (Ok(name), &[earned, of]) = (folder::exercise_of(&entry.path()), numbers.as_slice()) {
            let most = best.entry(name).or_insert((earned, of));
            *most = (*most).max((earned, of));
        }
    }
    let solved = best.values().filter(|(earned, of)| earned == of).count();
    let begun = best.len() - solved;
    writeln!(output, "\n{solved} of {} exercises solved, {begun} begun.", catalog.exercises.len())?;
    let next = catalog
        .exercises
        .iter()
        .find(|it| best.get(&it.manifest.name).is_none_or(|(earned, of)| earned < of));
    match next {
        Some(next) => writeln!(output, "The next one in the order of the book: {}", next.manifest.name),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_put_there_anew_is_told_where_it_was_changed() {
        let attempt = tempfile::tempdir().unwrap();
        let files =
            ["src/lib.rs", "src/main.rs", "Cargo.toml"].map(|name| (name.to_string(), "a\nb\n".to_string()));
        let files = Files::from(files);
        folder::write(&files, attempt.path()).unwrap();
        fs::write(attempt.path().join("src/main.rs"), "a\r\nb").unwrap();
        assert_eq!(changed(attempt.path(), &files, "part.rs"), None);
        fs::write(attempt.path().join("src/lib.rs"), "a\nmod helper;\nb\n").unwrap();
        let note = changed(attempt.path(), &files, "part.rs").unwrap();
        assert!(note.contains(": src/lib.rs.") && note.contains("src/part.rs"), "{note}");
    }
}

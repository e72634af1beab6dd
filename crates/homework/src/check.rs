//! Checks an attempt on the student's own machine.

use std::fs::{self, File};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use exercise::{Answer, Sheet, Wrong};
use stage::Error;
use wait_timeout::ChildExt;

use crate::judge::{Verdict, judge};
use crate::start::hand_out;
use crate::{Catalog, Exercise, folder};

/// Longer than this no attempt takes.
const PATIENCE: Duration = Duration::from_secs(20);

/// Builds and runs the attempt in a folder, and says what the first wrong value is. `Ok(true)` where all is right.
pub fn check(attempt: &Path, output: &mut dyn Write) -> Result<bool, Error> {
    let catalog = Catalog::read()?;
    let exercise = catalog.find(&folder::exercise_of(attempt)?)?;
    let sheet = exercise.sheet();
    let Some(answers) = run(&catalog, exercise, &sheet, attempt)? else { return Ok(false) };
    let verdict = judge(exercise, &sheet, &answers);
    say(exercise, &sheet, &answers, &verdict, output).map_err(Error::from_output)?;
    remember(attempt, verdict.earned, exercise.points());
    progress(&catalog, attempt, output).map_err(Error::from_output)?;
    Ok(verdict.wrong.is_none())
}

/// The answers of an attempt to all cases; `None` where it does not compile (the compiler has said why).
fn run(
    catalog: &Catalog,
    exercise: &Exercise,
    sheet: &Sheet,
    attempt: &Path,
) -> Result<Option<Vec<Answer>>, Error> {
    // the student's files in a hand-out as it was, so that nothing else matters
    let fresh = attempt.join("target/checked");
    let mut files = hand_out(catalog, exercise)?;
    for (name, text) in folder::students(attempt)? {
        files.insert(format!("src/{name}"), text);
    }
    let cases = fresh.join("cases.txt");
    let answers = fresh.join("answers.txt");
    let _ = fs::remove_dir_all(fresh.join("src"));
    let _ = fs::remove_file(&answers);
    folder::write(&files, &fresh)?;
    fs::write(&cases, questions(sheet)).map_err(|error| folder::failed("write", &cases, error))?;

    let cargo = std::env::var_os("CARGO").unwrap_or("cargo".into());
    let mut build = Command::new(cargo);
    build.args(["build", "--quiet", "--target-dir", "target"]).current_dir(&fresh);
    // what cargo says of this workbench is not said of the attempt
    build.env_remove("CARGO_MANIFEST_DIR").env_remove("CARGO_TARGET_DIR");
    let built = build.status().map_err(|error| Error::Failed(format!("cannot run cargo: {error}")))?;
    if !built.success() {
        return Ok(None);
    }
    let program = fresh.join("target/debug").join(&exercise.manifest.chapter);
    let program = program.canonicalize().map_err(|error| folder::failed("find", &program, error))?;
    let null = || Stdio::null();
    let mut child = Command::new(&program)
        .args(["--probe", "cases.txt", "answers.txt"])
        .current_dir(&fresh)
        .stdin(null())
        .stdout(null())
        .stderr(null())
        .spawn()
        .map_err(|error| folder::failed("run", &program, error))?;
    let ended = child.wait_timeout(PATIENCE).map_err(|error| folder::failed("wait for", &program, error))?;
    if ended.is_none() {
        let _ = child.kill();
        let _ = child.wait();
    }
    let text = if answers.exists() { folder::text(&answers)? } else { String::new() };
    let ending = match ended {
        None => format!("it was stopped after {} seconds", PATIENCE.as_secs()),
        Some(status) if !status.success() => format!("it ended with {status}"),
        Some(_) => "it did not answer".to_string(),
    };
    Ok(Some(whole(&text, sheet, &ending)))
}

/// The cases of a sheet without what is expected of them.
pub(crate) fn questions(sheet: &Sheet) -> String {
    let mut sheet = sheet.clone();
    sheet.rows.iter_mut().for_each(|row| row.steps = Default::default());
    sheet.to_text()
}

/// The answers in a text, a row that has none being broken by `ending`.
pub(crate) fn whole(text: &str, sheet: &Sheet, ending: &str) -> Vec<Answer> {
    let answers = Answer::all_from_text(text, sheet.rows.len());
    let broken = |answer: Option<Answer>| {
        answer.unwrap_or_else(|| Answer {
            steps: Default::default(),
            broken: Some(exercise::Broken { message: ending.to_string(), place: String::new() }),
        })
    };
    answers.into_iter().map(broken).collect()
}

fn say(
    exercise: &Exercise,
    sheet: &Sheet,
    answers: &[Answer],
    verdict: &Verdict,
    output: &mut dyn Write,
) -> std::io::Result<()> {
    let manifest = &exercise.manifest;
    writeln!(
        output,
        "{} · {} · {} of {} points\n",
        manifest.name,
        manifest.page,
        verdict.earned,
        exercise.points()
    )?;
    let widest = sheet.properties.iter().map(|it| it.name.chars().count()).max().unwrap_or(0);
    for (property, &right) in sheet.properties.iter().zip(&verdict.right) {
        let earned = if right { property.points } else { 0 };
        writeln!(output, "  {:widest$}  {earned} of {}", property.name, property.points)?;
    }
    writeln!(output)?;
    match &verdict.wrong {
        Some(wrong) => say_wrong(exercise, sheet, answers, wrong, verdict, output),
        None => writeln!(output, "All of it is right."),
    }
}

fn say_wrong(
    exercise: &Exercise,
    sheet: &Sheet,
    answers: &[Answer],
    wrong: &Wrong,
    verdict: &Verdict,
    output: &mut dyn Write,
) -> std::io::Result<()> {
    writeln!(output, "The first value that is wrong:")?;
    writeln!(
        output,
        "{}",
        exercise::told(sheet, wrong, answers.get(wrong.row).unwrap_or(&Answer::default()))
    )?;
    writeln!(output, "  page      {}", exercise.manifest.page)?;
    match verdict.mistake {
        Some(known) => writeln!(output, "\nThis looks like `{}`. {}", known.name, known.says),
        None => Ok(()),
    }
}

/// Keeps what an attempt earned, for the progress; where it cannot, nothing is lost.
fn remember(attempt: &Path, earned: u32, points: u32) {
    if let Ok(mut file) = File::create(attempt.join("target/points.txt")) {
        let _ = writeln!(file, "{earned} {points}");
    }
}

/// What is solved among the hand-outs that stand beside this one.
fn progress(catalog: &Catalog, attempt: &Path, output: &mut dyn Write) -> std::io::Result<()> {
    let Ok(attempt) = attempt.canonicalize() else { return Ok(()) };
    let Some(folder) = attempt.parent() else { return Ok(()) };
    let mut best = std::collections::BTreeMap::new();
    for entry in fs::read_dir(folder)?.flatten() {
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

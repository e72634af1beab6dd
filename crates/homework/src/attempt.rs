//! What becomes of an attempt when it is built and run.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use cutter::source::Files;
use exercise::{Answer, Broken, Sheet};
use stage::Error;

use crate::limits::{MOST_ANSWERED, MOST_SAID};
use crate::process::{Patience, watch};
use crate::{Exercise, cargo, folder};

/// What became of an attempt.
#[derive(Debug)]
pub(crate) enum Outcome {
    /// It does not compile: the compiler's words.
    NotBuilt(String),
    /// It was not ready in time, or could not be put in place: why.
    Refused(String),
    /// Its answers, one a case.
    Answered(Vec<Answer>),
}

/// The cases of a sheet without what is expected of them.
pub(crate) fn questions(sheet: &Sheet) -> String {
    let mut sheet = sheet.clone();
    sheet.rows.iter_mut().for_each(|row| row.steps = Default::default());
    sheet.to_text()
}

/// The answers in what an attempt wrote, a row that has none being broken by `ending`.
pub(crate) fn whole(written: &[u8], sheet: &Sheet, ending: &str) -> Vec<Answer> {
    let answers = Answer::all_from_text(&String::from_utf8_lossy(written), sheet.rows.len());
    let broken = || Some(Broken { message: ending.to_string(), place: String::new() });
    let whole =
        |answer: Option<Answer>| answer.unwrap_or(Answer { steps: Default::default(), broken: broken() });
    answers.into_iter().map(whole).collect()
}

/// How a program ended that did not answer everything, the status being the shell's: 128 and the signal's
/// number.
pub(crate) fn ending(status: Option<i32>, wall: Duration) -> String {
    match status {
        None => format!("it was stopped after {} seconds (a loop without end?)", wall.as_secs()),
        Some(0) => "it ended before it answered".to_string(),
        Some(134) => "it was aborted (no memory left, or a recursion without end?)".to_string(),
        Some(137) => "it was killed".to_string(),
        Some(139) => "it crashed (SIGSEGV)".to_string(),
        Some(153) => "it wrote too much".to_string(),
        Some(status) => format!("it ended with status {status}"),
    }
}

/// Building takes this long at most: the first time there is much to fetch and to compile.
const BUILDING: Duration = Duration::from_secs(900);
/// Longer than this no attempt runs.
const RUNNING: Duration = Duration::from_secs(10);

/// Builds and runs an attempt in a folder, with nothing between it and the machine. `files` are the hand-out
/// with the student's files in it.
pub(crate) fn in_the_open(
    fresh: &Path,
    files: &Files,
    exercise: &Exercise,
    sheet: &Sheet,
    colors: bool,
) -> Result<Outcome, Error> {
    let (cases, answers) = (fresh.join("cases.txt"), fresh.join("answers.txt"));
    let _ = fs::remove_dir_all(fresh.join("src"));
    let _ = fs::remove_file(&answers);
    folder::write(files, fresh)?;
    fs::write(&cases, questions(sheet)).map_err(|error| folder::failed("write", &cases, error))?;

    let mut build = cargo::cargo(fresh, "build");
    build.args(["--quiet", "--target-dir", "target", "--color", if colors { "always" } else { "never" }]);
    let patience = Patience { wall: BUILDING, stdout: 0, stderr: MOST_SAID, too_much: &|| false };
    let built = watch(&mut build, &patience).map_err(cargo::missing)?;
    if built.status.is_none() {
        return Ok(Outcome::Refused(format!("compiling was stopped after {} seconds", BUILDING.as_secs())));
    }
    if !built.well() {
        return Ok(Outcome::NotBuilt(String::from_utf8_lossy(&built.stderr).trim_end().to_string()));
    }

    let program = fresh.join("target/debug").join(&exercise.manifest.chapter);
    let program = program.canonicalize().map_err(|error| folder::failed("find", &program, error))?;
    let mut command = Command::new(&program);
    command.args(["--probe", "cases.txt", "answers.txt"]).current_dir(fresh);
    let too_much = || fs::metadata(&answers).is_ok_and(|it| it.len() > MOST_ANSWERED);
    let patience = Patience { wall: RUNNING, stdout: 0, stderr: 0, too_much: &too_much };
    let ended = watch(&mut command, &patience).map_err(|error| folder::failed("run", &program, error))?;
    let ending = match ended.status {
        None if too_much() => "it was stopped, for it wrote too much".to_string(),
        status => ending(status.map(shell_status), RUNNING),
    };
    let written = folder::first(&answers, MOST_ANSWERED).unwrap_or_default();
    Ok(Outcome::Answered(whole(&written, sheet, &ending)))
}

/// A status as a shell has it: 128 and the number of the signal that ended it.
fn shell_status(status: std::process::ExitStatus) -> i32 {
    #[cfg(unix)]
    {
        use std::os::unix::process::ExitStatusExt;
        status.code().or(status.signal().map(|signal| 128 + signal)).unwrap_or(1)
    }
    #[cfg(not(unix))]
    {
        status.code().unwrap_or(1)
    }
}

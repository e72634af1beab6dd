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

/// The answers in what an attempt wrote: the first row that has none is broken by `ending`, and to the rows
/// after it the program never came.
pub(crate) fn whole(written: &[u8], sheet: &Sheet, ending: &str) -> Vec<Answer> {
    let answers = Answer::all_from_text(&String::from_utf8_lossy(written), sheet.rows.len());
    let mut why = ending;
    let mut missing = || {
        let message = std::mem::replace(&mut why, "the program had ended in a case before this one");
        let broken = Broken { message: message.to_string(), place: String::new() };
        Answer { steps: Default::default(), broken: Some(broken) }
    };
    answers.into_iter().map(|answer| answer.unwrap_or_else(&mut missing)).collect()
}

/// How a program ended that did not answer everything, the status being the shell's: 128 and the signal's
/// number. `wall` is how long it could take, `cpu` how long it could compute, where that was limited.
pub(crate) fn ending(status: Option<i32>, wall: Duration, cpu: Option<Duration>) -> String {
    let slow = "a loop without end, or code that is much too slow";
    let (wall, cpu) = (wall.as_secs(), cpu.unwrap_or(wall).as_secs());
    match status {
        None => format!("the program was stopped after {wall} seconds, which is the limit: {slow}"),
        Some(SIGXCPU) => {
            format!(
                "the program was stopped when it had computed for {cpu} seconds, which is the limit: {slow}"
            )
        }
        Some(0) => "the program ended before it answered".to_string(),
        Some(134) => "the program was aborted: no memory left, or a recursion without end".to_string(),
        Some(137) => "the program was killed".to_string(),
        Some(139) => "the program crashed (SIGSEGV)".to_string(),
        Some(153) => "the program was stopped, for it wrote too much".to_string(),
        Some(status) => format!("the program ended with status {status} before it answered"),
    }
}

/// What a shell says of a program whose time of a processor is over.
const SIGXCPU: i32 = 128 + 24;

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
    build.args(["--quiet", "--color", if colors { "always" } else { "never" }]);
    build.arg("--target-dir").arg(cargo::whole(&fresh.join("target")));
    let patience = Patience { wall: BUILDING, stdout: 0, stderr: MOST_SAID, too_much: &|| false };
    let built = watch(&mut build, &patience).map_err(cargo::missing)?;
    if built.status.is_none() {
        return Ok(Outcome::Refused(format!("compiling was stopped after {} seconds", BUILDING.as_secs())));
    }
    if !built.well() {
        return Ok(Outcome::NotBuilt(String::from_utf8_lossy(&built.stderr).trim_end().to_string()));
    }

    let program = fresh.join("target/debug").join(&exercise.manifest.chapter);
    let program = program.canonicalize().map_err(|_| {
        let remedy = "your own cargo configuration puts it elsewhere: leave build.target out there";
        Error::Failed(format!("cannot find {}; {remedy}", program.display()))
    })?;
    let mut command = Command::new(&program);
    command.args(["--probe", "cases.txt", "answers.txt"]).current_dir(fresh);
    let too_much = || fs::metadata(&answers).is_ok_and(|it| it.len() > MOST_ANSWERED);
    let patience = Patience { wall: RUNNING, stdout: 0, stderr: 0, too_much: &too_much };
    let ended = watch(&mut command, &patience).map_err(|error| folder::failed("run", &program, error))?;
    let ending = match ended.status {
        None if too_much() => ending(Some(153), RUNNING, None),
        status => ending(status.map(shell_status), RUNNING, None),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_end_is_told_of_the_case_it_came_in_and_of_no_other() {
        let text = "exercise\ta/b\ncolumns\tx\nproperty\tany\t1\ncase\t1\ncase\t2\ncase\t3\n";
        let sheet = Sheet::from_text(text).unwrap();
        let answers = whole(b"case\t0\n", &sheet, "it crashed");
        let broken: Vec<&str> =
            answers.iter().map(|it| it.broken.as_ref().map_or("", |it| it.message.as_str())).collect();
        assert_eq!(broken, ["", "it crashed", "the program had ended in a case before this one"]);
    }

    #[test]
    fn a_limit_on_time_is_named_with_both_causes() {
        let (wall, cpu) = (Duration::from_secs(20), Some(Duration::from_secs(5)));
        for (status, limit) in [(None, "after 20 seconds"), (Some(SIGXCPU), "computed for 5 seconds")] {
            let said = ending(status, wall, cpu);
            assert!(said.contains(limit) && said.contains("loop") && said.contains("too slow"), "{said}");
        }
    }
}

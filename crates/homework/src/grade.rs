//! Grades a class.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use exercise::Sheet;
use stage::{Error, Progress, Scratch};

use crate::attempt::{Outcome, in_the_open};
use crate::bench::Bench;
use crate::report::{Report, csv, gradescope, json, text};
use crate::sandbox::Sandbox;
use crate::submission::{Submission, Taken};
use crate::{Catalog, Exercise, start};

/// What is to be graded, and how.
#[derive(Clone, Debug)]
pub struct GradeAsk {
    /// A folder each; its name is the student's.
    pub folders: Vec<PathBuf>,
    /// The exercise that was set; without it, each submission says what it is for.
    pub exercise: Option<String>,
    /// How the grades are written.
    pub format: GradeFormat,
    /// So many at a time; without it, as many as there are processors.
    pub jobs: Option<usize>,
    /// Whether submissions may do all that we can.
    pub unsandboxed: bool,
}

/// How grades are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GradeFormat {
    /// A table to read.
    Text,
    /// A list of objects.
    Json,
    /// For a spreadsheet.
    Csv,
    /// The results.json of one submission.
    Gradescope,
}

/// Grades submissions and writes the grades, in the order in which they were named, when all are there.
///
/// A folder that is no submission, one that does not compile, and one that had to be stopped have their grade
/// as well. [`Error::Failed`] where there is no sandbox, or a hand-out cannot be built.
pub fn grade(ask: &GradeAsk, output: &mut dyn Write) -> Result<(), Error> {
    if ask.format == GradeFormat::Gradescope && ask.folders.len() != 1 {
        let why =
            "--format gradescope is for one submission, which Gradescope puts into /autograder/submission";
        return Err(Error::Request(format!("{why}; {} folders are named", ask.folders.len())));
    }
    let catalog = Catalog::read()?;
    if let Some(name) = &ask.exercise {
        catalog.find(name)?;
    }
    let submissions: Vec<Submission> = ask.folders.iter().map(|folder| Submission::at(folder)).collect();
    let reports = reports(ask, &catalog, &submissions)?;
    let written = match ask.format {
        GradeFormat::Text => text(&reports),
        GradeFormat::Json => json(&reports),
        GradeFormat::Csv => csv(&reports),
        GradeFormat::Gradescope => reports.first().map(gradescope).unwrap_or_default(),
    };
    output.write_all(written.as_bytes()).map_err(Error::from_output)
}

/// Where attempts are built and run.
enum Place<'a> {
    Within(Bench<'a>),
    Open(&'a Scratch),
}

fn reports(ask: &GradeAsk, catalog: &Catalog, submissions: &[Submission]) -> Result<Vec<Report>, Error> {
    let scratch = Scratch::new(scratch).map_err(|error| {
        let temporary = std::env::temp_dir();
        let remedy = "name another place with TMPDIR=FOLDER";
        Error::Failed(format!("cannot make a folder in {}: {error}; {remedy}", temporary.display()))
    })?;
    let mut place = match ask.unsandboxed {
        true => Place::Open(&scratch),
        false => Place::Within(Bench::new(Sandbox::find()?, &scratch)?),
    };
    let taken: Vec<Result<(Taken, &Exercise), Error>> =
        submissions.iter().map(|it| take(it, catalog, ask.exercise.as_deref())).collect();

    // what is there before any submission is
    let mut sheets: BTreeMap<&str, Sheet> = BTreeMap::new();
    let exercises: BTreeSet<&str> = taken.iter().flatten().map(|(_, it)| it.manifest.name.as_str()).collect();
    let progress = Progress::new((exercises.len() + submissions.len()) as u64);
    for name in exercises {
        progress.starts(name.to_string());
        let exercise = catalog.find(name)?;
        sheets.insert(name, exercise.sheet());
        if let Place::Within(bench) = &mut place {
            bench.prepare(catalog, exercise)?;
        }
        progress.done();
    }

    let grade_one = |number: usize| -> Result<Report, Error> {
        let submission = &submissions[number];
        progress.starts(submission.student.clone());
        let report = match &taken[number] {
            Err(why) => {
                let asked = ask.exercise.as_deref().and_then(|name| catalog.find(name).ok());
                Report::refused(submission, asked, &why.to_string())
            }
            Ok((taken, exercise)) => {
                let sheet = sheets.get(exercise.manifest.name.as_str()).ok_or(Error::NotYet)?;
                let outcome = match &place {
                    Place::Within(bench) => bench.attempt(exercise, number, &taken.files)?,
                    Place::Open(scratch) => open(catalog, exercise, sheet, scratch, number, taken)?,
                };
                Report::of(submission, exercise, sheet, &outcome)
            }
        };
        progress.done();
        Ok(report)
    };
    let cores = thread::available_parallelism().map_or(1, |count| count.get());
    each(submissions.len(), ask.jobs.unwrap_or(cores), &grade_one)
}

/// What a submission has to say, or that it has nothing.
fn take<'a>(
    submission: &Submission,
    catalog: &'a Catalog,
    asked: Option<&str>,
) -> Result<(Taken, &'a Exercise), Error> {
    let taken = submission.take(asked)?;
    let exercise = catalog.find(&taken.exercise)?;
    Ok((taken, exercise))
}

fn open(
    catalog: &Catalog,
    exercise: &Exercise,
    sheet: &Sheet,
    scratch: &Scratch,
    number: usize,
    taken: &Taken,
) -> Result<Outcome, Error> {
    let mut files = start::hand_out(catalog, exercise)?;
    files.extend(taken.files.iter().map(|(name, text)| (format!("src/{name}"), text.clone())));
    let fresh = scratch.path().join(format!("attempt-{number}"));
    in_the_open(&fresh, &files, exercise, sheet, false)
}

/// Does something for each number, on some threads; the results in order, or the first error.
fn each<T: Send>(
    count: usize,
    threads: usize,
    one: &(impl Fn(usize) -> Result<T, Error> + Sync),
) -> Result<Vec<T>, Error> {
    let next = AtomicUsize::new(0);
    let results: Mutex<Vec<Option<Result<T, Error>>>> = Mutex::new((0..count).map(|_| None).collect());
    thread::scope(|scope| {
        for _ in 0..threads.clamp(1, count.max(1)) {
            scope.spawn(|| {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= count {
                        break;
                    }
                    let result = one(number);
                    if result.is_err() {
                        // nothing new is begun: the run has failed
                        next.store(count, Ordering::Relaxed);
                    }
                    if let Ok(mut results) = results.lock() {
                        results[number] = Some(result);
                    }
                }
            });
        }
    });
    let results = results.into_inner().unwrap_or_default();
    results.into_iter().flatten().collect()
}

/// A folder that only this user reads in, with a name that nobody else can guess.
fn scratch() -> io::Result<PathBuf> {
    Ok(tempfile::Builder::new().prefix("first-hit-").tempdir()?.keep())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_results_are_in_order_and_the_first_error_counts() {
        let squares = each(50, 4, &|number| Ok(number * number)).unwrap();
        assert_eq!(squares, (0..50).map(|number| number * number).collect::<Vec<_>>());
        let failed = each(50, 4, &|number| if number % 7 == 3 { Err(Error::NotYet) } else { Ok(number) });
        assert!(matches!(failed, Err(Error::NotYet)));
        assert!(each(0, 4, &|number| Ok(number)).unwrap().is_empty());
    }

    #[test]
    fn gradescope_is_for_one() {
        let ask = GradeAsk {
            folders: vec!["a".into(), "b".into()],
            exercise: None,
            format: GradeFormat::Gradescope,
            jobs: None,
            unsandboxed: false,
        };
        let error = grade(&ask, &mut Vec::new()).unwrap_err();
        assert_eq!(error.status(), 2);
        assert!(error.to_string().contains("2 folders"), "{error}");
    }
}

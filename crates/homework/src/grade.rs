//! Grades a class.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use exercise::Sheet;
use stage::{Error, Progress, Scratch};

use crate::attempt::{Outcome, in_the_open};
use crate::bench::Bench;
use crate::report::{Report, csv, gradescope, json, one_line, text};
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
/// as well.
///
/// [`Error::Request`] where a folder is not there, where there is no submission among them or each of them
/// only holds some, where there is no such exercise, or where Gradescope's format is asked for other than
/// one folder. [`Error::Failed`] where [`Catalog::read`] fails, there is no sandbox, a hand-out cannot be
/// built, or the grades not be written; [`Error::PipeClosed`] where nobody reads them.
pub fn grade(ask: &GradeAsk, output: &mut dyn Write) -> Result<(), Error> {
    if ask.format == GradeFormat::Gradescope && ask.folders.len() != 1 {
        let why =
            "--format gradescope is for one submission, which Gradescope puts into /autograder/submission";
        return Err(Error::Request(format!("{why}; {} folders are named", ask.folders.len())));
    }
    let submissions = submissions(ask)?;
    let catalog = Catalog::read()?;
    let asked = ask.exercise.as_deref().map(|name| catalog.find(name)).transpose()?;
    let reports = reports(ask, &catalog, asked, &submissions)?;
    let written = match ask.format {
        GradeFormat::Text => text(&reports),
        GradeFormat::Json => json(&reports),
        GradeFormat::Csv => csv(&reports),
        GradeFormat::Gradescope => reports.first().map(gradescope).unwrap_or_default(),
    };
    output.write_all(written.as_bytes()).map_err(Error::from_output)
}

/// The submissions that are meant. Where a folder is not there, or all of them hold submissions in place of
/// being some, nothing is graded.
fn submissions(ask: &GradeAsk) -> Result<Vec<Submission>, Error> {
    let name = |folder: &Path| one_line(&folder.display().to_string(), 1000);
    if let Some(gone) = ask.folders.iter().find(|it| fs::symlink_metadata(it).is_err()) {
        let why = "there is no such folder; name the submissions, a folder each, as FOLDER/*";
        return Err(Error::Request(format!("{}: {why}", name(gone))));
    }
    let submissions = Submission::all(&ask.folders);
    let held: Vec<usize> = submissions.iter().map(Submission::holds).collect();
    match submissions.first() {
        None => {
            Err(Error::Request("there is no submission among what is named; name a folder each".to_string()))
        }
        // what Gradescope gets has its row, whatever it is
        Some(first) if ask.format != GradeFormat::Gradescope && held.iter().all(|&count| count > 0) => {
            let (folder, count) = (name(&first.folder), held[0]);
            let submissions = if count == 1 { "submission" } else { "submissions" };
            let why =
                format!("it is no submission, but holds {count} {submissions}; did you mean {folder}/*?");
            Err(Error::Request(format!("{folder}: {why}")))
        }
        Some(_) => Ok(submissions),
    }
}

/// Where attempts are built and run.
enum Place<'a> {
    Within(Bench<'a>),
    Open(&'a Scratch),
}

fn reports(
    ask: &GradeAsk,
    catalog: &Catalog,
    asked: Option<&Exercise>,
    submissions: &[Submission],
) -> Result<Vec<Report>, Error> {
    let scratch = Scratch::new(scratch).map_err(|error| {
        let temporary = std::env::temp_dir();
        let remedy = "name another place with TMPDIR=FOLDER";
        Error::Failed(format!("cannot make a folder in {}: {error}; {remedy}", temporary.display()))
    })?;
    let mut place = match ask.unsandboxed {
        true => Place::Open(&scratch),
        false => {
            let sandbox = Sandbox::find(&hidden(catalog, &scratch, submissions))?;
            Place::Within(Bench::new(sandbox, &scratch)?)
        }
    };
    let taken: Vec<Result<Taken, Error>> = submissions.iter().map(|it| it.take(catalog, asked)).collect();

    // what is there before any submission is
    let mut exercises: BTreeMap<&str, (&Exercise, Sheet)> = BTreeMap::new();
    for Taken { exercise, .. } in taken.iter().flatten() {
        let name = exercise.manifest.name.as_str();
        exercises.entry(name).or_insert_with(|| (*exercise, exercise.sheet()));
    }
    let progress = Progress::new((exercises.len() + submissions.len()) as u64);
    for (name, (exercise, _)) in &exercises {
        progress.starts(format!("building the hand-out of {name}"));
        if let Place::Within(bench) = &mut place {
            bench.prepare(catalog, exercise)?;
        }
        progress.done();
    }

    let grade_one = |number: usize| -> Report {
        let submission = &submissions[number];
        progress.starts(format!("grading {}", submission.student));
        let graded = taken[number].as_ref().map_err(Error::to_string).and_then(|it| {
            let (exercise, sheet) =
                exercises.get(it.exercise.manifest.name.as_str()).ok_or("it was not taken")?;
            let outcome = match &place {
                Place::Within(bench) => bench.attempt(exercise, number, &it.files),
                Place::Open(scratch) => open(catalog, exercise, sheet, scratch, number, it),
            };
            // whatever fails here fails for this one; where, has another name in each run
            let within = scratch.path().display().to_string();
            let outcome = outcome.map_err(|error| error.to_string().replace(&within, ""))?;
            Ok(Report::of(submission, exercise, sheet, &outcome))
        });
        progress.done();
        graded.unwrap_or_else(|why| Report::refused(submission, asked, &why))
    };
    let cores = thread::available_parallelism().map_or(1, |count| count.get());
    Ok(each(submissions.len(), ask.jobs.unwrap_or(cores), &grade_one))
}

/// What no submission may see, wherever it lies: our checkout, cargo's passwords, our home, what others
/// handed in, and what is made of it.
fn hidden(catalog: &Catalog, scratch: &Scratch, submissions: &[Submission]) -> Vec<PathBuf> {
    let of_the_environment =
        ["CARGO_HOME", "HOME"].into_iter().filter_map(std::env::var_os).map(PathBuf::from);
    let ours = [catalog.source.root(), scratch.path()].map(Path::to_path_buf);
    let theirs = submissions.iter().map(|it| it.folder.clone());
    of_the_environment.chain(ours).chain(theirs).collect()
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

/// Does something for each number, on some threads; the results in order. Where a thread cannot be had, the others
/// do its share; this one always works.
fn each<T: Send>(count: usize, threads: usize, one: &(impl Fn(usize) -> T + Sync)) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let results: Mutex<Vec<Option<T>>> = Mutex::new((0..count).map(|_| None).collect());
    let work = || {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= count {
                break;
            }
            let result = one(number);
            if let Ok(mut results) = results.lock() {
                results[number] = Some(result);
            }
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads.min(count) {
            let _ = thread::Builder::new().spawn_scoped(scope, work);
        }
        work();
    });
    results.into_inner().unwrap_or_default().into_iter().flatten().collect()
}

/// A folder that only this user reads in, with a name that nobody else can guess.
fn scratch() -> io::Result<PathBuf> {
    Ok(tempfile::Builder::new().prefix("first-hit-").tempdir()?.keep())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ask(folders: Vec<PathBuf>, format: GradeFormat) -> GradeAsk {
        GradeAsk { folders, exercise: None, format, jobs: None, unsandboxed: false }
    }

    #[test]
    fn the_results_are_in_order() {
        let squares = each(50, 4, &|number| number * number);
        assert_eq!(squares, (0..50).map(|number| number * number).collect::<Vec<_>>());
        assert!(each(0, 4, &|number| number).is_empty());
    }

    #[test]
    fn gradescope_is_for_one() {
        let error = grade(&ask(vec!["a".into(), "b".into()], GradeFormat::Gradescope), &mut Vec::new());
        let error = error.unwrap_err();
        assert_eq!(error.status(), 2);
        assert!(error.to_string().contains("2 folders"), "{error}");
    }

    #[test]
    fn what_is_no_submission_at_all_is_a_wrong_request() {
        let class = tempfile::tempdir().unwrap();
        let (ada, gone) = (class.path().join("ada"), class.path().join("gone"));
        fs::create_dir_all(ada.join("src")).unwrap();
        let refused = |folders: Vec<PathBuf>, why: &str| {
            let error = grade(&ask(folders, GradeFormat::Csv), &mut Vec::new()).unwrap_err();
            assert!(error.status() == 2 && error.to_string().contains(why), "{error}");
        };
        refused(vec![ada.clone(), gone], "there is no such folder");
        let mean = format!("holds 1 submission; did you mean {}/*?", class.path().display());
        fs::create_dir(class.path().join("notes")).unwrap();
        refused(vec![class.path().to_path_buf()], &mean);
        fs::create_dir(class.path().join("__MACOSX")).unwrap();
        refused(vec![class.path().join("__MACOSX")], "no submission among");
        // among others it is one row
        let both = ask(vec![class.path().to_path_buf(), ada], GradeFormat::Csv);
        assert_eq!(submissions(&both).unwrap().len(), 2);
        let one = ask(vec![class.path().to_path_buf()], GradeFormat::Gradescope);
        assert_eq!(submissions(&one).unwrap().len(), 1);
    }
}

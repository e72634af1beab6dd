//! Builds and runs attempts in the sandbox, upon what was built once.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use cutter::source::Files;
use exercise::{Answer, Sheet};
use stage::{Error, Scratch};

use crate::attempt::{Outcome, ending, questions, whole};
use crate::limits::{BASE, COMPILE, MOST_SAID, RUN};
use crate::sandbox::Sandbox;
use crate::{Catalog, Exercise, cargo, folder, start};

/// The untouched hand-outs of some exercises, built, and a sandbox to go on in.
pub(crate) struct Bench<'a> {
    sandbox: Sandbox,
    scratch: &'a Scratch,
    bases: BTreeMap<String, Base>,
    toolchain: PathBuf,
}

/// An untouched hand-out, built: its project and what was made of it, in one file.
struct Base {
    packed: PathBuf,
    cases: PathBuf,
    sheet: Sheet,
}

/// Cargo keeps to the sandbox: nothing of our home is there.
const CARGO: &str = "export CARGO_HOME=/work/.home TMPDIR=/work/tmp CARGO_INCREMENTAL=0 CARGO_PROFILE_DEV_DEBUG=0; \
                     export CARGO_TERM_COLOR=never; \
                     mkdir -p /work/tmp;";
/// What was built once cannot be unpacked: nothing that an attempt could do.
const NOT_OURS: i32 = 89;
/// The student's files do not go where they belong: a folder where there is a file, or too many of them.
const NOT_IN_PLACE: i32 = 90;
/// Cargo had something to say.
const NOT_BUILT: i32 = 91;
/// What cargo started had its time of a processor.
const TOO_SLOW: i32 = 92;
/// A signal ended what cargo started: it aborts where there is no memory left, and crashes where it calls itself without
/// end. What it says then holds addresses, which are others in each run.
const CRASHED: i32 = 93;

/// What the program prints goes nowhere; its answers go through a pipe that is the sandbox's own, as they
/// come. A process that it left behind may hold the pipe: it is not waited for.
const RUN_IT: &str = "mkfifo answers; cat answers & cat=$!; \
                      prlimit --nproc=PROCESSES -- /program --probe /cases.txt answers >/dev/null 2>&1; \
                      echo $? >&2; \
                      { sleep 1; kill $cat; } & wait $cat";

impl<'a> Bench<'a> {
    /// A bench whose files go into `scratch`.
    pub(crate) fn new(sandbox: Sandbox, scratch: &'a Scratch) -> Result<Bench<'a>, Error> {
        let toolchain = cargo::toolchain(scratch.path())?;
        Ok(Bench { sandbox, scratch, bases: BTreeMap::new(), toolchain })
    }

    /// Fetches what an exercise needs, outside, and builds its untouched hand-out, inside.
    pub(crate) fn prepare(&mut self, catalog: &Catalog, exercise: &Exercise) -> Result<(), Error> {
        let name = &exercise.manifest.name;
        let place = self.scratch.path().join("bases").join(name.replace('/', "-"));
        let project = place.join("project");
        let files = start::hand_out(catalog, exercise)?;
        self.scratch.uninterrupted(|| folder::write(&files, &project))?;
        vendor(self.scratch, &project)?;

        self.share(&place)?;
        let shown = [(self.toolchain.as_path(), "/toolchain"), (&project, "/project")];
        let script = format!(
            "{CARGO} cp -r /project/. . && cargo build --quiet --offline >&2 && rm -rf tmp && \
             tar --format=posix -c $(ls -A)"
        );
        let built = self.sandbox.run(&BASE, &shown, &script).map_err(|error| bwrap(&error))?;
        if !built.well() {
            let said = String::from_utf8_lossy(&built.stderr);
            return Err(Error::Failed(format!("cannot build the hand-out of {name}:\n{}", said.trim_end())));
        }
        let (packed, cases, sheet) = (place.join("base.tar"), place.join("cases.txt"), exercise.sheet());
        write(&packed, &built.stdout)?;
        write(&cases, questions(&sheet).as_bytes())?;
        self.share(&place)?;
        self.bases.insert(name.clone(), Base { packed, cases, sheet });
        self.try_untouched(exercise)
    }

    /// Whether the untouched hand-out answers: where it does not, no submission is to blame.
    fn try_untouched(&self, exercise: &Exercise) -> Result<(), Error> {
        let why = match self.attempt(exercise, 0, &Files::new())? {
            // it asks its questions, each at a place of its own
            Outcome::Answered(answers) => {
                let asks = |it: &Answer| it.broken.as_ref().is_none_or(|broken| !broken.place.is_empty());
                let ending = answers.iter().find(|it| !asks(it)).and_then(|it| it.broken.clone());
                let Some(broken) = ending else { return Ok(()) };
                broken.message
            }
            Outcome::NotBuilt(why) | Outcome::Refused(why) => why,
        };
        let remedy =
            "where programs may not run in the folder for temporary files, name another: TMPDIR=FOLDER";
        let name = &exercise.manifest.name;
        Err(Error::Failed(format!(
            "the untouched hand-out of {name} does not run in the sandbox: {why}\n{remedy}"
        )))
    }

    /// Builds and runs an attempt, `number` being its own, with the student's `files` of `src`.
    pub(crate) fn attempt(
        &self,
        exercise: &Exercise,
        number: usize,
        files: &Files,
    ) -> Result<Outcome, Error> {
        let name = &exercise.manifest.name;
        let base = self.bases.get(name);
        let base = base.ok_or_else(|| Error::Failed(format!("{name} was not prepared")))?;
        let place = self.scratch.path().join(format!("attempt-{number}"));
        let outcome = self.in_place(exercise, base, &place, files);
        let _ = fs::remove_dir_all(&place);
        outcome
    }

    fn in_place(
        &self,
        exercise: &Exercise,
        base: &Base,
        place: &Path,
        files: &Files,
    ) -> Result<Outcome, Error> {
        let (src, program) = (place.join("src"), place.join("program"));
        self.scratch.uninterrupted(|| {
            // even where there is no file
            fs::create_dir_all(&src).map_err(|error| folder::failed("make", &src, error))?;
            folder::write(files, &src)
        })?;
        self.share(place)?;

        let shown =
            [(self.toolchain.as_path(), "/toolchain"), (&base.packed, "/base.tar"), (&src, "/student")];
        let script = format!(
            "{CARGO} tar -x -f /base.tar || exit {NOT_OURS}; cp -r /student/. src/ || exit {NOT_IN_PLACE}; \
             cargo build --quiet --offline --jobs 1 2>tmp/said || {{ \
             tail -c 9999 tmp/said | grep -q \"signal: 24\" && exit {TOO_SLOW}; \
             tail -c 9999 tmp/said | grep -q \"^  process didn't exit successfully: .*(signal: \" && exit {CRASHED}; \
             head -c {MOST_SAID} tmp/said >&2; exit {NOT_BUILT}; }}; cat target/debug/{}",
            exercise.manifest.chapter
        );
        let built = self.sandbox.run(&COMPILE, &shown, &script).map_err(|error| bwrap(&error))?;
        let said = || String::from_utf8_lossy(&built.stderr).trim_end().to_string();
        match built.status.map(|status| status.code()) {
            Some(Some(0)) => {}
            None => return Ok(stopped(format!("after {} seconds", COMPILE.wall.as_secs()))),
            // whoever wrote so much lost the reader
            _ if built.stdout.len() as u64 >= COMPILE.output => {
                let mebibytes = COMPILE.output >> 20;
                return Ok(Outcome::Refused(format!("its program has more than {mebibytes} MiB")));
            }
            Some(Some(TOO_SLOW)) => {
                let seconds = COMPILE.cpu.as_secs();
                return Ok(stopped(format!("when it had taken {seconds} seconds of a processor")));
            }
            Some(Some(CRASHED)) => {
                let mebibytes = COMPILE.memory >> 20;
                return Ok(Outcome::Refused(format!(
                    "the compiler crashed over it, as it does when it needs more than {mebibytes} MiB of memory"
                )));
            }
            Some(Some(NOT_BUILT)) => return Ok(Outcome::NotBuilt(said())),
            Some(Some(NOT_IN_PLACE)) => {
                return Ok(Outcome::Refused(format!("it cannot be put in place: {}", said())));
            }
            Some(_) => return Err(Error::Failed(format!("the sandbox does not work: {}", said()))),
        }
        write(&program, &built.stdout)?;
        executable(&program)?;
        self.share(place)?;

        let shown = [(program.as_path(), "/program"), (&base.cases, "/cases.txt")];
        let script = RUN_IT.replace("PROCESSES", &RUN.processes.to_string());
        let ran = self.sandbox.run(&RUN, &shown, &script).map_err(|error| bwrap(&error))?;
        let said = String::from_utf8_lossy(&ran.stderr);
        let status = said.lines().last().and_then(|line| line.trim().parse().ok());
        let ending = match (ran.status, status) {
            (None, _) => ending(None, RUN.wall, Some(RUN.cpu)),
            (Some(_), Some(status)) => ending(Some(status), RUN.wall, Some(RUN.cpu)),
            (Some(_), None) => "the program ended its own sandbox, or took all its processes".to_string(),
        };
        Ok(Outcome::Answered(whole(&ran.stdout, &base.sheet, &ending)))
    }

    fn share(&self, place: &Path) -> Result<(), Error> {
        self.sandbox.share(place).map_err(|error| folder::failed("share", place, error))
    }
}

/// Puts the sources of what a project needs beside it, so that nothing is fetched later: with the user's own
/// cargo, his mirrors and his passwords, which the sandbox never sees.
fn vendor(scratch: &Scratch, project: &Path) -> Result<(), Error> {
    cargo::run(cargo::cargo(project, "fetch").arg("--quiet"), "fetch what the hand-out needs")?;
    let mut vendor = cargo::cargo(project, "vendor");
    vendor.args(["--quiet", "--offline", "--respect-source-config", "--versioned-dirs"]);
    vendor.arg(cargo::whole(&project.join("vendor")));
    cargo::run(&mut vendor, "copy what the hand-out needs")?;
    let mut files = Files::new();
    files.insert(".cargo/config.toml".into(), VENDORED.into());
    scratch.uninterrupted(|| {
        fs::create_dir_all(project.join("vendor")).map_err(|error| folder::failed("make", project, error))?;
        folder::write(&files, project)
    })
}

const VENDORED: &str =
    "[source.crates-io]\nreplace-with = \"vendored\"\n\n[source.vendored]\ndirectory = \"vendor\"\n";

fn write(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    fs::write(path, bytes).map_err(|error| folder::failed("write", path, error))
}

fn executable(path: &Path) -> Result<(), Error> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = fs::Permissions::from_mode(0o755);
        fs::set_permissions(path, mode).map_err(|error| folder::failed("make executable", path, error))?;
    }
    let _ = path;
    Ok(())
}

fn stopped(when: String) -> Outcome {
    Outcome::Refused(format!("compiling it was stopped {when}, which is the limit"))
}

fn bwrap(error: &std::io::Error) -> Error {
    Error::Failed(format!("cannot run bwrap: {error}"))
}

//! Commands that write something, and what they write when nothing is in their way.

use std::path::Path;
use std::process::Command;
use std::sync::LazyLock;

use stage::Stage;
use tests::{Folder, Run, STAGES, command_in};

use crate::files::{Files, OLD};

/// Every stage and the workbench in one program.
const PROGRAM: &str = env!("CARGO_BIN_EXE_any-stage");

/// What stands between a test and the command: programs that run the next one, each with its arguments.
pub(crate) type Through<'a> = &'a [&'a str];

/// A command, and what it leaves in its folder when nothing is in its way.
pub(crate) struct Writer {
    /// The name of a stage or of the workbench, and the arguments.
    pub(crate) args: Vec<String>,
    /// The files that it writes.
    pub(crate) files: Files,
}

impl Writer {
    /// Finds out in a folder of its own.
    pub(crate) fn new(args: &[&str]) -> Writer {
        let folder = Folder::new();
        let run = run(folder.path(), args);
        assert_eq!((run.status, run.errors_but_bars()), (0, String::new()), "{args:?}");
        let args = args.iter().map(ToString::to_string).collect();
        Writer { args, files: Files::in_folder(folder.path()) }
    }

    /// The arguments as they are passed on.
    pub(crate) fn args(&self) -> Vec<&str> {
        self.args.iter().map(String::as_str).collect()
    }

    /// A folder with an old file wherever the command writes one.
    pub(crate) fn folder_of_old_files(&self) -> Folder {
        let folder = Folder::new();
        self.files.put_old_ones(folder.path());
        folder
    }

    /// It could not be done, that was said in one line with this cause, and all that is there is old.
    pub(crate) fn assert_failed(&self, run: &Run, left: &Path, cause: &str) {
        let told: Vec<&str> = run.errors.lines().filter(|line| line.starts_with("error: ")).collect();
        assert!(run.status == 1 && told.len() == 1 && told[0].contains(cause), "{self:?}: {run:?}");
        assert!(self.names_a_file(told[0]), "{self:?}: {run:?}");
        let left = Files::in_folder(left);
        assert!(left.names().eq(self.files.names()), "{self:?}: {:?}", left.names().collect::<Vec<_>>());
        assert!(left.contents().all(|content| content == OLD.as_bytes()), "{self:?}");
    }

    /// Whether what is told names something that the command was to write.
    fn names_a_file(&self, told: &str) -> bool {
        let folder = |name: &str| name.split('/').next().unwrap_or_default().to_string();
        self.files.names().any(|name| told.contains(name) || told.contains(&folder(name)))
    }
}

impl std::fmt::Debug for Writer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.args.join(" "))
    }
}

/// What was said beside the lines of progress.
trait ButBars {
    /// The lines that tell of something wrong.
    fn errors_but_bars(&self) -> String;
}

impl ButBars for Run {
    fn errors_but_bars(&self) -> String {
        self.errors.lines().filter(|line| !line.starts_with("ran ")).collect()
    }
}

/// The command `NAME ARGS…` in a folder, through other programs.
pub(crate) fn command(folder: &Path, through: Through<'_>, args: &[&str]) -> Command {
    let words = [through, &[PROGRAM], args].concat();
    command_in(folder, words[0], &words[1..])
}

/// Runs `NAME ARGS…` in a folder.
pub(crate) fn run(folder: &Path, args: &[&str]) -> Run {
    Run::to_end(command(folder, &[], args))
}

/// A picture of every stage, each of some kilobytes.
pub(crate) static PICTURES: LazyLock<Vec<Writer>> = LazyLock::new(|| {
    let picture =
        |stage: &&dyn Stage| Writer::new(&[stage.about().name, "--size", "200x150", "--out", "picture.png"]);
    STAGES.iter().map(picture).collect()
});

/// What every stage draws of a measurement that takes no time.
pub(crate) static DRAWINGS: LazyLock<Vec<Writer>> = LazyLock::new(|| {
    let drawing = |stage: &&dyn Stage| {
        let about = stage.about();
        let (name, first) = (about.name, about.regimes[0].0);
        Writer::new(&[name, "trade", "--quick", "--cases", "1", "--regime", first, "--out", "measured.png"])
    };
    STAGES.iter().map(drawing).collect()
});

/// Pages to look at rays, and ids beside a picture.
pub(crate) static PAGES: LazyLock<Vec<Writer>> = LazyLock::new(|| {
    let page = |name: &str| {
        Writer::new(&[name, "--size", "24x18", "--out", "picture.png", "--inspect", "page.html"])
    };
    let ids = Writer::new(&["signature", "--size", "240x180", "--out", "picture.png", "--ids", "ids.png"]);
    vec![page("ray-sphere"), page("signature"), page("whitted"), ids]
});

/// The gallery of some stages.
pub(crate) static GALLERY: LazyLock<Writer> =
    LazyLock::new(|| Writer::new(&["workbench", "run", "pinhole", "ray-wall", "ray-plane", "--out", "."]));

/// The gallery of all stages.
pub(crate) static WHOLE_GALLERY: LazyLock<Writer> = LazyLock::new(|| Writer::new(&["workbench"]));

/// A hand-out of an exercise.
pub(crate) static HAND_OUT: LazyLock<Writer> = LazyLock::new(|| {
    Writer::new(&["workbench", "exercise", "start", "ray-sphere/closest-approach", "--into", "attempt"])
});

//! `workbench run`: every stage on the worked example of the notes.

use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use indicatif::ProgressBar;
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use stage::{About, Ask, Error, Stage, Transcript, write_picture, write_whole};

use crate::drawings;
use crate::gallery;
use crate::stages::{self, widest};

/// How many columns the line under a heading takes: as many as a section of a transcript.
const WIDTH: usize = 100;

/// What a stage left behind.
pub struct Finished {
    /// The stage.
    pub about: About,
    /// The steps of its worked example.
    pub transcript: Transcript,
    /// Where its picture is.
    pub picture: PathBuf,
    /// The picture's columns and rows.
    pub size: (u32, u32),
    /// Whether the book's page of it is there, see [`book_page`].
    pub in_book: bool,
    /// Whether its page to look at rays is there, see [`inspector_page`].
    pub inspected: bool,
}

/// Where the book has its chapter, from the folder of the pictures: where `cargo run -p book` puts it in
/// `out`.
pub fn book_page(name: &str) -> String {
    format!("book/{name}.html")
}

/// Where the gallery looks for a page that `--inspect` wrote, from the folder of the pictures.
pub fn inspector_page(name: &str) -> String {
    format!("{name}-inspect.html")
}

/// Where the drawing of its full `trade` goes, from the folder of the pictures; what `trade` itself draws is
/// not touched.
pub fn trade_drawing(name: &str) -> String {
    format!("trade/{name}.svg")
}

/// Runs the stages, writes `NAME.png` and `trade/NAME.svg` for each and `index.html` into `folder`, and
/// prints the transcripts, the pictures and the gallery's place, in the order given.
///
/// The error of a stage; [`Error::Failed`] where a thread cannot be had or a file cannot be written;
/// [`Error::PipeClosed`] where nobody reads the output. The files come first: a reader who leaves after one
/// line, as `head` does, still finds them all.
pub fn run(stages: &[&dyn Stage], folder: &Path, output: &mut dyn Write) -> Result<(), Error> {
    let finished = show_all(stages, folder)?;
    write_drawings(&finished, folder)?;
    let gallery = folder.join("index.html");
    write_whole(&gallery, |file| gallery::write(&finished, file))?;
    print(&finished, &gallery, output).map_err(Error::from_output)
}

/// Writes what `trade` drew of each stage.
fn write_drawings(finished: &[Finished], folder: &Path) -> Result<(), Error> {
    let place = folder.join("trade");
    std::fs::create_dir_all(&place).map_err(|error| {
        Error::Failed(format!("cannot make the folder {}: {error}; name another with --out", place.display()))
    })?;
    for Finished { about, .. } in finished {
        if let Some(svg) = drawings::trade_of(about.name) {
            write_whole(&folder.join(trade_drawing(about.name)), |file| file.write_all(svg.as_bytes()))?;
        }
    }
    Ok(())
}

/// Shows the stages side by side; where several fail, the error is that of the first in the list.
fn show_all(stages: &[&dyn Stage], folder: &Path) -> Result<Vec<Finished>, Error> {
    let threads = ThreadPoolBuilder::new().build().map_err(|error| {
        Error::Failed(format!("cannot start the threads: {error}; set RAYON_NUM_THREADS=1 for a single one"))
    })?;
    let progress = Progress::new(stages.len());
    let results: Vec<Result<Finished, Error>> = threads.install(|| {
        let one = |stage: &&dyn Stage| {
            let finished = show(*stage, folder);
            progress.done(stage.about().name);
            finished
        };
        // Stages differ in length, so each is handed out by itself.
        stages.par_iter().with_max_len(1).map(one).collect()
    });
    progress.bar.finish_and_clear();
    results.into_iter().collect()
}

/// How far the run is: a bar on a terminal, a plain line a stage elsewhere. Both go to standard error.
struct Progress {
    bar: ProgressBar,
    on_terminal: bool,
}

impl Progress {
    fn new(stages: usize) -> Progress {
        let on_terminal = io::stderr().is_terminal();
        let bar = if on_terminal { ProgressBar::new(stages as u64) } else { ProgressBar::hidden() };
        Progress { bar, on_terminal }
    }

    fn done(&self, name: &str) {
        self.bar.inc(1);
        if !self.on_terminal {
            // Where nobody reads them, the lines may be lost.
            let _ = writeln!(io::stderr(), "ran {name}");
        }
    }
}

fn show(stage: &dyn Stage, folder: &Path) -> Result<Finished, Error> {
    let about = stage.about();
    let shown = stage.show(&Ask::default())?;
    let picture = folder.join(about.name).with_extension("png");
    write_picture(&shown.picture, &picture)?;
    let is_there = |page: String| folder.join(page).is_file();
    let (in_book, inspected) = (is_there(book_page(about.name)), is_there(inspector_page(about.name)));
    let (transcript, size) = (shown.transcript, shown.picture.size());
    Ok(Finished { about, transcript, picture, size, in_book, inspected })
}

fn print(finished: &[Finished], gallery: &Path, output: &mut dyn Write) -> io::Result<()> {
    for Finished { about, transcript, .. } in finished {
        let line = "═".repeat(WIDTH);
        writeln!(output, "{:02} {}: {}\n{line}\n{transcript}\n", about.number, about.name, about.teaches)?;
    }
    let width = widest(finished.iter().map(|stage| stage.about.name));
    for Finished { about, picture, .. } in finished {
        writeln!(output, "{:02} {:width$}  {}", about.number, about.name, picture.display())?;
    }
    let all = stages::ALL.len();
    let part = if finished.len() < all {
        format!(", these {} of {all} stages", finished.len())
    } else {
        String::new()
    };
    writeln!(output, "   {:width$}  {}{part}", "gallery", gallery.display())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use stage::{Ask, Case, Row, Shown, TradeAsk, Traded};

    use super::*;
    use crate::stages;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("workbench-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    /// Every file is there, the summary ends the output, and the transcripts stand above it. (Whole scenes take longer, and
    /// are run like any other.)
    #[test]
    fn a_run_leaves_pictures_and_a_gallery() {
        let (folder, some) = (folder("run"), &stages::ALL[..7]);
        let mut output = Vec::new();
        run(some, &folder, &mut output).unwrap();
        let output = String::from_utf8(output).unwrap();

        let names = || some.iter().map(|stage| stage.about().name);
        let mut files: Vec<String> = names().map(|name| format!("{name}.png")).collect();
        files.push("index.html".to_string());
        let summary: Vec<&str> = output.lines().rev().take(files.len()).collect();
        for (file, line) in files.iter().zip(summary.iter().rev()) {
            assert!(folder.join(file).is_file(), "{file}");
            assert!(line.contains(&folder.join(file).display().to_string()), "{line}");
        }
        assert!(summary[0].ends_with("index.html, these 7 of 11 stages"), "{}", summary[0]);
        for name in names() {
            assert!(folder.join(trade_drawing(name)).is_file(), "{name}");
        }
        assert_eq!(fs::read_dir(&folder).unwrap().count(), files.len() + 1, "and the drawings");

        let mut rest = output.as_str();
        for stage in some {
            let transcript = stage.show(&Ask::default()).unwrap().transcript.to_string();
            rest = rest.split_once(&transcript).expect("the stages' transcripts, in order").1;
        }
        fs::remove_dir_all(folder).unwrap();
    }

    /// A stage that always fails, with its number as the cause.
    struct Failing(u32);

    impl Stage for Failing {
        fn about(&self) -> About {
            About { number: self.0, ..stages::ALL[0].about() }
        }

        fn show(&self, _: &Ask) -> Result<Shown, Error> {
            Err(Error::Failed(self.0.to_string()))
        }

        fn eval(&self, _: &Ask, _: &Case<'_>) -> Result<Row, Error> {
            Err(Error::Failed(self.0.to_string()))
        }

        fn trade(&self, _: &TradeAsk) -> Result<Traded, Error> {
            Err(Error::Failed(self.0.to_string()))
        }
    }

    #[test]
    fn the_first_failure_is_the_one_that_is_told() {
        let folder = folder("failing");
        let mut output = Vec::new();
        let error = run(&[&Failing(1), &Failing(2), &Failing(3)], &folder, &mut output).unwrap_err();
        assert_eq!((error.to_string().as_str(), error.status()), ("1", 1));
        assert!(output.is_empty());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0, "no gallery of half a run");
        fs::remove_dir_all(folder).unwrap();
    }
}

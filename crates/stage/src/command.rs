//! The verbs of a stage: what each does with what was asked, and the exit status. The flags are in `flags.rs`.

use std::ffi::OsString;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::ArgMatches;
use clap::parser::ValueSource;

use crate::eval::eval;
use crate::flags::{TRADE_PLOT, TRADE_SEED, command};
use crate::json::Report;
use crate::trade::{TradeFormat, place_beside};
use crate::whole_file::try_at;
use crate::{About, Ask, Error, Flag, Precision, Shown, Stage, TradeAsk, try_beside, write_picture};

/// The whole program of a stage: reads the command line, does it, and says how it ended.
pub fn main(stage: &dyn Stage) -> ExitCode {
    main_from(stage, std::env::args_os())
}

/// [`main`] for a command line that is given; its first word is the program's name.
pub fn main_from(stage: &dyn Stage, args: impl IntoIterator<Item = OsString>) -> ExitCode {
    match command(&stage.about()).try_get_matches_from(args) {
        Ok(matches) => finish(serve(stage, &matches, &mut BufWriter::new(io::stdout().lock()))),
        Err(usage) => refuse(&usage),
    }
}

/// Prints clap's message, a usage error or the help that was asked for, and gives its exit status.
pub fn refuse(usage: &clap::Error) -> ExitCode {
    let printed = usage.print();
    match usage.exit_code() {
        0 => finish(printed.map_err(Error::from_output)),
        code => ExitCode::from(code as u8),
    }
}

/// Turns a result into an exit status and, where it failed, one line of cause on standard error.
pub fn finish(result: Result<(), Error>) -> ExitCode {
    let Err(error) = result else {
        return ExitCode::SUCCESS;
    };
    if error.status() != 0 {
        // Standard error may be closed as well; then there is nobody to tell.
        let _ = writeln!(io::stderr(), "error: {error}");
    }
    ExitCode::from(error.status())
}

fn serve(stage: &dyn Stage, matches: &ArgMatches, output: &mut dyn Write) -> Result<(), Error> {
    let about = stage.about();
    let ask = ask(&about, matches);
    let format = matches.get_one::<String>("format").map_or("text", String::as_str);
    let done = match matches.subcommand() {
        Some(("trade", matches)) => trade(stage, matches, &ask, output),
        _ if format == "csv" => {
            let eval = if about.inputs.is_empty() { "" } else { ", and eval prints CSV in any case" };
            Err(Error::Request(format!("--format csv is for trade; show prints text or json{eval}")))
        }
        Some(("eval", matches)) => {
            eval(stage, &ask, matches.get_one::<PathBuf>("cases").map(PathBuf::as_path), output)
        }
        _ => {
            let out = matches.get_one::<PathBuf>("out");
            let ids = own_file(&about, matches, Flag::Ids);
            show(stage, &ask, out, ids.as_deref(), format == "json", output)
        }
    };
    // What was answered before an error is still worth having.
    let flushed = output.flush().map_err(Error::from_output);
    done.and(flushed)
}

fn show(
    stage: &dyn Stage,
    ask: &Ask,
    out: Option<&PathBuf>,
    ids: Option<&Path>,
    json: bool,
    output: &mut dyn Write,
) -> Result<(), Error> {
    let shown = stage.show(ask)?;
    if let (Some(_), Some(seen)) = (ids, &shown.ids)
        && seen.nameless > 0
    {
        return Err(Error::Request(format!(
            "--ids: {} pixels see an object that has no id, as ids end at 65535; write fewer objects",
            seen.nameless
        )));
    }
    let path = picture_path(stage, out)?;
    if let Some(ids) = ids {
        if same_file(ids, &path) {
            let place = path.display();
            return Err(Error::Request(format!("--ids and the picture are both {place}; name two files")));
        }
        // Both or neither: no picture where its ids cannot be kept.
        try_at(ids)?;
    }
    write_picture(&shown.picture, &path)?;
    let mut said = report(&shown, &path, json);
    if let (Some(path), Some(ids)) = (ids, &shown.ids) {
        ids.write(path)?;
        if !json {
            said += &format!("ids: {}\n", path.display());
        }
    }
    output.write_all(said.as_bytes()).map_err(Error::from_output)
}

/// Whether two names are of one file, be it there or not.
fn same_file(a: &Path, b: &Path) -> bool {
    let whole = |path: &Path| {
        let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        let inside = || Some(folder.canonicalize().ok()?.join(path.file_name()?));
        path.canonicalize().ok().or_else(inside).unwrap_or_else(|| path.to_path_buf())
    };
    whole(a) == whole(b)
}

/// Where the picture goes: as asked, else `out/NAME.png`, whose folder is made.
fn picture_path(stage: &dyn Stage, out: Option<&PathBuf>) -> Result<PathBuf, Error> {
    if let Some(path) = out {
        return Ok(path.clone());
    }
    let folder = Path::new("out");
    std::fs::create_dir_all(folder).map_err(|error| {
        Error::Failed(format!("cannot make the folder out: {error}; name a file with --out"))
    })?;
    Ok(folder.join(stage.about().name).with_extension("png"))
}

fn trade(stage: &dyn Stage, matches: &ArgMatches, ask: &Ask, output: &mut dyn Write) -> Result<(), Error> {
    let named = |flag| matches.value_source(flag) == Some(ValueSource::CommandLine);
    let ask = TradeAsk {
        method: named("method").then_some(ask.method),
        precision: named("precision").then_some(ask.precision),
        regimes: matches.get_many("regime").into_iter().flatten().cloned().collect(),
        cases: matches.get_one("cases").copied(),
        seed: matches.get_one("seed").copied().unwrap_or(TRADE_SEED),
        quick: matches.get_flag("quick"),
        scene: ask.scene.clone(),
    };
    let format = match matches.get_one::<String>("format").map(String::as_str) {
        Some("json") => TradeFormat::Json,
        Some("csv") => TradeFormat::Csv,
        _ => TradeFormat::Text,
    };
    if ask.scene.is_some() && !ask.regimes.is_empty() {
        return Err(Error::Request(
            "--regime names scenes of the chapter; leave it out, or leave out --scene".to_string(),
        ));
    }
    // A wrong request leaves no folder behind, and what takes a minute is not begun where its drawings
    // cannot be kept.
    known(&ask.regimes, &stage.about())?;
    let picture = picture_path(stage, matches.get_one("out"))?;
    try_beside(&place_beside(&picture, TRADE_PLOT))?;
    let traded = stage.trade(&ask)?;

    // The numbers first: whatever becomes of the drawings, they are not measured in vain.
    let mut print = |text: &str| {
        output.write_all(text.as_bytes()).and_then(|()| output.flush()).map_err(Error::from_output)
    };
    let mut printed = print(&traded.report(format));
    let mut drawn = Ok(());
    for place in traded.write_drawings(&picture) {
        match place {
            Ok(place) if format == TradeFormat::Text => {
                printed = printed.and_then(|()| print(&format!("drawing: {}\n", place.display())));
            }
            Ok(_) => {}
            Err(error) => drawn = drawn.and(Err(error)),
        }
    }
    // A reader that went away is no failure, a drawing that is missing is one.
    if matches!(printed, Err(Error::PipeClosed)) { drawn.and(printed) } else { printed.and(drawn) }
}

/// Whether the stage has the regimes that are asked for.
fn known(regimes: &[String], about: &About) -> Result<(), Error> {
    let names: Vec<&str> = about.regimes.iter().map(|(name, _)| *name).collect();
    match regimes.iter().find(|regime| !names.contains(&regime.as_str())) {
        None => Ok(()),
        Some(unknown) => {
            Err(Error::Request(format!("there is no regime `{unknown}`; there are {}", names.join(", "))))
        }
    }
}

/// What `show` prints: the transcript and where the picture went, as text or as one JSON object.
pub fn report(shown: &Shown, picture: &Path, json: bool) -> String {
    let transcript = &shown.transcript;
    if json {
        let report = Report { transcript, picture };
        let text = serde_json::to_string_pretty(&report).expect("a transcript has only string keys");
        text + "\n"
    } else {
        format!("{transcript}\npicture: {}\n", picture.display())
    }
}

fn ask(about: &About, matches: &ArgMatches) -> Ask {
    let name = |flag| matches.get_one::<String>(flag).map(String::as_str);
    let method = about.methods.iter().position(|method| Some(*method) == name("method")).unwrap_or(0);
    let precision = if name("precision") == Some("f32") { Precision::F32 } else { Precision::F64 };
    Ask {
        method,
        precision,
        size: matches.get_one("size").copied(),
        pixel: matches.get_one("pixel").copied(),
        scene: own_file(about, matches, Flag::Scene),
    }
}

/// The file that a flag names which not every stage has.
fn own_file(about: &About, matches: &ArgMatches, flag: Flag) -> Option<PathBuf> {
    let has = about.flags.contains(&flag);
    if has { matches.get_one(flag.name()).cloned() } else { None }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::*;
    use crate::{Case, Drawing, Row, Sheet, Shown, Traded};

    /// A stage that remembers what it was asked to measure.
    #[derive(Default)]
    struct Fake {
        asked: Mutex<Option<TradeAsk>>,
    }

    impl Fake {
        /// Answers a command line: what is printed, how it ends, and what was asked.
        fn answer(&self, words: &[&str]) -> (String, Result<(), Error>, Option<TradeAsk>) {
            let mut output = Vec::new();
            let done = self.answer_on(words, &mut output);
            (String::from_utf8(output).unwrap(), done, self.asked.lock().unwrap().take())
        }

        fn answer_on(&self, words: &[&str], output: &mut dyn Write) -> Result<(), Error> {
            let words = ["fake"].iter().chain(words);
            serve(self, &command(&self.about()).try_get_matches_from(words).unwrap(), output)
        }
    }

    impl Stage for Fake {
        fn about(&self) -> About {
            About {
                number: 1,
                name: "fake",
                teaches: "",
                notes: "",
                methods: vec!["notes", "robust"],
                size: (2, 2),
                picture: "",
                inputs: &["x"],
                flags: &[],
                words: &[],
                results: &[],
                trade: "",
                regimes: vec![("ordinary", "as usual"), ("far", "far away")],
            }
        }

        fn show(&self, _: &Ask) -> Result<Shown, Error> {
            panic!("nobody asks for a picture")
        }

        fn eval(&self, _: &Ask, _: &Case<'_>) -> Result<Row, Error> {
            panic!("nobody asks about a case")
        }

        fn trade(&self, ask: &TradeAsk) -> Result<Traded, Error> {
            *self.asked.lock().unwrap() = Some(ask.clone());
            let drawing = |ending| Drawing { ending, sheet: Sheet::Svg("<svg/>".to_string()) };
            let drawings = ["trade.svg", "map.svg"].map(drawing).to_vec();
            Ok(Traded { text: "the numbers\n".to_string(), records: Vec::new(), drawings })
        }
    }

    /// An empty folder, and the picture in it that `--out` names.
    fn folder(name: &str) -> (PathBuf, String) {
        let folder = std::env::temp_dir().join(format!("stage-command-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let picture = folder.join("picture.png").display().to_string();
        (folder, picture)
    }

    #[test]
    fn the_command_line_is_well_formed() {
        command(&Fake::default().about()).debug_assert();
    }

    #[test]
    fn what_trade_is_not_told_is_all() {
        let (folder, out) = folder("all");
        let (_, done, asked) = Fake::default().answer(&["trade", "--out", &out]);
        done.unwrap();
        let all = TradeAsk {
            method: None,
            precision: None,
            regimes: Vec::new(),
            cases: None,
            seed: TRADE_SEED,
            quick: false,
            scene: None,
        };
        assert_eq!(asked, Some(all));
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn flags_of_trade_stand_before_or_after_the_verb() {
        let (folder, out) = folder("flags");
        let fake = Fake::default();
        let flags = ["--method", "notes", "--precision", "f64", "--format", "json", "--out", &out];
        let [before, after] = [[&flags[..], &["trade"]], [&["trade"], &flags[..]]].map(|words| {
            let (said, done, asked) = fake.answer(&words.concat());
            done.unwrap();
            (said, asked.unwrap())
        });
        assert_eq!(before, after);
        let (said, asked) = before;
        assert_eq!((asked.method, asked.precision), (Some(0), Some(Precision::F64)), "the defaults of show");
        assert_eq!(said, "[]\n");
        let (said, ..) = fake.answer(&["--format", "csv", "trade", "--out", &out]);
        assert_eq!(said, "");
        let (.., asked) = fake.answer(&["--method", "notes", "trade", "--method", "robust", "--out", &out]);
        assert_eq!(asked.unwrap().method, Some(1), "the later one counts");
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn csv_is_for_trade() {
        for words in [&["--format", "csv"][..], &["--format", "csv", "show"], &["eval", "--format", "csv"]] {
            let (said, done, _) = Fake::default().answer(words);
            assert_eq!((said.as_str(), done.unwrap_err().status()), ("", 2));
        }
    }

    #[test]
    fn nothing_is_measured_for_a_wrong_request_or_a_folder_that_is_not_there() {
        let (folder, _) = folder("refused");
        let missing = folder.join("missing/picture.png").display().to_string();
        for (regime, status, cause) in [
            ("nowhere", 2, "there is no regime `nowhere`; there are ordinary, far"),
            ("far", 1, "there is no folder "),
        ] {
            let words = ["trade", "--regime", "ordinary", "--regime", regime, "--out", &missing];
            let (said, done, asked) = Fake::default().answer(&words);
            let error = done.unwrap_err();
            assert_eq!((said.as_str(), error.status(), asked), ("", status, None));
            assert!(error.to_string().contains(cause), "{error}");
        }
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_drawing_that_fails_costs_neither_the_numbers_nor_the_other_drawing() {
        let (folder, out) = folder("drawing");
        std::fs::create_dir(folder.join("picture-trade.svg")).unwrap();
        let (said, done, _) = Fake::default().answer(&["trade", "--out", &out]);
        let map = folder.join("picture-map.svg");
        assert_eq!(said, format!("the numbers\n\ndrawing: {}\n", map.display()));
        let error = done.unwrap_err();
        assert_eq!(error.status(), 1);
        assert!(error.to_string().contains("picture-trade.svg: it is a folder"), "{error}");
        assert!(map.is_file());
        std::fs::remove_dir_all(folder).unwrap();
    }

    /// An output that takes nothing.
    struct Refusing(io::ErrorKind);

    impl Write for Refusing {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(self.0.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn the_drawings_are_written_even_if_nobody_reads_the_numbers() {
        let (folder, out) = folder("unread");
        let answer =
            |kind| Fake::default().answer_on(&["trade", "--out", &out], &mut Refusing(kind)).unwrap_err();
        for (kind, status) in [(io::ErrorKind::BrokenPipe, 0), (io::ErrorKind::StorageFull, 1)] {
            assert_eq!(answer(kind).status(), status);
            for ending in ["trade.svg", "map.svg"] {
                std::fs::remove_file(folder.join(format!("picture-{ending}"))).unwrap();
            }
        }
        // A drawing that fails is a failure all the same.
        std::fs::create_dir(folder.join("picture-map.svg")).unwrap();
        assert_eq!(answer(io::ErrorKind::BrokenPipe).status(), 1);
        assert!(answer(io::ErrorKind::StorageFull).to_string().contains("standard output"));
        std::fs::remove_dir_all(folder).unwrap();
    }
}

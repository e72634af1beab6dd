//! The command line of a stage: its verbs, its flags, its exit status.

use std::ffi::OsString;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};

use crate::eval::eval;
use crate::json::Report;
use crate::trade::{TradeFormat, place_beside};
use crate::{About, Ask, Error, Precision, Shown, Stage, TradeAsk, try_beside, write_picture};

/// The most pixels of a picture.
const MOST_PIXELS: u64 = 1 << 28;
/// The seed of `trade` when none is given.
const TRADE_SEED: u64 = 20261123;
/// The most cases a regime.
const MOST_CASES: usize = 100_000_000;
/// The drawing of `trade` that every stage makes; its place is tried before anything is measured.
const TRADE_PLOT: &str = "trade.svg";

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

/// The request that a stage answers when nothing is said: its first method, f64, its own size, the
/// worked example.
pub fn default_ask(about: &About) -> Ask {
    Ask { method: 0, precision: Precision::F64, size: about.size, pixel: None }
}

fn serve(stage: &dyn Stage, matches: &ArgMatches, output: &mut dyn Write) -> Result<(), Error> {
    let about = stage.about();
    let ask = ask(&about, matches)?;
    let format = matches.get_one::<String>("format").map_or("text", String::as_str);
    let done = match matches.subcommand() {
        Some(("trade", matches)) => trade(stage, matches, &ask, output),
        _ if format == "csv" => Err(Error::Request(
            "--format csv is for trade; show prints text or json, and eval prints CSV in any case"
                .to_string(),
        )),
        Some(("eval", matches)) => {
            eval(stage, &ask, matches.get_one::<PathBuf>("cases").map(PathBuf::as_path), output)
        }
        _ => show(stage, &ask, matches.get_one::<PathBuf>("out"), format == "json", output),
    };
    // What was answered before an error is still worth having.
    let flushed = output.flush().map_err(Error::from_output);
    done.and(flushed)
}

fn show(
    stage: &dyn Stage,
    ask: &Ask,
    out: Option<&PathBuf>,
    json: bool,
    output: &mut dyn Write,
) -> Result<(), Error> {
    let shown = stage.show(ask)?;
    let path = picture_path(stage, out)?;
    write_picture(&shown.picture, &path)?;
    output.write_all(report(&shown, &path, json).as_bytes()).map_err(Error::from_output)
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
    };
    let format = match matches.get_one::<String>("format").map(String::as_str) {
        Some("json") => TradeFormat::Json,
        Some("csv") => TradeFormat::Csv,
        _ => TradeFormat::Text,
    };
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

fn ask(about: &About, matches: &ArgMatches) -> Result<Ask, Error> {
    let name = |flag| matches.get_one::<String>(flag).map(String::as_str);
    let method = about.methods.iter().position(|method| Some(*method) == name("method")).unwrap_or(0);
    let precision = if name("precision") == Some("f32") { Precision::F32 } else { Precision::F64 };
    let size = matches.get_one("size").copied().unwrap_or(about.size);
    let pixel = matches.get_one::<(u32, u32)>("pixel").copied();
    if let Some((col, row)) = pixel.filter(|&(col, row)| col >= size.0 || row >= size.1) {
        let ((width, height), last) = (size, (size.0 - 1, size.1 - 1));
        return Err(Error::Request(format!(
            "pixel {col},{row} lies outside the picture of {width}x{height} pixels; the last one is {},{}",
            last.0, last.1
        )));
    }
    Ok(Ask { method, precision, size, pixel })
}

fn command(about: &About) -> Command {
    let About { name, number, teaches, notes, picture, inputs, results, .. } = about;
    let show = Command::new("show")
        .about("Print the intermediate values of one ray, and write the picture (the default)")
        .after_help(format!("The picture: {picture}"));
    let eval = Command::new("eval")
        .about("Answer a case file: one result row a case")
        .after_help(format!(
            "Reads the columns   {}\nWrites the columns  {}\n--pixel, --size, --out and --format are for show",
            inputs.join(","),
            results.join(",")
        ))
        .arg(
            Arg::new("cases")
                .long("cases")
                .value_name("FILE")
                .value_parser(value_parser!(PathBuf))
                .help("A CSV file with a header row; without it, or for -, standard input"),
        );
    let trade = Command::new("trade")
        .about("Measure the methods and precisions against each other: speed beside accuracy")
        .after_help(trade_notes(about))
        .args(trade_flags(about));
    Command::new(*name)
        .bin_name(*name)
        .about(format!("{number:02} {name}: {teaches}"))
        .after_help(format!(
            "These are the options of show; {name} trade --help has those of trade\n\
             The notes: {notes}\n\
             Exit status: 0 done, 1 it could not be done, 2 the request was wrong"
        ))
        .disable_help_subcommand(true)
        .subcommands([show, trade, eval])
        .args(common_flags(about).map(|flag| flag.global(true)))
}

/// The flags of every verb, before it or after it. Their texts and defaults are those of `show`.
fn common_flags(about: &About) -> [Arg; 6] {
    let About { name, methods, size, .. } = about;
    [
        Arg::new("method")
            .long("method")
            .value_name("NAME")
            .value_parser(PossibleValuesParser::new(methods.clone()))
            .default_value(methods[0])
            .help("The formulation to follow"),
        Arg::new("precision")
            .long("precision")
            .value_name("PRECISION")
            .value_parser(Precision::ALL.map(Precision::name))
            .default_value("f64")
            .help("The floating-point numbers to compute in"),
        Arg::new("pixel")
            .long("pixel")
            .value_name("COL,ROW")
            .allow_hyphen_values(true)
            .value_parser(parse_pixel)
            .help("The pixel whose ray is explained, 0,0 the top left; without it, the worked example"),
        Arg::new("size")
            .long("size")
            .value_name("WIDTHxHEIGHT")
            .allow_hyphen_values(true)
            .value_parser(parse_size)
            .help(format!("The picture's size in pixels [default: {}x{}]", size.0, size.1)),
        Arg::new("out")
            .long("out")
            .value_name("FILE.png")
            .value_parser(parse_png)
            .help(format!("Where the picture goes [default: out/{name}.png]")),
        // Before the verb is read, csv may still turn out to be for `trade`.
        Arg::new("format")
            .long("format")
            .value_name("FORMAT")
            .value_parser(
                ["text", "json", "csv"].map(|format| PossibleValue::new(format).hide(format == "csv")),
            )
            .default_value("text")
            .help("How the steps are printed"),
    ]
}

/// The flags of `trade`: its own, and the common ones as they are meant there. A flag of the same name
/// takes the place of the global one.
fn trade_flags(about: &About) -> Vec<Arg> {
    let [method, precision, pixel, size, out, format] = common_flags(about);
    let all = |flag: Arg, help: &'static str| flag.default_value(None).help(help);
    vec![
        Arg::new("quick")
            .long("quick")
            .action(ArgAction::SetTrue)
            .help("Take a few seconds at most instead of up to a minute"),
        Arg::new("regime")
            .long("regime")
            .value_name("NAME")
            .action(ArgAction::Append)
            .help("Measure in this regime only; may be given several times [default: all]"),
        all(method, "Measure this method only [default: all]"),
        all(precision, "Measure at this precision only [default: both]"),
        Arg::new("cases")
            .long("cases")
            .value_name("N")
            .value_parser(parse_cases)
            .help("How many cases of each regime are judged [default: 20000; with --quick 500]"),
        Arg::new("seed")
            .long("seed")
            .value_name("N")
            .value_parser(value_parser!(u64))
            .help(format!("The seed that the cases are drawn from [default: {TRADE_SEED}]")),
        out.help(format!(
            "Names the drawings, which go beside it: FILE-{TRADE_PLOT} and so on [default: out/{}.png]",
            about.name
        )),
        format.value_parser(["text", "json", "csv"]).help("How the numbers are printed"),
        pixel.hide(true),
        size.hide(true),
    ]
}

/// What follows the flags in the help of `trade`.
fn trade_notes(about: &About) -> String {
    let About { trade, regimes, .. } = about;
    let width = regimes.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    let regimes: String = regimes.iter().map(|(name, what)| format!("\n  {name:width$}  {what}")).collect();
    format!("{trade}\n--pixel and --size are for show.\n\nRegimes:{regimes}")
}

/// Reads `COL,ROW`.
fn parse_pixel(text: &str) -> Result<(u32, u32), String> {
    let number = |text: &str| text.trim().parse::<u32>().ok();
    text.split_once(',')
        .and_then(|(col, row)| Some((number(col)?, number(row)?)))
        .ok_or_else(|| "write a column and a row from 0, such as 320,200".to_string())
}

/// Reads `WIDTHxHEIGHT`: neither 0, and at most 2^28 pixels in all.
fn parse_size(text: &str) -> Result<(u32, u32), String> {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    // A number too long for u64 is in any case too large.
    let number = |text: &str| digits(text).then(|| text.parse::<u64>().unwrap_or(u64::MAX));
    let (width, height) = text
        .split_once('x')
        .and_then(|(width, height)| Some((number(width)?, number(height)?)))
        .ok_or("write columns x rows, such as 640x400")?;
    match (u32::try_from(width), u32::try_from(height)) {
        _ if width == 0 || height == 0 => Err("a picture needs at least one column and one row".to_string()),
        (Ok(width), Ok(height)) if u64::from(width) * u64::from(height) <= MOST_PIXELS => Ok((width, height)),
        _ => Err(format!("a picture has at most {MOST_PIXELS} pixels in all")),
    }
}

/// Reads a number of cases.
fn parse_cases(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(cases) if (1..=MOST_CASES).contains(&cases) => Ok(cases),
        _ => Err(format!("write a whole number from 1 to {MOST_CASES}")),
    }
}

/// Reads a file name that ends in `.png`.
fn parse_png(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let is_png = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    if is_png { Ok(path) } else { Err("the picture is a PNG; name a file that ends in .png".to_string()) }
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
                inputs: &[],
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

    #[test]
    fn sizes_are_bounded() {
        assert_eq!(parse_size("640x400"), Ok((640, 400)));
        assert_eq!(parse_size("1x268435456"), Ok((1, 1 << 28)));
        for bad in [
            "0x0",
            "0x5",
            "100000000x100000000",
            "99999999999999999999999x1",
            "640",
            "x",
            "-1x5",
            "1x2x3",
            "+1x1",
            "éx1",
        ] {
            assert!(parse_size(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn pixels_are_column_and_row() {
        assert_eq!(parse_pixel("3,4"), Ok((3, 4)));
        for bad in ["3", "3,", ",4", "-1,0", "3;4", "3,4,5", "99999999999,0"] {
            assert!(parse_pixel(bad).is_err(), "{bad}");
        }
    }
}

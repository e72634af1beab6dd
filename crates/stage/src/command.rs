//! The command line of a stage: its verbs, its flags, its exit status.

use std::ffi::OsString;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgMatches, Command, value_parser};

use crate::eval::eval;
use crate::json::Report;
use crate::{About, Ask, Error, Precision, Shown, Stage, write_picture};

/// The most pixels of a picture.
const MOST_PIXELS: u64 = 1 << 28;

/// The whole program of a stage: reads the command line, does it, and says how it ended.
pub fn main(stage: &dyn Stage) -> ExitCode {
    main_from(stage, std::env::args_os())
}

/// [`main`] for a command line that is given; its first word is the program's name.
pub fn main_from(stage: &dyn Stage, args: impl IntoIterator<Item = OsString>) -> ExitCode {
    match command(&stage.about()).try_get_matches_from(args) {
        Ok(matches) => finish(serve(stage, &matches)),
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

fn serve(stage: &dyn Stage, matches: &ArgMatches) -> Result<(), Error> {
    let about = stage.about();
    let ask = ask(&about, matches)?;
    let mut output = BufWriter::new(io::stdout().lock());
    let done = match matches.subcommand() {
        Some(("eval", matches)) => {
            eval(stage, &ask, matches.get_one::<PathBuf>("cases").map(PathBuf::as_path), &mut output)
        }
        _ => {
            let json = matches.get_one::<String>("format").is_some_and(|format| format == "json");
            show(stage, &ask, matches.get_one::<PathBuf>("out"), json, &mut output)
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
    json: bool,
    output: &mut dyn Write,
) -> Result<(), Error> {
    let shown = stage.show(ask)?;
    let path = match out {
        Some(path) => path.clone(),
        None => {
            let folder = Path::new("out");
            std::fs::create_dir_all(folder).map_err(|error| {
                Error::Failed(format!("cannot make the folder out: {error}; name a file with --out"))
            })?;
            folder.join(stage.about().name).with_extension("png")
        }
    };
    write_picture(&shown.picture, &path)?;
    output.write_all(report(&shown, &path, json).as_bytes()).map_err(Error::from_output)
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
    let About { name, number, teaches, notes, methods, size, picture, inputs, results, .. } = about;
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
    Command::new(*name)
        .bin_name(*name)
        .about(format!("{number:02} {name}: {teaches}"))
        .after_help(format!(
            "The notes: {notes}\nExit status: 0 done, 1 it could not be done, 2 the request was wrong"
        ))
        .disable_help_subcommand(true)
        .subcommands([show, eval])
        .args(
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
                    .help(
                        "The pixel whose ray is explained, 0,0 the top left; without it, the worked example",
                    ),
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
                Arg::new("format")
                    .long("format")
                    .value_name("FORMAT")
                    .value_parser(["text", "json"])
                    .default_value("text")
                    .help("How the steps are printed"),
            ]
            .map(|arg| arg.global(true)),
        )
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

/// Reads a file name that ends in `.png`.
fn parse_png(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let is_png = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    if is_png { Ok(path) } else { Err("the picture is a PNG; name a file that ends in .png".to_string()) }
}

#[cfg(test)]
mod tests {
    use super::*;

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

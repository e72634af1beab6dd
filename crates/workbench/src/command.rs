//! The command line of the workbench.

use std::ffi::OsString;
use std::fs;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use homework::{CheckAsk, GradeAsk, GradeFormat, ListFormat};
use stage::{Error, clean_up_when_interrupted, finish, large_files_are_errors, refuse};

use crate::list::list;
use crate::run::run;
use crate::stages;

/// The whole program: reads the command line, does it, and says how it ended.
pub fn main() -> ExitCode {
    main_from(std::env::args_os())
}

/// [`main`] for a command line that is given; its first word is the program's name.
pub fn main_from(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    clean_up_when_interrupted();
    match command().try_get_matches_from(args) {
        Ok(matches) => {
            // what is built there is a student's, and ends as the system ends it
            if !matches!(matches.subcommand_name(), Some("check" | "grade")) {
                large_files_are_errors();
            }
            let mut output = BufWriter::new(io::stdout().lock());
            let done = serve(&matches, &mut output);
            let flushed = output.flush().map_err(Error::from_output);
            finish(done.and(flushed))
        }
        Err(usage) => refuse(&usage),
    }
}

/// Does what a command line, one of [`command`], asks, and writes the answer to `output`.
///
/// The error of the verb; [`Error::NotYet`] where an attempt is not right, [`Error::Request`] where a folder
/// for pictures is named for a verb that draws none.
pub fn serve(matches: &ArgMatches, output: &mut dyn Write) -> Result<(), Error> {
    draws_where(matches)?;
    match matches.subcommand() {
        Some(("list", matches)) => list(stages::ALL, json(matches), output),
        Some(("exercise", matches)) => match matches.subcommand() {
            Some(("start", matches)) => {
                let name = matches.get_one::<String>("exercise").map(String::as_str).unwrap_or_default();
                let short = name.replace('/', "-");
                let into =
                    matches.get_one::<PathBuf>("into").cloned().unwrap_or_else(|| PathBuf::from(short));
                homework::start(name, &into, output)
            }
            Some((_, matches)) => homework::list(list_format(matches), output),
            None => homework::list(ListFormat::Text, output),
        },
        Some(("check", matches)) => {
            let attempt =
                matches.get_one::<PathBuf>("attempt").cloned().unwrap_or_else(|| PathBuf::from("."));
            let ask = CheckAsk { json: json(matches), trade: matches.get_flag("trade") };
            match homework::check(&attempt, ask, output)? {
                true => Ok(()),
                false => Err(Error::NotYet),
            }
        }
        Some(("grade", matches)) => homework::grade(&grade_ask(matches), output),
        Some((_, matches)) => {
            let names = matches.get_many::<String>("stage").unwrap_or_default();
            let names: Vec<&str> = names.map(String::as_str).collect();
            run(&stages::named(&names), &folder(matches)?, output)
        }
        None => run(stages::ALL, &folder(matches)?, output),
    }
}

/// `Err` where a folder for pictures is named for a verb that draws none.
fn draws_where(matches: &ArgMatches) -> Result<(), Error> {
    let remedy = match matches.subcommand() {
        Some(("exercise", _)) => "name the folder of a hand-out with --into",
        Some(("check", _)) => "with --trade the drawing is in the attempt's own folder",
        Some(("grade" | "list", _)) => "to keep what is printed, write > FILE at the end",
        _ => return Ok(()),
    };
    let (verb, matches) = matches.subcommand().unwrap_or(("", matches));
    match matches.get_one::<PathBuf>("out") {
        Some(_) => {
            Err(Error::Request(format!("--out is for the pictures of run, and {verb} has none; {remedy}")))
        }
        None => Ok(()),
    }
}

fn list_format(matches: &ArgMatches) -> ListFormat {
    match matches.get_one::<String>("format").map(String::as_str) {
        Some("json") => ListFormat::Json,
        Some("instructor") => ListFormat::Instructor,
        _ => ListFormat::Text,
    }
}

fn grade_ask(matches: &ArgMatches) -> GradeAsk {
    GradeAsk {
        folders: matches.get_many("folders").into_iter().flatten().cloned().collect(),
        exercise: matches.get_one("exercise").cloned(),
        format: match matches.get_one::<String>("format").map(String::as_str) {
            Some("json") => GradeFormat::Json,
            Some("csv") => GradeFormat::Csv,
            Some("gradescope") => GradeFormat::Gradescope,
            _ => GradeFormat::Text,
        },
        jobs: matches.get_one::<u16>("jobs").map(|&jobs| usize::from(jobs)),
        unsandboxed: matches.get_flag("unsandboxed"),
    }
}

fn json(matches: &ArgMatches) -> bool {
    matches.get_one::<String>("format").is_some_and(|format| format == "json")
}

/// The command line: `run`, which is also what no verb means, `list`, and what a course needs.
pub fn command() -> Command {
    let run = Command::new("run")
        .about("Run stages on the worked examples of the notes (the default)")
        .after_help(
            "Prints each stage's intermediate values, and writes its picture to DIR/NAME.png and all of them \
             to the page DIR/index.html.",
        )
        .arg(
            Arg::new("stage")
                .value_name("STAGE")
                .num_args(0..)
                .value_parser(PossibleValuesParser::new(stages::names()))
                .help("The stages to run; without a name, all of them"),
        );
    let list = Command::new("list")
        .about("Say what each stage teaches, and which pages of the notes it follows")
        .arg(format("How the stages are listed"));
    let start = Command::new("start")
        .about("Write a hand-out: a project of its own, with holes to fill in")
        .arg(
            Arg::new("exercise")
                .value_name("STAGE/EXERCISE")
                .required(true)
                .help("As `exercise list` names it"),
        )
        .arg(
            Arg::new("into")
                .long("into")
                .value_name("DIR")
                .value_parser(value_parser!(PathBuf))
                .help("A new folder for it, or an empty one [default: STAGE-EXERCISE]"),
        );
    let exercise = Command::new("exercise").about("List the exercises, or hand one out").subcommands([
        Command::new("list").about("Say what exercises there are").arg(
            format("How the exercises are listed; instructor is a page for the lecturer, with the answers")
                .value_parser(["text", "json", "instructor"]),
        ),
        start,
    ]);
    Command::new("workbench")
        .bin_name("workbench")
        .about("Run every stage, print the intermediate values of each, and write each picture")
        .after_help(
            "One stage by itself, with its other verbs and methods: cargo run -p NAME -- --help\n\
             Exit status: 0 done, 1 it could not be done, 2 the request was wrong",
        )
        .disable_help_subcommand(true)
        .subcommands([run, list, exercise, check(), grade()])
        .arg(out().global(true))
}

fn check() -> Command {
    Command::new("check")
        .about("Build and run an attempt at an exercise, and say which value is wrong first")
        .after_help("Exit status: 0 all is right, 1 it is not or does not compile, 2 the request was wrong")
        .arg(
            Arg::new("attempt")
                .value_name("DIR")
                .value_parser(value_parser!(PathBuf))
                .help("The folder of the hand-out [default: .]"),
        )
        .arg(format("How the verdict is written"))
        .arg(flag("trade").help(
            "Where the exercise is a method of its chapter and is right: build the chapter with it, measure \
             it beside the other methods, and draw DIR/trade.svg",
        ))
}

fn grade() -> Command {
    Command::new("grade")
        .about("Grade a class: build and run every submission in a sandbox, side by side")
        .after_help(
            "Of a submission only its own .rs files in src/ are taken, and put into a fresh hand-out. Each \
             has 40 seconds of a processor to compile and 5 to run, 128 MiB, no network, and sees nothing \
             but the system and itself.\n\
             Exit status: 0 all were graded, whatever the grade; 1 that could not be done; 2 the request was \
             wrong",
        )
        .arg(
            Arg::new("folders")
                .value_name("DIR")
                .required(true)
                .num_args(1..)
                .value_parser(value_parser!(PathBuf))
                .help("The submissions, a folder each; its name is the student's: CLASS/*"),
        )
        .arg(
            Arg::new("exercise")
                .long("exercise")
                .value_name("STAGE/NAME")
                .help("The exercise that was set [default: each submission says which one it is for]"),
        )
        .arg(format("How the grades are written; gradescope is for one submission").value_parser([
            "text",
            "json",
            "csv",
            "gradescope",
        ]))
        .arg(
            Arg::new("jobs")
                .long("jobs")
                .value_name("N")
                .value_parser(value_parser!(u16).range(1..))
                .help("How many are graded at a time [default: one a processor]"),
        )
        .arg(flag("unsandboxed").help("Do without the sandbox: a submission can then do all that you can"))
}

fn flag(name: &'static str) -> Arg {
    Arg::new(name).long(name).action(ArgAction::SetTrue)
}

fn format(help: &'static str) -> Arg {
    Arg::new("format")
        .long("format")
        .value_name("FORMAT")
        .value_parser(["text", "json"])
        .default_value("text")
        .help(help)
}

fn out() -> Arg {
    Arg::new("out")
        .long("out")
        .value_name("DIR")
        .value_parser(value_parser!(PathBuf))
        .help("Of run alone: the folder for the pictures and the page that shows them [default: out]")
}

/// The folder to write to: the default one is made, a named one has to be there.
fn folder(matches: &ArgMatches) -> Result<PathBuf, Error> {
    let named = matches.get_one::<PathBuf>("out");
    let folder = named.cloned().unwrap_or_else(|| PathBuf::from("out"));
    let make = named.is_none() && !folder.exists();
    let made = if make { fs::create_dir_all(&folder) } else { Ok(()) };
    let cause = match made.and_then(|()| fs::metadata(&folder)) {
        Ok(found) if found.is_dir() => return Ok(folder),
        Ok(_) => "it is not a folder; name one with --out".to_string(),
        Err(error) if error.kind() == ErrorKind::NotFound => {
            "there is no such folder; create it, or name another with --out".to_string()
        }
        Err(error) => format!("{error}; name another folder with --out"),
    };
    Err(Error::Failed(format!("cannot write into {}: {cause}", folder.display())))
}

#[cfg(test)]
mod tests {
    use std::ffi::OsStr;

    use super::*;

    fn answer(arguments: &[&OsStr]) -> Result<String, Error> {
        let matches = command().try_get_matches_from(arguments).unwrap();
        let mut output = Vec::new();
        serve(&matches, &mut output)?;
        Ok(String::from_utf8(output).unwrap())
    }

    #[test]
    fn the_command_line_is_well_formed() {
        command().debug_assert();
    }

    #[test]
    fn an_unknown_stage_is_a_usage_error() {
        let error = command().try_get_matches_from(["workbench", "run", "ray-spear"]).unwrap_err();
        assert_eq!(error.exit_code(), 2);
        assert!(error.to_string().contains("ray-sphere"), "{error}");
    }

    #[test]
    fn where_nothing_is_drawn_a_folder_for_pictures_is_refused() {
        for verb in [
            &["grade", "a"][..],
            &["check", "a"],
            &["exercise", "list"],
            &["exercise", "start", "ray-wall/first-hit"],
            &["list"],
        ] {
            let before = [&["workbench", "--out", "a"][..], verb].concat();
            let after = [&["workbench"][..], verb, &["--out", "a"]].concat();
            for arguments in [before, after] {
                let arguments: Vec<&OsStr> = arguments.iter().map(AsRef::as_ref).collect();
                let error = answer(&arguments).unwrap_err();
                assert!(error.status() == 2 && error.to_string().contains("--out"), "{arguments:?}: {error}");
            }
        }
    }

    #[test]
    fn a_named_folder_has_to_be_there() {
        let missing = std::env::temp_dir().join(format!("workbench-missing-{}", std::process::id()));
        let file = std::env::current_exe().unwrap();
        for (out, cause) in [(&missing, "there is no such folder"), (&file, "it is not a folder")] {
            let error = answer(&["workbench".as_ref(), "--out".as_ref(), out.as_ref()]).unwrap_err();
            assert_eq!(error.status(), 1);
            assert!(error.to_string().contains(cause), "{error}");
            assert!(error.to_string().contains(&out.display().to_string()), "{error}");
        }
        assert!(!missing.exists());
    }
}

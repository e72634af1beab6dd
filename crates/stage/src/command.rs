//! The verbs of a stage: what each does with what was asked, and the exit status. The flags are in `flags.rs`.

use std::ffi::OsString;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::ArgMatches;
use clap::parser::ValueSource;

use crate::eval::eval;
use crate::flags::{AUTO, TRADE_PLOT, TRADE_SEED, command, for_show, own_for_show};
use crate::inspect::write_page;
use crate::json::Report;
use crate::trade::{TradeFormat, place_beside};
use crate::whole_file::try_at;
use crate::{
    About, Ask, Error, Flag, Precision, Shown, Stage, TradeAsk, clean_up_when_interrupted,
    large_files_are_errors, try_beside, write_picture,
};

mod stray;

/// The folder of all pictures that nobody names.
const OUT: &str = "out";

/// The whole program of a stage: reads the command line, does it, and says how it ended.
pub fn main(stage: &dyn Stage) -> ExitCode {
    main_from(stage, std::env::args_os())
}

/// [`main`] for a command line that is given; its first word is the program's name.
pub fn main_from(stage: &dyn Stage, args: impl IntoIterator<Item = OsString>) -> ExitCode {
    large_files_are_errors();
    clean_up_when_interrupted();
    match command(&stage.about()).try_get_matches_from(args) {
        Ok(matches) => finish(serve(stage, &matches, &mut BufWriter::new(io::stdout().lock()))),
        Err(usage) => {
            let verbs = if stage.about().inputs.is_empty() { "show or trade" } else { "show, trade or eval" };
            refuse(&stray::explained(usage, verbs))
        }
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
    if error.status() != 0 && !matches!(error, Error::NotYet) {
        // Standard error may be closed as well; then there is nobody to tell.
        let _ = writeln!(io::stderr(), "error: {error}");
    }
    ExitCode::from(error.status())
}

fn serve(stage: &dyn Stage, matches: &ArgMatches, output: &mut dyn Write) -> Result<(), Error> {
    let about = stage.about();
    let ask = asked(&about, matches);
    let format = matches.get_one::<String>("format").map_or("text", String::as_str);
    let done = match matches.subcommand() {
        Some((verb @ ("trade" | "eval"), _)) if ask.auto => {
            Err(Error::Request(format!("--precision {AUTO} is for show; {verb} takes f32 or f64")))
        }
        Some(("trade", matches)) => trade(stage, matches, &ask, output),
        _ if format == "csv" => {
            let eval = if about.inputs.is_empty() { "" } else { ", and eval prints CSV in any case" };
            Err(Error::Request(format!("--format csv is for trade; show prints text or json{eval}")))
        }
        Some(("eval", matches)) => {
            let named = |flag: &&str| matches.value_source(flag) == Some(ValueSource::CommandLine);
            if let Some(flag) = own_for_show(&about).find(named) {
                return Err(Error::Request(format!("--{flag} is for show; leave it out of eval")));
            }
            eval(stage, &ask, matches.get_one::<PathBuf>("cases").map(PathBuf::as_path), output)
        }
        _ => {
            let files = Files {
                out: matches.get_one("out").cloned(),
                ids: Flag::Ids.value(&about, matches),
                inspect: Flag::Inspect.value(&about, matches),
            };
            show(stage, &ask, &files, format == "json", output)
        }
    };
    // What was answered before an error is still worth having.
    let flushed = output.flush().map_err(Error::from_output);
    done.and(flushed)
}

/// The files of `show` that are asked for.
struct Files {
    /// The picture.
    out: Option<PathBuf>,
    /// The ids of what is seen.
    ids: Option<PathBuf>,
    /// The page to look at rays.
    inspect: Option<PathBuf>,
}

fn show(
    stage: &dyn Stage,
    ask: &Ask,
    files: &Files,
    json: bool,
    output: &mut dyn Write,
) -> Result<(), Error> {
    let Files { out, ids, inspect } = files;
    // What cannot be kept is not begun, and a wrong request leaves no folder behind.
    if out.is_some() || Path::new(OUT).exists() {
        try_at(&picture_path(stage, out.as_ref())?)?;
    }
    if let Some(page) = inspect {
        try_at(page)?;
        for (flag, other) in [("--out", out), ("--ids", ids)] {
            if other.as_ref().is_some_and(|other| same_file(page, other)) {
                let place = page.display();
                return Err(Error::Request(format!("--inspect and {flag} are both {place}; name two files")));
            }
        }
    }
    let shown = stage.show(ask)?;
    if let (Some(_), Some(seen)) = (ids, &shown.ids)
        && seen.nameless > 0
    {
        return Err(Error::Request(format!(
            "--ids: {} pixels see an object that has no id, as ids end at 65535; write fewer objects",
            seen.nameless
        )));
    }
    let path = picture_path(stage, out.as_ref())?;
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
    if let Some(page) = inspect {
        inspector(stage, ask, shown, page)?;
        if !json {
            said += &format!("inspector: {}\n", page.display());
        }
    }
    output.write_all(said.as_bytes()).map_err(Error::from_output)
}

/// Writes the page to look at rays, in the numbers that the transcript has.
fn inspector(stage: &dyn Stage, ask: &Ask, shown: Shown, page: &Path) -> Result<(), Error> {
    // the picture's memory is needed no more
    let Shown { transcript, .. } = shown;
    let chosen = Precision::ALL.into_iter().find(|precision| precision.name() == transcript.precision);
    let precision = chosen.unwrap_or(ask.precision);
    let ask = Ask { precision, auto: false, ..ask.clone() };
    stage.inspect(&ask, &mut |rays| write_page(page, &stage.about(), &transcript, rays))
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
    let folder = Path::new(OUT);
    std::fs::create_dir_all(folder).map_err(|error| {
        Error::Failed(format!("cannot make the folder {OUT}: {error}; name a file with --out"))
    })?;
    Ok(folder.join(stage.about().name).with_extension("png"))
}

fn trade(stage: &dyn Stage, matches: &ArgMatches, ask: &Ask, output: &mut dyn Write) -> Result<(), Error> {
    let named = |flag: &str| matches.value_source(flag) == Some(ValueSource::CommandLine);
    // What would change nothing is not taken without a word.
    if let Some(flag) = for_show(&stage.about()).find(|flag| named(flag)) {
        let remedy = match flag {
            "scene" => "trade measures in scenes of its own: name one with --regime",
            _ => "leave it out of trade",
        };
        return Err(Error::Request(format!("--{flag} is for show; {remedy}")));
    }
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

/// What a parsed command line of a stage asks of `show`. `matches` are those of the whole line, read as
/// `command_line` says for the same stage, and not those of a verb.
pub fn asked(about: &About, matches: &ArgMatches) -> Ask {
    let name = |flag| matches.get_one::<String>(flag).map(String::as_str);
    let method = about.methods.iter().position(|method| Some(*method) == name("method")).unwrap_or(0);
    let precision = if name("precision") == Some("f32") { Precision::F32 } else { Precision::F64 };
    Ask {
        method,
        precision,
        size: matches.get_one("size").copied(),
        pixel: matches.get_one("pixel").copied(),
        scene: Flag::Scene.value(about, matches).or(Flag::SceneOfShow.value(about, matches)),
        srgb: Flag::Srgb.is_set(about, matches),
        samples: Flag::Samples.value(about, matches),
        threads: Flag::Threads.value(about, matches),
        depth: Flag::Depth.value(about, matches),
        tolerance: Flag::Tolerance.value(about, matches),
        explain: Flag::Explain.is_set(about, matches),
        auto: name("precision") == Some(AUTO),
        why: None,
    }
}

#[cfg(test)]
mod tests;

//! The command line of a stage: its verbs, their flags, how a flag is read.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Arg, ArgAction, Command, value_parser};

use crate::{About, Precision};

mod own;

pub use own::Flag;

/// The most pixels of a picture.
const MOST_PIXELS: u64 = 1 << 28;
/// The seed of `trade` when none is given.
pub(crate) const TRADE_SEED: u64 = 20261123;
/// The most cases a regime.
const MOST_CASES: usize = 100_000_000;
/// The word for a precision that the stage chooses.
pub(crate) const AUTO: &str = "auto";
/// The drawing of `trade` that every stage makes; its place is tried before anything is measured.
pub(crate) const TRADE_PLOT: &str = "trade.svg";

/// The command line of a stage: its verbs with their flags and their help.
pub fn command(about: &About) -> Command {
    let About { name, number, teaches, notes, picture, inputs, results, .. } = about;
    let show = Command::new("show")
        .about("Print the intermediate values of one ray, and write the picture (the default)")
        .after_help(format!("The picture: {picture}"));
    let eval = Command::new("eval")
        .about("Answer a case file: one result row a case")
        .after_help(format!(
            "Reads the columns   {}\nWrites the columns  {}\n{} are for show",
            inputs.join(","),
            results.join(","),
            listed(["pixel", "size", "out", "format"].into_iter().chain(own_for_show(about)))
        ))
        .args(hidden(about))
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
        .subcommands([show, trade])
        .subcommands((!inputs.is_empty()).then_some(eval))
        .args(common_flags(about).map(|flag| flag.global(true)))
        .args(about.flags.iter().filter_map(|flag| Some(flag.arg(name)?.global(true))))
}

/// The flags of every verb, before it or after it. Their texts and defaults are those of `show`.
fn common_flags(about: &About) -> [Arg; 6] {
    let About { name, methods, .. } = about;
    let auto = about.flags.contains(&Flag::Auto);
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
            .value_parser(PossibleValuesParser::new(precisions().chain(auto.then_some(AUTO))))
            .default_value("f64")
            .help(if auto {
                "The floating-point numbers to compute in; auto: f32 where nothing visible is lost"
            } else {
                "The floating-point numbers to compute in"
            }),
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
            .help(format!("The picture's size in pixels [default: {}]", own_size(about))),
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

/// The precisions by name.
fn precisions() -> impl Iterator<Item = &'static str> {
    Precision::ALL.into_iter().map(Precision::name)
}

/// The size of a picture that nobody asks for, in words.
fn own_size(About { size, flags, .. }: &About) -> String {
    let has_scenes = flags.contains(&Flag::Scene) || flags.contains(&Flag::SceneOfShow);
    if has_scenes { "the scene's".to_string() } else { format!("{}x{}", size.0, size.1) }
}

/// The flags of `trade`: its own, and the common ones as they are meant there. A flag of the same name
/// takes the place of the global one.
fn trade_flags(about: &About) -> Vec<Arg> {
    let [method, precision, pixel, size, out, format] = common_flags(about);
    let all = |flag: Arg, help: &'static str| flag.default_value(None).help(help);
    let mut flags = vec![
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
        all(precision, "Measure at this precision only [default: both]")
            .value_parser(PossibleValuesParser::new(precisions())),
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
    ];
    flags.extend(hidden(about));
    flags
}

/// The stage's own flags of `show` where they are refused, and not listed.
fn hidden(about: &About) -> impl Iterator<Item = Arg> {
    let for_show = about.flags.iter().filter(|flag| flag.is_for_show());
    for_show.filter_map(|flag| Some(flag.arg(about.name)?.hide(true)))
}

/// The names of the flags that are for `show` and that `trade` refuses.
pub(crate) fn for_show(about: &About) -> impl Iterator<Item = &'static str> {
    ["pixel", "size"].into_iter().chain(own_for_show(about))
}

/// Those of them that not every stage has.
pub(crate) fn own_for_show(about: &About) -> impl Iterator<Item = &'static str> {
    about.flags.iter().filter(|flag| flag.is_for_show()).map(|flag| flag.name())
}

/// Some flags in a sentence.
fn listed(names: impl Iterator<Item = &'static str>) -> String {
    let mut names: Vec<String> = names.map(|name| format!("--{name}")).collect();
    let last = names.pop().unwrap_or_default();
    format!("{} and {last}", names.join(", "))
}

/// What follows the flags in the help of `trade`.
fn trade_notes(about: &About) -> String {
    let About { trade, regimes, .. } = about;
    let width = regimes.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    let regimes: String = regimes.iter().map(|(name, what)| format!("\n  {name:width$}  {what}")).collect();
    let for_show = listed(for_show(about));
    format!("{trade}\n{for_show} are for show.\n\nRegimes:{regimes}")
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

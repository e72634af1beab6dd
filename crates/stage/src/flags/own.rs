//! The flags that not every stage has: what each is, and how it is read.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::{Arg, ArgAction, ArgMatches, value_parser};

use super::parse_png;
use crate::About;
use crate::inspect::MOST_INSPECTED;

/// A flag that only some stages have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flag {
    /// `--scene FILE`: another scene than the chapter's own.
    Scene,
    /// The same where `trade` takes no scene: what it measures is known of the chapter's own only.
    SceneOfShow,
    /// `--ids FILE.png`: the ids of the objects as a picture of 16-bit grays.
    Ids,
    /// `--inspect FILE.html`: a page on which every pixel's ray can be looked at, see
    /// [`Chapter::inspect`](crate::Chapter::inspect).
    Inspect,
    /// `--srgb`: the picture is encoded by the sRGB curve.
    Srgb,
    /// `--samples N`: N × N rays a pixel.
    Samples,
    /// `--threads N`: how many threads work on the picture. (What `trade` times is on one.)
    Threads,
    /// `--depth N`: how deep the recursion goes, instead of the scene's `max_depth`.
    Depth,
    /// `--tolerance E`: by how much a pixel may differ for what is left out.
    Tolerance,
    /// `--explain`: what the scene requires.
    Explain,
    /// `--precision` takes `auto` too: the stage chooses, see
    /// [`Chapter::precision`](crate::Chapter::precision).
    Auto,
}

impl Flag {
    /// The name of the flag.
    pub fn name(self) -> &'static str {
        match self {
            Flag::Scene | Flag::SceneOfShow => "scene",
            Flag::Ids => "ids",
            Flag::Inspect => "inspect",
            Flag::Srgb => "srgb",
            Flag::Samples => "samples",
            Flag::Threads => "threads",
            Flag::Depth => "depth",
            Flag::Tolerance => "tolerance",
            Flag::Explain => "explain",
            Flag::Auto => "precision",
        }
    }

    /// Whether `trade` has no use for it.
    pub(super) fn is_for_show(self) -> bool {
        !matches!(self, Flag::Scene | Flag::Auto)
    }

    /// What the stage named `stage` adds to its command line; nothing for [`Flag::Auto`], a word of a flag
    /// that every stage has.
    pub(super) fn arg(self, stage: &str) -> Option<Arg> {
        let arg = Arg::new(self.name()).long(self.name());
        let switch = |help: &'static str| arg.clone().action(ArgAction::SetTrue).help(help);
        let number = |name, help: &'static str| {
            // so that a negative number is told what would be right
            arg.clone().value_name(name).allow_hyphen_values(true).help(help)
        };
        Some(match self {
            Flag::Scene | Flag::SceneOfShow => arg
                .value_name("FILE")
                .value_parser(value_parser!(PathBuf))
                .help(format!("A scene, in TOML or NFF [default: the scene of {stage}]")),
            Flag::Ids => arg
                .value_name("FILE.png")
                .value_parser(parse_png)
                .help("Write the ids of the objects too, in 16-bit gray; 0 where none is hit"),
            Flag::Inspect => arg.value_name("FILE.html").value_parser(parse_html).help(format!(
                "Write a page to look at every pixel's ray; without --size of at most {MOST_INSPECTED} pixels"
            )),
            Flag::Srgb => switch("Encode the picture by the sRGB curve"),
            Flag::Samples => number("N", "Trace N x N rays a pixel, N from 1 to 64 [default: 1]")
                .value_parser(|text: &str| whole(text, 1..=64)),
            Flag::Threads => {
                number("N", "How many threads work, from 1 to 1024 [default: all the machine has]")
                    .value_parser(|text: &str| whole(text, 1..=1024).map(|threads| threads as usize))
            }
            Flag::Depth => number(
                "N",
                "How deep the recursion goes, from 1 to 1000; glass may double the rays with each [default: the scene's]",
            )
            .value_parser(|text: &str| whole(text, 1..=1000)),
            Flag::Tolerance => {
                number("E", "Leave out what cannot change a channel of a pixel by more than E [default: 0]")
                    .value_parser(parse_tolerance)
            }
            Flag::Explain => switch("Say what the scene requires, and what it does not"),
            Flag::Auto => return None,
        })
    }

    /// What is given for it; `None` where nothing is, or where the stage has no such flag.
    pub(crate) fn value<T: Clone + Send + Sync + 'static>(
        self,
        about: &About,
        matches: &ArgMatches,
    ) -> Option<T> {
        let has = about.flags.contains(&self);
        if has { matches.get_one(self.name()).cloned() } else { None }
    }

    /// Whether it is given, for a flag without a value.
    pub(crate) fn is_set(self, about: &About, matches: &ArgMatches) -> bool {
        about.flags.contains(&self) && matches.get_flag(self.name())
    }
}

/// Reads a file name that ends in `.html`.
fn parse_html(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let is_html = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("html"));
    if is_html { Ok(path) } else { Err("it is a page; name a file that ends in .html".to_string()) }
}

/// Reads a whole number of a range.
fn whole(text: &str, range: RangeInclusive<u32>) -> Result<u32, String> {
    match text.parse() {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => Err(format!("write a whole number from {} to {}", range.start(), range.end())),
    }
}

/// Reads how much a pixel may differ: finite, and not negative.
fn parse_tolerance(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(tolerance) if tolerance.is_finite() && tolerance >= 0.0 => Ok(tolerance),
        _ => Err("write a finite number that is not negative, such as 0.001".to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_are_bounded() {
        assert_eq!(["1", "64"].map(|text| whole(text, 1..=64)), [Ok(1), Ok(64)]);
        for bad in ["0", "65", "-1", "1.5", "4294967297", "", "two"] {
            assert_eq!(whole(bad, 1..=64), Err("write a whole number from 1 to 64".to_string()), "{bad}");
        }
    }

    #[test]
    fn a_tolerance_is_finite_and_not_negative() {
        assert_eq!(["0", "1e-3", "2"].map(parse_tolerance), [Ok(0.0), Ok(0.001), Ok(2.0)]);
        for bad in ["-1e-9", "inf", "1e400", "nan", "", "small"] {
            assert!(parse_tolerance(bad).is_err_and(|said| said.contains("finite")), "{bad}");
        }
    }
}

//! A word on the command line that belongs to no flag.

use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, Error};

/// clap's message, with a remedy where a word stands by itself and resembles nothing that there is.
pub(super) fn explained(mut usage: Error, verbs: &str) -> Error {
    let word = [ContextKind::InvalidSubcommand, ContextKind::InvalidArg]
        .into_iter()
        .find_map(|kind| usage.get(kind));
    let is_word = matches!(word, Some(ContextValue::String(word)) if !word.starts_with('-'));
    let has_tip = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::Suggested]
        .into_iter()
        .any(|kind| usage.get(kind).is_some());
    if is_word && !has_tip {
        let tip = format!(
            "a word by itself is {verbs}; all else stands after its flag and is one word, as --pixel 170,300"
        );
        usage.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![StyledStr::from(tip)]));
    }
    usage
}

#[cfg(test)]
mod tests {
    use clap::{Arg, Command};

    use super::*;

    fn said(words: &[&str]) -> String {
        let command =
            Command::new("fake").arg(Arg::new("pixel").long("pixel")).subcommand(Command::new("eval"));
        let usage = command.try_get_matches_from([&["fake"], words].concat()).unwrap_err();
        explained(usage, "show or eval").to_string()
    }

    #[test]
    fn a_stray_word_is_told_where_it_belongs() {
        for words in [&["--pixel", "170", "300"][..], &["eval", "cases.csv"]] {
            let said = said(words);
            assert!(
                said.contains("tip: a word by itself is show or eval; all else stands after its flag"),
                "{said}"
            );
        }
    }

    #[test]
    fn what_resembles_something_keeps_its_own_tip() {
        assert!(said(&["evl"]).contains("'eval'") && !said(&["evl"]).contains("by itself"));
        for words in [&["--pixl", "1"][..], &["--pixel"], &["--help"]] {
            assert!(!said(words).contains("by itself"), "{words:?}");
        }
    }
}

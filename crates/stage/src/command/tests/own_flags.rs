use std::sync::Mutex;

use math::Real;

use super::*;
use crate::{Chapter, Chosen, Flag, Section};

/// A chapter with every flag there is, which remembers what it was asked and in which numbers. Left to choose
/// it takes f32.
#[derive(Default)]
struct Every {
    shown: Mutex<Option<(&'static str, Ask)>>,
}

const FLAGS: &[Flag] = &[
    Flag::Scene,
    Flag::Ids,
    Flag::Inspect,
    Flag::Srgb,
    Flag::Samples,
    Flag::Threads,
    Flag::Depth,
    Flag::Tolerance,
    Flag::Explain,
    Flag::Auto,
];

impl Chapter for Every {
    fn about(&self) -> About {
        About { flags: FLAGS, ..Fake::default().about() }
    }

    fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
        *self.shown.lock().unwrap() = Some((R::NAME, ask.clone()));
        Err(Error::Failed("no picture".to_string()))
    }

    fn precision(&self, _: &Ask) -> Result<Chosen, Error> {
        Ok(Chosen { precision: Precision::F32, why: Some(Section::new("why", "")) })
    }

    fn trade(&self, _: &TradeAsk) -> Result<Traded, Error> {
        Err(Error::Failed("no numbers".to_string()))
    }
}

impl Every {
    /// What it is asked to show, and in which numbers.
    fn shown(words: &[&str]) -> (&'static str, Ask) {
        let every = Every::default();
        let error = every.serve(words).unwrap_err();
        assert_eq!(error.to_string(), "no picture");
        every.shown.into_inner().unwrap().unwrap()
    }

    fn serve(&self, words: &[&str]) -> Result<(), Error> {
        let words = ["every"].iter().chain(words);
        let matches = command(&Chapter::about(self)).try_get_matches_from(words).unwrap();
        serve(self, &matches, &mut Vec::new())
    }
}

#[test]
fn the_command_line_of_every_flag_is_well_formed() {
    command(&Chapter::about(&Every::default())).debug_assert();
}

#[test]
fn nothing_is_asked_where_nothing_is_said() {
    assert_eq!(Every::shown(&[]), ("f64", Ask::default()));
}

#[test]
fn own_flags_stand_before_or_after_the_verb() {
    let flags =
        ["--srgb", "--samples", "3", "--threads", "2", "--depth", "1000", "--tolerance", "1e-3", "--explain"];
    let want = Ask {
        srgb: true,
        samples: Some(3),
        threads: Some(2),
        depth: Some(1000),
        tolerance: Some(0.001),
        explain: true,
        ..Ask::default()
    };
    assert_eq!(Every::shown(&[&flags[..], &["show"]].concat()).1, want);
    assert_eq!(Every::shown(&[&["show"], &flags[..]].concat()).1, want);
}

#[test]
fn a_wrong_value_is_told_what_would_be_right() {
    for (flag, bad, right) in [
        ("--inspect", "a.png", "ends in .html"),
        ("--samples", "65", "from 1 to 64"),
        ("--threads", "0", "from 1 to 1024"),
        ("--depth", "-1", "from 1 to 1000"),
        ("--tolerance", "-0.5", "not negative"),
    ] {
        let words = ["every", flag, bad];
        let error = command(&Chapter::about(&Every::default())).try_get_matches_from(words).unwrap_err();
        assert_eq!(error.exit_code(), 2);
        assert!(error.to_string().contains(right), "{error}");
    }
}

#[test]
fn auto_is_the_precision_that_the_chapter_chooses() {
    let (numbers, ask) = Every::shown(&["--precision", "auto"]);
    assert_eq!((numbers, ask.precision, ask.auto), ("f32", Precision::F32, true));
    assert_eq!(ask.why, Some(Section::new("why", "")), "it is told what was found");
    let (numbers, ask) = Every::shown(&["--precision", "auto", "show", "--precision", "f64"]);
    assert_eq!((numbers, ask.precision, ask.auto), ("f64", Precision::F64, false), "the later one counts");
}

#[test]
fn auto_is_for_show_and_only_where_a_chapter_can_choose() {
    for verb in ["trade", "eval"] {
        let error = Every::default().serve(&["--precision", "auto", verb]).unwrap_err();
        assert_eq!(error.status(), 2);
        assert!(error.to_string().contains("f32 or f64"), "{error}");
    }
    let every = command(&Chapter::about(&Every::default()));
    let other = command(&Fake::default().about());
    for (command, words) in
        [(every, &["", "trade", "--precision", "auto"][..]), (other, &["", "--precision", "auto"])]
    {
        assert_eq!(command.try_get_matches_from(words).unwrap_err().exit_code(), 2);
    }
}

#[test]
fn the_help_of_trade_names_what_is_for_show() {
    let help =
        |about: &About| command(about).try_get_matches_from(["", "trade", "--help"]).unwrap_err().to_string();
    let every = help(&Chapter::about(&Every::default()));
    let named = "--pixel, --size, --ids, --inspect, --srgb, --samples, --threads, --depth, --tolerance and --explain are for show.";
    assert!(every.contains(named), "{every}");
    assert!(every.contains("--scene <FILE>") && !every.contains("--samples <N>"), "{every}");
    assert!(help(&Fake::default().about()).contains("\n--pixel and --size are for show."));
}

/// What would change nothing in a measurement is refused, before the verb or after it; what trade takes is not.
#[test]
fn trade_refuses_what_is_for_show() {
    for words in [
        &["--size", "10x10"][..],
        &["--pixel", "3,3"],
        &["--ids", "ids.png"],
        &["--inspect", "a.html"],
        &["--srgb"],
        &["--samples", "2"],
        &["--threads", "2"],
        &["--depth", "3"],
        &["--tolerance", "0.1"],
        &["--explain"],
    ] {
        for words in [[words, &["trade"]].concat(), [&["trade"], words].concat()] {
            let error = Every::default().serve(&words).unwrap_err();
            assert_eq!(error.status(), 2, "{words:?}");
            let said = error.to_string();
            assert!(said.contains(" is for show; leave it out of trade"), "{words:?}: {said}");
        }
    }
}

#[test]
fn eval_refuses_the_inspector() {
    for words in [["--inspect", "a.html", "eval"], ["eval", "--inspect", "a.html"]] {
        let error = Every::default().serve(&words).unwrap_err();
        assert_eq!(
            (error.status(), error.to_string().as_str()),
            (2, "--inspect is for show; leave it out of eval")
        );
    }
}

/// What keeps the page from being written is told before the picture is asked for.
#[test]
fn a_page_needs_a_place_of_its_own() {
    let (folder, _) = folder("page");
    let [page, missing] =
        ["page.html", "missing/page.html"].map(|name| folder.join(name).display().to_string());
    // only a link can make a picture and a page one file
    std::fs::write(&page, "").unwrap();
    let linked = folder.join("linked.png").display().to_string();
    #[cfg(unix)]
    std::os::unix::fs::symlink(&page, &linked).unwrap();
    for (words, status, cause) in [
        (&["--inspect", &missing][..], 1, "there is no folder"),
        #[cfg(unix)]
        (&["--inspect", &page, "--out", &linked], 2, "--inspect and --out are both "),
        #[cfg(unix)]
        (&["--inspect", &page, "--ids", &linked], 2, "--inspect and --ids are both "),
        (&["--inspect", &page], 1, "no picture"),
    ] {
        let error = Every::default().serve(words).unwrap_err();
        assert_eq!(error.status(), status, "{error}");
        assert!(error.to_string().contains(cause), "{error}");
    }
    std::fs::remove_dir_all(folder).unwrap();
}

/// A stage whose trade takes no scene: it does not list the flag, and says what to name instead.
#[test]
fn a_trade_without_scenes_says_so() {
    struct OfShow;
    impl Chapter for OfShow {
        fn about(&self) -> About {
            About { flags: &[Flag::SceneOfShow], ..Fake::default().about() }
        }

        fn show<R: Real>(&self, ask: &Ask) -> Result<Shown, Error> {
            Err(Error::Failed(format!("{:?}", ask.scene)))
        }

        fn trade(&self, _: &TradeAsk) -> Result<Traded, Error> {
            Err(Error::Failed("measured".to_string()))
        }
    }
    let said = |words: &[&str]| {
        let words = ["of-show"].iter().chain(words);
        let matches = command(&Chapter::about(&OfShow)).try_get_matches_from(words).unwrap();
        serve(&OfShow, &matches, &mut Vec::new()).unwrap_err()
    };
    let help = command(&Chapter::about(&OfShow)).try_get_matches_from(["", "trade", "--help"]);
    let help = help.unwrap_err().to_string();
    assert!(!help.contains("--scene <FILE>") && help.contains("--size and --scene are for show"), "{help}");
    assert!(said(&["--scene", "a.toml"]).to_string().contains("a.toml"));
    for words in [&["trade", "--scene", "a.toml"][..], &["--scene", "a.toml", "trade", "--regime", "far"]] {
        let error = said(words);
        assert_eq!(error.status(), 2);
        assert!(error.to_string().contains("name one with --regime"), "{error}");
    }
}

//! The help texts.

use lab::Effort;
use stage::TradeAsk;
use tests::{Folder, STAGES, stage_named};

use crate::assert_snapshot;
use crate::process::{command, run};

#[test]
fn every_verb_explains_itself() {
    let folder = Folder::new();
    for stage in STAGES {
        let name = stage.about().name;
        let mut texts = String::new();
        let verbs = [&["--help"][..], &["show", "--help"], &["trade", "--help"], &["eval", "--help"]];
        // the last is of stages with case files only
        let verbs = &verbs[..if stage.about().inputs.is_empty() { 3 } else { 4 }];
        for args in verbs {
            let help = run(folder.path(), name, args);
            assert_eq!((help.status, help.errors.as_str()), (0, ""), "{name} {args:?}");
            texts += &format!("$ {name} {}\n{}\n", args.join(" "), help.output);
        }
        assert_snapshot(&format!("{name}.help"), &texts);
    }
    assert!(folder.names().is_empty());
}

/// What the help says of `trade` is said once more in the lab.
#[test]
fn the_help_of_trade_is_true() {
    let folder = Folder::new();
    let [all, quick] = [false, true].map(|quick| Effort::of(&TradeAsk { quick, ..quick_run() }, 1).cases);
    for stage in STAGES {
        let (help, about) =
            (run(folder.path(), stage.about().name, &["trade", "--help"]).output, stage.about());
        assert!(help.contains(&format!("[default: {all}; with --quick {quick}]")), "{help}");
        let (_, listed) = help.split_once("\nRegimes:\n").expect("a list of the regimes");
        let listed: Vec<_> = listed.lines().filter_map(|line| line.trim().split_once("  ")).collect();
        let listed: Vec<_> = listed.iter().map(|(name, what)| (*name, what.trim_start())).collect();
        assert_eq!(listed, about.regimes);

        // What the stage measures in, it says itself where it is asked for something else.
        let error =
            stage.trade(&TradeAsk { regimes: vec!["nowhere".to_string()], ..quick_run() }).unwrap_err();
        let said = run(folder.path(), about.name, &["trade", "--regime", "nowhere"]).errors;
        assert_eq!(said, format!("error: {error}\n"));
    }
    assert!(folder.names().is_empty());
}

/// The pinhole's help has its scenes in the words of its report.
#[test]
fn the_help_of_pinhole_has_the_words_of_its_report() {
    let pinhole = stage_named("pinhole").expect("the first chapter");
    let report = pinhole.trade(&quick_run()).unwrap().text;
    for (name, what) in pinhole.about().regimes {
        assert!(report.contains(&format!("\n{name}: {what} · ")), "{name}: {what}\n{report}");
    }
}

/// A quick run of everything.
fn quick_run() -> TradeAsk {
    TradeAsk {
        method: None,
        precision: None,
        regimes: Vec::new(),
        cases: None,
        seed: 1,
        quick: true,
        scene: None,
    }
}

/// Help is output like any other.
#[cfg(target_os = "linux")]
#[test]
fn help_that_does_not_fit_is_a_failure() {
    let folder = Folder::new();
    for stage in STAGES {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let output = command(folder.path(), stage.about().name, &["--help"]).stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(1));
    }
}

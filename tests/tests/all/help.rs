//! The help texts.

use tests::{Folder, STAGES};

use crate::assert_snapshot;
use crate::process::{command, run};

#[test]
fn every_verb_explains_itself() {
    let folder = Folder::new();
    for stage in STAGES {
        let name = stage.about().name;
        let mut texts = String::new();
        for args in [&["--help"][..], &["show", "--help"], &["eval", "--help"]] {
            let help = run(folder.path(), name, args);
            assert_eq!((help.status, help.errors.as_str()), (0, ""), "{name} {args:?}");
            texts += &format!("$ {name} {}\n{}\n", args.join(" "), help.output);
        }
        assert_snapshot(&format!("{name}.help"), &texts);
    }
    assert!(folder.names().is_empty());
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

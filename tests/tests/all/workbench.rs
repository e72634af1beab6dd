//! The umbrella command: its help texts, its list, and a run of the whole.

use tests::Folder;

use crate::assert_snapshot;

/// What the workbench prints.
fn answer(args: &[&str]) -> String {
    let matches = ::workbench::command().try_get_matches_from([&["workbench"], args].concat()).unwrap();
    let mut output = Vec::new();
    ::workbench::serve(&matches, &mut output).unwrap();
    String::from_utf8(output).unwrap()
}

#[test]
fn the_help_is_true() {
    let mut command = ::workbench::command();
    command.build();
    let mut said = command.render_help().to_string();
    for words in ["run", "list", "exercise", "exercise list", "exercise start", "check", "grade"] {
        let verb =
            words.split(' ').fold(&mut command, |command, name| command.find_subcommand_mut(name).unwrap());
        said.push_str(&format!("\n$ workbench {words} --help\n{}", verb.render_help()));
    }
    assert_snapshot("workbench.help", &said);
}

#[test]
fn the_list_says_what_each_stage_teaches() {
    assert_snapshot("workbench.list", &answer(&["list"]));
}

#[test]
fn a_run_of_some_stages_prints_and_writes_those() {
    let folder = Folder::new();
    let out = folder.path().to_str().unwrap();
    let said = answer(&["run", "ray-sphere", "ray-plane", "--out", out]);
    let [plane, sphere] = ["03 ray-plane: ", "04 ray-sphere: "].map(|heading| said.find(heading).unwrap());
    assert!(plane < sphere && !said.contains("01 pinhole"), "in the order of the book:\n{said}");
    assert_eq!(folder.names(), ["index.html", "ray-plane.png", "ray-sphere.png", "trade"]);
}

//! `check` on a student's own machine: what does not compile, panics, never ends, or writes without end. In
//! `.ci/full`.

use std::fs;
use std::path::Path;

use homework::{Catalog, CheckAsk, check, start};
use serde_json::Value;

const EXERCISE: &str = "ray-sphere/closest-approach";
const ENTRY: &str = "let length = ray.direction.length();";

#[test]
#[ignore = "takes half a minute: .ci/full runs it"]
fn each_ending_has_its_words() {
    let folder = tempfile::tempdir().unwrap();
    let attempt = folder.path().join("attempt");
    start(EXERCISE, &attempt, &mut Vec::new()).unwrap();
    let catalog = Catalog::read().unwrap();
    let manifest = &catalog.find(EXERCISE).unwrap().manifest;
    let solution = &manifest.library(&catalog.source, &Default::default()).unwrap()[&manifest.file];
    let as_it_is = || -> (bool, Value) {
        let mut output = Vec::new();
        let right = check(&attempt, CheckAsk { json: true, trade: false }, &mut output).unwrap();
        (right, serde_json::from_slice(&output).unwrap())
    };
    let (right, said) = as_it_is();
    let output = said["output"].as_str().unwrap();
    assert!(
        !right && output.starts_with("Next: src/closest_approach.rs:") && output.contains("asks:\n"),
        "{output}"
    );

    // what else lies in the folder does not count
    fs::create_dir(attempt.join(".cargo")).unwrap();
    let config = "[build]\nrustc-wrapper = \"/bin/false\"\ntarget = \"no-such-target\"\n";
    fs::write(attempt.join(".cargo/config.toml"), config).unwrap();
    fs::write(attempt.join("rust-toolchain.toml"), "[toolchain]\nchannel = \"1.0.0\"\n").unwrap();
    fs::write(attempt.join("build.rs"), "fn main() { panic!() }").unwrap();
    let lib = fs::read_to_string(attempt.join("src/lib.rs")).unwrap();
    fs::write(attempt.join("src/lib.rs"), format!("{lib}mod helper;\n")).unwrap();
    fs::write(attempt.join("src/helper.rs"), "").unwrap();

    let checked = |does: &str| -> (bool, Value) {
        let text = solution.replace(ENTRY, &format!("{{ {does} }}\n    {ENTRY}"));
        fs::write(attempt.join("src").join(&manifest.file), text).unwrap();
        as_it_is()
    };
    let says = |does: &str, status: &str, words: &str| {
        let (right, said) = checked(does);
        let output = said["output"].as_str().unwrap();
        assert!(!right && said["status"] == status && output.contains(words), "{said:#}");
    };

    let (right, said) = checked("println!(\"{}\", \"noise\".repeat(100_000));");
    assert!(right && said["score"] == 9, "what it prints is its own business: {said:#}");
    assert!(said["output"].as_str().unwrap().contains("as in grading: src/lib.rs."), "{said:#}");
    says("let t: u8 = \"a\";", "does not compile", "--> src/closest_approach.rs:");
    says("panic!(\"no idea\");", "wrong", "a panic at src/closest_approach.rs:");
    says("loop {}", "wrong", "stopped after 10 seconds");
    says(
        "loop { std::fs::write(\"answers.txt\", vec![b'a'; 3 << 20]).unwrap(); }",
        "wrong",
        "wrote too much",
    );
    says("std::process::exit(0);", "wrong", "the program ended before it answered");
    says("std::process::abort();", "wrong", "the program was aborted");

    // what cannot be done is said
    let error = check(Path::new("/nowhere/at/all"), CheckAsk::default(), &mut Vec::new()).unwrap_err();
    assert!(error.status() == 2 && error.to_string().contains("there is no such folder"), "{error}");
}

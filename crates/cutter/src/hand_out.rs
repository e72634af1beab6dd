//! What a student gets.

use crate::given::{QUIET, given};
use crate::manifest::GIVEN;
use crate::source::Files;
use crate::{Manifest, Source, operations};

/// The files of a hand-out: a project that stands alone.
///
/// `expected` is the sheet with what it should find in the cases that it is shown, `transcript` the same for
/// reading.
pub fn hand_out(
    manifest: &Manifest,
    source: &Source,
    expected: String,
    transcript: &str,
) -> Result<Files, String> {
    let given = given(source, &manifest.folder)?;
    let mut files = Files::new();
    for (path, text) in given.files(source, &manifest.without)? {
        files.insert(format!("given/{path}"), text);
    }
    for (path, text) in source.whole("crates/exercise/src", "lib.rs")? {
        files.insert(format!("given/exercise/src/{path}"), text);
    }
    files.insert("given/exercise/Cargo.toml".into(), kit());
    for (path, text) in manifest.library(source, &manifest.questions())? {
        files.insert(format!("src/{path}"), text);
    }
    let about = format!(
        "//! {}: what of the chapter `{}` goes with it.\n//!\n\
         //! Your part is in {}; this file is written anew when it is checked.\n\n",
        manifest.name,
        manifest.chapter,
        manifest.asks(source)?.into_iter().map(|(file, _)| file).collect::<Vec<_>>().join(" and ")
    );
    let lib = files.entry("src/lib.rs".into()).or_default();
    *lib = format!("{about}{lib}{WORK}");
    let library = manifest.chapter.replace('-', "_");
    files.insert("src/main.rs".into(), MAIN.replace("LIBRARY", &library));
    files.insert("tests/properties.rs".into(), tests(manifest, &library));
    files.insert("expected.txt".into(), expected);
    files.insert("Cargo.toml".into(), cargo(manifest, &given.dependencies(&manifest.chapter, "given/")));
    files.insert("Cargo.lock".into(), source.read("Cargo.lock")?);
    files.insert(".gitignore".into(), "/target\n".into());
    let operations = operations::of(manifest, &files[&format!("src/{}", manifest.file)]);
    files.insert("README.md".into(), readme(manifest, source, &operations, transcript)?);
    manifest.reword(&mut files, |file| file.starts_with(GIVEN))?;
    Ok(files)
}

const WORK: &str = "\n/// What `cargo run` shows and `cargo test` tests.\n\
    pub const WORK: exercise::Work = exercise::Work { sheet: include_str!(\"../expected.txt\"), probe: probe::probe };\n";

const MAIN: &str = "//! `cargo run`: the values of your code, up to the first that is wrong.\n\n\
    fn main() -> std::process::ExitCode {\n    exercise::main(LIBRARY::WORK)\n}\n";

fn kit() -> String {
    format!(
        "[package]\nname = \"exercise\"\nversion = \"0.1.0\"\nedition = \"2024\"\npublish = false\n\n\
         [lints.rust]\n{QUIET}"
    )
}

fn cargo(manifest: &Manifest, dependencies: &str) -> String {
    format!(
        "# {}. There is nothing to change here: when it is checked, this file is written anew.\n\
         [package]\nname = \"{}\"\nversion = \"0.1.0\"\nedition = \"2024\"\npublish = false\nautobins = false\n\n\
         [[bin]]\nname = \"{}\"\npath = \"src/main.rs\"\n\n[workspace]\n\n[dependencies]\n\
         exercise = {{ path = \"given/exercise\" }}\n{dependencies}\n\
         [lints.rust]\n{QUIET}",
        manifest.name, manifest.chapter, manifest.chapter
    )
}

fn tests(manifest: &Manifest, library: &str) -> String {
    let mut text = "//! `cargo test`: what your code should be right about, one by one.\n".to_string();
    for property in &manifest.properties {
        let words = property.name.split(|sign: char| !sign.is_ascii_alphanumeric());
        let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
        let name = words.join("_").to_lowercase();
        let name =
            if name.starts_with(|sign: char| sign.is_ascii_digit()) { format!("p{name}") } else { name };
        text += &format!(
            "\n#[test]\nfn {name}() {{\n    exercise::test({library}::WORK, {:?});\n}}\n",
            property.name
        );
    }
    text
}

fn readme(
    manifest: &Manifest,
    source: &Source,
    operations: &str,
    transcript: &str,
) -> Result<String, String> {
    let Manifest { title, name, page, minutes, task, predict, properties, .. } = manifest;
    let mut text = format!(
        "# {title}\n\n`{name}` · {page} · about {minutes} minutes\n\n{task}\n\n## Before you start\n\n{}\n\nWrite your \
         answer down; then see.\n\n## What to do\n",
        predict.0
    );
    for (file, regions) in manifest.asks(source)? {
        text += &format!("\n`src/{file}` asks, where it says `todo!`:\n\n");
        for region in regions {
            text += &format!("- {}\n", region.question);
        }
    }
    text += &format!(
        "\nPut your lines in place of each of these `todo!`s. Helpers of your own may go there, or into modules \
         below.\n\n{operations}## See what it does\n\n```sh\n\
         cargo run     # asks what is still to be done; then shows your values, step by step, up to the first that is wrong\n\
         cargo test    # what your code should be right about, one by one\n```\n\n\
         Whoever also has the workbench can ask it, in its own folder: \
         `cargo run --release -- check THIS_FOLDER`. It tries cases that are not shown here, and knows mistakes by name.\n\n\
         ## What it should print\n\n```text\n{transcript}```\n\n\
         ## How it is graded\n\n| property | points |\n| --- | --- |\n"
    );
    for property in properties {
        text += &format!("| {} | {} |\n", property.name, property.points);
    }
    text += "\nA property counts as a whole, on these cases and on others. Numbers may be off by roundings: any \
             algebra that is right will do. Only the `.rs` files in `src/` are looked at, and of those not \
             `lib.rs`, `main.rs` and `probe.rs`, which are put there anew: declare a module of your own \
             where you use it, not in `lib.rs`. Hand in this folder without `target/`.\n";
    Ok(text)
}

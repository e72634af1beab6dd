//! A student's method on the chapter's own trade plot, beside the others.

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use cutter::Source;
use cutter::source::Files;
use stage::{Error, write_whole};
use toml::{Table, Value};

use crate::{Catalog, Exercise, cargo, folder};

/// What of a crate's folder its library and its program do not need; a chapter's exercises are its solutions'
/// business.
const LEFT_OUT: [&str; 5] = ["target", "tests", "exercises", "corpus", "out"];
/// Two kinds of rays that every chapter with methods has: those of every day, and those that part the
/// methods.
const REGIMES: [&str; 2] = ["ordinary", "grazing"];

/// Puts a student's files in place of the chapter's in a copy of what the stage is made of, under
/// `target/placed`, builds the stage there, lets it measure all its methods, prints its table, and draws
/// `trade.svg` in the attempt's folder.
pub(crate) fn trade(
    catalog: &Catalog,
    exercise: &Exercise,
    attempt: &Path,
    students: &Files,
    output: &mut dyn Write,
) -> Result<(), Error> {
    let manifest = &exercise.manifest;
    let placed = attempt.join("target/placed");
    copy(&catalog.source, &manifest.folder, &placed)?;
    folder::write(students, &placed.join(&manifest.folder).join("src"))?;

    let method = manifest.method.as_deref().unwrap_or_default();
    let printed = |error| Error::from_output(error);
    let rays = REGIMES.join(" and ");
    writeln!(output, "\nYour `{method}` takes its place in `{}`, for {rays} rays:\n", manifest.chapter)
        .and_then(|()| output.flush())
        .map_err(printed)?;
    // the terminal is the compiler's meanwhile
    let mut build = cargo::cargo(&placed, "build");
    build
        .args(["--quiet", "--release", "-p", &manifest.chapter, "--target-dir"])
        .arg(cargo::whole(&placed.join("target")))
        .stdin(Stdio::null());
    if !build.status().map_err(cargo::missing)?.success() {
        let why =
            "the stage does not compile with your files in it; the compiler's words are above. It calls what";
        return Err(Error::Failed(format!("{why} {} had in the hand-out, by the same names", manifest.file)));
    }
    let program = placed.join("target/release").join(&manifest.chapter);
    let program = program.canonicalize().map_err(|error| folder::failed("find", &program, error))?;
    let out = placed.join("out");
    fs::create_dir_all(&out).map_err(|error| folder::failed("make", &out, error))?;
    let picture = Path::new("out").join(&manifest.chapter).with_extension("png");
    let mut measure = Command::new(&program);
    measure.args(["trade", "--quick", "--out"]).arg(&picture).current_dir(&placed).stdin(Stdio::null());
    for regime in REGIMES {
        measure.args(["--regime", regime]);
    }
    let table = cargo::run(&mut measure, "measure")?;
    // where its drawings are is told below
    let table = String::from_utf8_lossy(&table);
    for line in table.lines().filter(|line| !line.starts_with("drawing: ")) {
        writeln!(output, "{line}").map_err(printed)?;
    }
    let drawn = out.join(format!("{}-trade.svg", manifest.chapter));
    let drawing = fs::read(&drawn).map_err(|error| folder::failed("read", &drawn, error))?;
    let place = attempt.join("trade.svg");
    write_whole(&place, |file| file.write_all(&drawing))?;
    writeln!(output, "drawing: {}", place.display()).map_err(printed)
}

/// Copies what the crate in a folder is built from: its workspace without any other crate.
fn copy(source: &Source, chapter: &str, into: &Path) -> Result<(), Error> {
    let text = source.read("Cargo.toml").map_err(Error::Failed)?;
    let mut root: Table = text.parse().map_err(|error| Error::Failed(format!("Cargo.toml: {error}")))?;
    let folders = needed(source, &root, chapter).map_err(Error::Failed)?;
    if let Some(workspace) = root.get_mut("workspace").and_then(Value::as_table_mut) {
        let members = folders.iter().map(|folder| Value::String(folder.clone())).collect();
        workspace.insert("members".to_string(), Value::Array(members));
        workspace.remove("default-members");
    }
    let mut files = Files::new();
    files.insert("Cargo.toml".into(), root.to_string());
    files.insert("Cargo.lock".into(), source.read("Cargo.lock").map_err(Error::Failed)?);
    folder::write(&files, into)?;
    // files of an earlier attempt may have other names
    let _ = fs::remove_dir_all(into.join(chapter).join("src"));
    folders.iter().try_for_each(|folder| copy_folder(&source.root().join(folder), &into.join(folder)))
}

/// The folders of the workspace's crates that one of them needs, with itself, tests included: cargo wants to
/// see them.
fn needed(source: &Source, root: &Table, folder: &str) -> Result<BTreeSet<String>, String> {
    let known = root.get("workspace").and_then(|it| it.get("dependencies")).and_then(Value::as_table);
    let known = known.ok_or("Cargo.toml has no workspace.dependencies")?;
    let path = |name: &String| known.get(name)?.get("path")?.as_str().map(String::from);
    let (mut found, mut open) = (BTreeSet::new(), vec![folder.to_string()]);
    while let Some(folder) = open.pop() {
        let file = format!("{folder}/Cargo.toml");
        let cargo: Table = source.read(&file)?.parse().map_err(|error| format!("{file}: {error}"))?;
        for kind in ["dependencies", "dev-dependencies", "build-dependencies"] {
            let names = cargo.get(kind).and_then(Value::as_table).into_iter().flat_map(Table::keys);
            open.extend(names.filter_map(path).filter(|path| !found.contains(path) && *path != folder));
        }
        found.insert(folder);
    }
    Ok(found)
}

/// Copies a folder; a file that is as it should be keeps its date, so that nothing is built twice.
fn copy_folder(from: &Path, to: &Path) -> Result<(), Error> {
    fs::create_dir_all(to).map_err(|error| folder::failed("make", to, error))?;
    let entries = fs::read_dir(from).map_err(|error| folder::failed("list", from, error))?;
    for entry in entries {
        let entry = entry.map_err(|error| folder::failed("list", from, error))?;
        let (from, to): (PathBuf, PathBuf) = (entry.path(), to.join(entry.file_name()));
        if LEFT_OUT.iter().any(|name| entry.file_name() == *name) {
            continue;
        }
        if from.is_dir() {
            copy_folder(&from, &to)?;
            continue;
        }
        let new = fs::read(&from).map_err(|error| folder::failed("read", &from, error))?;
        if !fs::read(&to).is_ok_and(|old| old == new) {
            fs::write(&to, new).map_err(|error| folder::failed("write", &to, error))?;
        }
    }
    Ok(())
}

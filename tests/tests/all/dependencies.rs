//! The page of the dependencies lists what the manifests ask for, and who asks.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use toml::{Table, Value};

/// What is taken from others, each with the packages that take it.
type Taken = BTreeMap<String, BTreeSet<String>>;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

fn manifest(file: &str) -> Table {
    read(file).parse().unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// The manifests of the workspace's packages, from its own list of them, and that of the fuzz targets.
fn manifests(workspace: &Table) -> Vec<Table> {
    let mut folders = vec!["fuzz".to_string()];
    for member in workspace["members"].as_array().unwrap().iter().map(|it| it.as_str().unwrap()) {
        let Some(group) = member.strip_suffix("/*") else {
            folders.push(member.to_string());
            continue;
        };
        let names = fs::read_dir(root().join(group)).unwrap().map(|entry| entry.unwrap().file_name());
        folders.extend(names.map(|name| format!("{group}/{}", name.to_str().unwrap())));
    }
    let files = folders.iter().map(|folder| format!("{folder}/Cargo.toml"));
    files.filter(|file| root().join(file).exists()).map(|file| manifest(&file)).collect()
}

/// The tables of that kind: the package's own and those of single platforms.
fn tables<'a>(package: &'a Table, kind: &'a str) -> impl Iterator<Item = (&'a String, &'a Value)> {
    let platforms = package.get("target").and_then(Value::as_table).into_iter().flatten();
    let platforms = platforms.filter_map(|(_, platform)| platform.as_table());
    [package].into_iter().chain(platforms).filter_map(move |it| it.get(kind)?.as_table()).flatten()
}

fn is_ours(dependency: &Value) -> bool {
    dependency.get("path").is_some()
}

/// What the workspace names for its packages is taken, too, even where no package asks for it.
fn taken() -> Taken {
    let root = manifest("Cargo.toml");
    let workspace = root["workspace"].as_table().unwrap();
    let shared = workspace["dependencies"].as_table().unwrap();
    let foreign = shared.iter().filter(|(_, dependency)| !is_ours(dependency));
    let mut used: Taken = foreign.map(|(name, _)| (name.clone(), BTreeSet::new())).collect();
    let mut tested = Taken::new();
    for package in manifests(workspace) {
        let of = package["package"]["name"].as_str().unwrap();
        let kinds = [("dependencies", true), ("build-dependencies", true), ("dev-dependencies", false)];
        for (kind, for_use) in kinds {
            for (name, dependency) in tables(&package, kind) {
                let is_shared = dependency.get("workspace").is_some();
                let named = if is_shared { &shared[name] } else { dependency };
                if !is_ours(named) {
                    let name = named.get("package").and_then(Value::as_str).unwrap_or(name);
                    let taken = if for_use { &mut used } else { &mut tested };
                    taken.entry(name.to_string()).or_default().insert(of.to_string());
                }
            }
        }
    }
    // what nobody but tests takes
    for (name, packages) in tested {
        let by = used.entry(name).or_default();
        if by.is_empty() {
            *by = packages;
        }
    }
    used
}

/// The rows of the page under a heading: the name in the first cell, the names in the second.
fn rows(page: &str, heading: &str) -> Taken {
    let (_, rest) = page.split_once(&format!("\n## {heading}\n")).expect(heading);
    let section = rest.split("\n## ").next().unwrap();
    let names = |cell: &str| cell.split('`').skip(1).step_by(2).map(String::from).collect::<Vec<_>>();
    let mut rows = Taken::new();
    for row in section.lines().filter(|line| line.starts_with("| `")) {
        let mut cells = row.split('|').skip(1);
        let name = names(cells.next().unwrap()).remove(0);
        let by = names(cells.next().unwrap()).into_iter().collect();
        assert!(cells.all(|cell| cell.len() > 2 || cell.is_empty()), "an empty cell: {row}");
        assert!(rows.insert(name, by).is_none(), "twice: {row}");
    }
    rows
}

#[test]
fn every_crate_is_on_the_page_with_those_that_take_it() {
    let (page, taken) = (rows(&read("book/src/dependencies.md"), "Crates"), taken());
    let names: BTreeSet<&String> = page.keys().chain(taken.keys()).collect();
    let mut faults = Vec::new();
    for name in names {
        match (page.get(name), taken.get(name)) {
            (None, Some(by)) => faults.push(format!("{name}, taken by {by:?}, is not on the page")),
            (Some(_), None) => faults.push(format!("{name} is on the page, and nobody takes it")),
            (told, by) if told != by => faults.push(format!("{name} is taken by {by:?}, not by {told:?}")),
            _ => {}
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn every_package_of_the_browser_is_on_the_page() {
    let manifest: serde_json::Value = serde_json::from_str(&read("book/browser/package.json")).unwrap();
    let kinds = ["dependencies", "devDependencies"].map(|kind| manifest[kind].as_object());
    let asked: Vec<&String> = kinds.into_iter().flatten().flat_map(|packages| packages.keys()).collect();
    let page = rows(&read("book/src/dependencies.md"), "Packages for the browser");
    assert_eq!(page.keys().collect::<Vec<_>>(), asked);
}

/// The folders below `folder` with a license of their own.
fn licensed(folder: &Path, found: &mut BTreeSet<String>) {
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            licensed(&path, found);
        } else if path.file_name().is_some_and(|name| name == "LICENSE") {
            let place = folder.strip_prefix(root()).unwrap().to_str().unwrap();
            found.insert(place.replace('\\', "/"));
        }
    }
}

#[test]
fn every_folder_with_a_license_of_its_own_is_on_the_page() {
    let mut found = BTreeSet::new();
    for group in ["book/src", "book/theme", "chapters", "crates"] {
        licensed(&root().join(group), &mut found);
    }
    let page = rows(&read("book/src/dependencies.md"), "Files that come along");
    let folders: BTreeSet<String> = page.into_values().flatten().collect();
    assert!(folders.is_superset(&found), "{found:?} are not all among {folders:?}");
    for folder in folders {
        assert!(root().join(&folder).is_dir(), "{folder} is not there");
    }
}

#[test]
fn every_tool_is_one_that_the_scripts_call() {
    let scripts = [".ci/run", ".ci/full", ".ci/fresh-machine", "book/browser/run"].map(read).concat();
    let tools = rows(&read("book/src/dependencies.md"), "Tools");
    assert!(tools.len() > 4, "{tools:?}");
    for tool in tools.keys() {
        assert!(scripts.contains(tool.as_str()), "no script calls {tool}");
    }
    for line in scripts.lines().filter(|line| line.contains("cargo install ")) {
        let tool = line.rsplit_once(' ').unwrap().1.split('@').next().unwrap();
        assert!(tools.contains_key(tool), "{tool} is not on the page");
    }
}

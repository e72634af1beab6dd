//! What an exercise is: a TOML file in the chapter's folder `exercises`.

mod read;

use std::collections::BTreeMap;

use toml::Table;

use crate::slice::{self, Modules, Part};
use crate::source::Files;
use crate::{Filling, Source, cut, docs};

/// An exercise.
#[derive(Clone, Debug)]
pub struct Manifest {
    /// `ray-sphere/closest-approach`
    pub name: String,
    /// `ray-sphere`
    pub chapter: String,
    /// `chapters/04-ray-sphere`
    pub folder: String,
    /// What is to be done, in a line.
    pub title: String,
    /// The page of the notes.
    pub page: String,
    /// How long it takes, in minutes.
    pub minutes: u32,
    /// What it teaches.
    pub teaches: String,
    /// A question to answer before anything runs, and its answer.
    pub predict: (String, String),
    /// What a student is told, in some sentences.
    pub task: String,
    /// The file with the regions, in the chapter's `src`: `closest_approach.rs`. Regions may be in files of
    /// `brings` too.
    pub file: String,
    /// The names of the regions that become holes.
    pub holes: Vec<String>,
    /// The name of the chapter's method that this is, as `--method` has it, where it is one:
    /// `closest-approach`.
    pub method: Option<String>,
    /// The names of regions that are another exercise's: a hand-out has neither their lines nor their
    /// question.
    ///
    /// What earlier exercises of the chapter ask comes along solved; what later ones ask is hidden.
    pub hides: Vec<String>,
    /// Lines for hidden regions that are run through all the same, and whose values are not looked at.
    pub instead: Fillings,
    /// What else of the chapter comes along, by file; that of `lib.rs` is [`Part::Items`]. All of `file`
    /// comes, but for what is said of it here.
    pub brings: BTreeMap<String, Part>,
    /// Modules of given crates that stay behind, since they have the answer: `math/grid`.
    pub without: Vec<String>,
    /// What the hand-out says of items, where the chapter's own words have the answer, by file; see [`docs`].
    /// A file is the chapter's, `lib.rs`, or that of a given crate, `given/math/src/no_grid.rs`.
    pub docs: BTreeMap<String, BTreeMap<String, String>>,
    /// Whether the holes have numbers of a type `R`, and vectors of those. (Else `tools` says what they
    /// have.)
    pub generic: bool,
    /// What there is to work with besides, a line each.
    pub tools: Vec<String>,
    /// The names of a case's numbers.
    pub columns: Vec<String>,
    /// What an answer can be right about.
    pub properties: Vec<Asked>,
    /// What is often done wrong, at least four.
    pub mistakes: Vec<Mistake>,
    /// Right solutions in other algebra.
    pub others: Vec<Fillings>,
}

/// A property with its cases.
#[derive(Clone, Debug)]
pub struct Asked {
    /// "from inside"
    pub name: String,
    /// What it counts.
    pub points: u32,
    /// The cases, each with a number for each of [`Manifest::columns`]; the first one goes along with the
    /// hand-out.
    pub cases: Vec<Vec<f64>>,
}

/// A mistake that is known.
#[derive(Clone, Debug)]
pub struct Mistake {
    /// `far-root`
    pub name: String,
    /// The sentence that helps.
    pub says: String,
    /// How it is made: by its values it is recognized.
    pub model: Fillings,
    /// The same written independently.
    pub again: Vec<Fillings>,
}

/// The lines for each hole, by its name.
pub type Fillings = BTreeMap<String, Filling>;

impl Manifest {
    /// Every exercise of a checkout, in the order of the book.
    pub fn all(source: &Source) -> Result<Vec<Manifest>, String> {
        let mut all = Vec::new();
        for chapter in source.list("chapters", "")? {
            let folder = format!("chapters/{chapter}");
            let mut here = Vec::new();
            for file in source.list(&format!("{folder}/exercises"), ".toml")? {
                here.push(Manifest::read(source, &folder, file.trim_end_matches(".toml"))?);
            }
            // within a chapter, by their length: the short ones first
            here.sort_by_key(|it| it.minutes);
            all.extend(here);
        }
        Ok(all)
    }

    /// Reads `exercises/NAME.toml` of a chapter's folder.
    pub fn read(source: &Source, folder: &str, name: &str) -> Result<Manifest, String> {
        let path = format!("{folder}/exercises/{name}.toml");
        let text = source.read(&path)?;
        let table: Table = text.parse().map_err(|error| format!("{path}: {error}"))?;
        read::manifest(&table, folder, name).map_err(|error| format!("{path}: {error}"))
    }

    /// The path of its probe in the checkout.
    pub fn probe(&self) -> String {
        let name = self.name.rsplit('/').next().unwrap_or_default().replace('-', "_");
        format!("{}/exercises/{name}.rs", self.folder)
    }

    /// The library of the exercise, with its holes filled, and its probe: the files of `src`. `Err` where a
    /// filling is for no region.
    pub fn library(&self, source: &Source, fillings: &Fillings) -> Result<Files, String> {
        let src = format!("{}/src", self.folder);
        let mut files = Files::new();
        let parts = self.parts();
        let top =
            |(file, part): (&String, &Part)| (!file.contains('/')).then(|| (module_of(file), part.clone()));
        let modules: Modules = parts.iter().filter_map(top).collect();
        // a file comes before those of its modules, which may be other parts of them
        for (file, part) in &parts {
            let below = modules_below(file, &parts);
            let here = |(name, _): &(&String, &Filling)| self.file_of(source, name).as_ref() == Ok(file);
            let fillings =
                fillings.iter().filter(here).map(|(name, it)| (name.clone(), it.clone())).collect();
            source.add(&src, file, part, &below, &fillings, &mut files)?;
        }
        if let Some(name) = fillings.keys().find(|name| self.file_of(source, name).is_err()) {
            self.file_of(source, name)?;
        }
        let names = match self.brings.get("lib.rs") {
            Some(Part::Items(names)) => names.as_slice(),
            _ => &[],
        };
        let lib = cut(&source.read(&format!("{src}/lib.rs"))?, &Fillings::new())?;
        let lib = slice::items(&lib, names, &modules).map_err(|error| format!("{src}/lib.rs: {error}"))?;
        files.insert("lib.rs".into(), format!("{}\npub mod probe;\n", lib.text));
        files.insert("probe.rs".into(), source.read(&self.probe())?);
        self.reword(&mut files, |file| !file.starts_with(GIVEN))?;
        Ok(files)
    }

    /// Says in other words what is said of items in some of the files, by their paths.
    pub(crate) fn reword(&self, files: &mut Files, of: impl Fn(&str) -> bool) -> Result<(), String> {
        for (file, words) in self.docs.iter().filter(|(file, _)| of(file)) {
            let text =
                files.get_mut(file).ok_or(format!("`docs` has words for {file}, which is not there"))?;
            *text = docs::reworded(text, words).map_err(|error| format!("{file}: {error}"))?;
        }
        Ok(())
    }

    /// The files that come along, but for `lib.rs`, and how much of each.
    fn parts(&self) -> BTreeMap<String, Part> {
        let mut parts = self.brings.clone();
        parts.remove("lib.rs");
        parts.entry(self.file.clone()).or_insert(Part::All);
        parts
    }

    /// The file with a region; `Err` where none has it that comes along.
    pub fn file_of(&self, source: &Source, name: &str) -> Result<String, String> {
        let parts = self.parts();
        for file in parts.keys() {
            let path = format!("{}/src/{file}", self.folder);
            let regions = cut::regions(&source.read(&path)?).map_err(|error| format!("{path}: {error}"))?;
            if regions.iter().any(|region| region.name == name) {
                return Ok(file.clone());
            }
        }
        Err(format!("{}/src/{}: there is no `// exercise {name}`", self.folder, self.file))
    }

    /// The regions that become holes, by their files, in order.
    pub fn asks(&self, source: &Source) -> Result<Vec<(String, Vec<cut::Region>)>, String> {
        let mut asks: Vec<(String, Vec<cut::Region>)> = Vec::new();
        for name in &self.holes {
            let file = self.file_of(source, name)?;
            let regions = cut::regions(&source.read(&format!("{}/src/{file}", self.folder))?)?;
            let region = regions.into_iter().find(|region| region.name == *name);
            match asks.iter_mut().find(|(other, _)| *other == file) {
                Some((_, regions)) => regions.extend(region),
                None => asks.push((file, region.into_iter().collect())),
            }
        }
        Ok(asks)
    }

    /// The same without their files.
    pub fn regions(&self, source: &Source) -> Result<Vec<cut::Region>, String> {
        Ok(self.asks(source)?.into_iter().flat_map(|(_, regions)| regions).collect())
    }

    /// Nothing where another exercise asks, or what is there instead.
    pub fn hidden(&self) -> Fillings {
        let filling = |name: &String| self.instead.get(name).cloned().unwrap_or(Filling::Hidden);
        self.hides.iter().map(|name| (name.clone(), filling(name))).collect()
    }

    /// A question in every hole, and nothing where another exercise has one.
    pub fn questions(&self) -> Fillings {
        let asked = self.holes.iter().map(|name| (name.clone(), Filling::Question));
        asked.chain(self.hidden()).collect()
    }
}

/// Where a hand-out has the crates that are given.
pub(crate) const GIVEN: &str = "given/";

/// The top module of a file of `src`.
fn module_of(file: &str) -> String {
    file.trim_end_matches(".rs").split('/').next().unwrap_or_default().to_string()
}

/// Of the modules that a file declares, those that come along as parts of their own.
fn modules_below(file: &str, parts: &BTreeMap<String, Part>) -> Modules {
    let folder = format!("{}/", file.trim_end_matches(".rs"));
    let below = |(it, part): (&String, &Part)| Some((module_of(it.strip_prefix(&folder)?), part.clone()));
    parts.iter().filter_map(below).collect()
}

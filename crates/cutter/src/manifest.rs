//! What an exercise is: a TOML file in the chapter's folder `exercises`.

use std::collections::BTreeMap;

use toml::{Table, Value};

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
    /// How long it takes.
    pub minutes: u32,
    /// What it teaches.
    pub teaches: String,
    /// A question to answer before anything runs, and its answer.
    pub predict: (String, String),
    /// What a student is told, in some sentences.
    pub task: String,
    /// The file with the regions, in the chapter's `src`: `closest_approach.rs`. Regions may be in files of `brings` too.
    pub file: String,
    /// The names of the regions that become holes.
    pub holes: Vec<String>,
    /// The name of the chapter's method that this is, as `--method` has it, where it is one:
    /// `closest-approach`.
    pub method: Option<String>,
    /// The names of regions that are another exercise's: a hand-out has neither their lines nor their question.
    pub hides: Vec<String>,
    /// What else of the chapter comes along, by file; that of `lib.rs` is [`Part::Items`]. All of `file` comes, but for
    /// what is said of it here.
    pub brings: BTreeMap<String, Part>,
    /// Modules of given crates that stay behind, since they have the answer: `math/grid`.
    pub without: Vec<String>,
    /// What the hand-out says of items of `file`, where the chapter's own words have the answer; see [`docs`].
    pub docs: BTreeMap<String, String>,
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
    /// The cases; the first one goes along with the hand-out.
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
        manifest(&table, folder, name).map_err(|error| format!("{path}: {error}"))
    }

    /// The path of its probe in the checkout.
    pub fn probe(&self) -> String {
        let name = self.name.rsplit('/').next().unwrap_or_default().replace('-', "_");
        format!("{}/exercises/{name}.rs", self.folder)
    }

    /// The library of the exercise, with its holes filled, and its probe: the files of `src`.
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
        if let Some(text) = files.get_mut(&self.file) {
            let said = docs::reworded(text, &self.docs);
            *text = said.map_err(|error| format!("{src}/{}: {error}", self.file))?;
        }
        let names = match self.brings.get("lib.rs") {
            Some(Part::Items(names)) => names.as_slice(),
            _ => &[],
        };
        let lib = cut(&source.read(&format!("{src}/lib.rs"))?, &Fillings::new())?;
        let lib = slice::items(&lib, names, &modules).map_err(|error| format!("{src}/lib.rs: {error}"))?;
        files.insert("lib.rs".into(), format!("{}\npub mod probe;\n", lib.text));
        files.insert("probe.rs".into(), source.read(&self.probe())?);
        Ok(files)
    }

    /// The files that come along, but for `lib.rs`, and how much of each.
    fn parts(&self) -> BTreeMap<String, Part> {
        let mut parts = self.brings.clone();
        parts.remove("lib.rs");
        parts.entry(self.file.clone()).or_insert(Part::All);
        parts
    }

    /// The file with a region.
    fn file_of(&self, source: &Source, name: &str) -> Result<String, String> {
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

    /// A question in every hole, and nothing where another exercise has one.
    pub fn questions(&self) -> Fillings {
        let asked = self.holes.iter().map(|name| (name.clone(), Filling::Question));
        asked.chain(self.hides.iter().map(|name| (name.clone(), Filling::Hidden))).collect()
    }
}

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

fn manifest(table: &Table, folder: &str, name: &str) -> Result<Manifest, String> {
    let chapter = folder.trim_start_matches("chapters/").get(3..).unwrap_or_default().to_string();
    let predict = get(table, "predict")?.as_table().ok_or("`predict` has a question and an answer")?;
    let holes = strings(table, "holes")?;
    let hides = if table.contains_key("hides") { strings(table, "hides")? } else { Vec::new() };
    let brings = get(table, "brings")?.as_table().ok_or("`brings` is a table of files")?;
    let part = |(file, part): (&String, &Value)| match part {
        Value::String(all) if all == "all" => Ok((format!("{file}.rs"), Part::All)),
        Value::Array(_) => Ok((format!("{file}.rs"), Part::Items(strings(brings, file)?))),
        _ => Err(format!("`brings.{file}` is \"all\" or a list of items")),
    };
    let columns: Vec<String> = strings(table, "columns")?;
    let properties =
        tables(table, "property")?.map(|it| asked(it, columns.len())).collect::<Result<_, _>>()?;
    let mistakes = tables(table, "mistake")?.map(|it| mistake(it, &holes)).collect::<Result<_, _>>()?;
    let others = get(table, "others")?.as_array().ok_or("`others` is a list of solutions")?;
    Ok(Manifest {
        name: format!("{chapter}/{name}"),
        chapter,
        folder: folder.to_string(),
        title: string(table, "title")?,
        page: string(table, "page")?,
        minutes: whole(table, "minutes")?,
        teaches: string(table, "teaches")?,
        predict: (string(predict, "question")?, string(predict, "answer")?),
        task: string(table, "task")?,
        file: string(table, "file")? + ".rs",
        method: table.contains_key("method").then(|| string(table, "method")).transpose()?,
        brings: brings.iter().map(part).collect::<Result<_, _>>()?,
        without: if table.contains_key("without") { strings(table, "without")? } else { Vec::new() },
        docs: match table.get("docs").map(Value::as_table) {
            None => BTreeMap::new(),
            Some(None) => return Err("`docs` is a table of texts".to_string()),
            Some(Some(docs)) => docs
                .keys()
                .map(|name| Ok((name.clone(), string(docs, name)?)))
                .collect::<Result<_, String>>()?,
        },
        columns,
        properties,
        mistakes,
        others: others.iter().map(|it| fillings(it, &holes)).collect::<Result<_, _>>()?,
        holes,
        hides,
    })
}

fn asked(table: &Table, columns: usize) -> Result<Asked, String> {
    let name = string(table, "name")?;
    let rows = get(table, "cases")?.as_array().ok_or("`cases` is a list of cases")?;
    let number = |value: &Value| value.as_float().or(value.as_integer().map(|whole| whole as f64));
    let case = |row: &Value| {
        let numbers = row.as_array()?.iter().map(number).collect::<Option<Vec<f64>>>()?;
        (numbers.len() == columns).then_some(numbers)
    };
    let cases = rows.iter().map(case).collect::<Option<Vec<_>>>();
    let cases =
        cases.ok_or(format!("property {name}: a case is {columns} numbers, a number for each column"))?;
    Ok(Asked { name, points: whole(table, "points")?, cases })
}

fn mistake(table: &Table, holes: &[String]) -> Result<Mistake, String> {
    let again = get(table, "again")?.as_array().ok_or("`again` is a list of solutions")?;
    Ok(Mistake {
        name: string(table, "name")?,
        says: string(table, "says")?,
        model: fillings(get(table, "model")?, holes)?,
        again: again.iter().map(|it| fillings(it, holes)).collect::<Result<_, _>>()?,
    })
}

/// The lines for the only hole, or a table of lines for some of the holes; the others stay as the chapter has
/// them.
fn fillings(value: &Value, holes: &[String]) -> Result<Fillings, String> {
    match value {
        Value::String(lines) if holes.len() == 1 => {
            Ok([(holes[0].clone(), Filling::Lines(lines.clone()))].into_iter().collect())
        }
        Value::Table(table) => {
            let filling = |(name, lines): (&String, &Value)| {
                let lines = lines.as_str().filter(|_| holes.contains(name));
                let lines = lines.ok_or(format!("a solution has lines for {name}, which is no hole"))?;
                Ok((name.clone(), Filling::Lines(lines.to_string())))
            };
            table.iter().map(filling).collect()
        }
        _ => Err("a solution is the lines for the only hole, or a table: { hole = \"lines\" }".to_string()),
    }
}

fn get<'a>(table: &'a Table, key: &str) -> Result<&'a Value, String> {
    table.get(key).ok_or(format!("`{key}` is missing"))
}

fn string(table: &Table, key: &str) -> Result<String, String> {
    get(table, key)?.as_str().map(|text| text.trim().to_string()).ok_or(format!("`{key}` is a text"))
}

fn strings(table: &Table, key: &str) -> Result<Vec<String>, String> {
    let texts = get(table, key)?.as_array().and_then(|array| {
        array.iter().map(|value| value.as_str().map(String::from)).collect::<Option<Vec<_>>>()
    });
    texts.ok_or(format!("`{key}` is a list of texts"))
}

fn whole(table: &Table, key: &str) -> Result<u32, String> {
    let number = get(table, key)?.as_integer().and_then(|number| u32::try_from(number).ok());
    number.ok_or(format!("`{key}` is a whole number"))
}

fn tables<'a>(table: &'a Table, key: &str) -> Result<impl Iterator<Item = &'a Table>, String> {
    let list = get(table, key)?.as_array().filter(|list| list.iter().all(Value::is_table));
    let list = list.ok_or(format!("`{key}` is a list of tables: [[{key}]]"))?;
    Ok(list.iter().filter_map(Value::as_table))
}

//! A manifest from its TOML. A key that is not known is refused: it would go unheeded.

use std::collections::BTreeMap;

use toml::{Table, Value};

use super::{Asked, Fillings, Manifest, Mistake};
use crate::Filling;
use crate::slice::Part;

const KEYS: [&str; 20] = [
    "brings", "columns", "docs", "file", "generic", "hides", "holes", "instead", "method", "minutes",
    "mistake", "others", "page", "predict", "property", "task", "teaches", "title", "tools", "without",
];

pub(super) fn manifest(table: &Table, folder: &str, name: &str) -> Result<Manifest, String> {
    let chapter = folder.trim_start_matches("chapters/").get(3..).unwrap_or_default().to_string();
    known(table, &KEYS)?;
    let predict = get(table, "predict")?.as_table().ok_or("`predict` has a question and an answer")?;
    known(predict, &["question", "answer"])?;
    let holes = strings(table, "holes")?;
    let hides = some_strings(table, "hides")?;
    let instead = table.get("instead").map(|it| fillings(it, &hides)).transpose()?.unwrap_or_default();
    let file = string(table, "file")? + ".rs";
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
        method: table.contains_key("method").then(|| string(table, "method")).transpose()?,
        brings: brings.iter().map(part).collect::<Result<_, _>>()?,
        without: some_strings(table, "without")?,
        generic: match table.get("generic") {
            None => true,
            Some(value) => value.as_bool().ok_or("`generic` is true or false")?,
        },
        tools: some_strings(table, "tools")?,
        docs: docs(table, &file)?,
        file,
        columns,
        properties,
        mistakes,
        others: others.iter().map(|it| fillings(it, &holes)).collect::<Result<_, _>>()?,
        holes,
        hides,
        instead,
    })
}

/// `[docs]`: words for items of `file`, and a table of words for each other file.
fn docs(table: &Table, file: &str) -> Result<BTreeMap<String, BTreeMap<String, String>>, String> {
    let mut docs: BTreeMap<String, BTreeMap<String, String>> = BTreeMap::new();
    let Some(words) = table.get("docs") else { return Ok(docs) };
    let words = words.as_table().ok_or("`docs` is a table of texts")?;
    for (name, value) in words {
        match value {
            Value::Table(of_file) => {
                for name_there in of_file.keys() {
                    let words = string(of_file, name_there)?;
                    docs.entry(format!("{name}.rs")).or_default().insert(name_there.clone(), words);
                }
            }
            _ => {
                docs.entry(file.to_string()).or_default().insert(name.clone(), string(words, name)?);
            }
        }
    }
    Ok(docs)
}

/// Refuses a key that is none of these.
fn known(table: &Table, keys: &[&str]) -> Result<(), String> {
    match table.keys().find(|key| !keys.contains(&key.as_str())) {
        Some(key) => Err(format!("`{key}` is no key here; there are {}", keys.join(", "))),
        None => Ok(()),
    }
}

fn asked(table: &Table, columns: usize) -> Result<Asked, String> {
    known(table, &["name", "points", "cases"])?;
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
    known(table, &["name", "says", "model", "again"])?;
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

fn some_strings(table: &Table, key: &str) -> Result<Vec<String>, String> {
    if table.contains_key(key) { strings(table, key) } else { Ok(Vec::new()) }
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

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"
title = "Twice"
page = "1"
minutes = 5
teaches = "Twos."
task = "Double it."
file = "twice"
holes = ["y"]
hides = ["z"]
instead = { z = "let z = 0;" }
columns = ["x"]
others = ["let y = x + x;"]
predict = { question = "?", answer = "!" }
brings = { lib = ["A"] }
docs = { y = "Twice x.", lib = { A = "An A." } }
property = [{ name = "any", points = 1, cases = [[1], [2.5]] }]
mistake = [{ name = "thrice", says = "No.", model = "let y = 3 * x;", again = [{ y = "3 * x" }] }]
"#;

    fn read(text: &str) -> Result<Manifest, String> {
        manifest(&text.parse().unwrap(), "chapters/01-double", "it")
    }

    #[test]
    fn a_manifest_is_read() {
        let it = read(TEXT).unwrap();
        assert_eq!((it.name.as_str(), it.file.as_str()), ("double/it", "twice.rs"));
        assert_eq!(it.docs["twice.rs"]["y"], "Twice x.");
        assert_eq!(it.docs["lib.rs"]["A"], "An A.");
        assert_eq!(it.hidden()["z"], Filling::Lines("let z = 0;".into()));
        assert_eq!(it.properties[0].cases, [[1.0], [2.5]]);
    }

    #[test]
    fn what_is_not_known_is_refused() {
        for (from, to, key) in [
            ("minutes", "method_ = \"a\"\nminutes", "method_"),
            ("answer = ", "answr = \"!\", answer = ", "answr"),
            ("points = 1", "points = 1, point = 1", "point"),
            ("says = ", "say = \"\", says = ", "say"),
        ] {
            let error = read(&TEXT.replacen(from, to, 1)).unwrap_err();
            assert!(error.starts_with(&format!("`{key}` is no key here")), "{error}");
        }
        let error = read(&TEXT.replace("instead = { z", "instead = { w")).unwrap_err();
        assert!(error.contains("lines for w"), "{error}");
    }
}

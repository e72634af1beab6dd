//! `workbench list`: what each stage teaches, and which pages of the notes it follows.

use std::io::Write;

use serde::ser::{Serialize, SerializeMap, Serializer};
use stage::{About, Error, Stage};

use crate::stages::widest;

/// Writes three lines a stage, or one JSON list with the same fields. [`Error::Failed`] where that cannot be
/// written, [`Error::PipeClosed`] where nobody reads it.
pub fn list(stages: &[&dyn Stage], json: bool, output: &mut dyn Write) -> Result<(), Error> {
    let entries: Vec<Entry> = stages.iter().map(|stage| Entry(stage.about())).collect();
    let text = if json { to_json(&entries) } else { to_text(&entries) };
    output.write_all(text.as_bytes()).map_err(Error::from_output)
}

/// One stage of the list.
struct Entry(About);

fn to_text(entries: &[Entry]) -> String {
    let width = widest(entries.iter().map(|entry| entry.0.name));
    let indent = " ".repeat(width + 5);
    let lines = entries.iter().map(|Entry(about)| {
        let About { number, name, teaches, notes, methods, .. } = about;
        let methods = methods.join(" · ");
        format!(
            "{number:02} {name:width$}  {teaches}\n{indent}notes:   {notes}\n{indent}methods: {methods}\n"
        )
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn to_json(entries: &[Entry]) -> String {
    serde_json::to_string_pretty(entries).expect("an entry has only string keys") + "\n"
}

impl Serialize for Entry {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let About { number, name, teaches, notes, methods, .. } = &self.0;
        let mut map = serializer.serialize_map(Some(5))?;
        map.serialize_entry("number", number)?;
        map.serialize_entry("name", name)?;
        map.serialize_entry("teaches", teaches)?;
        map.serialize_entry("notes", notes)?;
        map.serialize_entry("methods", methods)?;
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stages;

    fn listed(json: bool) -> String {
        let mut output = Vec::new();
        list(stages::ALL, json, &mut output).unwrap();
        String::from_utf8(output).unwrap()
    }

    #[test]
    fn the_text_names_everything_in_order() {
        let text = listed(false);
        let mut rest = text.as_str();
        for stage in stages::ALL {
            let about = stage.about();
            for part in [about.name, about.teaches, about.notes].into_iter().chain(about.methods) {
                let (_, after) = rest.split_once(part).unwrap_or_else(|| panic!("{part} in\n{text}"));
                rest = after;
            }
        }
    }

    #[test]
    fn the_json_has_the_same_fields() {
        let entries: serde_json::Value = serde_json::from_str(&listed(true)).unwrap();
        assert_eq!(entries.as_array().unwrap().len(), stages::ALL.len());
        for (entry, stage) in entries.as_array().unwrap().iter().zip(stages::ALL) {
            let about = stage.about();
            assert_eq!(entry["number"], about.number);
            assert_eq!(entry["name"], about.name);
            assert_eq!(entry["teaches"], about.teaches);
            assert_eq!(entry["notes"], about.notes);
            assert_eq!(entry["methods"], serde_json::json!(about.methods));
        }
    }
}

//! A transcript as JSON: the contract's `steps`, and the tables beside them.

use std::path::Path;

use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::value::digits;
use crate::{Section, Step, Transcript, Value};

/// What `show --format json` prints: a transcript and where its picture went.
pub(crate) struct Report<'a> {
    pub(crate) transcript: &'a Transcript,
    pub(crate) picture: &'a Path,
}

impl Serialize for Report<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Transcript { stage, method, precision, sections } = self.transcript;
        let steps: Vec<InSection<'_>> = sections
            .iter()
            .flat_map(|section| section.steps.iter().map(|step| InSection { section: &section.title, step }))
            .collect();
        let tables: Vec<Titled<'_>> =
            sections.iter().filter(|section| section.table.is_some()).map(Titled).collect();
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("stage", stage)?;
        map.serialize_entry("method", method)?;
        map.serialize_entry("precision", precision)?;
        map.serialize_entry("picture", &self.picture.to_string_lossy())?;
        map.serialize_entry("steps", &steps)?;
        map.serialize_entry("tables", &tables)?;
        map.end()
    }
}

/// A step, with the section it stands in.
struct InSection<'a> {
    section: &'a str,
    step: &'a Step,
}

impl Serialize for InSection<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("symbol", &self.step.symbol)?;
        map.serialize_entry("formula", &self.step.formula)?;
        map.serialize_entry("value", &self.step.value)?;
        map.serialize_entry("note", &self.step.note)?;
        map.serialize_entry("section", self.section)?;
        map.end()
    }
}

/// A section's table, under the section's title.
struct Titled<'a>(&'a Section);

impl Serialize for Titled<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("title", &self.0.title)?;
        if let Some(table) = &self.0.table {
            map.serialize_entry("columns", &table.columns)?;
            map.serialize_entry("rows", &table.rows)?;
        }
        map.end()
    }
}

impl Serialize for Value {
    /// A number, an array or a string; what is not finite is "inf", "-inf" or "nan".
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Value::F32(x) if x.is_finite() => serializer.serialize_f32(*x),
            Value::F64(x) if x.is_finite() => serializer.serialize_f64(*x),
            Value::F32(x) => serializer.serialize_str(&digits(*x)),
            Value::F64(x) => serializer.serialize_str(&digits(*x)),
            Value::Array(values) => serializer.collect_seq(values),
            Value::Text(text) => serializer.serialize_str(text),
        }
    }
}

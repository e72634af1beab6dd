//! The transcript: one ray, step by step, in the notes' symbols.

use math::{Real, Vector};

use crate::{About, Ask, Value};

/// One line: a symbol, its formula as the page writes it, its value, and where a decision falls,
/// what it means.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The page's symbol: `t_close`.
    pub symbol: String,
    /// The page's formula: `u_r · (c − p_r)`.
    pub formula: String,
    /// The value, from the method's own struct.
    pub value: Value,
    /// What the value decides, or an empty string.
    pub note: String,
}

/// Values that belong side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The heads of the columns.
    pub columns: Vec<String>,
    /// The rows, each as long as `columns`.
    pub rows: Vec<Vec<Value>>,
    /// So many of them stand in the text, the first ones; all in JSON.
    pub in_text: usize,
}

/// A heading with its steps, its table, or a remark.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// What it shows.
    pub title: String,
    /// The page of the notes it follows; may be empty.
    pub source: String,
    /// The steps, in order.
    pub steps: Vec<Step>,
    /// A table below the steps.
    pub table: Option<Table>,
    /// Sentences below it all.
    pub remarks: Vec<String>,
    /// It stands in the text as well, and not in JSON alone.
    pub in_text: bool,
}

/// All that `show` says about one ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Transcript {
    /// The stage's name.
    pub stage: &'static str,
    /// The method's name.
    pub method: &'static str,
    /// The precision's name.
    pub precision: &'static str,
    /// The sections, the worked ray first.
    pub sections: Vec<Section>,
}

impl Transcript {
    /// An empty transcript for a request, whose method must be one of the stage's.
    pub fn new(about: &About, ask: &Ask) -> Transcript {
        let method = about.methods[ask.method];
        Transcript { stage: about.name, method, precision: ask.precision.name(), sections: Vec::new() }
    }

    /// Opens a section; its steps are added to what this returns.
    pub fn section(&mut self, title: impl Into<String>, source: impl Into<String>) -> &mut Section {
        self.sections.push(Section::new(title, source));
        self.sections.last_mut().expect("a section was just pushed")
    }
}

impl Section {
    /// An empty section.
    pub fn new(title: impl Into<String>, source: impl Into<String>) -> Section {
        let (title, source) = (title.into(), source.into());
        Section { title, source, steps: Vec::new(), table: None, remarks: Vec::new(), in_text: true }
    }

    /// A step whose value is a number.
    pub fn number<R: Real>(&mut self, symbol: &str, formula: &str, x: R) -> &mut Section {
        self.step(symbol, formula, Value::number(x))
    }

    /// A step whose value is a vector or a point.
    pub fn vector<R: Real>(&mut self, symbol: &str, formula: &str, v: impl Vector<R>) -> &mut Section {
        self.step(symbol, formula, Value::vector(v))
    }

    /// A step.
    pub fn step(&mut self, symbol: &str, formula: &str, value: Value) -> &mut Section {
        let (symbol, formula) = (symbol.to_string(), formula.to_string());
        self.steps.push(Step { symbol, formula, value, note: String::new() });
        self
    }

    /// Says what the last step decides; nothing where there is no step.
    pub fn note(&mut self, note: impl Into<String>) -> &mut Section {
        if let Some(step) = self.steps.last_mut() {
            step.note = note.into();
        }
        self
    }

    /// Sets the table; each of `rows` is as long as `columns`.
    pub fn table(&mut self, columns: &[&str], rows: Vec<Vec<Value>>) -> &mut Section {
        let columns = columns.iter().map(|column| column.to_string()).collect();
        self.table = Some(Table { columns, rows, in_text: usize::MAX });
        self
    }

    /// Ends the table after so many rows where it is text; nothing where no table is set yet.
    pub fn rows_in_text(&mut self, most: usize) -> &mut Section {
        if let Some(table) = &mut self.table {
            table.in_text = most;
        }
        self
    }

    /// Adds a sentence below.
    pub fn remark(&mut self, remark: impl Into<String>) -> &mut Section {
        self.remarks.push(remark.into());
        self
    }
}

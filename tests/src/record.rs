//! CSV without quotes, as the commands print it and the case files have it, and the numbers in it.

use std::collections::BTreeMap;

use stage::{About, Precision};

/// One row of a CSV file by the names of its columns.
pub struct Record(BTreeMap<String, String>);

impl Record {
    /// A row that has one column.
    pub fn with(column: &str, text: &str) -> Record {
        Record([(column.to_string(), text.to_string())].into())
    }

    /// The text in a column; empty where there is no such column.
    pub fn text(&self, column: &str) -> &str {
        self.0.get(column).map_or("", String::as_str)
    }

    /// The names of the columns whose text is NaN.
    pub fn nan_columns(&self) -> Vec<&str> {
        let nan = self.0.iter().filter(|(_, text)| text.eq_ignore_ascii_case("nan"));
        nan.map(|(column, _)| column.as_str()).collect()
    }

    /// The number in a column, as f64 has it. Panics where there is none.
    pub fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or_else(|_| panic!("a number in {column}: {:?}", self.0))
    }

    /// The numbers in several columns. Panics where one of them has none.
    pub fn numbers<const N: usize>(&self, columns: [&str; N]) -> [f64; N] {
        columns.map(|column| self.number(column))
    }
}

/// The rows of a CSV text without quotes. Panics where there is no header row.
pub fn records(text: &str) -> Vec<Record> {
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a header row").split(',').collect();
    let record = |line: &str| {
        let fields = names.iter().zip(line.split(','));
        Record(fields.map(|(name, field)| (name.to_string(), field.to_string())).collect())
    };
    lines.map(record).collect()
}

/// A number as a precision reads it. Panics where the text is none.
pub fn number(text: &str, precision: Precision) -> f64 {
    match precision {
        Precision::F32 => text.parse::<f32>().map(f64::from),
        Precision::F64 => text.parse::<f64>(),
    }
    .unwrap_or_else(|_| panic!("`{text}` is no number"))
}

/// The numbers of a case in the order of the stage's columns, as a precision reads them; a word is its
/// place. Panics where a column has neither.
pub fn case_of(record: &Record, about: &About, precision: Precision) -> Vec<f64> {
    let value = |column: &&str| {
        let text = record.text(column);
        match about.words.iter().find(|(name, _)| name == column) {
            None => number(text, precision),
            Some((_, words)) => {
                let place = words.iter().position(|word| *word == text);
                place.unwrap_or_else(|| panic!("`{text}` is none of {words:?}")) as f64
            }
        }
    };
    about.inputs.iter().map(value).collect()
}

//! Case files: CSV with a header row, read one line at a time.

use std::io::{BufRead, Read};

use csv_core::{ReadFieldResult, Reader};
use math::{Real, Vector};

use crate::value::digits;
use crate::{About, Error, Precision, Value, Words};

/// The longest line that is read: longer ones are no cases.
const LONGEST_LINE: u64 = 1 << 20;

/// One field of a line and where it starts.
#[derive(Clone, Debug, PartialEq)]
struct Field {
    text: Vec<u8>,
    /// The byte of the line at which it starts, from 1.
    column: usize,
}

/// One row of a case file: the input columns of its stage, in their order.
#[derive(Debug)]
pub struct Case<'a> {
    file: &'a str,
    line: u64,
    names: &'static [&'static str],
    words: &'static [Words],
    fields: Vec<&'a Field>,
}

impl Case<'_> {
    /// The fields as numbers, each read to the nearest value of the precision.
    ///
    /// [`Error::Request`] with line and column where a field is no number; `nan`, `inf` and 1e400 are
    /// numbers. In a column of words the number is the word's place among them. N is the number of input
    /// columns of the stage.
    pub fn numbers<R: Real, const N: usize>(&self) -> Result<[R; N], Error> {
        let mut numbers = [R::from(0.0); N];
        for ((number, field), name) in numbers.iter_mut().zip(&self.fields).zip(self.names) {
            let text = std::str::from_utf8(&field.text).ok().map(str::trim);
            let words = words_of(self.words, name);
            let read = text.and_then(|text| match words {
                None => R::parse(text),
                Some(words) => Some(R::round_from(words.iter().position(|word| *word == text)? as f64)),
            });
            *number = read.ok_or_else(|| {
                let Case { file, line, .. } = self;
                let (column, found) = (field.column, shown(&field.text));
                let expected = match words {
                    None => "not a number; write a decimal such as -0.5 or 1e-3, or nan, or inf".to_string(),
                    Some(words) => format!("none of {}", words.join(", ")),
                };
                Error::Request(format!("{file}:{line}:{column}: {found} in column `{name}` is {expected}"))
            })?;
        }
        Ok(numbers)
    }
}

impl About {
    /// A case, a number for each of [`About::inputs`], as a row of a case file, in numbers that read back to
    /// the same values of the precision. A word that there is not stays empty.
    pub fn row_of(&self, case: &[f64], precision: Precision) -> String {
        let field = |(name, &number): (&&str, &f64)| match (words_of(self.words, name), precision) {
            (Some(words), _) => words.get(number as usize).copied().unwrap_or_default().to_string(),
            (None, Precision::F32) => format!("{:?}", number as f32),
            (None, Precision::F64) => format!("{number:?}"),
        };
        self.inputs.iter().zip(case).map(field).collect::<Vec<_>>().join(",")
    }
}

/// The words that may stand in a column; `None` for a column of numbers.
pub(crate) fn words_of(words: &[Words], column: &str) -> Option<&'static [&'static str]> {
    words.iter().find(|(name, _)| *name == column).map(|(_, words)| *words)
}

/// One result row: values by the names of their columns. A column without a value stays empty; one that the
/// stage does not write is left out, and of one that is set twice the first value stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row(Vec<(&'static str, String)>);

impl Row {
    /// A row with nothing in it yet.
    pub fn empty() -> Row {
        Row::default()
    }

    /// A row that begins with `hit` = 1.
    pub fn hit() -> Row {
        Row::empty().word("hit", "1")
    }

    /// A row that says `hit` = 0, and why; `reason` is empty where there is none worth naming.
    pub fn miss(reason: &'static str) -> Row {
        Row::empty().word("hit", "0").word("reason", reason)
    }

    /// A row for a case that has no answer, and why.
    pub fn invalid(reason: &'static str) -> Row {
        Row::empty().word("hit", "invalid").word("reason", reason)
    }

    /// Sets a column to a word.
    pub fn word(mut self, column: &'static str, word: &'static str) -> Row {
        self.0.push((column, word.to_string()));
        self
    }

    /// Sets a column to a number, written so that it reads back to the same value.
    pub fn number<R: Real>(mut self, column: &'static str, x: R) -> Row {
        self.0.push((column, digits(x)));
        self
    }

    /// Sets columns to the components of a vector, which has N of them.
    pub fn vector<R: Real, const N: usize>(mut self, columns: [&'static str; N], v: impl Vector<R>) -> Row {
        for (column, &component) in columns.into_iter().zip(v.components()) {
            self.0.push((column, digits(component)));
        }
        self
    }

    /// The row as a line of CSV in the order of `columns`.
    pub(crate) fn line(&self, columns: &[&str]) -> String {
        let value =
            |name: &&str| self.0.iter().find(|(column, _)| column == name).map_or("", |(_, value)| value);
        columns.iter().map(value).collect::<Vec<_>>().join(",")
    }
}

/// Reads cases from CSV: the columns that a stage wants are found by name in the header row.
pub(crate) struct CaseReader<'a, I> {
    input: I,
    file: &'a str,
    line: u64,
    /// How many columns the header has.
    width: usize,
    names: &'static [&'static str],
    words: &'static [Words],
    /// Where each of `names` stands in a row.
    places: Vec<usize>,
    fields: Vec<Field>,
    csv: Reader,
}

impl<'a, I: BufRead> CaseReader<'a, I> {
    /// Reads the header row. `file` is the name that errors give.
    pub(crate) fn new(
        input: I,
        file: &'a str,
        names: &'static [&'static str],
        words: &'static [Words],
    ) -> Result<Self, Error> {
        let (places, fields, csv) = (Vec::new(), Vec::new(), Reader::new());
        let mut reader = CaseReader { input, file, line: 0, width: 0, names, words, places, fields, csv };
        let expected = names.join(",");
        if !reader.read_fields()? {
            return Err(Error::Request(format!(
                "{file}:1:1: the file is empty; its first row names the columns: {expected}"
            )));
        }
        reader.width = reader.fields.len();
        let place =
            |name: &&str| reader.fields.iter().position(|field| field.text.trim_ascii() == name.as_bytes());
        let missing: Vec<&str> = names.iter().copied().filter(|name| place(name).is_none()).collect();
        if !missing.is_empty() {
            let (line, missing) = (reader.line, missing.join(", "));
            return Err(Error::Request(format!(
                "{file}:{line}:1: the header row lacks {missing}; this stage reads the columns {expected}"
            )));
        }
        let twice = reader.fields.iter().enumerate().find(|(at, field)| {
            let name = field.text.trim_ascii();
            let before = reader.fields[..*at].iter().any(|other| other.text.trim_ascii() == name);
            before && names.iter().any(|wanted| wanted.as_bytes() == name)
        });
        if let Some((_, Field { text, column })) = twice {
            let (line, name) = (reader.line, shown(text.trim_ascii()));
            return Err(Error::Request(format!(
                "{file}:{line}:{column}: the column {name} stands twice in the header row; leave one of them out"
            )));
        }
        reader.places = names.iter().filter_map(place).collect();
        Ok(reader)
    }

    /// The next case; `None` at the end of the file. Blank lines are passed over.
    pub(crate) fn next(&mut self) -> Result<Option<Case<'_>>, Error> {
        if !self.read_fields()? {
            return Ok(None);
        }
        let (found, width, line, file) = (self.fields.len(), self.width, self.line, self.file);
        if found != width {
            let at = self.fields.get(width).or(self.fields.last()).map_or(1, |field| field.column);
            return Err(Error::Request(format!(
                "{file}:{line}:{at}: this row's field count is {found}, the header row's {width}; they must be the same"
            )));
        }
        let fields = self.places.iter().map(|&place| &self.fields[place]).collect();
        Ok(Some(Case { file, line, names: self.names, words: self.words, fields }))
    }

    /// Reads the next line that is not blank into `fields`; false at the end of the file.
    fn read_fields(&mut self) -> Result<bool, Error> {
        let mut line = Vec::new();
        while is_blank(&line) {
            line.clear();
            let read = (&mut self.input).take(LONGEST_LINE).read_until(b'\n', &mut line);
            self.line += 1;
            let (file, number) = (self.file, self.line);
            match read {
                Ok(0) => return Ok(false),
                Ok(bytes) if bytes as u64 == LONGEST_LINE && !line.ends_with(b"\n") => {
                    return Err(Error::Request(format!(
                        "{file}:{number}:{bytes}: a line of more than {LONGEST_LINE} bytes is no case; is this a case file?"
                    )));
                }
                Ok(_) => {}
                Err(error) => {
                    return Err(Error::Failed(format!("{file}:{number}: cannot read on: {error}")));
                }
            }
        }
        let line = line.trim_ascii_end();
        let (file, number) = (self.file, self.line);
        if let Some(at) = line.iter().position(|&byte| byte == b'\r') {
            let column = at + 1;
            return Err(Error::Request(format!(
                "{file}:{number}:{column}: a carriage return inside a line; end the lines with \\n or \\r\\n"
            )));
        }
        self.fields = split(&mut self.csv, line).ok_or_else(|| {
            let end = line.len();
            Error::Request(format!(
                "{file}:{number}:{end}: a quoted field does not end on its line; close it with \""
            ))
        })?;
        Ok(true)
    }
}

/// Whether a line shows nothing: white space, perhaps after a byte order mark, which is passed over at the
/// start of any line.
fn is_blank(line: &[u8]) -> bool {
    line.strip_prefix("\u{feff}".as_bytes()).unwrap_or(line).trim_ascii().is_empty()
}

/// The fields of one line of CSV; `None` where a quoted field does not end.
fn split(reader: &mut Reader, line: &[u8]) -> Option<Vec<Field>> {
    reader.reset();
    let mut text = vec![0; line.len() + 1];
    let mut input: &[u8] = &[line, b"\n"].concat();
    let mut fields = Vec::new();
    let mut column = 1;
    loop {
        match reader.read_field(input, &mut text) {
            (ReadFieldResult::Field { record_end }, read, written) => {
                fields.push(Field { text: text[..written].to_vec(), column });
                if record_end {
                    return Some(fields);
                }
                column += read;
                input = &input[read..];
            }
            _ => return None,
        }
    }
}

/// A field for an error message: short, and printable whatever its bytes are.
fn shown(text: &[u8]) -> String {
    if text.is_empty() {
        return "an empty field".to_string();
    }
    let (start, more) = if text.len() > 40 { (&text[..40], "…") } else { (text, "") };
    let start: String = String::from_utf8_lossy(start).chars().flat_map(char::escape_debug).collect();
    Value::text(format!("`{start}{more}`")).to_text()
}

#[cfg(test)]
mod tests {
    use super::*;

    const NAMES: &[&str] = &["ox", "dx"];
    const WORDS: &[Words] = &[("dx", &["left", "right"])];

    fn read(text: &[u8]) -> Result<Vec<[f64; 2]>, Error> {
        let mut reader = CaseReader::new(text, "cases.csv", NAMES, &[])?;
        let mut rows = Vec::new();
        while let Some(case) = reader.next()? {
            rows.push(case.numbers()?);
        }
        Ok(rows)
    }

    fn message(text: &[u8]) -> String {
        let error = read(text).unwrap_err();
        assert_eq!(error.status(), 2);
        error.to_string()
    }

    #[test]
    fn columns_are_found_by_name_and_others_ignored() {
        let rows = read(b"\xef\xbb\xbfremark,dx,ox\r\n\"a, \"\"b\"\"\",1,2\r\n\r\nc, 3 ,4").unwrap();
        assert_eq!(rows, [[2.0, 1.0], [4.0, 3.0]]);
    }

    #[test]
    fn a_line_with_nothing_but_a_mark_is_blank() {
        let mark = "\u{feff}";
        let rows = read(format!("{mark}\n{mark}ox,dx\n{mark} \r\n{mark}1,2\n").as_bytes()).unwrap();
        assert_eq!(rows, [[1.0, 2.0]]);
        assert!(message(mark.as_bytes()).contains("the file is empty"));
    }

    #[test]
    fn nan_inf_and_overflow_are_numbers() {
        let rows = read(b"ox,dx\nnan,-inf\n1e400,5e-324\n").unwrap();
        assert!(rows[0][0].is_nan());
        assert_eq!((rows[0][1], rows[1]), (f64::NEG_INFINITY, [f64::INFINITY, 5e-324]));
    }

    #[test]
    fn a_number_is_rounded_once_to_f32() {
        // just above the middle of 1 and its f32 successor: through f64 it would round down, to even
        let text = b"ox,dx\n1.00000005960464477540,0\n";
        let mut reader = CaseReader::new(&text[..], "cases.csv", NAMES, &[]).unwrap();
        let [x, _] = reader.next().unwrap().unwrap().numbers::<f32, 2>().unwrap();
        assert_eq!(x, 1.0 + f32::EPSILON);
        assert_eq!(1.000_000_059_604_644_8_f64 as f32, 1.0);
    }

    #[test]
    fn a_word_is_its_place() {
        let text = b"ox,dx\n3, right\n0,left\n0,1\n";
        let mut reader = CaseReader::new(&text[..], "cases.csv", NAMES, WORDS).unwrap();
        let mut next = || reader.next().unwrap().unwrap().numbers::<f64, 2>();
        assert_eq!([next().unwrap(), next().unwrap()], [[3.0, 1.0], [0.0, 0.0]]);
        let message = next().unwrap_err().to_string();
        assert_eq!(message, "cases.csv:4:3: `1` in column `dx` is none of left, right");
    }

    #[test]
    fn errors_name_line_and_column() {
        let start = |text: &[u8]| message(text).split(": ").next().unwrap().to_string();
        assert_eq!(start(b"ox,dx\n1,2\n\"3\",abc\n"), "cases.csv:3:5");
        assert_eq!(start(b"ox,dx\n1,\n"), "cases.csv:2:3");
        assert_eq!(start(b"ox,dx\n\n\n1,2,3\n"), "cases.csv:4:5", "blank lines count");
        assert_eq!(start(b"ox,dx\n1\n"), "cases.csv:2:1");
        assert_eq!(start(b"ox,dy\n"), "cases.csv:1:1");
        assert_eq!(start(b""), "cases.csv:1:1");
        assert_eq!(start(b"ox,dx\n\"1,2\n"), "cases.csv:2:4");
        assert!(message(b"ox,dx\n1,abc\n").contains("`abc` in column `dx`"));
    }

    #[test]
    fn garbage_is_refused_in_print() {
        let text = message(b"ox,dx\n\xff\x00\x1b[31m,1\n");
        assert!(text.chars().all(|letter| !letter.is_control()), "{text:?}");
        assert!(message(&[0xff; 100]).contains("the header row lacks"));
        assert!(message(&[b'a'; 1 << 21]).contains("more than"));
    }
}

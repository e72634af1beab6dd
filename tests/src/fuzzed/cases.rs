//! A case file of any bytes.

use stage::{Error, Precision};

use super::{Bytes, NAME, answered};
use crate::{judge, records};

/// The first byte chooses the stage; the second the precision, whether the header row is put in front, and
/// the method; the rest is the case file. It is answered row by row, or refused with the place of the
/// fault.
///
/// The error says what is wrong with the answer or with the refusal.
pub fn cases(bytes: &[u8]) -> Result<(), String> {
    let mut bytes = Bytes(bytes);
    let stage = bytes.stage();
    let about = stage.about();
    let how = bytes.choice();
    let [precision, header, method] = [how % 2, how / 2 % 2, how / 4 % about.methods.len()];
    let header = if header == 1 { format!("{}\n", about.inputs.join(",")) } else { String::new() };
    let text = [header.as_bytes(), bytes.0].concat();
    let lines: Vec<&[u8]> = text.split_inclusive(|byte| *byte == b'\n').collect();

    let (output, ended) = answered(stage, method, Precision::ALL[precision], &text);
    // Up to where the file is answered: all of it, or the line at fault.
    let before = match &ended {
        Ok(()) => lines.len(),
        Err(error) => line_at_fault(error, &lines)? - 1,
    };
    let rows = lines[..before].iter().filter(|line| !is_blank(line)).count();
    if output.lines().count() != rows {
        return Err(format!("{rows} lines of cases, header included, and\n{output}"));
    }
    if rows == 0 {
        return Ok(());
    }
    let width = about.results.len();
    match output.lines().find(|line| line.split(',').count() != width) {
        Some(line) => Err(format!("`{line}` has not {width} fields")),
        None => records(&output).iter().find_map(judge::disorder).map_or(Ok(()), Err),
    }
}

/// The line that an error names, from 1; or what is wrong with the error.
fn line_at_fault(error: &Error, lines: &[&[u8]]) -> Result<usize, String> {
    let text = error.to_string();
    let fault = |what: &str| Err(format!("{what}: status {}, {text:?}", error.status()));
    if error.status() != 2 || text.chars().any(char::is_control) {
        return fault("not refused in print");
    }
    let place = text.strip_prefix(NAME).and_then(|text| text.strip_prefix(':'));
    let mut numbers = place.into_iter().flat_map(|place| place.splitn(3, ':')).map(str::parse::<usize>);
    let (Some(Ok(line)), Some(Ok(column))) = (numbers.next(), numbers.next()) else {
        return fault("without a place");
    };
    // An empty file has a first line, and a line may end too early.
    let length = lines.get(line.wrapping_sub(1)).map(|line| line.len());
    match length.or((line == lines.len() + 1).then_some(0)) {
        Some(length) if (1..=length + 1).contains(&column) => {}
        _ => return fault("at a place that there is not"),
    }
    let quoted = lines.get(line - 1).is_some_and(|line| line.contains(&b'"'));
    if text.contains("a quoted field does not end") && !quoted {
        return fault("there is no quote");
    }
    Ok(line)
}

/// Nothing but white space, which a case file may have anywhere; a byte order mark shows as little.
fn is_blank(line: &[u8]) -> bool {
    line.strip_prefix("\u{feff}".as_bytes()).unwrap_or(line).trim_ascii().is_empty()
}

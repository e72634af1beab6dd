//! For a spreadsheet: RFC 4180, and nothing that a spreadsheet would take for a formula.

use csv_core::{Terminator, WriterBuilder};

use super::{Part, Report, Status};

const COLUMNS: [&str; 11] = [
    "student",
    "folder",
    "exercise",
    "status",
    "score",
    "points",
    "properties",
    "symbol",
    "expected",
    "got",
    "mistake",
];

/// A line a submission, the columns named in the first.
pub(crate) fn csv(reports: &[Report]) -> String {
    let mut text = line(&COLUMNS.map(String::from));
    for it in reports {
        let part = |it: &Part| format!("{} {}/{}", it.name, it.score, it.points);
        let properties: Vec<String> = it.properties.iter().map(part).collect();
        let [symbol, expected, got] = first_wrong(it);
        let mistake = it.mistake.as_ref().map(|(name, _)| name.clone()).unwrap_or_default();
        text += &line(&[
            guarded(&it.student),
            guarded(&it.folder),
            guarded(&it.exercise),
            it.status.name().to_string(),
            it.score.to_string(),
            it.points.to_string(),
            guarded(&properties.join("; ")),
            guarded(&symbol),
            guarded(&expected),
            guarded(&got),
            guarded(&mistake),
        ]);
    }
    text
}

/// Symbol, what is expected, and what came instead; of what was not judged, why.
fn first_wrong(report: &Report) -> [String; 3] {
    let why = || report.output.lines().next().unwrap_or_default().to_string();
    match &report.wrong {
        Some(it) => [it.symbol.clone(), it.expected.clone(), it.got.clone()],
        None if report.status == Status::Right => Default::default(),
        None => [String::new(), String::new(), why()],
    }
}

/// A field that a spreadsheet would take for a formula gets an apostrophe before it.
fn guarded(field: &str) -> String {
    let formula = field.starts_with(['=', '+', '-', '@', '\t', '\r', '＝', '＋', '－', '＠']);
    // a number may well have a sign
    if formula && field.parse::<f64>().is_err() { format!("'{field}") } else { field.to_string() }
}

fn line(fields: &[String]) -> String {
    let mut writer = WriterBuilder::new().terminator(Terminator::CRLF).build();
    // every letter may be a quote, which is written twice
    let longest: usize = fields.iter().map(|field| field.len() * 2 + 3).sum();
    let (mut bytes, mut end) = (vec![0; longest + 16], 0);
    for (number, field) in fields.iter().enumerate() {
        if number > 0 {
            end += writer.delimiter(&mut bytes[end..]).1;
        }
        end += writer.field(field.as_bytes(), &mut bytes[end..]).2;
    }
    end += writer.terminator(&mut bytes[end..]).1;
    String::from_utf8_lossy(&bytes[..end]).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::three;

    #[test]
    fn quotes_are_doubled_and_formulas_are_text() {
        let text = csv(&three());
        let lines: Vec<&str> = text.split_terminator("\r\n").collect();
        assert_eq!(lines.len(), 4);
        assert_eq!(
            lines[1],
            "ada,class/ada,ray-sphere/closest-approach,right,3,3,straight at it 1/1; from inside 2/2,,,,"
        );
        assert!(lines[2].starts_with("\"bob, \"\"the\"\" second\",class/bob,"), "{}", lines[2]);
        assert!(lines[2].ends_with(",t_close,1,2,direction-not-unit"), "{}", lines[2]);
        assert!(lines[3].starts_with("\"'=HYPERLINK(\"\"x\"\")\","), "{}", lines[3]);
        assert!(lines[3].ends_with(",it is no hand-out,"), "{}", lines[3]);
    }

    #[test]
    fn a_number_keeps_its_sign() {
        for (field, kept) in
            [("-3.5", "-3.5"), ("-3+cmd", "'-3+cmd"), ("@a", "'@a"), ("a=b", "a=b"), ("", "")]
        {
            assert_eq!(guarded(field), kept);
        }
    }
}

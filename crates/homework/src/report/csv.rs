//! For a spreadsheet: RFC 4180, and nothing that a spreadsheet would take for a formula.

use csv_core::{Terminator, WriterBuilder};

use super::{Part, Report};

const BEFORE: [&str; 6] = ["student", "folder", "exercise", "status", "score", "points"];
const AFTER: [&str; 5] = ["symbol", "expected", "got", "mistake", "message"];

/// A line a submission, the columns named in the first: between others one for each property, with what was
/// earned by it, and empty where the submission is for another exercise.
pub(crate) fn csv(reports: &[Report]) -> String {
    let mut properties: Vec<(&str, &Part)> = Vec::new();
    for (exercise, part) in
        reports.iter().flat_map(|it| it.properties.iter().map(|part| (&*it.exercise, part)))
    {
        if !properties.iter().any(|(of, it)| (*of, &it.name) == (exercise, &part.name)) {
            properties.push((exercise, part));
        }
    }
    // where there are several exercises, each names its own
    let one = properties.windows(2).all(|two| two[0].0 == two[1].0);
    let heading = |(exercise, part): &(&str, &Part)| {
        let of = if one { String::new() } else { format!("{exercise}: ") };
        guarded(&format!("{of}{} (of {})", part.name, part.points))
    };
    let columns = BEFORE.map(String::from).into_iter().chain(properties.iter().map(heading));
    let mut text = line(&columns.chain(AFTER.map(String::from)).collect::<Vec<_>>());
    for it in reports {
        let earned = |(exercise, part): &(&str, &Part)| {
            let mine = it.properties.iter().find(|mine| *exercise == it.exercise && mine.name == part.name);
            mine.map(|mine| mine.score.to_string()).unwrap_or_default()
        };
        let before = [&it.student, &it.folder, &it.exercise].map(|field| guarded(field));
        let before =
            before.into_iter().chain([it.status.name().into(), it.score.to_string(), it.points.to_string()]);
        let after = after(it).map(|field| guarded(&field));
        text += &line(&before.chain(properties.iter().map(earned)).chain(after).collect::<Vec<_>>());
    }
    text
}

/// Of the first value that is wrong: symbol, what is expected, and what came instead; the name of the
/// mistake; what is said of all of it, in one line.
fn after(report: &Report) -> [String; 5] {
    // a spreadsheet knows no other minus
    let numbers = |text: &str| text.replace('−', "-");
    let [symbol, expected, got] = match &report.wrong {
        Some(it) => [it.symbol.clone(), numbers(&it.expected), numbers(&it.got)],
        None => Default::default(),
    };
    let mistake = report.mistake.as_ref().map(|(name, _)| name.clone()).unwrap_or_default();
    let lines = report.output.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "));
    let message = lines.filter(|line| !line.is_empty()).collect::<Vec<_>>().join("; ");
    [symbol, expected, got, mistake, message]
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
            lines[0],
            "student,folder,exercise,status,score,points,straight at it (of 1),from inside (of 2),\
             symbol,expected,got,mistake,message"
        );
        assert_eq!(
            lines[1],
            "ada,class/ada,ray-sphere/closest-approach,right,3,3,1,2,,,,,All of it is right."
        );
        assert!(lines[2].starts_with("\"bob, \"\"the\"\" second\",class/bob,"), "{}", lines[2]);
        let of_bob = ",wrong,1,3,1,0,t_close,1,2,direction-not-unit,\
                      The first value that is wrong:; symbol t_close";
        assert!(lines[2].ends_with(of_bob), "{}", lines[2]);
        assert!(lines[3].starts_with("\"'=HYPERLINK(\"\"x\"\")\","), "{}", lines[3]);
        assert!(lines[3].ends_with(",refused,0,0,,,,,,,it is no hand-out"), "{}", lines[3]);
    }

    #[test]
    fn properties_of_several_exercises_are_kept_apart_and_a_minus_is_one() {
        let mut reports = three();
        reports[1].exercise = "ray-wall/first-hit".into();
        let wrong = reports[1].wrong.as_mut().unwrap();
        (wrong.expected, wrong.got) = ("−3.5".into(), "(0, −1, 2)".into());
        let text = csv(&reports);
        let lines: Vec<&str> = text.split_terminator("\r\n").collect();
        for name in
            ["ray-sphere/closest-approach: straight at it (of 1)", "ray-wall/first-hit: from inside (of 2)"]
        {
            assert!(lines[0].contains(name), "{}", lines[0]);
        }
        assert!(lines[1].contains(",right,3,3,1,2,,,"), "{}", lines[1]);
        assert!(lines[2].contains(",wrong,1,3,,,1,0,t_close,-3.5,\"(0, -1, 2)\","), "{}", lines[2]);
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

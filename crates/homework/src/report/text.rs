//! As a table to read.

use super::{Report, Status, one_line};

/// A line a submission, and how many of each kind there are.
pub(crate) fn text(reports: &[Report]) -> String {
    let score = |it: &Report| format!("{} of {}", it.score, it.points);
    let columns = |it: &Report| [it.student.clone(), it.exercise.clone(), score(it), remark(it)];
    let heading = ["student", "exercise", "points", "the first value that is wrong"].map(String::from);
    let rows: Vec<[String; 4]> = [heading].into_iter().chain(reports.iter().map(columns)).collect();
    let widest = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let [student, exercise, points] = [0, 1, 2].map(widest);
    let mut text = String::new();
    for [a, b, c, d] in &rows {
        text += format!("{a:student$}  {b:exercise$}  {c:points$}  {d}").trim_end();
        text += "\n";
    }
    let count = |status: Status| reports.iter().filter(|it| it.status == status).count();
    let kinds = [Status::Right, Status::Wrong, Status::NotCompiled, Status::Refused];
    let kinds = kinds.map(|kind| (count(kind), kind.name())).into_iter().filter(|(count, _)| *count > 0);
    let kinds: Vec<String> = kinds.map(|(count, name)| format!("{count} {name}")).collect();
    text + &format!("\n{} submissions: {}\n", reports.len(), kinds.join(", "))
}

/// What a hole of the hand-out says.
const UNTOUCHED: &str = ": not yet implemented: ";

/// What stands behind the points.
fn remark(report: &Report) -> String {
    let mistake = report.mistake.as_ref().map(|(name, _)| format!(" ({name})")).unwrap_or_default();
    match (report.status, &report.wrong) {
        (Status::Right, _) => String::new(),
        (Status::Wrong, Some(it)) if it.got.contains(UNTOUCHED) => {
            let place = it.got.strip_prefix("a panic at ").and_then(|rest| rest.split(UNTOUCHED).next());
            format!("{}: not done yet, {} still asks", it.property, place.unwrap_or("it"))
        }
        (Status::Wrong, Some(it)) => {
            let (expected, got) = (one_line(&it.expected, 40), one_line(&it.got, 90));
            format!("{}: {} should be {expected}; got {got}{mistake}", it.property, symbol(&it.symbol))
        }
        // the compiler names the file in its second line
        (Status::NotCompiled, _) => {
            let lines: Vec<&str> = report.output.lines().take(2).map(str::trim).collect();
            format!("does not compile: {}", one_line(&lines.join(" "), 120))
        }
        _ => one_line(report.output.lines().next().unwrap_or_default(), 120),
    }
}

fn symbol(symbol: &str) -> &str {
    if symbol.is_empty() { "a value" } else { symbol }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::three;

    #[test]
    fn a_line_a_submission() {
        let by_hand = "\
student            exercise                     points  the first value that is wrong
ada                ray-sphere/closest-approach  3 of 3
bob, \"the\" second  ray-sphere/closest-approach  1 of 3  from inside: t_close should be 1; got 2 (direction-not-unit)
=HYPERLINK(\"x\")                                 0 of 0  it is no hand-out

3 submissions: 1 right, 1 wrong, 1 refused
";
        assert_eq!(text(&three()), by_hand);
    }
}

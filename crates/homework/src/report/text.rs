//! As a table to read.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::{End, Report, Status, one_line};

/// A line a submission, how many of each kind there are, and how each exercise went.
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
    text += &format!("\n{}: {}\n", counted(reports.len(), "submission"), kinds.join(", "));
    if reports.len() > 1 {
        text += &by_exercise(reports);
    }
    text
}

/// For each exercise how many have all its points, and the mistake that most of them make.
fn by_exercise(reports: &[Report]) -> String {
    let mut exercises: BTreeMap<&str, Vec<&Report>> = BTreeMap::new();
    for it in reports.iter().filter(|it| !it.exercise.is_empty()) {
        exercises.entry(&it.exercise).or_default().push(it);
    }
    let line = |(exercise, all): (&str, Vec<&Report>)| {
        let full = all.iter().filter(|it| it.status == Status::Right).count();
        let mut mistakes: BTreeMap<&str, usize> = BTreeMap::new();
        for (name, _) in all.iter().filter_map(|it| it.mistake.as_ref()) {
            *mistakes.entry(name).or_default() += 1;
        }
        // of those that are equally common the first by name
        let most = mistakes.iter().min_by_key(|&(_, &count)| Reverse(count));
        let most = most.map(|(name, &count)| format!("; most often {name}, {}", counted(count, "time")));
        format!("  {exercise}: {full} of {} with all the points{}\n", all.len(), most.unwrap_or_default())
    };
    exercises.into_iter().map(line).collect()
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// What stands behind the points.
fn remark(report: &Report) -> String {
    let mistake = report.mistake.as_ref().map(|(name, _)| format!(" ({name})")).unwrap_or_default();
    match (report.status, &report.wrong) {
        (Status::Right, _) => String::new(),
        (Status::Wrong, Some(it)) => match &it.end {
            Some(End::Asks(place)) => format!("{}: not done yet, {place} still asks", it.property),
            Some(End::Program(how)) => format!("{}: for {}, {how}", it.property, one_line(&it.given, 60)),
            None => {
                let (expected, got) = (one_line(&it.expected, 40), one_line(&it.got, 90));
                format!("{}: {} should be {expected}; got {got}{mistake}", it.property, symbol(&it.symbol))
            }
        },
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
  ray-sphere/closest-approach: 1 of 2 with all the points; most often direction-not-unit, 1 time
";
        assert_eq!(text(&three()), by_hand);
        assert!(text(&three()[..1]).ends_with("\n1 submission: 1 right\n"));
    }

    #[test]
    fn the_end_of_a_program_is_told_with_its_case_and_a_hole_with_its_place() {
        let ended = |end: End| {
            let mut report = three().swap_remove(1);
            report.mistake = None;
            report.wrong.as_mut().unwrap().end = Some(end);
            remark(&report)
        };
        let crashed = ended(End::Program("the program crashed (SIGSEGV)".into()));
        assert_eq!(crashed, "from inside: for o = (0, 0, 4), the program crashed (SIGSEGV)");
        let asks = ended(End::Asks("src/a.rs:3".into()));
        assert_eq!(asks, "from inside: not done yet, src/a.rs:3 still asks");
    }
}

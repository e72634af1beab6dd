//! What is said of a submission.

mod csv;
mod gradescope;
mod json;
mod text;

use exercise::{Answer, Sheet, Wrong, asks, ended, first_wrong_step, got, next, told};

use crate::Exercise;
use crate::attempt::Outcome;
use crate::judge::{Verdict, judge};
use crate::submission::Submission;

pub(crate) use csv::csv;
pub(crate) use gradescope::gradescope;
pub(crate) use json::{json, json_of};
pub(crate) use text::text;

/// What is said of a submission.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Report {
    /// Whose it is: the name of the folder.
    pub(crate) student: String,
    /// Where it is.
    pub(crate) folder: String,
    /// The exercise; empty where it is not known.
    pub(crate) exercise: String,
    /// How it went.
    pub(crate) status: Status,
    /// What it earns,
    pub(crate) score: u32,
    /// of so much.
    pub(crate) points: u32,
    /// The same by property.
    pub(crate) properties: Vec<Part>,
    /// The first value that is wrong.
    pub(crate) wrong: Option<FirstWrong>,
    /// The name of the mistake, and the sentence that helps.
    pub(crate) mistake: Option<(String, String)>,
    /// Some lines for the student.
    pub(crate) output: String,
}

/// How a submission went.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Status {
    /// All of it is right.
    Right,
    /// Something is wrong.
    Wrong,
    /// It does not compile.
    NotCompiled,
    /// There was nothing to grade.
    Refused,
}

impl Status {
    /// As the formats have it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Status::Right => "right",
            Status::Wrong => "wrong",
            Status::NotCompiled => "does not compile",
            Status::Refused => "refused",
        }
    }
}

/// A property and what was earned by it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    pub(crate) name: String,
    pub(crate) score: u32,
    pub(crate) points: u32,
    /// What is wrong first in it, if anything is.
    pub(crate) output: String,
}

/// The first value that is wrong, in words.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FirstWrong {
    pub(crate) property: String,
    pub(crate) given: String,
    pub(crate) symbol: String,
    pub(crate) formula: String,
    pub(crate) expected: String,
    pub(crate) got: String,
    pub(crate) ulps: Option<f64>,
    /// Where the notes have it.
    pub(crate) page: String,
    /// What ended the answer in place of a value, if something did.
    pub(crate) end: Option<End>,
}

/// What ended an answer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum End {
    /// A hole of the hand-out, which still asks: where it is.
    Asks(String),
    /// The whole program ended: how.
    Program(String),
}

impl Report {
    /// Of a folder that is no submission.
    pub(crate) fn refused(submission: &Submission, exercise: Option<&Exercise>, why: &str) -> Report {
        let property = |it: &cutter::manifest::Asked| Part {
            name: it.name.clone(),
            score: 0,
            points: it.points,
            output: String::new(),
        };
        let properties = exercise.map(|it| it.manifest.properties.iter().map(property).collect());
        Report {
            student: one_line(&submission.student, 200),
            folder: one_line(&submission.folder.display().to_string(), 1000),
            exercise: exercise.map(|it| it.manifest.name.clone()).unwrap_or_default(),
            status: Status::Refused,
            score: 0,
            points: exercise.map_or(0, Exercise::points),
            properties: properties.unwrap_or_default(),
            wrong: None,
            mistake: None,
            output: clean(why, MOST_OUTPUT),
        }
    }

    /// Of what became of an attempt.
    pub(crate) fn of(
        submission: &Submission,
        exercise: &Exercise,
        sheet: &Sheet,
        outcome: &Outcome,
    ) -> Report {
        let none = |why: &str| Report::refused(submission, Some(exercise), why);
        match outcome {
            Outcome::Refused(why) => none(why),
            Outcome::NotBuilt(words) => Report { status: Status::NotCompiled, ..none(words) },
            Outcome::Answered(answers) => {
                let verdict = judge(exercise, sheet, answers);
                Report::judged(none(""), exercise, sheet, answers, &verdict)
            }
        }
    }

    fn judged(
        mut report: Report,
        exercise: &Exercise,
        sheet: &Sheet,
        answers: &[Answer],
        verdict: &Verdict,
    ) -> Report {
        report.score = verdict.earned;
        for (number, (part, &right)) in report.properties.iter_mut().zip(&verdict.right).enumerate() {
            part.score = if right { part.points } else { 0 };
            part.output = first_of(sheet, answers, number).unwrap_or_default();
        }
        let Some(wrong) = &verdict.wrong else {
            return Report { status: Status::Right, output: "All of it is right.".to_string(), ..report };
        };
        let none = Answer::default();
        let answer = answers.get(wrong.row).unwrap_or(&none);
        report.output = match (asks(wrong, answer), ended(wrong, answer)) {
            // as `cargo run` says it in the hand-out
            (Some(_), _) => clean(&next(sheet, wrong, answer), MOST_OUTPUT),
            (None, end) => {
                let said = clean(&told(sheet, wrong, answer), MOST_OUTPUT);
                let first =
                    if end.is_some() { "It ends in this case" } else { "The first value that is wrong" };
                format!("{first}:\n{said}\n  page      {}", exercise.manifest.page)
            }
        };
        if let Some(known) = verdict.mistake {
            report.output += &format!("\n\nThis looks like `{}`. {}", known.name, known.says);
            report.mistake = Some((known.name.clone(), known.says.clone()));
        }
        Report { status: Status::Wrong, wrong: Some(in_words(exercise, sheet, wrong, answer)), ..report }
    }
}

/// The first value that is wrong in a property.
fn first_of(sheet: &Sheet, answers: &[Answer], property: usize) -> Option<String> {
    let none = Answer::default();
    (0..sheet.rows.len()).filter(|&row| sheet.rows[row].property == property).find_map(|row| {
        let answer = answers.get(row).unwrap_or(&none);
        let wrong = first_wrong_step(&sheet.rows[row].steps, answer)?;
        Some(clean(&told(sheet, &Wrong { row, ..wrong }, answer), MOST_OUTPUT))
    })
}

fn in_words(exercise: &Exercise, sheet: &Sheet, wrong: &Wrong, answer: &Answer) -> FirstWrong {
    let ended = ended(wrong, answer);
    let asks = asks(wrong, answer).map(|(place, _)| End::Asks(one_line(place, 200)));
    // where the whole program ended, or something is still to be done, no step is to blame
    let is_ended = ended.is_some() || asks.is_some();
    let expected = wrong.expected.as_ref().filter(|_| !is_ended);
    let nothing = if is_ended { "an answer" } else { "nothing more" };
    FirstWrong {
        property: sheet.properties[sheet.rows[wrong.row].property].name.clone(),
        given: sheet.case(wrong.row).to_string(),
        symbol: expected.map(|it| it.symbol.clone()).unwrap_or_default(),
        formula: expected.map(|it| it.formula.clone()).unwrap_or_default(),
        expected: expected.map_or(nothing.to_string(), |it| it.value.to_string()),
        got: one_line(&got(wrong, answer), 200),
        ulps: wrong.ulps.filter(|it| it.is_finite()),
        page: exercise.manifest.page.clone(),
        end: asks.or(ended.map(|how| End::Program(one_line(how, 200)))),
    }
}

/// So many letters of what a submission or the compiler says are kept.
const MOST_OUTPUT: usize = 8000;

/// What a submission made is shown without what would move a terminal's cursor or turn the direction of the
/// letters, and not without end.
pub(crate) fn clean(text: &str, most: usize) -> String {
    let harmless = |sign: char| match sign {
        '\n' => '\n',
        '\t' => ' ',
        '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => '\u{fffd}',
        _ if sign.is_control() => '\u{fffd}',
        _ => sign,
    };
    let mut clean: String = text.chars().take(most).map(harmless).collect();
    if text.chars().nth(most).is_some() {
        clean += " […]";
    }
    clean
}

/// The same in one line.
pub(crate) fn one_line(text: &str, most: usize) -> String {
    clean(text, most).replace('\n', " ")
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// Three submissions as the formats are to show them.
    pub(crate) fn three() -> Vec<Report> {
        let part = |name: &str, score, points| Part {
            name: name.into(),
            score,
            points,
            output: if score < points { "  symbol    t_close".into() } else { String::new() },
        };
        let right = Report {
            student: "ada".into(),
            folder: "class/ada".into(),
            exercise: "ray-sphere/closest-approach".into(),
            status: Status::Right,
            score: 3,
            points: 3,
            properties: vec![part("straight at it", 1, 1), part("from inside", 2, 2)],
            wrong: None,
            mistake: None,
            output: "All of it is right.".into(),
        };
        let wrong = FirstWrong {
            property: "from inside".into(),
            given: "o = (0, 0, 4)".into(),
            symbol: "t_close".into(),
            formula: "u_r · (c − p_r)".into(),
            expected: "1".into(),
            got: "2".into(),
            ulps: Some(4503599627370496.0),
            page: "House 4.4".into(),
            end: None,
        };
        let mistaken = Report {
            student: "bob, \"the\" second".into(),
            folder: "class/bob".into(),
            status: Status::Wrong,
            score: 1,
            properties: vec![part("straight at it", 1, 1), part("from inside", 0, 2)],
            wrong: Some(wrong),
            mistake: Some(("direction-not-unit".into(), "D has another length.".into())),
            output: "The first value that is wrong:\n  symbol    t_close".into(),
            ..right.clone()
        };
        let refused = Report {
            student: "=HYPERLINK(\"x\")".into(),
            folder: "class/=HYPERLINK(\"x\")".into(),
            exercise: String::new(),
            status: Status::Refused,
            score: 0,
            points: 0,
            properties: Vec::new(),
            output: "it is no hand-out".into(),
            ..right.clone()
        };
        vec![right, mistaken, refused]
    }

    /// What was right before the hole is lost with the answer: no symbol is wrong.
    #[test]
    fn a_hole_that_still_asks_is_blamed_on_no_symbol() {
        let catalog = crate::Catalog::read().unwrap();
        let (exercise, sheet) = (&catalog.exercises[0], catalog.exercises[0].sheet());
        let message = "not yet implemented: What is x?".to_string();
        let broken = exercise::Broken { message, place: "src/a.rs:3".into() };
        let answers = vec![Answer { broken: Some(broken), ..Answer::default() }; sheet.rows.len()];
        let wrong = judge(exercise, &sheet, &answers).wrong.unwrap();
        let words = in_words(exercise, &sheet, &wrong, &answers[0]);
        assert_eq!(
            (words.symbol.as_str(), words.formula.as_str(), words.expected.as_str()),
            ("", "", "an answer")
        );
        assert_eq!(words.end, Some(End::Asks("src/a.rs:3".into())));
    }

    #[test]
    fn what_a_submission_says_cannot_take_the_terminal_over() {
        assert_eq!(clean("a\x1b[2Jb\tc\nd\u{202e}e\r", 100), "a\u{fffd}[2Jb c\nd\u{fffd}e\u{fffd}");
        assert_eq!(clean("äöüß", 3), "äöü […]");
        assert_eq!(one_line("a\nb", 9), "a b");
    }
}

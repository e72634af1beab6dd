//! Cases with what is expected of them, and answers to them, as text: a line each, its fields between tabs.
//!
//! ```text
//! exercise  ray-sphere/closest-approach
//! columns   ox oy …
//! property  from inside  2
//! case      0 0 …
//! step      t_close  u_r · (c − p_r)  number  3.1622776601683795  0.000000000000002
//! ```
//!
//! The last field of a step is its tolerance. Answers have `case` with the number of the row, `step` without
//! tolerances, and `broken` with a message and a place.

use std::fmt::Write;

use crate::value::one_line;
use crate::{Case, Step, Steps, Value};

/// What an answer can be right about, and what that counts.
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// "from inside"
    pub name: String,
    /// So much it adds to the grade.
    pub points: u32,
}

/// A case with what is expected.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Which property it shows, by its place in [`Sheet::properties`].
    pub property: usize,
    /// The case's numbers, one for each of [`Sheet::columns`].
    pub numbers: Vec<f64>,
    /// What is expected, with tolerances.
    pub steps: Steps,
}

/// An exercise's cases with what is expected of each.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// `ray-sphere/closest-approach`
    pub exercise: String,
    /// The names of the numbers of a case.
    pub columns: Vec<String>,
    /// The properties, in the order in which they are looked at.
    pub properties: Vec<Property>,
    /// The cases, those of a property together.
    pub rows: Vec<Row>,
}

/// How some code ended before its case did.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// The panic's message.
    pub message: String,
    /// File and line; empty where the program ended without a panic.
    pub place: String,
}

/// What some code makes of a case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// So far it came.
    pub steps: Steps,
    /// And there it ended, if it did.
    pub broken: Option<Broken>,
}

impl Sheet {
    /// A row as a case, by its place in [`Sheet::rows`].
    pub fn case(&self, row: usize) -> Case<'_> {
        Case::new(&self.columns, &self.rows[row].numbers)
    }

    /// The sheet as text.
    pub fn to_text(&self) -> String {
        let mut text = format!("exercise\t{}\ncolumns\t{}\n", self.exercise, self.columns.join(" "));
        for (number, property) in self.properties.iter().enumerate() {
            let _ = writeln!(text, "property\t{}\t{}", property.name, property.points);
            for row in self.rows.iter().filter(|row| row.property == number) {
                let numbers: Vec<String> = row.numbers.iter().map(|x| format!("{x:?}")).collect();
                let _ = writeln!(text, "case\t{}", numbers.join(" "));
                row.steps.0.iter().for_each(|step| step_to_text(step, &mut text));
            }
        }
        text
    }

    /// Reads what [`Sheet::to_text`] wrote. `Err` is the number of the first line, from 1, that is something
    /// else.
    pub fn from_text(text: &str) -> Result<Sheet, usize> {
        let (exercise, columns, properties, rows) = (String::new(), Vec::new(), Vec::new(), Vec::new());
        let mut sheet = Sheet { exercise, columns, properties, rows };
        for (number, line) in text.lines().enumerate() {
            sheet.line(line).ok_or(number + 1)?;
        }
        Ok(sheet)
    }

    fn line(&mut self, line: &str) -> Option<()> {
        match line.split('\t').collect::<Vec<_>>()[..] {
            ["exercise", name] => self.exercise = name.to_string(),
            ["columns", names] => self.columns = names.split(' ').map(String::from).collect(),
            ["property", name, points] => {
                self.properties.push(Property { name: name.to_string(), points: points.parse().ok()? });
            }
            ["case", numbers] => {
                let numbers = numbers.split(' ').map(|x| x.parse().ok()).collect::<Option<_>>()?;
                let property = self.properties.len().checked_sub(1)?;
                self.rows.push(Row { property, numbers, steps: Steps::default() });
            }
            ["step", ..] => self.rows.last_mut()?.steps.0.push(step_from_text(line)?),
            _ => return None,
        }
        Some(())
    }
}

impl Answer {
    /// The answer to a row as text.
    pub fn to_text(&self, row: usize) -> String {
        let mut text = format!("case\t{row}\n");
        self.steps.0.iter().for_each(|step| step_to_text(step, &mut text));
        if let Some(Broken { message, place }) = &self.broken {
            let _ = writeln!(text, "broken\t{}\t{}", one_line(message), one_line(place));
        }
        text
    }

    /// Reads the answers to `rows` rows, in whatever order they come; it trusts nothing. What does not read
    /// as an answer is passed over, a row that comes twice counts as it came first, and a row that does not
    /// come has no answer: `None`.
    pub fn all_from_text(text: &str, rows: usize) -> Vec<Option<Answer>> {
        let mut answers: Vec<Option<Answer>> = vec![None; rows];
        let mut row = None;
        for line in text.lines() {
            match line.split('\t').collect::<Vec<_>>()[..] {
                ["case", number] => {
                    row = number.parse().ok().filter(|&row: &usize| row < rows && answers[row].is_none());
                    if let Some(row) = row {
                        answers[row] = Some(Answer::default());
                    }
                }
                ["step", ..] => {
                    let answer = row.and_then(|row| answers[row].as_mut());
                    if let (Some(answer), Some(step)) = (answer, step_from_text(line)) {
                        answer.steps.0.push(step);
                    }
                }
                ["broken", message, place] => {
                    if let Some(answer) = row.and_then(|row| answers[row].as_mut()) {
                        let (message, place) = (message.to_string(), place.to_string());
                        answer.broken = Some(Broken { message, place });
                    }
                }
                _ => {}
            }
        }
        answers
    }
}

fn step_to_text(step: &Step, text: &mut String) {
    let tolerance: Vec<String> = step.tolerance.iter().map(|x| format!("{x:?}")).collect();
    let (symbol, formula) = (one_line(&step.symbol), one_line(&step.formula));
    let _ = writeln!(text, "step\t{symbol}\t{formula}\t{}\t{}", step.value.to_fields(), tolerance.join(" "));
}

fn step_from_text(line: &str) -> Option<Step> {
    let [_, symbol, formula, kind, value, tolerance] = line.split('\t').collect::<Vec<_>>()[..] else {
        return None;
    };
    let value = Value::from_fields(kind, value)?;
    let numbers = tolerance.split(' ').filter(|x| !x.is_empty());
    let tolerance = numbers.map(|x| x.parse().ok()).collect::<Option<_>>()?;
    Some(Step { symbol: symbol.to_string(), formula: formula.to_string(), value, tolerance })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_reads_back_as_it_was() {
        let mut steps = Steps::default();
        steps.number("t", "−b ± √D", 0.1).text("verdict", "", "a hit").numbers("λ", "", &[1.0, 2.0]);
        steps.0[0].tolerance = vec![1e-16];
        let sheet = Sheet {
            exercise: "ray-sphere/quadratic".into(),
            columns: vec!["ox".into(), "oy".into()],
            properties: vec![
                Property { name: "ordinary".into(), points: 1 },
                Property { name: "from inside".into(), points: 2 },
            ],
            rows: vec![
                Row { property: 0, numbers: vec![1.0, -0.0], steps: steps.clone() },
                Row { property: 1, numbers: vec![0.5, f64::INFINITY], steps },
            ],
        };
        assert_eq!(Sheet::from_text(&sheet.to_text()), Ok(sheet));
        assert_eq!(Sheet::from_text("exercise\ta/b\ncase\t1 2\n"), Err(2), "of no property");
        assert_eq!(Sheet::from_text("what"), Err(1));
    }

    #[test]
    fn of_answers_nothing_is_trusted() {
        let mut steps = Steps::default();
        steps.number("t", "f", 2.0);
        let broken = Some(Broken { message: "not yet\nimplemented".into(), place: "a.rs:1".into() });
        let answer = Answer { steps, broken };
        let text = format!(
            "noise\n{}case\t7\nstep\tx\t\tnumber\t1.0\t\n{}case\t99999999999999999999\ncase\t0\nstep\tt\n",
            answer.to_text(1),
            Answer::default().to_text(1)
        );
        let answers = Answer::all_from_text(&text, 3);
        let message = &answers[1].as_ref().unwrap().broken.as_ref().unwrap().message;
        assert_eq!(message, "not yet implemented");
        assert_eq!(answers[1].as_ref().unwrap().steps, answer.steps);
        assert_eq!((answers[0].clone(), answers[2].clone()), (Some(Answer::default()), None));
    }
}

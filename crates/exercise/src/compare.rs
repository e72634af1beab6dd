//! The first value that is wrong.

use crate::{Answer, Sheet, Step, Steps, Value, ulps};

/// A step that is not what it should be.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// The row of the sheet, from 0.
    pub row: usize,
    /// The step's place in the row, from 0.
    pub step: usize,
    /// What it should be; `None` where no step was expected any more.
    pub expected: Option<Step>,
    /// What it is; `None` where the code did not get so far.
    pub got: Option<Value>,
    /// How far off the first number is that is wrong, in units of the last digit of what is expected; `None`
    /// where no number is to blame.
    pub ulps: Option<f64>,
    /// How the code ended before the case did, if it did: the message of a panic.
    pub broken: Option<String>,
}

/// The first wrong step of the first row that has one; `None` where all is right. `answers` are what the code
/// makes of the rows of `sheet`, in order; a row without an answer is wrong at its first step.
pub fn first_wrong(sheet: &Sheet, answers: &[Answer]) -> Option<Wrong> {
    let none = Answer::default();
    (0..sheet.rows.len()).find_map(|row| {
        let answer = answers.get(row).unwrap_or(&none);
        first_wrong_step(&sheet.rows[row].steps, answer).map(|wrong| Wrong { row, ..wrong })
    })
}

/// The first wrong step of one answer; its row is 0.
pub fn first_wrong_step(expected: &Steps, answer: &Answer) -> Option<Wrong> {
    let (expected, got) = (&expected.0, &answer.steps.0);
    let broken = || answer.broken.as_ref().map(|it| it.message.clone());
    for step in 0..expected.len().max(got.len()) {
        let (wanted, got) = (expected.get(step), got.get(step));
        let right = match (wanted, got) {
            (Some(wanted), Some(got)) => {
                wanted.symbol == got.symbol && wanted.value.is_met_by(&got.value, &wanted.tolerance)
            }
            _ => false,
        };
        if !right {
            let ulps = wanted.zip(got).and_then(|(wanted, got)| off(wanted, &got.value));
            let broken = if got.is_none() { broken() } else { None };
            let (expected, got) = (wanted.cloned(), got.map(|got| got.value.clone()));
            return Some(Wrong { row: 0, step, expected, got, ulps, broken });
        }
    }
    // it wrote all its steps and then broke
    let broken = broken()?;
    Some(Wrong { row: 0, step: got.len(), expected: None, got: None, ulps: None, broken: Some(broken) })
}

/// How far off the first wrong number is.
fn off(wanted: &Step, got: &Value) -> Option<f64> {
    let (expected, got) = (wanted.value.numbers(), got.numbers());
    if expected.len() != got.len() {
        return None;
    }
    let tolerance = |place: usize| wanted.tolerance.get(place).copied().unwrap_or(0.0);
    let wrong = |&place: &usize| {
        let apart = (expected[place] - got[place]).abs();
        expected[place] != got[place] && (apart.is_nan() || apart > tolerance(place))
    };
    (0..expected.len()).find(wrong).map(|place| ulps(expected[place], got[place]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Broken, Property, Row};

    fn sheet() -> Sheet {
        let mut steps = Steps::default();
        steps.number("d", "‖x − c‖", 3.0).vector("x", "p + t u", [1.0, 2.0, 4.0]);
        steps.0[1].tolerance = vec![0.0, 0.0, 0.5];
        let row = Row { property: 0, numbers: vec![1.0], steps };
        Sheet {
            exercise: "a/b".into(),
            columns: vec!["n".into()],
            properties: vec![Property { name: "any".into(), points: 1 }],
            rows: vec![row.clone(), row],
        }
    }

    fn answer(d: f64, z: f64) -> Answer {
        let mut steps = Steps::default();
        steps.number("d", "", d).vector("x", "", [1.0, 2.0, z]);
        Answer { steps, broken: None }
    }

    #[test]
    fn the_first_wrong_number_of_the_first_wrong_step_counts() {
        let sheet = sheet();
        assert_eq!(first_wrong(&sheet, &[answer(3.0, 4.0), answer(3.0, 4.5)]), None);
        let wrong = first_wrong(&sheet, &[answer(3.0, 4.25), answer(3.0, 5.0)]).unwrap();
        assert_eq!((wrong.row, wrong.step), (1, 1));
        assert_eq!(wrong.ulps, Some(1.0 / (4.0 * f64::EPSILON)));
        let wrong = first_wrong(&sheet, &[answer(3.0 + f64::EPSILON * 2.0, 9.0)]).unwrap();
        assert_eq!((wrong.row, wrong.step, wrong.ulps), (0, 0, Some(1.0)));
    }

    #[test]
    fn what_is_missing_or_too_much_or_broken_is_wrong() {
        let sheet = sheet();
        let wrong = first_wrong(&sheet, &[answer(3.0, 4.0)]).unwrap();
        assert_eq!((wrong.row, wrong.step, wrong.got), (1, 0, None));
        let mut more = answer(3.0, 4.0);
        more.steps.number("e", "", 1.0);
        assert_eq!(first_wrong_step(&sheet.rows[0].steps, &more).unwrap().expected, None);
        let mut broken = answer(3.0, 4.0);
        broken.broken = Some(Broken { message: "over".into(), place: "a.rs:3".into() });
        assert_eq!(first_wrong_step(&sheet.rows[0].steps, &broken).unwrap().broken.unwrap(), "over");
    }
}

//! What an attempt is worth, and which mistake it makes.

use exercise::{Answer, Sheet, Wrong, first_wrong, first_wrong_step, run};

use crate::sheets::expected;
use crate::{Exercise, Known};

/// What an attempt is worth.
#[derive(Clone, Debug)]
pub struct Verdict<'a> {
    /// For each property of the sheet, in its order, whether all its cases are right.
    pub right: Vec<bool>,
    /// The first value that is wrong; `None` where all are right.
    pub wrong: Option<Wrong>,
    /// The mistake that it makes, if it is a known one.
    pub mistake: Option<&'a Known>,
    /// The points it earns.
    pub earned: u32,
}

/// Judges the answers to all cases of an exercise: `sheet` is [`Exercise::sheet`], and the answers are in the
/// order of its rows. A row without an answer is wrong.
pub fn judge<'a>(exercise: &'a Exercise, sheet: &Sheet, answers: &[Answer]) -> Verdict<'a> {
    let mut right = vec![true; sheet.properties.len()];
    for (row, asked) in sheet.rows.iter().enumerate() {
        right[asked.property] &= wrong_step(sheet, answers, row).is_none();
    }
    let earned =
        sheet.properties.iter().zip(&right).filter(|(_, right)| **right).map(|(it, _)| it.points).sum();
    let wrong = first_wrong(sheet, answers);
    let mistake = wrong.as_ref().and_then(|_| recognize(exercise, sheet, answers));
    Verdict { right, wrong, mistake, earned }
}

/// The known mistake that explains the answers: what is right is right with the mistake too, and in every
/// case that is wrong the first wrong value is the one that the mistake leads to, in the same place.
fn recognize<'a>(exercise: &'a Exercise, sheet: &Sheet, answers: &[Answer]) -> Option<&'a Known> {
    let mut known = exercise.mistakes.iter();
    known.find(|known| (0..sheet.rows.len()).all(|row| explains(known, sheet, answers, row)))
}

/// Whether a mistake explains the answer to one case.
fn explains(known: &Known, sheet: &Sheet, answers: &[Answer], row: usize) -> bool {
    let asked = &sheet.rows[row];
    let mistaken = Answer { broken: None, ..run(known.probe, &sheet.case(row)) };
    let made = first_wrong_step(&asked.steps, &mistaken);
    let (wrong, made) = match (wrong_step(sheet, answers, row), made) {
        (None, None) => return true,
        (Some(wrong), Some(made)) if wrong.step == made.step => (wrong, made),
        _ => return false,
    };
    let symbol = answers.get(row).and_then(|it| it.steps.0.get(wrong.step)).map(|step| &step.symbol);
    // with the tolerances of the mistake's own formulas
    let mistaken = expected(known.probe, &sheet.columns, &asked.numbers);
    match (mistaken.0.get(made.step), wrong.got) {
        (Some(made), Some(got)) => {
            Some(&made.symbol) == symbol && made.value.is_met_by(&got, &made.tolerance)
        }
        _ => false,
    }
}

fn wrong_step(sheet: &Sheet, answers: &[Answer], row: usize) -> Option<Wrong> {
    first_wrong_step(&sheet.rows[row].steps, answers.get(row).unwrap_or(&Answer::default()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Catalog, answers};

    /// A row without an answer is wrong, and says nothing of a mistake; the rows before it do.
    #[test]
    fn answers_may_be_too_few() {
        let catalog = Catalog::read().unwrap();
        let exercise = &catalog.exercises[0];
        let sheet = exercise.sheet();
        let right = answers(&sheet, exercise.reference);
        for known in &exercise.mistakes {
            let wrong = answers(&sheet, known.probe);
            assert_eq!(judge(exercise, &sheet, &wrong).mistake.map(|it| &it.name), Some(&known.name));
            for count in 0..right.len() {
                let verdict = judge(exercise, &sheet, &wrong[..count]);
                assert!(verdict.wrong.is_some() && verdict.mistake.is_none(), "{count} answers");
            }
        }
        assert_eq!(judge(exercise, &sheet, &right).earned, exercise.points());
    }
}

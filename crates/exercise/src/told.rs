//! A step that is wrong, in words: for whoever sees their own code run, is checked, or is graded.

use crate::{Answer, Broken, Sheet, Wrong};

/// What to do after a step that is wrong: a question that is still open is asked; else [`told`].
pub fn next(sheet: &Sheet, wrong: &Wrong, answer: &Answer) -> String {
    match asks(wrong, answer) {
        Some((place, question)) => format!("Next: {place} asks:\n  {question}"),
        None => format!("Here it goes wrong.\n{}", told(sheet, wrong, answer)),
    }
}

/// A wrong step in words, some lines without an end of the last: `answer` is what the code made of its row.
///
/// Where the whole program ended in the case, no step is to blame, and none is named.
pub fn told(sheet: &Sheet, wrong: &Wrong, answer: &Answer) -> String {
    let property = &sheet.properties[sheet.rows[wrong.row].property].name;
    let mut text = format!("  property  {property}\n  given     {}\n", sheet.case(wrong.row));
    if let Some(how) = ended(wrong, answer) {
        return text + &format!("  no answer {how}");
    }
    text += &match &wrong.expected {
        Some(step) => {
            format!("  symbol    {}\n  formula   {}\n  expected  {}\n", step.symbol, step.formula, step.value)
        }
        None => "  expected  nothing more\n".to_string(),
    };
    text += &format!("  got       {}", got(wrong, answer));
    if let Some(ulps) = wrong.ulps.filter(|ulps| ulps.is_finite()) {
        // a million and more are no roundings, and nobody reads all their digits
        let ulps = if ulps < 1e6 { format!("{ulps:.0}") } else { format!("{ulps:.1e}") };
        text += &format!("\n  off by    {ulps} ulps (units of the last digit)");
    }
    text
}

/// What there is in place of the step: a value, a panic, how the program ended, or nothing.
pub fn got(wrong: &Wrong, answer: &Answer) -> String {
    match (&wrong.got, broken(wrong, answer)) {
        (Some(got), _) => got.to_string(),
        (None, Some(Broken { message, place })) if place.is_empty() => format!("nothing: {message}"),
        (None, Some(Broken { message, place })) => format!("a panic at {place}: {message}"),
        (None, None) => "nothing".to_string(),
    }
}

/// The place of a hole that still asks, and its question, where that is what ended the answer.
pub fn asks<'a>(wrong: &Wrong, answer: &'a Answer) -> Option<(&'a str, &'a str)> {
    let Broken { message, place } = broken(wrong, answer)?;
    // the words of `todo!`
    Some((place, message.strip_prefix("not yet implemented: ")?))
}

/// How the program ended before it had answered, where it did: not by a panic, which has a place.
pub fn ended<'a>(wrong: &Wrong, answer: &'a Answer) -> Option<&'a str> {
    broken(wrong, answer).filter(|it| it.place.is_empty()).map(|it| it.message.as_str())
}

fn broken<'a>(wrong: &Wrong, answer: &'a Answer) -> Option<&'a Broken> {
    answer.broken.as_ref().filter(|_| wrong.broken.is_some())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Value, first_wrong};

    const SHEET: &str = "exercise\tdouble/it\ncolumns\tx\nproperty\tany\t1\ncase\t2.0\n\
                         step\ty\t2 x\tnumber\t4.0\t0.0\n";

    fn of_ending(message: &str, place: &str) -> (String, String) {
        let sheet = Sheet::from_text(SHEET).unwrap();
        let broken = Some(Broken { message: message.into(), place: place.into() });
        let answer = Answer { broken, ..Answer::default() };
        let wrong = first_wrong(&sheet, std::slice::from_ref(&answer)).unwrap();
        (told(&sheet, &wrong, &answer), next(&sheet, &wrong, &answer))
    }

    #[test]
    fn the_end_of_the_program_is_blamed_on_no_step() {
        let (told, next) = of_ending("the program crashed", "");
        assert_eq!(told, "  property  any\n  given     x = 2\n  no answer the program crashed");
        assert_eq!(next, format!("Here it goes wrong.\n{told}"));
    }

    #[test]
    fn the_difference_is_told_in_ulps_however_large() {
        // by hand: a unit of the last digit of 4 is 2^-50
        let ulp = 4.0 * f64::EPSILON;
        for (got, by) in [(4.0 + 3.0 * ulp, "3"), (4.0 + 999_999.0 * ulp, "999999"), (4.5, "5.6e14")] {
            let sheet = Sheet::from_text(SHEET).unwrap();
            let mut answer = Answer { steps: sheet.rows[0].steps.clone(), ..Answer::default() };
            answer.steps.0[0].value = Value::Number(got);
            let wrong = first_wrong(&sheet, std::slice::from_ref(&answer)).unwrap();
            let told = told(&sheet, &wrong, &answer);
            assert!(told.ends_with(&format!("  off by    {by} ulps (units of the last digit)")), "{told}");
        }
    }

    #[test]
    fn a_panic_is_told_with_its_step_and_a_question_is_asked() {
        let (told, _) = of_ending("over", "src/a.rs:3");
        assert!(told.contains("  symbol    y\n"), "{told}");
        assert!(told.ends_with("  got       a panic at src/a.rs:3: over"), "{told}");
        let (_, next) = of_ending("not yet implemented: What is twice x?", "src/a.rs:3");
        assert_eq!(next, "Next: src/a.rs:3 asks:\n  What is twice x?");
    }
}

//! What `cargo run` and `cargo test` do in a hand-out.

use std::cell::RefCell;
use std::fs::{self, File};
use std::io::{self, Write};
use std::panic::{self, AssertUnwindSafe};
use std::process::ExitCode;
use std::sync::Once;

use crate::{Answer, Broken, Case, Sheet, Step, Steps, Wrong, first_wrong_step, next, told};

/// Writes down what the code makes of a case.
pub type Probe = fn(&Case, &mut Steps);

/// The code of an exercise, with what to look at.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    /// The cases that it is shown, with what is expected of them: a [`Sheet`] as text.
    pub sheet: &'static str,
    /// What it makes of a case.
    pub probe: Probe,
}

thread_local! {
    /// Where the last panic of this thread was, while a probe runs.
    static PLACE: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Runs a probe. A panic ends the answer, and is no error; it prints nothing. What ends the program by other
/// means, as a recursion without end does, ends this one.
pub fn run(probe: impl Fn(&Case, &mut Steps), case: &Case) -> Answer {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            let place = info.location().map_or(String::new(), |it| format!("{}:{}", it.file(), it.line()));
            let asked = PLACE.with(|it| it.borrow_mut().as_mut().map(|kept| *kept = place).is_some());
            if !asked {
                before(info);
            }
        }));
    });
    PLACE.with(|it| *it.borrow_mut() = Some(String::new()));
    let mut steps = Steps::default();
    let ended = panic::catch_unwind(AssertUnwindSafe(|| probe(case, &mut steps)));
    let place = PLACE.with(|it| it.borrow_mut().take()).unwrap_or_default();
    let broken = ended.err().map(|payload| {
        let text = payload.downcast_ref::<&str>().map(|text| text.to_string());
        let message = text.or_else(|| payload.downcast_ref::<String>().cloned()).unwrap_or_default();
        Broken { message, place }
    });
    Answer { steps, broken }
}

/// `cargo run`: shows what the code makes of its cases, up to the first value that is wrong, and says what to
/// do next. With `--probe CASES ANSWERS` it writes answers to the cases of one file into another, for whoever
/// judges.
///
/// Exit status: 0 done, whatever the values are; 1 where a file cannot be read or written, or is no sheet;
/// 2 where other arguments are given.
pub fn main(work: Work) -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => done(show(work, &mut io::stdout().lock())),
        ["--probe", cases, answers] => done(answer(work.probe, cases, answers)),
        _ => {
            eprintln!("error: this takes no arguments: what it can do is in README.md");
            ExitCode::from(2)
        }
    }
}

fn done(ended: io::Result<()>) -> ExitCode {
    match ended {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
        _ => ExitCode::SUCCESS,
    }
}

/// `cargo test`: the rows of one property, by its name.
///
/// # Panics
/// Where a value is wrong, with what was expected, and where `work` has no sheet or its sheet no such property.
/// (A test fails by a panic.)
pub fn test(work: Work, property: &str) {
    let sheet = sheet(work).expect("the hand-out's own expected.txt is whole");
    let known = sheet.properties.iter().any(|it| it.name == property);
    assert!(
        known,
        "expected.txt has no property `{property}`: take its line from the file as it was handed out"
    );
    for (number, row) in sheet.rows.iter().enumerate() {
        if sheet.properties[row.property].name == property {
            let answer = run(work.probe, &sheet.case(number));
            if let Some(wrong) = first_wrong_step(&row.steps, &answer) {
                panic!("\n{}", told(&sheet, &Wrong { row: number, ..wrong }, &answer));
            }
        }
    }
}

fn sheet(work: Work) -> io::Result<Sheet> {
    let broken = |line| io::Error::other(format!("expected.txt, line {line} is not as it was handed out"));
    Sheet::from_text(work.sheet).map_err(broken)
}

fn answer(probe: Probe, cases: &str, answers: &str) -> io::Result<()> {
    let sheet = Sheet::from_text(&fs::read_to_string(cases)?);
    let sheet = sheet.map_err(|line| io::Error::other(format!("{cases}, line {line} is no case")))?;
    let mut file = File::create(answers)?;
    for row in 0..sheet.rows.len() {
        // one case after the other: where the code never comes back, what it did before counts
        file.write_all(run(probe, &sheet.case(row)).to_text(row).as_bytes())?;
    }
    Ok(())
}

fn show(work: Work, output: &mut dyn Write) -> io::Result<()> {
    let sheet = sheet(work)?;
    writeln!(output, "{}\n", sheet.exercise)?;
    for (number, row) in sheet.rows.iter().enumerate() {
        let property = &sheet.properties[row.property].name;
        writeln!(output, "{property}\n  given {}", sheet.case(number))?;
        // where the code crashes or never comes back, its case is the last that is seen
        output.flush()?;
        let answer = run(work.probe, &sheet.case(number));
        let wrong = first_wrong_step(&row.steps, &answer);
        let right = wrong.as_ref().map_or(row.steps.0.len(), |wrong| wrong.step);
        write!(output, "{}", lines(&answer.steps.0[..right.min(answer.steps.0.len())]))?;
        if let Some(wrong) = wrong {
            let wrong = Wrong { row: number, ..wrong };
            return writeln!(output, "\n{}", next(&sheet, &wrong, &answer));
        }
        writeln!(output)?;
    }
    writeln!(output, "Every value is as it should be. Next: cargo test, then hand it in (README.md).")
}

/// Steps as lines: symbol, formula, value.
pub fn lines(steps: &[Step]) -> String {
    let widest = |of: fn(&Step) -> &str| steps.iter().map(|step| of(step).chars().count()).max().unwrap_or(0);
    let (symbol, formula) = (widest(|step| &step.symbol), widest(|step| &step.formula));
    let line =
        |step: &Step| format!("  {:symbol$}  {:formula$}  {}\n", step.symbol, step.formula, step.value);
    steps.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::*;

    const SHEET: &str = "exercise\tdouble/it\ncolumns\tx\nproperty\tpositive\t1\ncase\t2.0\n\
                         step\ty\t2 x\tnumber\t4.0\t0.0\n\
                         property\tnegative\t1\ncase\t-3.0\nstep\ty\t2 x\tnumber\t-6.0\t0.0\n";

    fn shown(probe: Probe) -> String {
        let mut output = Vec::new();
        show(Work { sheet: SHEET, probe }, &mut output).unwrap();
        String::from_utf8(output).unwrap()
    }

    fn asks(_: &Case, _: &mut Steps) {
        todo!("What is twice x?")
    }

    #[test]
    fn an_untouched_hole_asks_its_question() {
        let text = shown(asks);
        assert!(text.contains("asks:\n  What is twice x?"), "{text}");
        assert!(text.contains("program.rs:"), "{text}");
    }

    #[test]
    #[should_panic(expected = "no property `postive`")]
    fn a_property_that_is_none_does_not_pass() {
        let probe = |case: &Case, steps: &mut Steps| {
            steps.number("y", "2 x", case.number("x") * 2.0);
        };
        test(Work { sheet: SHEET, probe }, "postive");
    }

    #[test]
    fn it_stops_at_the_first_value_that_is_wrong() {
        let text = shown(|case, steps| {
            steps.number("y", "2 x", (case.number("x") * 2.0).abs());
        });
        for line in ["positive\n", "  y  2 x  4\n", "given     x = −3", "expected  −6", "got       6"] {
            assert!(text.contains(line), "{line} is not in\n{text}");
        }
        let text = shown(|case, steps| {
            steps.number("y", "2 x", case.number("x") * 2.0);
        });
        assert!(text.contains("Every value"), "{text}");
    }

    /// What was written, as far as it was flushed.
    static FLUSHED: Mutex<String> = Mutex::new(String::new());

    struct Flushed(String);

    impl Write for Flushed {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0 += &String::from_utf8_lossy(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            FLUSHED.lock().unwrap().clone_from(&self.0);
            Ok(())
        }
    }

    #[test]
    fn a_case_is_seen_before_it_is_tried() {
        let probe: Probe = |case, steps| {
            let seen = FLUSHED.lock().unwrap().ends_with(&format!("  given {case}\n"));
            steps.number("y", "2 x", if seen { case.number("x") * 2.0 } else { f64::NAN });
        };
        show(Work { sheet: SHEET, probe }, &mut Flushed(String::new())).unwrap();
        let shown = FLUSHED.lock().unwrap().clone();
        assert!(shown.contains("given x = −3"), "{shown}");
    }

    #[test]
    fn a_property_is_tested_by_itself() {
        let probe: Probe = |case, steps| {
            steps.number("y", "2 x", (case.number("x") * 2.0).abs());
        };
        test(Work { sheet: SHEET, probe }, "positive");
        let failed = panic::catch_unwind(|| test(Work { sheet: SHEET, probe }, "negative"));
        let message = failed.unwrap_err().downcast_ref::<String>().cloned().unwrap();
        assert!(message.contains("property  negative"), "{message}");
    }
}

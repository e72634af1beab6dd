//! Every exercise is proved: the reference passes, what is right in other algebra is accused of nothing,
//! every listed mistake fails and is called by its name, and an untouched hand-out fails exactly what it asks
//! for.

use attempts::Kind;
use exercise::first_wrong;
use homework::judge::judge;
use homework::{Catalog, Exercise, answers};
use rayon::prelude::*;

/// Each exercise, several at a time.
fn for_each(does: impl Fn(&Exercise) + Send + Sync) {
    Catalog::read().unwrap().exercises.par_iter().for_each(does);
}

/// What the attempts of a kind at an exercise are worth.
fn each(exercise: &Exercise, kind: fn(Kind) -> bool, mut seen: impl FnMut(Kind, homework::judge::Verdict)) {
    let sheet = exercise.sheet();
    for &(name, this, probe) in attempts::all() {
        if name == exercise.manifest.name && kind(this) {
            seen(this, judge(exercise, &sheet, &answers(&sheet, probe)));
        }
    }
}

#[test]
fn the_reference_passes() {
    for_each(|exercise| {
        let sheet = exercise.sheet();
        let verdict = judge(exercise, &sheet, &answers(&sheet, exercise.reference));
        assert!(verdict.wrong.is_none(), "{}: {:?}", exercise.manifest.name, verdict.wrong);
        assert_eq!(verdict.earned, exercise.points(), "{}", exercise.manifest.name);
        for (row, asked) in sheet.rows.iter().enumerate() {
            assert!(!asked.steps.0.is_empty(), "{}: case {row} shows nothing", exercise.manifest.name);
        }
    });
}

#[test]
fn what_is_right_in_other_algebra_passes_without_accusation() {
    for_each(|exercise| {
        let mut count = 0;
        each(
            exercise,
            |kind| matches!(kind, Kind::Right(_)),
            |kind, verdict| {
                count += 1;
                assert!(verdict.wrong.is_none(), "{} {kind:?}: {:#?}", exercise.manifest.name, verdict.wrong);
                assert!(verdict.mistake.is_none());
            },
        );
        assert!(count >= 2, "{}: {count} solutions in other algebra", exercise.manifest.name);
    });
}

#[test]
fn each_mistake_is_called_by_its_name() {
    for_each(|exercise| {
        let name = &exercise.manifest.name;
        assert!(exercise.mistakes.len() >= 4, "{name}: {} mistakes", exercise.mistakes.len());
        for known in &exercise.mistakes {
            let count = attempts::all().iter().filter(|(of, kind, _)| {
                of == name && matches!(kind, Kind::Wrong(mistake, _) if *mistake == known.name)
            });
            assert!(count.count() >= 2, "{name}: {} is written again less than twice", known.name);
        }
        let sheet = exercise.sheet();
        for known in &exercise.mistakes {
            let verdict = judge(exercise, &sheet, &answers(&sheet, known.probe));
            let named = verdict.mistake.map(|known| known.name.as_str());
            assert_eq!(named, Some(known.name.as_str()), "{name}, the model itself: {:#?}", verdict.wrong);
        }
        each(
            exercise,
            |kind| matches!(kind, Kind::Wrong(..)),
            |kind, verdict| {
                let Kind::Wrong(mistake, _) = kind else { unreachable!() };
                assert!(verdict.wrong.is_some(), "{name} {kind:?} passes");
                let named = verdict.mistake.map(|known| known.name.as_str());
                assert_eq!(named, Some(mistake), "{name} {kind:?}: {:#?}", verdict.wrong);
            },
        );
    });
}

#[test]
fn the_models_differ_from_each_other_and_from_the_reference() {
    for_each(|exercise| {
        let sheet = exercise.sheet();
        let sheet_of = |known: &homework::Known| homework::sheet(&exercise.manifest, known.probe, usize::MAX);
        let sheets: Vec<_> = exercise.mistakes.iter().map(sheet_of).collect();
        for (number, known) in exercise.mistakes.iter().enumerate() {
            let made = answers(&sheet, known.probe);
            assert!(
                first_wrong(&sheet, &made).is_some(),
                "{}: {} is right",
                exercise.manifest.name,
                known.name
            );
            for (other, other_sheet) in sheets.iter().enumerate().filter(|(other, _)| *other != number) {
                let differ = first_wrong(other_sheet, &made).is_some();
                assert!(differ, "{}: mistakes {number} and {other} are one", exercise.manifest.name);
            }
        }
    });
}

/// It panics with a question in every case that comes to a hole, and it passes no property of which it asks
/// something.
#[test]
fn the_untouched_hand_out_fails_where_it_asks() {
    for_each(|exercise| {
        let sheet = exercise.sheet();
        let name = &exercise.manifest.name;
        each(
            exercise,
            |kind| kind == Kind::Untouched,
            |_, verdict| {
                assert!(verdict.mistake.is_none(), "{name}: an untouched hand-out is accused");
                let broken = verdict.wrong.and_then(|wrong| wrong.broken).unwrap_or_default();
                assert!(broken.starts_with("not yet implemented: "), "{name}: {broken:?}");
            },
        );
        for &(of, kind, probe) in attempts::all() {
            if of == name && kind == Kind::Untouched {
                for (row, answer) in answers(&sheet, probe).iter().enumerate() {
                    let asked = answer.broken.as_ref().is_some_and(|it| it.message.starts_with("not yet"));
                    let right = exercise::first_wrong_step(&sheet.rows[row].steps, answer).is_none();
                    assert!(asked || right, "{name}: case {row} is wrong, and nothing is asked there");
                }
            }
        }
    });
}

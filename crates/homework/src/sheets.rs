//! What is expected of an exercise's cases, and how far off each number may be.

use cutter::Manifest;
use exercise::{Answer, Case, Probe, Property, Row, Sheet, Steps, Value, run};

/// What some code makes of an exercise's cases, of each property the first `most`, as what is expected of
/// others.
pub fn sheet(manifest: &Manifest, probe: Probe, most: usize) -> Sheet {
    let columns = &manifest.columns;
    let (mut properties, mut rows) = (Vec::new(), Vec::new());
    for (property, asked) in manifest.properties.iter().enumerate() {
        properties.push(Property { name: asked.name.clone(), points: asked.points });
        for numbers in asked.cases.iter().take(most) {
            let steps = expected(probe, columns, numbers);
            rows.push(Row { property, numbers: numbers.clone(), steps });
        }
    }
    Sheet { exercise: manifest.name.clone(), columns: columns.clone(), properties, rows }
}

/// What some code makes of the cases of a sheet.
pub fn answers(sheet: &Sheet, probe: impl Fn(&Case, &mut Steps)) -> Vec<Answer> {
    (0..sheet.rows.len()).map(|row| run(&probe, &sheet.case(row))).collect()
}

/// No formula of an exercise rounds more often than this on the way to a value.
const ROUNDINGS: f64 = 64.0;
/// u, the error of one rounding.
const U: f64 = f64::EPSILON / 2.0;
/// 2^−40 of a case's largest number: a step so small that the formulas are straight, and so large that its
/// effect is not drowned by roundings.
const NUDGE: f64 = 1.0 / (1u64 << 40) as f64;
/// What half a nudge moves, as a part of what the whole one does: a straight line ½, a root at its end √½, a
/// jump 1.
const HALVED: f64 = 0.75;

/// A probe's steps with tolerances.
///
/// A formula that is right and made of sums, products, quotients and roots finds what is exact for numbers
/// next to the given ones: each rounding acts as if the numbers were off by u of the largest of them. So a
/// value v(x₁, x₂, …) may be off by ROUNDINGS · u · (Σ |∂v/∂xᵢ| · max|x| + |v|), whatever the algebra. The
/// derivatives are taken by nudging one number after the other.
///
/// A nudge over an edge says nothing about a number, and is passed over: one that changes a verdict, and one
/// that makes a number jump, which half the nudge does as far. A case on an edge (t = 0, a tangent, the rim)
/// is decided by the page or the task, and its numbers are so short that no algebra rounds on the way to the
/// verdict: [`on_an_edge`] finds them, and a test looks at their numbers.
pub(crate) fn expected(probe: Probe, columns: &[String], numbers: &[f64]) -> Steps {
    let mut steps = run(probe, &Case::new(columns, numbers)).steps;
    let mut moved: Vec<Vec<f64>> = steps.0.iter().map(|step| vec![0.0; step.value.numbers().len()]).collect();
    for beside in nudged(probe, columns, numbers) {
        for (step, moved) in moved.iter_mut().enumerate() {
            for (number, moved) in moved.iter_mut().enumerate() {
                let away = beside.iter().filter_map(|way| glides(&steps, way, step, number));
                *moved += away.fold(0.0, f64::max);
            }
        }
    }
    for (step, moved) in steps.0.iter_mut().zip(moved) {
        let of_roundings = |(moved, x): (f64, &f64)| ROUNDINGS * U * (moved / NUDGE + x.abs());
        let tolerance = moved.into_iter().zip(step.value.numbers()).map(of_roundings);
        step.tolerance = tolerance.map(|it| if it.is_finite() { it } else { 0.0 }).collect();
    }
    steps
}

/// Whether a nudge of one of a case's numbers changes a verdict or makes a number jump.
#[cfg(test)]
fn on_an_edge(probe: Probe, columns: &[String], numbers: &[f64]) -> bool {
    let steps = run(probe, &Case::new(columns, numbers)).steps;
    let every =
        |step: usize| (0..steps.0[step].value.numbers().len().max(1)).map(move |number| (step, number));
    nudged(probe, columns, numbers).iter().flatten().any(|way| {
        let same = way.iter().all(|beside| beside.0.len() == steps.0.len());
        let glides = |(step, number): (usize, usize)| match steps.0[step].value {
            Value::Text(_) => way.iter().all(|beside| same_way(&steps, beside, step)),
            _ => glides(&steps, way, step, number).is_some(),
        };
        !same || !(0..steps.0.len()).flat_map(every).all(glides)
    })
}

/// The steps beside those of a case: for each of its numbers both ways, for at the edge of a verdict one of
/// them may stay on this side of it, and each by a whole nudge and by half of one.
fn nudged(probe: Probe, columns: &[String], numbers: &[f64]) -> Vec<[[Steps; 2]; 2]> {
    let largest = numbers.iter().filter(|x| x.is_finite()).fold(0.0_f64, |most, x| most.max(x.abs()));
    let nudge = NUDGE * largest;
    let beside = |place: usize, nudge: f64| {
        let mut beside = numbers.to_vec();
        beside[place] += nudge;
        run(probe, &Case::new(columns, &beside)).steps
    };
    let ways = |place: usize| [nudge, -nudge].map(|by| [by, by / 2.0].map(|by| beside(place, by)));
    (0..numbers.len()).map(ways).collect()
}

/// How far a number of a step moves with a nudge, where the way to it stays the same and it does not jump.
fn glides(steps: &Steps, [whole, half]: &[Steps; 2], step: usize, number: usize) -> Option<f64> {
    let (far, near) = (apart(steps, whole, step, number)?, apart(steps, half, step, number)?);
    // what roundings move is no jump
    let rounded = ROUNDINGS * f64::EPSILON * steps.0[step].value.numbers()[number].abs();
    (near <= HALVED * far + rounded).then_some(far.min(2.0 * near))
}

/// How far a number of a step is from where it was, where the way to it is still the same.
fn apart(steps: &Steps, beside: &Steps, step: usize, number: usize) -> Option<f64> {
    same_way(steps, beside, step).then_some(())?;
    let away = (beside.0[step].value.numbers()[number] - steps.0[step].value.numbers()[number]).abs();
    away.is_finite().then_some(away)
}

/// Whether the verdicts up to a step are the same, and its own too where it is one.
fn same_way(steps: &Steps, beside: &Steps, step: usize) -> bool {
    let same_kind = |place: usize| match (&steps.0[place].value, &beside.0.get(place)?.value) {
        (Value::Text(one), Value::Text(other)) => (one == other).then_some(()),
        (one, other) => (one.numbers().len() == other.numbers().len()).then_some(()),
    };
    (0..=step).try_for_each(same_kind).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: y = a − b for a = 3, b = 1 moves by as much as a and b do, together by 2 · 3 of u; and y = 2
    /// is rounded.
    #[test]
    fn the_tolerance_is_what_roundings_may_do() {
        let columns = ["a", "b"].map(String::from);
        let probe: Probe = |case, steps| {
            let (a, b) = (case.number("a"), case.number("b"));
            steps.number("y", "a − b", a - b).text("sign", "", a > b).numbers("z", "", &[a * a, 5.0]);
        };
        let steps = expected(probe, &columns, &[3.0, 1.0]);
        assert_eq!(steps.0[0].tolerance, [64.0 * U * (6.0 + 2.0)]);
        assert!(steps.0[1].tolerance.is_empty());
        // and a² moves by 2 a · 3 of u, up to the nudge's own square; 5 by nothing
        let [squared, five] = steps.0[2].tolerance[..] else { panic!("two numbers") };
        assert!((squared / (64.0 * U) - (18.0 + 9.0)).abs() < 1e-10, "{squared}");
        assert_eq!(five, 64.0 * U * 5.0);
    }

    /// At the edge of a verdict only the side that is the same counts.
    #[test]
    fn a_nudge_across_a_verdict_is_passed_over() {
        let columns = ["x".to_string()];
        let probe: Probe = |case, steps| {
            let x = case.number("x");
            steps.text("side", "", x >= 4.0).number(
                "y",
                "√x − 2",
                if x >= 4.0 { x.sqrt() - 2.0 } else { 9.0 },
            );
        };
        let steps = expected(probe, &columns, &[4.0]);
        let by_hand = 64.0 * U * (4.0 / 4.0);
        assert!((steps.0[1].tolerance[0] / by_hand - 1.0).abs() < 1e-3, "{:?}", steps.0[1].tolerance);
    }

    /// A jump from number to number is passed over too, as a verdict is: at x = 0 the nearest of 0 and 5 that
    /// is not negative moves with x, and does not move by 5.
    #[test]
    fn a_nudge_across_a_jump_is_passed_over() {
        let columns = ["x".to_string(), "one".to_string()];
        let probe: Probe = |case, steps| {
            let x = case.number("x");
            steps.number("t", "the first", if x >= 0.0 { x } else { 5.0 });
        };
        assert_eq!(expected(probe, &columns, &[0.0, 1.0]).0[0].tolerance, [64.0 * U]);
        assert!(on_an_edge(probe, &columns, &[0.0, 1.0]) && !on_an_edge(probe, &columns, &[2.0, 1.0]));
    }

    /// A root at its end is no jump: √x moves by √½ of a whole nudge with half of one.
    #[test]
    fn a_root_at_its_end_counts() {
        let columns = ["x".to_string(), "one".to_string()];
        let probe: Probe = |case, steps| {
            steps.number("a", "√x", case.number("x").max(0.0).sqrt());
        };
        let steps = expected(probe, &columns, &[0.0, 1.0]);
        assert_eq!(steps.0[0].tolerance, [64.0 * U * NUDGE.sqrt() / NUDGE]);
        assert!(!on_an_edge(probe, &columns, &[0.0, 1.0]));
    }

    /// On an edge the case decides only what its numbers say without a rounding, in any algebra: whole
    /// numbers and binary fractions of some bits, whose products and sums are exact.
    #[test]
    fn where_a_case_is_on_an_edge_its_numbers_are_short() {
        let short = |x: &f64| x.is_infinite() || x.abs() <= 8192.0 && (x * 1024.0).fract() == 0.0;
        let (mut count, mut long) = (0, Vec::new());
        for exercise in crate::Catalog::read().unwrap().exercises {
            let it = &exercise.manifest;
            for asked in &it.properties {
                for case in &asked.cases {
                    if on_an_edge(exercise.reference, &it.columns, case) {
                        count += 1;
                        if !case.iter().all(short) {
                            long.push(format!("{}, {}: {case:?}", it.name, asked.name));
                        }
                    }
                }
            }
        }
        assert!(count > 0 && long.is_empty(), "of {count} cases on an edge:\n{}", long.join("\n"));
    }
}

//! The Pareto front as a staircase.

use super::trade::Mark;

/// The corners of the staircase as (ns, error): it starts at the fastest mark of the front, and each pair
/// of corners after that is the place where the next one begins to do better.
///
/// Its height at a speed is the least error of a mark of the front that is at least as fast: it never
/// promises what no mark keeps, whatever marks are said to be on the front.
pub(super) fn staircase(marks: &[Mark]) -> Vec<(f64, f64)> {
    let mut front: Vec<(f64, f64)> = marks
        .iter()
        .filter(|mark| mark.on_front && mark.has_place())
        .map(|mark| (mark.ns, mark.error))
        .collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut corners: Vec<(f64, f64)> = Vec::new();
    for (ns, error) in front {
        match corners.last() {
            None => corners.push((ns, error)),
            Some(&(_, least)) if error < least => corners.extend([(ns, least), (ns, error)]),
            Some(_) => {}
        }
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::*;
    use stage::Precision;

    fn mark(ns: f64, error: f64, on_front: bool) -> Mark {
        Mark { method: String::new(), precision: Precision::F64, ns, error, wrong: 0, cases: 1, on_front }
    }

    /// The height of the staircase at a speed.
    fn height(corners: &[(f64, f64)], ns: f64) -> Option<f64> {
        corners.iter().rfind(|corner| corner.0 <= ns).map(|corner| corner.1)
    }

    /// Marks strewn over the plane, with their true front.
    fn strewn(seed: u64) -> Vec<Mark> {
        let mut draw = crate::Draw::new(seed, "front", Precision::F64);
        let mut marks: Vec<Mark> = (0..40)
            .map(|_| mark(draw.log_uniform(1.0, 100.0), draw.log_uniform(1e-17, 1.0), false))
            .collect();
        let places: Vec<(f64, f64)> = marks.iter().map(|mark| (mark.ns, mark.error)).collect();
        for mark in &mut marks {
            mark.on_front = !places.iter().any(|&(ns, error)| ns < mark.ns && error < mark.error);
        }
        marks
    }

    #[test]
    fn it_steps_down_only_and_promises_nothing_that_no_mark_keeps() {
        for seed in 0..20 {
            let marks = strewn(seed);
            let corners = staircase(&marks);
            assert!(
                corners.windows(2).all(|pair| pair[1].0 >= pair[0].0 && pair[1].1 <= pair[0].1),
                "{seed}"
            );
            for &(ns, error) in &corners {
                let is_kept = marks.iter().any(|mark| mark.ns <= ns && mark.error <= error);
                assert!(is_kept, "seed {seed}: nobody is at {ns}, {error}");
            }
        }
    }

    #[test]
    fn no_mark_lies_below_it() {
        for seed in 0..20 {
            let marks = strewn(seed);
            let corners = staircase(&marks);
            for mark in &marks {
                let height = height(&corners, mark.ns);
                assert!(
                    height.is_some_and(|height| mark.error >= height),
                    "seed {seed}: {mark:?}, {height:?}"
                );
            }
        }
    }

    #[test]
    fn it_passes_over_what_is_dominated_and_over_what_has_no_place() {
        assert_eq!(staircase(&[]), []);
        assert_eq!(staircase(&[mark(3.0, 1e-3, true)]), [(3.0, 1e-3)]);
        let marks =
            [mark(3.0, 1e-3, true), mark(3.1, 1e-2, true), mark(9.0, 0.0, true), mark(1.0, 1e-9, false)];
        assert_eq!(staircase(&marks), [(3.0, 1e-3), (9.0, 1e-3), (9.0, 0.0)]);
        assert_eq!(
            staircase(&[mark(f64::NAN, 0.0, true), mark(1.0, f64::NAN, true), mark(0.0, 0.0, true)]),
            []
        );
    }
}

//! Which choices are worth considering.

/// For every (cost, error) whether it is on the Pareto front: no other is at most as costly and at most as
/// wrong, and less of one of the two. Of two that are the same in both, both are; one with a NaN always
/// is.
pub fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let beats = |a: &(f64, f64), b: &(f64, f64)| a.0 <= b.0 && a.1 <= b.1 && a != b;
    points.iter().map(|point| !points.iter().any(|other| beats(other, point))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_beaten_in_both_is_not_on_the_front() {
        let points = [(1.0, 9.0), (2.0, 5.0), (3.0, 5.0), (4.0, 1.0), (4.0, 1.0), (5.0, 2.0)];
        assert_eq!(front(&points), [true, true, false, true, true, false]);
        assert_eq!(front(&[]), [false; 0]);
    }
}

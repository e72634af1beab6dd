//! Where a line runs inside a convex set.

use std::cmp::Ordering;

use super::quadratic::Quadratic;
use super::{Dyadic, ExactRoot};

/// The values of t from one root to another, both included: the line inside a closed convex set.
///
/// That is always one stretch, and what several sets have in common is again such a set.
#[derive(Clone, Debug)]
pub(super) struct Stretch {
    /// `None` where it has no beginning.
    from: Option<ExactRoot>,
    /// `None` where it has no end.
    to: Option<ExactRoot>,
}

impl Stretch {
    /// The whole line.
    const WHOLE: Stretch = Stretch { from: None, to: None };

    /// All t from this one on.
    pub(super) fn from(t: ExactRoot) -> Stretch {
        Stretch { from: Some(t), to: None }
    }

    /// All t up to this one.
    pub(super) fn up_to(t: ExactRoot) -> Stretch {
        Stretch { from: None, to: Some(t) }
    }

    /// Where height + t rise ≥ 0; `None` where that is nowhere.
    pub(super) fn above(height: &Dyadic, rise: &Dyadic) -> Option<Stretch> {
        let foot = || ExactRoot::quotient(-height, rise.clone());
        match rise.sign() {
            Ordering::Greater => Some(Stretch::from(foot())),
            Ordering::Less => Some(Stretch::up_to(foot())),
            Ordering::Equal => height.sign().is_ge().then_some(Stretch::WHOLE),
        }
    }

    /// Where A t² − 2 B t + C ≤ 0, for A ≥ 0; `None` where that is nowhere.
    pub(super) fn within(a: Dyadic, b: Dyadic, c: Dyadic) -> Option<Stretch> {
        if a.is_zero() {
            return Stretch::above(&-&c, &(&b + &b));
        }
        let [from, to] = ExactRoot::roots(Quadratic::new(a, b, c)?);
        Some(Stretch { from: Some(from), to: Some(to) })
    }

    /// What they have in common; `None` where that is nothing. Among their ends are roots of one equation
    /// with t² at the most.
    pub(super) fn common<const N: usize>(stretches: [Option<Stretch>; N]) -> Option<Stretch> {
        let mut common = Stretch::WHOLE;
        for stretch in stretches {
            let Stretch { from, to } = stretch?;
            common.from = either(common.from, from, Ordering::Greater);
            common.to = either(common.to, to, Ordering::Less);
        }
        let is_empty = match (&common.from, &common.to) {
            (Some(from), Some(to)) => from.compared_with_root(to).is_gt(),
            _ => false,
        };
        (!is_empty).then_some(common)
    }

    /// Whether t is in it, both ends included.
    pub(super) fn holds(&self, t: &ExactRoot) -> bool {
        let begun = self.from.as_ref().is_none_or(|from| from.compared_with_root(t).is_le());
        begun && self.to.as_ref().is_none_or(|to| to.compared_with_root(t).is_ge())
    }

    /// Its two ends. Panics where it has not both: no solid reaches to infinity.
    pub(super) fn ends(self) -> [ExactRoot; 2] {
        [self.from, self.to].map(|end| end.expect("a solid is bounded"))
    }
}

/// Of two ends the one that compares so with the other.
fn either(a: Option<ExactRoot>, b: Option<ExactRoot>, order: Ordering) -> Option<ExactRoot> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if a.compared_with_root(&b) == order { a } else { b }),
        (a, b) => a.or(b),
    }
}

#[cfg(test)]
mod tests {
    use stage::Precision;

    use super::*;

    fn ends(stretch: Option<Stretch>) -> Option<[f64; 2]> {
        stretch.map(|stretch| stretch.ends().map(|end| end.written(Precision::F64).nearest))
    }

    fn above(height: f64, rise: f64) -> Option<Stretch> {
        Stretch::above(&Dyadic::of(height), &Dyadic::of(rise))
    }

    fn within(coefficients: [f64; 3]) -> Option<Stretch> {
        let [a, b, c] = coefficients.map(Dyadic::of);
        Stretch::within(a, b, c)
    }

    #[test]
    fn common_is_from_the_last_beginning_to_the_first_end() {
        // by hand: t ≥ 1, t ≥ 3, t ≤ 5, t ≤ 4 and (t − 2)(t − 6) ≤ 0
        let (from, later) = (above(-1.0, 1.0), above(-6.0, 2.0));
        let (to, sooner) = (above(5.0, -1.0), above(8.0, -2.0));
        let curved = within([1.0, 4.0, 12.0]);
        let [from, later, to, sooner, curved] = [&from, &later, &to, &sooner, &curved].map(|x| x.clone());
        let common = |stretches: [&Option<Stretch>; 3]| ends(Stretch::common(stretches.map(Clone::clone)));
        assert_eq!(common([&from, &later, &to]), Some([3.0, 5.0]));
        assert_eq!(common([&later, &from, &curved]), Some([3.0, 6.0]));
        assert_eq!(common([&curved, &to, &sooner]), Some([2.0, 4.0]));
        assert_eq!(common([&sooner, &to, &from]), Some([1.0, 4.0]));
        let whole = above(0.0, 0.0);
        assert_eq!(common([&whole, &curved, &whole]), Some([2.0, 6.0]));
    }

    #[test]
    fn touching_is_in_common_and_beside_is_not() {
        let curved = || within([1.0, 4.0, 12.0]);
        assert_eq!(ends(Stretch::common([curved(), above(2.0, -1.0)])), Some([2.0, 2.0]));
        assert_eq!(ends(Stretch::common([curved(), above(-6.0, 1.0)])), Some([6.0, 6.0]));
        assert_eq!(ends(Stretch::common([curved(), above(2.0_f64.next_down(), -1.0)])), None);
        assert_eq!(ends(Stretch::common([above(-6.0_f64.next_up(), 1.0), curved()])), None);
        assert_eq!(ends(Stretch::common([curved(), above(-5e-324, 0.0)])), None);
        // by hand: (t − 2)² + c ≤ 0
        assert_eq!(ends(within([1.0, 2.0, 4.0])), Some([2.0, 2.0]));
        assert_eq!(ends(within([1.0, 2.0, 4.0_f64.next_up()])), None);
    }

    #[test]
    fn both_ends_are_held() {
        let stretch = Stretch::common([above(-1.0, 1.0), above(5.0, -1.0)]).unwrap();
        let holds = |t: f64| stretch.holds(&ExactRoot::quotient(Dyadic::of(t), Dyadic::of(1.0)));
        assert!([1.0, 3.0, 5.0].into_iter().all(holds));
        assert!(![1.0_f64.next_down(), 5.0_f64.next_up(), -3.0].into_iter().any(holds));
    }

    #[test]
    fn without_a_square_the_equation_is_linear() {
        // by hand: −2 B t + C ≤ 0 from t = 3/2 on or up to there; C ≤ 0 everywhere or nowhere
        let both = |other| ends(Stretch::common([within([0.0, 1.0, 3.0]), other]));
        assert_eq!(both(within([0.0, -2.0, -8.0])), Some([1.5, 2.0]));
        assert_eq!(both(within([0.0, -2.0, -4.0])), None);
        for c in [0.0, -1.0] {
            assert!(within([0.0, 0.0, c]).is_some_and(|all| all.from.is_none() && all.to.is_none()));
        }
        assert!(within([0.0, 0.0, 5e-324]).is_none());
    }
}

//! A t² − 2 B t + C = 0: where a line enters and leaves a curved surface.

use std::cmp::Ordering;

use dashu_int::ops::SquareRoot;

use super::Dyadic;
use super::digits::Digits;

/// The equation A t² − 2 B t + C = 0, with A > 0 and two real roots, which are equal for a tangent.
#[derive(Debug)]
pub(super) struct Quadratic {
    a: Dyadic,
    b: Dyadic,
    c: Dyadic,
    /// B² − A C, not negative.
    discriminant: Dyadic,
}

/// One of the two roots.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Which {
    /// (B − √D) / A, where the line enters.
    Smaller,
    /// (B + √D) / A, where it leaves.
    Larger,
}

/// How many bits of |B| + √D are worked out behind the first.
const BITS: i32 = 130;

impl Quadratic {
    /// The equation with these coefficients; `None` where it has no real root, since B² < A C.
    ///
    /// Panics where A is zero: then it is not quadratic, and its one root is the quotient C / 2B.
    pub(super) fn new(a: Dyadic, b: Dyadic, c: Dyadic) -> Option<Quadratic> {
        assert!(!a.is_zero(), "an equation without t²");
        let discriminant = &b.square() - &(&a * &c);
        if discriminant.sign().is_lt() {
            return None;
        }
        // The same roots, with A > 0.
        let [a, b, c] = if a.sign().is_lt() { [-&a, -&b, -&c] } else { [a, b, c] };
        Some(Quadratic { a, b, c, discriminant })
    }

    /// How a root compares with `t`.
    pub(super) fn compared_with(&self, which: Which, t: &Dyadic) -> Ordering {
        self.compared_with_quotient(which, t, &Dyadic::of(1.0))
    }

    /// How a root compares with n / d, for d > 0.
    pub(super) fn compared_with_quotient(&self, which: Which, n: &Dyadic, d: &Dyadic) -> Ordering {
        let (a_n, b_d) = (&self.a * n, &self.b * d);
        // B / A, where the line is deepest, is midway between the roots.
        let beyond_the_middle = (&a_n - &b_d).sign();
        // On its own side of the middle a root is where the polynomial changes its sign. Times d²:
        let polynomial = || (&(&(&a_n - &(&b_d + &b_d)) * n) + &(&self.c * &d.square())).sign();
        match (which, beyond_the_middle) {
            (Which::Smaller, Ordering::Greater) => Ordering::Less,
            (Which::Larger, Ordering::Less) => Ordering::Greater,
            (Which::Smaller, _) => polynomial(),
            (Which::Larger, _) => polynomial().reverse(),
        }
    }

    /// Whether both roots are one.
    pub(super) fn is_tangent(&self) -> bool {
        self.discriminant.is_zero()
    }

    /// The leading digits of a root, without a difference whose digits could cancel.
    pub(super) fn digits(&self, which: Which) -> Digits {
        let [low, high] = self.sum();
        // B ± √D adds up where both have the same sign; the other root is C over that sum (Vieta).
        match (which, self.b.sign()) {
            (Which::Larger, Ordering::Less) => Digits::of_quotient(&-&self.c, &high),
            (Which::Larger, _) => Digits::of_quotient(&low, &self.a),
            (Which::Smaller, Ordering::Greater) => Digits::of_quotient(&self.c, &high),
            (Which::Smaller, _) => Digits::of_quotient(&-&low, &self.a),
        }
    }

    /// |B| + √D to within 2^−129 of it: it is not less than the first number, and less than the second.
    fn sum(&self) -> [Dyadic; 2] {
        let top_of_root = self.discriminant.top().map(|top| top.div_euclid(2));
        let Some(top) = self.b.top().max(top_of_root) else {
            return [Dyadic::scaled(0, 0), Dyadic::scaled(1, 0)];
        };
        let unit = top - BITS;
        // Both are rounded down to whole units: together they lack less than two.
        let low = self.b.whole(unit) + self.discriminant.whole(2 * unit).sqrt();
        let high = &low + 2u8;
        [low, high].map(|units| Dyadic::scaled(units, unit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn equation(coefficients: [f64; 3]) -> Option<Quadratic> {
        let [a, b, c] = coefficients.map(Dyadic::of);
        Quadratic::new(a, b, c)
    }

    /// How both roots compare with `t`.
    fn compared(equation: &Quadratic, t: f64) -> [Ordering; 2] {
        [Which::Smaller, Which::Larger].map(|which| equation.compared_with(which, &Dyadic::of(t)))
    }

    #[test]
    fn roots_are_compared_exactly() {
        use Ordering::{Equal, Greater, Less};
        // by hand: 2 (t − 3)(t − 5) = 2 t² − 16 t + 30, and the same with every sign turned
        for coefficients in [[2.0, 8.0, 30.0], [-2.0, -8.0, -30.0]] {
            let equation = equation(coefficients).unwrap();
            assert_eq!(compared(&equation, 3.0_f64.next_down()), [Greater, Greater]);
            assert_eq!(compared(&equation, 3.0), [Equal, Greater]);
            assert_eq!(compared(&equation, 3.0_f64.next_up()), [Less, Greater]);
            assert_eq!(compared(&equation, 4.0), [Less, Greater]);
            assert_eq!(compared(&equation, 5.0), [Less, Equal]);
            assert_eq!(compared(&equation, 5.0_f64.next_up()), [Less, Less]);
        }
        // by hand: 9 (t − 1/3)(t + 5/3) = 9 t² + 12 t − 5, at quotients that are no floats
        let thirds = equation([9.0, -6.0, -5.0]).unwrap();
        let at = |n, d| {
            let [n, d] = [n, d].map(Dyadic::of);
            [Which::Smaller, Which::Larger].map(|which| thirds.compared_with_quotient(which, &n, &d))
        };
        assert_eq!([at(1.0, 3.0), at(-5.0, 3.0)], [[Less, Equal], [Equal, Greater]]);
        assert_eq!([at(1.0_f64.next_up(), 3.0), at(1.0, 3.0_f64.next_up())], [[Less, Less], [Less, Greater]]);
        // by hand: (t + 1)² touches at −1
        assert_eq!(compared(&equation([1.0, -1.0, 1.0]).unwrap(), -1.0), [Equal, Equal]);
    }

    #[test]
    fn the_smallest_difference_decides() {
        // by hand: D = 1 − (1 + 2^−52) < 0, D = 1 − 1 = 0, D = 1e600 − 1e600 + 5e−324 > 0
        assert!(equation([1.0, 1.0, 1.0_f64.next_up()]).is_none());
        assert!(equation([1.0, 1.0, 1.0]).is_some_and(|equation| equation.discriminant.is_zero()));
        let [a, b] = [1.0, 1e300].map(Dyadic::of);
        let below = &b.square() - &Dyadic::of(5e-324);
        let above = &b.square() + &Dyadic::of(5e-324);
        assert!(Quadratic::new(a.clone(), b.clone(), below).is_some());
        assert!(Quadratic::new(a, b, above).is_none());
    }

    #[test]
    fn a_sum_is_held_by_its_two_numbers() {
        // The third has a B of nearly a unit, which is cut, and so is √D: more than one unit is missing.
        let below_a_unit = 2.0_f64.powi(-BITS).next_down();
        for coefficients in [
            [1.0, 1.0, -1.0],
            [3.0, -1e200, 7.0],
            [1.0, below_a_unit, -2.0],
            [1.0, 0.0, -5e-324],
            [1.0, 0.0, -0.2],
        ] {
            let equation = equation(coefficients).unwrap();
            let size = if equation.b.sign().is_lt() { -&equation.b } else { equation.b.clone() };
            let [low, high] = equation.sum();
            // (x − |B|)² against D, from both sides
            let [to_low, to_high] = [&low - &size, &high - &size];
            assert!(to_low.sign().is_lt() || (&to_low.square() - &equation.discriminant).sign().is_le());
            assert!(to_high.sign().is_gt() && (&to_high.square() - &equation.discriminant).sign().is_gt());
            // 2^−129 of it apart, or less
            let apart = &(&high - &low) * &Dyadic::scaled(1, 129);
            assert!((&apart - &low).sign().is_le(), "{coefficients:?}");
        }
        // by hand: |B| + √D = 0
        assert!(equation([1.0, 0.0, 0.0]).unwrap().sum()[0].is_zero());
    }
}

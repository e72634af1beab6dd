//! An exact value of t.

use std::cmp::Ordering;
use std::sync::Arc;

use stage::Precision;

use super::digits::Digits;
use super::quadratic::{Quadratic, Which};
use super::{Dyadic, rounding};
use crate::Root;

/// A value of t, known by the equation that it solves.
#[derive(Clone, Debug)]
pub struct ExactRoot(Equation);

#[derive(Clone, Debug)]
enum Equation {
    /// d t = n, with d > 0.
    Linear { n: Dyadic, d: Dyadic },
    /// A t² − 2 B t + C = 0, shared by its two roots.
    Quadratic(Arc<Quadratic>, Which),
}

impl ExactRoot {
    /// n / d. Panics where d is zero.
    pub(super) fn quotient(n: Dyadic, d: Dyadic) -> ExactRoot {
        assert!(!d.is_zero(), "a quotient by zero");
        // The same value, with d > 0.
        let [n, d] = if d.sign().is_lt() { [-&n, -&d] } else { [n, d] };
        ExactRoot(Equation::Linear { n, d })
    }

    /// Both roots of an equation, the smaller one first.
    pub(super) fn roots(equation: Quadratic) -> [ExactRoot; 2] {
        let equation = Arc::new(equation);
        [Which::Smaller, Which::Larger].map(|which| ExactRoot(Equation::Quadratic(equation.clone(), which)))
    }

    /// How it compares with a number.
    pub fn compared_with(&self, t: &Dyadic) -> Ordering {
        match &self.0 {
            Equation::Linear { n, d } => (n - &(d * t)).sign(),
            Equation::Quadratic(equation, which) => equation.compared_with(*which, t),
        }
    }

    /// How it compares with another one. Panics for roots of two different equations with t².
    pub(super) fn compared_with_root(&self, other: &ExactRoot) -> Ordering {
        match (&self.0, &other.0) {
            (Equation::Linear { n, d }, Equation::Linear { n: other_n, d: other_d }) => {
                (&(n * other_d) - &(other_n * d)).sign()
            }
            (Equation::Quadratic(equation, which), Equation::Linear { n, d }) => {
                equation.compared_with_quotient(*which, n, d)
            }
            (Equation::Linear { .. }, Equation::Quadratic(..)) => other.compared_with_root(self).reverse(),
            (Equation::Quadratic(equation, which), Equation::Quadratic(other_equation, other_which)) => {
                assert!(Arc::ptr_eq(equation, other_equation), "roots of two equations");
                if equation.is_tangent() { Ordering::Equal } else { which.cmp(other_which) }
            }
        }
    }

    /// It is not behind the origin of the ray: t ≥ 0.
    pub fn is_ahead(&self) -> bool {
        self.compared_with(&Dyadic::of(0.0)).is_ge()
    }

    /// It written down: the nearest value of the precision, and more digits than that.
    pub fn written(&self, precision: Precision) -> Root {
        let digits = match &self.0 {
            Equation::Linear { n, d } => Digits::of_quotient(n, d),
            Equation::Quadratic(equation, which) => equation.digits(*which),
        };
        let nearest = rounding::nearest(&digits, precision, |t| self.compared_with(t));
        Root { nearest, fine: digits.to_wide() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Draw;

    /// Pairs of numbers of any bits, and of small whole ones; and what the processor makes of them. By
    /// IEEE 754 it rounds a sum, a quotient and a square root correctly.
    fn assert_as_processor(
        name: &str,
        root: impl Fn(f64, f64) -> Option<ExactRoot>,
        processor: [fn(f64, f64) -> f64; 2],
    ) {
        for (precision, processor) in Precision::ALL.into_iter().zip(processor) {
            let mut draw = Draw::new(1, name, precision);
            let mut number = || loop {
                let number = if draw.below(4) == 0 { draw.below(9) as f64 - 4.0 } else { draw.any_number() };
                if number.is_finite() {
                    return number;
                }
            };
            for _ in 0..4000 {
                let (x, y) = (number(), number());
                let Some(root) = root(x, y) else { continue };
                let got = root.written(precision).nearest;
                // minus zero is zero
                let want = processor(x, y) + 0.0;
                assert_eq!(got.to_bits(), want.to_bits(), "{name} {x:e} {y:e}: want {want:e}, got {got:e}");
            }
        }
    }

    #[test]
    fn roots_are_compared_with_roots() {
        use Ordering::{Equal, Greater, Less};
        let quotient = |n, d| ExactRoot::quotient(Dyadic::of(n), Dyadic::of(d));
        let roots = |coefficients: [f64; 3]| {
            let [a, b, c] = coefficients.map(Dyadic::of);
            ExactRoot::roots(Quadratic::new(a, b, c).expect("real roots"))
        };
        // by hand: −1/√2 and 1/√2 = 0.7071…; 1/3 twice
        let ([low, high], [one, same]) = (roots([2.0, 0.0, -1.0]), roots([9.0, 3.0, 1.0]));
        let third = quotient(1.0, 3.0);
        for (left, right, order) in [
            (&low, &high, Less),
            (&high, &high, Equal),
            (&one, &same, Equal),
            (&one, &third, Equal),
            (&high, &quotient(7.0, 10.0), Greater),
            (&high, &quotient(-8.0, -11.0), Less),
            (&third, &quotient(-2.0, -6.0), Equal),
            (&third, &quotient(1.0, 3.0_f64.next_up()), Greater),
        ] {
            assert_eq!(left.compared_with_root(right), order, "{left:?} {right:?}");
            assert_eq!(right.compared_with_root(left), order.reverse(), "{right:?} {left:?}");
        }
    }

    #[test]
    fn a_quotient_is_what_a_processor_divides() {
        assert_as_processor(
            "quotient",
            |x, y| (y != 0.0).then(|| ExactRoot::quotient(Dyadic::of(x), Dyadic::of(y))),
            [|x, y| f64::from(x as f32 / y as f32), |x, y| x / y],
        );
    }

    #[test]
    fn a_sum_over_one_is_what_a_processor_adds() {
        assert_as_processor(
            "sum",
            |x, y| Some(ExactRoot::quotient(&Dyadic::of(x) + &Dyadic::of(y), Dyadic::of(1.0))),
            [|x, y| f64::from(x as f32 + y as f32), |x, y| x + y],
        );
    }

    #[test]
    fn a_square_root_is_what_a_processor_takes() {
        // t² − x = 0
        let roots = |x: f64| -> Option<[ExactRoot; 2]> {
            let [a, b, c] = [1.0, 0.0, -x].map(Dyadic::of);
            Quadratic::new(a, b, c).map(ExactRoot::roots)
        };
        let processor: [fn(f64, f64) -> f64; 2] = [|x, _| f64::from((x as f32).sqrt()), |x, _| x.sqrt()];
        assert_as_processor("larger", |x, _| roots(x).map(|[_, larger]| larger), processor);
        let processor: [fn(f64, f64) -> f64; 2] = [|x, _| -f64::from((x as f32).sqrt()), |x, _| -x.sqrt()];
        assert_as_processor("smaller", |x, _| roots(x).map(|[smaller, _]| smaller), processor);
    }
}

//! Bounds against exact sums, roots against exact roots.

use super::*;
use crate::Exact;

/// Numbers of many sizes, whole ones and some with few digits, the same on every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let (bits, kind) = (self.0 >> 11, self.0 >> 60);
        let unit = bits as f64 / (1u64 << 52) as f64 - 1.0;
        match kind {
            0..6 => unit,
            6..10 => (unit * 4.0).round(),
            10..12 => unit * 2.0_f64.powi(bits as i32 % 40),
            12..14 => 1.0 + (unit * 8.0).round() * f64::EPSILON,
            14 => unit * 2.0_f64.powi(bits as i32 % 500),
            _ => unit * 2.0_f64.powi(bits as i32 % 1000 - 20),
        }
    }
}

/// A formula with differences, products and sums, among them some that cancel.
fn formula<N: Sure>(x: [f64; 9]) -> [N; 3] {
    let [a, b]: [[N; 3]; 2] =
        [0, 3].map(|at| std::array::from_fn(|axis| N::difference(x[at + axis], x[6 + axis])));
    let cross = N::cross(&a, &b);
    let [dot, size] = [N::dot(&a, &b), N::dot(&cross, &cross)];
    // Lagrange: ‖a × b‖² + (a · b)² = ‖a‖² ‖b‖², so the last is 0
    let rest = size.clone() + dot.clone() * dot.clone() - N::dot(&a, &a) * N::dot(&b, &b);
    [N::product(x[0], x[1]) - dot, size, rest]
}

/// |value − exact| ≤ error, exactly.
fn assert_bounds(parts: [f64; 2], error: f64, exact: &Exact) {
    if !parts.iter().chain([&error]).all(|x| x.is_finite()) {
        return;
    }
    let off = Exact::new(parts[0]) + Exact::new(parts[1]) - exact.clone();
    let off = if off.is_negative() { -off } else { off };
    let within = !(Exact::new(error * SLACK) - off.clone()).is_negative();
    assert!(within, "{parts:?} is off by {:e}, not by {error:e}", off.about());
}

#[test]
fn no_error_is_beyond_its_bound_and_no_sign_is_wrong() {
    let (mut numbers, mut told) = (Numbers(1), [0, 0]);
    for _ in 0..20_000 {
        let x: [f64; 9] = std::array::from_fn(|_| numbers.next());
        let exact = formula::<Exact>(x);
        let (once, twice) = (formula::<Bounded<f64>>(x), formula::<Bounded<TwoPart>>(x));
        for ((exact, once), twice) in exact.iter().zip(once).zip(twice) {
            assert_bounds([once.value, 0.0], once.error, exact);
            assert_bounds([twice.value.hi, twice.value.lo], twice.error, exact);
            for (count, sign) in told.iter_mut().zip([once.sign(), twice.sign()]) {
                assert!(sign.is_none() || sign == exact.sign(), "{x:?}");
                *count += usize::from(sign.is_some());
            }
        }
    }
    // A bound that never tells would be no use. The third number is 0, which only whole numbers show.
    assert!(told[0] > 25_000 && told[1] > 35_000, "{told:?} of 60000");
}

/// The roots through (u, v): A = u² + 1, and D = B² − A C is taken the plain way.
fn roots<N: Sure, R: Real>(u: f64, v: f64, w: f64) -> [Option<R>; 2] {
    let a = N::product(u, u) + N::of(1.0);
    let (b, c) = (N::product(u, v), N::product(v, v) - N::product(w, w));
    let d = b.clone() * b.clone() - a.clone() * c.clone();
    if d.sign().is_none_or(Ordering::is_lt) {
        return [None; 2];
    }
    let quadratic = Quadratic { a, b, c, d };
    [N::root(&quadratic, -1.0), N::root(&quadratic, 1.0)]
}

#[test]
fn roots_and_quotients_are_those_of_exact_numbers_to_the_last_digit() {
    let (mut numbers, mut found) = (Numbers(2), [0; 3]);
    for _ in 0..20_000 {
        let [u, v, w] = std::array::from_fn(|_| numbers.next());
        let exact: [Option<f64>; 2] = roots::<Exact, f64>(u, v, w);
        let twice: [Option<f64>; 2] = roots::<Bounded<TwoPart>, f64>(u, v, w);
        let halves: [Option<f32>; 2] = roots::<Bounded<f64>, f32>(u, v, w);
        let exact_halves: [Option<f32>; 2] = roots::<Exact, f32>(u, v, w);
        for i in 0..2 {
            if let Some(t) = twice[i] {
                let want = exact[i].unwrap();
                assert!((t - want).abs() <= (want.next_up() - want).abs(), "{t:e}, not {want:e}");
                found[0] += 1;
            }
            if let Some(t) = halves[i] {
                let want = exact_halves[i].unwrap();
                assert!(t == want || (want.next_down()..=want.next_up()).contains(&t), "{t:e}, {want:e}");
                found[1] += 1;
            }
        }
        let [n, d] = [v, w].map(<Bounded<TwoPart>>::of);
        if let Some(t) = Sure::quotient::<f64>(&n, &d) {
            assert_eq!(t, v / w, "a division is rounded correctly");
            found[2] += 1;
        }
    }
    assert!(found.iter().all(|&count| count > 15_000), "{found:?}");
}

#[test]
fn one_rounding_of_f64_is_too_many_for_f64_and_none_for_f32() {
    let [n, d] = [1.0, 3.0].map(<Bounded<f64>>::of);
    assert_eq!(Sure::quotient::<f64>(&n, &d), None);
    assert_eq!(Sure::quotient::<f32>(&n, &d), Some(1.0 / 3.0));
    let off = Bounded { value: TwoPart::from(1.0), error: f64::EPSILON };
    assert_eq!(Sure::quotient::<f64>(&off, &<Bounded<TwoPart>>::of(1.0)), None, "a digit off is too much");
}

/// 1/3 + 1/3 · 2^−60, which no f64 holds: the correction counts where it is larger than half of the last digit.
#[test]
fn a_correction_is_rounded_once() {
    let third = 1.0 / 3.0;
    let correction = |value: f64, error: f64| Bounded { value, error }.added_to::<f64>(third);
    assert_eq!(correction(third * 2.0_f64.powi(-60), 1e-30), Some(third));
    assert_eq!(correction(third * 2.0_f64.powi(-52), 1e-30), Some(third.next_up()));
    assert_eq!(correction(third * 2.0_f64.powi(-60), 1e-16), None, "an error as large as the last digit");
    let root = Bounded { value: 2.0, error: 1e-9 }.sqrt();
    assert!(root.value == 2.0_f64.sqrt() && root.error >= 1e-9 / 8.0_f64.sqrt());
    let none_left = Bounded { value: -1e-20, error: 1e-18 }.sqrt();
    assert!(none_left.value == 0.0 && none_left.error >= 1e-9, "√ of what it may be");
}

#[test]
fn zero_is_certain_where_nothing_was_rounded() {
    let zero = <Bounded<f64> as Sure>::product(0.0, 1e-300);
    assert_eq!(zero.sign(), Some(Ordering::Equal));
    let vanished = <Bounded<f64> as Sure>::product(1e-200, 1e-200);
    assert_eq!((vanished.value, vanished.sign()), (0.0, None));
    // nor is it zero times a number so small that the error vanishes as well
    let again = vanished * <Bounded<f64> as Sure>::of(1e-200);
    assert_eq!((again.value, again.sign()), (0.0, None));
    let vanished = <Bounded<TwoPart> as Sure>::product(1e-200, 1e-200);
    assert_eq!((vanished * <Bounded<TwoPart> as Sure>::of(1e-200)).sign(), None);
    // nor is a quotient zero that is only too small
    let [n, d] = [1e-200, -1e200].map(<Bounded<f64>>::of);
    assert_eq!((Sure::quotient::<f64>(&n, &d), Sure::quotient::<f32>(&n, &d)), (None, None));
    let [n, d] = [1e-200, -1e200].map(<Bounded<TwoPart>>::of);
    assert_eq!(Sure::quotient::<f64>(&n, &d), None);
    let zero = <Bounded<TwoPart>>::of(0.0);
    assert_eq!(Sure::quotient::<f64>(&zero, &d), Some(0.0), "a zero is");
    let overflown = <Bounded<TwoPart> as Sure>::product(1e200, -1e200);
    let small = overflown * Bounded::exactly(TwoPart::from(1e-200));
    assert_eq!((small + Bounded::exactly(TwoPart::from(1e250))).sign(), None, "1e250 − 1e200");
}

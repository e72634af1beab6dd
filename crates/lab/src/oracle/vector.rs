//! Vectors of exact numbers.

use super::Dyadic;

/// a · b
pub(super) fn dot(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> Dyadic {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// a − b
pub(super) fn difference(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> [Dyadic; 3] {
    std::array::from_fn(|axis| &a[axis] - &b[axis])
}

/// The numbers by threes; those at the end that are left over are not looked at.
pub(super) fn vectors<const N: usize, const VECTORS: usize>(numbers: &[f64; N]) -> [[Dyadic; 3]; VECTORS] {
    std::array::from_fn(|i| std::array::from_fn(|axis| Dyadic::of(numbers[3 * i + axis])))
}

#[test]
fn what_cancels_is_gone() {
    // by hand: 1e200·1e200 + 1·2 − 1e200·1e200 = 2, though a float of that size has no digit for it
    let [a, b, c] = vectors(&[1e200, 1.0, -1e200, 1e200, 2.0, 1e200, 1e200, 1.0, -1e200]);
    assert!((&dot(&a, &b) - &Dyadic::of(2.0)).is_zero());
    assert!(difference(&a, &c).iter().all(Dyadic::is_zero));
    assert_eq!(difference(&a, &b)[1].sign(), std::cmp::Ordering::Less);
}

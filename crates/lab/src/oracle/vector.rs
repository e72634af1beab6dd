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

/// a × b
pub(super) fn cross(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> [Dyadic; 3] {
    std::array::from_fn(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        &(&a[next] * &b[last]) - &(&a[last] * &b[next])
    })
}

/// Whether it has no direction.
pub(super) fn is_zero(v: &[Dyadic; 3]) -> bool {
    v.iter().all(Dyadic::is_zero)
}

/// The numbers by threes; those at the end that are left over are not looked at.
pub(super) fn vectors<const N: usize, const VECTORS: usize>(numbers: &[f64; N]) -> [[Dyadic; 3]; VECTORS] {
    std::array::from_fn(|i| std::array::from_fn(|axis| Dyadic::of(numbers[3 * i + axis])))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cancels_is_gone() {
        // by hand: 1e200·1e200 + 1·2 − 1e200·1e200 = 2, though a float of that size has no digit for it
        let [a, b, c] = vectors(&[1e200, 1.0, -1e200, 1e200, 2.0, 1e200, 1e200, 1.0, -1e200]);
        assert!((&dot(&a, &b) - &Dyadic::of(2.0)).is_zero());
        assert!(is_zero(&difference(&a, &c)) && !is_zero(&difference(&a, &b)));
        assert_eq!(difference(&a, &b)[1].sign(), std::cmp::Ordering::Less);
    }

    #[test]
    fn a_cross_product_by_hand() {
        // by hand: (1, 2, 3) × (4, 5, 6) = (12 − 15, 12 − 6, 5 − 8)
        let [a, b, n] = vectors(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, -3.0, 6.0, -3.0]);
        assert!(is_zero(&difference(&cross(&a, &b), &n)));
        assert!(is_zero(&cross(&a, &a)));
    }
}

//! The angle between two vectors, to many digits.

use math::{Wide, portable};

/// The sum of the products of the components.
pub fn dot(a: [Wide; 3], b: [Wide; 3]) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The angle between two vectors of any length in radians, from 0 to π, the smallest ones too; `None`
/// where one of the two is zero.
pub fn angle(a: [Wide; 3], b: [Wide; 3]) -> Option<f64> {
    let across: [Wide; 3] = std::array::from_fn(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        a[next] * b[last] - a[last] * b[next]
    });
    let lengths = (dot(a, a) * dot(b, b)).sqrt();
    if lengths.is_zero() {
        return None;
    }
    // ‖a × b‖ is the sine, a · b tells which side
    let sine = (dot(across, across).sqrt() / lengths).to_f64();
    let cosine = (dot(a, b) / lengths).to_f64();
    let angle = portable::atan(sine / cosine.abs());
    Some(if cosine < 0.0 { std::f64::consts::PI - angle } else { angle })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    #[test]
    fn angles_of_any_size_between_vectors_of_any_length() {
        for length in [1.0, 1e-300, 1e300] {
            let of = |x, y| {
                angle([1.0, 0.0, 0.0].map(Wide::from), [x, y, 0.0].map(|x: f64| Wide::from(x * length)))
            };
            assert_eq!(of(1.0, 0.0), Some(0.0));
            assert_eq!(of(0.0, -1.0), Some(FRAC_PI_2));
            assert_eq!(of(-1.0, 0.0), Some(PI));
            // by hand: the angle whose tangent is 1, and a small angle is its tangent
            assert!((of(1.0, 1.0).unwrap() - FRAC_PI_4).abs() < 1e-15);
            assert!((of(1.0, 1e-8).unwrap() - 1e-8).abs() < 1e-22);
        }
        assert_eq!(angle([1.0; 3].map(Wide::from), [0.0; 3].map(Wide::from)), None);
    }
}

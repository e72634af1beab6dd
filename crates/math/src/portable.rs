//! Functions whose last bit differs between platforms, from one portable implementation.

/// The angle whose tangent is `x`, in radians, between −π/2 and π/2.
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// The angle of the point (`x`, `y`) from the x axis towards the y axis, in radians, from −π to π; 0 at the
/// origin itself where both are +0.
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// The angle whose cosine is `x`, in radians, from 0 to π; NaN where `x` lies outside −1 to 1.
pub fn acos(x: f64) -> f64 {
    libm::acos(x)
}

/// e to the power `x`: infinite where it is too large for a number, 0 where it is too small.
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// The natural logarithm of `x`; −∞ at zero, NaN below.
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// `x` to the power `y`; 1 where `y` is 0, whatever `x` is, and NaN where a negative `x` is raised to a power
/// that is not a whole number.
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// The cube root of `x`.
pub fn cbrt(x: f64) -> f64 {
    libm::cbrt(x)
}

/// The sine of `x` radians; NaN where `x` is infinite.
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// The cosine of `x` radians; NaN where `x` is infinite.
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// The tangent of `x` radians; NaN where `x` is infinite.
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;

    #[test]
    fn angles_lie_where_they_are_promised() {
        assert_eq!([1.0, 0.0, -1.0].map(acos), [0.0, FRAC_PI_2, PI]);
        assert!(acos(1.5).is_nan() && acos(-1.5).is_nan());
        // y first
        assert_eq!(atan2(1.0, 0.0), FRAC_PI_2);
        assert_eq!(atan2(-1.0, 0.0), -FRAC_PI_2);
        assert_eq!((atan2(0.0, -1.0), atan2(-0.0, -1.0)), (PI, -PI));
        assert_eq!(atan2(0.0, 0.0), 0.0);
    }

    #[test]
    fn cube_roots_by_hand() {
        assert_eq!((cbrt(27.0), cbrt(-0.125)), (3.0, -0.5));
    }

    #[test]
    fn powers_at_their_borders() {
        assert_eq!((pow(2.0, 10.0), pow(4.0, -0.5)), (1024.0, 0.5));
        assert_eq!((pow(0.0, 0.0), pow(f64::NAN, 0.0), pow(0.0, 3.0)), (1.0, 1.0, 0.0));
        assert!(pow(-2.0, 0.5).is_nan());
    }
}

//! Functions whose last bit differs between platforms, from one portable implementation.

/// The angle whose tangent is `x`, in radians, between −π/2 and π/2.
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// e to the power `x`.
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// The natural logarithm of `x`; NaN below zero.
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// The sine of `x` radians.
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// The cosine of `x` radians.
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// The tangent of `x` radians.
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

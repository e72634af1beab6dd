//! Functions whose last bit differs between platforms, from one portable implementation.

/// The angle whose tangent is `x`, in radians, between −π/2 and π/2.
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

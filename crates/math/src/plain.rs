//! Vectors of plain `f64`, three numbers each: what a robust method tries first, whatever the precision of the
//! ray.

/// a − b
#[inline(always)]
pub fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

/// a × b
#[inline(always)]
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a · b
#[inline(always)]
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// |x| + |y| + |z|: not below the length, and without a root.
#[inline(always)]
pub fn size(v: [f64; 3]) -> f64 {
    v[0].abs() + v[1].abs() + v[2].abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: (1, 2, 3) and (4, −5, 6).
    #[test]
    fn by_hand() {
        let (a, b) = ([1.0, 2.0, 3.0], [4.0, -5.0, 6.0]);
        assert_eq!(difference(a, b), [-3.0, 7.0, -3.0]);
        assert_eq!(cross(a, b), [27.0, 6.0, -13.0]);
        assert_eq!((dot(a, b), size(b)), (12.0, 15.0));
    }
}

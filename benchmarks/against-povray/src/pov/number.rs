//! Numbers as POV-Ray reads them.

/// A number that reads back to the same value: its digits, with an exponent where there would be many zeros.
pub(super) fn number(x: f64) -> String {
    // as many digits as an f64 holds; past them only zeros would be written
    const DIGITS: i32 = f64::DIGITS as i32;
    let magnitude = x.abs().log10();
    if x == 0.0 {
        "0".to_string()
    } else if magnitude.abs() < f64::from(DIGITS) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

/// `<x,y,z>`
pub(super) fn vector(v: [f64; 3]) -> String {
    let [x, y, z] = v.map(number);
    format!("<{x},{y},{z}>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back() {
        for x in [0.1, 1.0 / 3.0, 1e-7, 123456789.125, 1e20, 5e-324, f64::MAX, 1e-300] {
            assert_eq!(number(x).parse(), Ok(x));
            assert_eq!(number(-x).parse(), Ok(-x));
        }
        assert_eq!(vector([-0.0, 1.0, 1e20]), "<0,1,1e20>");
        assert_eq!(number(1e-7), "0.0000001");
    }
}

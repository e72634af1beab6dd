//! Where a number lies on an axis, and which numbers are written beside it.

use math::portable;

/// A logarithmic axis. It plots log₁₀ on a linear scale, so it reaches as far down as `f64` does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LogAxis {
    /// log₁₀ of the numbers at its two ends, the first smaller.
    pub(super) ends: (f64, f64),
    /// Where the two ends lie in the picture.
    pub(super) places: (f64, f64),
}

/// A linear axis from 0 or elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LinearAxis {
    /// The numbers at its two ends, the first smaller.
    pub(super) ends: (f64, f64),
    /// Where the two ends lie in the picture.
    pub(super) places: (f64, f64),
}

impl LogAxis {
    /// The place of a number. Zero, what is below zero and what is beyond the ends lie at the ends.
    pub(super) fn at(&self, number: f64) -> f64 {
        self.at_exponent(log10(number.max(0.0)))
    }

    /// The place of 10 to this power.
    pub(super) fn at_exponent(&self, exponent: f64) -> f64 {
        between(self.ends, self.places, exponent)
    }
}

impl LinearAxis {
    /// The place of a number; what is beyond the ends lies at the ends.
    pub(super) fn at(&self, number: f64) -> f64 {
        between(self.ends, self.places, number)
    }
}

fn between((low, high): (f64, f64), (from, to): (f64, f64), x: f64) -> f64 {
    let share = (x.clamp(low, high) - low) / (high - low);
    from + share * (to - from)
}

/// log₁₀ from the portable logarithm; −∞ at 0.
pub(super) fn log10(x: f64) -> f64 {
    portable::ln(x) / std::f64::consts::LN_10
}

/// The decade that a positive number is in: the exponent of its decimal notation, which is exact where
/// a rounded logarithm falls on the wrong side of a power of ten.
pub(super) fn decade(x: f64) -> i32 {
    format!("{x:e}").rsplit('e').next().and_then(|exponent| exponent.parse().ok()).unwrap_or(0)
}

/// The nearest numbers 1, 2 or 5 times a power of ten around the positive numbers from `low` to `high`:
/// the last one at or below, and the first one above.
pub(super) fn around(low: f64, high: f64) -> (f64, f64) {
    let below = steps(low).into_iter().rfind(|&step| step <= low);
    let above = steps(high).into_iter().find(|&step| step > high && step.is_finite());
    (below.unwrap_or(f64::MIN_POSITIVE), above.unwrap_or(f64::MAX))
}

/// The first number 1, 2 or 5 times a power of ten that is at least the positive number `x`.
pub(super) fn at_least(x: f64) -> f64 {
    steps(x).into_iter().find(|&step| step >= x && step.is_finite()).unwrap_or(f64::MAX)
}

fn steps(x: f64) -> [f64; 4] {
    [(1, 0), (2, 0), (5, 0), (1, 1)].map(|(digit, up)| decimal(digit, decade(x) + up))
}

/// digit × 10^exponent, correctly rounded.
pub(super) fn decimal(digit: u32, exponent: i32) -> f64 {
    format!("{digit}e{exponent}").parse().unwrap_or(f64::NAN)
}

/// About `count` round numbers from 0 or the first one above `low` up to `high`: steps of 1, 2 or 5
/// times a power of ten.
pub(super) fn round_numbers(low: f64, high: f64, count: u32) -> Vec<f64> {
    let raw = (high - low) / f64::from(count);
    if !(raw.is_finite() && raw > 0.0) {
        return vec![low];
    }
    let (_, step) = around(raw / 2.0, raw * 0.999);
    let first = (low / step).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    (first..=last.min(first + 100)).map(|i| i as f64 * step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mark_lies_where_the_closed_form_says() {
        let axis = LogAxis { ends: (-31.0, 0.0), places: (1000.0, 10.0) };
        for exponent in -31..=0 {
            for digit in [1, 2, 5] {
                let log = f64::from(exponent) + f64::from(digit).log10();
                let want = 10.0 + 990.0 * -log / 31.0;
                let got = axis.at(decimal(digit, exponent));
                assert!(
                    (got - want.clamp(10.0, 1000.0)).abs() < 1e-6,
                    "{digit}e{exponent}: {got} and not {want}"
                );
            }
        }
        assert_eq!(
            [0.0, -1.0, 1e-40, 5.0, f64::INFINITY].map(|x| axis.at(x)),
            [1000.0, 1000.0, 1000.0, 10.0, 10.0]
        );
    }

    #[test]
    fn a_decade_is_exact() {
        for exponent in -323..=308 {
            assert_eq!(decade(decimal(1, exponent)), exponent);
        }
        assert_eq!(decade(0.999_999_999_999_999_9), -1);
        assert_eq!(decade(f64::MAX), 308);
    }

    #[test]
    fn round_numbers_lie_around() {
        assert_eq!(around(4.3, 17.0), (2.0, 20.0));
        assert_eq!(around(0.9, 50.0), (0.5, 100.0));
        assert_eq!(around(1.0, 1.0), (1.0, 2.0));
        assert_eq!(around(5e-324, f64::MAX), (5e-324, f64::MAX));
        assert_eq!([4.3, 5.0, 5.1, 60.0].map(at_least), [5.0, 5.0, 10.0, 100.0]);
        assert_eq!([1e308, f64::MAX, f64::INFINITY].map(at_least), [1e308, f64::MAX, f64::MAX]);
        assert_eq!(round_numbers(0.0, 100.0, 10), [0., 10., 20., 30., 40., 50., 60., 70., 80., 90., 100.]);
        assert_eq!(round_numbers(0.0, 13.0, 6), [0.0, 5.0, 10.0]);
        assert_eq!(round_numbers(3.0, 3.0, 6), [3.0]);
    }
}

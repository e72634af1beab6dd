//! What plain `f64` can say of a ray and a shape at a glance: whether it is met, surely, and roughly where.
//!
//! A ray is tried on many shapes and lands on one. Of all others nothing is needed but that they are not met,
//! or that another one is nearer; and a ray to a light needs to know of one only that it is met at all. So λ
//! with all its digits is for the shape that a ray lands on.

use crate::{Real, Span};

/// What a glance says. All of it is certain, or it says so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Glance {
    /// The line of the ray passes by; or all that it would meet is behind the origin.
    Misses,
    /// It crosses something flat.
    Once(Around),
    /// The first of its crossings ahead; of those beyond nothing is said.
    First(Around),
    /// It crosses something round, into it and out of it.
    Twice(Around, Around),
    /// Too close to call, or no question for plain `f64`.
    Unsure,
}

/// λ, in lengths of the ray's direction, and how far it may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Around {
    /// As computed.
    pub t: f64,
    /// The true one is not farther away than this.
    pub off: f64,
}

/// The first crossing in a span, as far as a glance goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum First {
    /// There is none.
    None,
    /// λ is between these two.
    Between(f64, f64),
    /// It may be in the span or not.
    Unsure,
}

/// How far a method's λ may be off, in units of its last digit. The robust ones are within 9, by their own
/// bounds; the next power of two is taken. What is left of a glance when the exact method has rounded λ, and
/// what boxes are searched by.
pub const ULPS: f64 = 16.0;

impl Around {
    /// The range in which λ is, from its low end to its high one, as a method rounds it to R.
    #[inline(always)]
    pub fn range<R: Real>(self) -> (f64, f64) {
        let digit = 2.0 / (1u64 << R::DIGITS) as f64;
        let off = self.off + ULPS * digit * (self.t.abs() + self.off) + ULPS * Into::<f64>::into(R::SMALLEST);
        (self.t - off, self.t + off)
    }
}

impl Glance {
    /// The same for a ray that is known to start within: where its line enters is behind it.
    #[inline(always)]
    pub fn from_within(self) -> Glance {
        match self {
            Glance::Twice(_, far) => Glance::Once(far),
            other => other,
        }
    }

    /// The first crossing at λ ≥ span.min that is not beyond span.max.
    #[inline(always)]
    pub fn first_within<R: Real>(self, span: Span<R>) -> First {
        let (min, max): (f64, f64) = (span.min.into(), span.max.into());
        let one = |crossing: Around| {
            let (low, high) = crossing.range::<R>();
            match () {
                _ if low > max || high < min => First::None,
                // beyond the largest number every λ is infinite, and none is nearer than another
                _ if low >= min && high <= max && R::round_from(high).is_finite() => {
                    First::Between(low, high)
                }
                _ => First::Unsure,
            }
        };
        match self {
            Glance::Misses => First::None,
            Glance::Once(crossing) => one(crossing),
            Glance::First(crossing) => match crossing.range::<R>() {
                (low, _) if low < min => First::Unsure,
                _ => one(crossing),
            },
            Glance::Twice(near, far) => match near.range::<R>() {
                (_, high) if high < min => one(far),
                _ => one(near),
            },
            Glance::Unsure => First::Unsure,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: near 1, far 3, each off by ¼.
    #[test]
    fn a_span_takes_the_near_one_the_far_one_or_neither() {
        let around = |t| Around { t, off: 0.25 };
        let first = |min, max| Glance::Twice(around(1.0), around(3.0)).first_within(Span::new(min, max));
        let between = |t: f64| {
            move |it: First| {
                matches!(it, First::Between(low, high) if (low - (t - 0.25)).abs() < 1e-12
            && (high - (t + 0.25)).abs() < 1e-12)
            }
        };
        assert!(between(1.0)(first(0.0, 9.0)));
        assert!(between(3.0)(first(2.0, 9.0)));
        assert_eq!(first(4.0, 9.0), First::None);
        assert_eq!(first(0.0, 0.5), First::None);
        assert_eq!(first(2.0, 2.5), First::None, "between the two");
        for (min, max) in [(1.1, 9.0), (0.0, 1.1), (3.1, 9.0), (2.0, 3.1)] {
            assert_eq!(first(min, max), First::Unsure, "{min} {max}");
        }
        assert_eq!(Glance::Misses.first_within(Span::<f64>::ahead()), First::None);
        let ahead = Glance::First(around(1.0));
        assert_eq!(ahead.first_within(Span::new(2.0, 9.0)), First::Unsure, "there may be more");
        assert_eq!(ahead.first_within(Span::new(0.0, 0.5)), First::None);
        assert!(between(1.0)(ahead.first_within(Span::new(0.0, 9.0))));
        assert_eq!(Glance::Once(around(0.1)).first_within(Span::<f64>::ahead()), First::Unsure);
    }

    /// 1e39 is a number in f64, and in f32 infinite, as 2e39 is: which of the two is nearer it does not tell.
    #[test]
    fn what_is_infinite_is_not_compared() {
        let far = Glance::Once(Around { t: 1e39, off: 0.0 });
        assert!(matches!(far.first_within(Span::<f64>::ahead()), First::Between(..)));
        assert_eq!(far.first_within(Span::<f32>::ahead()), First::Unsure);
        assert_eq!(far.first_within(Span::<f32>::new(0.0, 1e38)), First::None);
    }
}

//! A range of t.

use crate::Real;

/// The range of t in which a hit counts: every intersector takes one.
///
/// Gambetta passes it as `t_min, t_max` (Listing 2-4); House writes t ≥ 0 beside Eq. 4.1. Both ends
/// belong to it. A span with `min > max` contains nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span<R> {
    /// The smallest t that counts: t_min.
    pub min: R,
    /// The largest t that counts: t_max.
    pub max: R,
}

impl<R: Real> Span<R> {
    /// The span [min, max].
    pub fn new(min: R, max: R) -> Self {
        Span { min, max }
    }

    /// Everything in front of the origin, [0, ∞]: House's t ≥ 0.
    pub fn ahead() -> Self {
        Span::new(R::from(0.0), R::INFINITY)
    }

    /// From the view plane on, [1, ∞], for a ray whose direction leads from the eye to that plane.
    ///
    /// Gambetta's text says t > 1, his Listing 2-4 admits t = 1; this follows the listing.
    pub fn from_view_plane() -> Self {
        Span::new(R::from(1.0), R::INFINITY)
    }

    /// min ≤ t ≤ max. False for NaN.
    pub fn contains(&self, t: R) -> bool {
        self.min <= t && t <= self.max
    }

    /// min < t < max. False for NaN.
    pub fn surrounds(&self, t: R) -> bool {
        self.min < t && t < self.max
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_belong_to_contains_and_not_to_surrounds() {
        let span = Span::new(1.0, 2.0);
        for (t, contained, surrounded) in [
            (0.5, false, false),
            (1.0, true, false),
            (1.5, true, true),
            (2.0, true, false),
            (f64::NAN, false, false),
        ] {
            assert_eq!((span.contains(t), span.surrounds(t)), (contained, surrounded), "t = {t}");
        }
    }

    #[test]
    fn infinity_is_ahead() {
        assert!(Span::ahead().contains(f64::INFINITY));
        assert!(!Span::ahead().surrounds(f64::INFINITY));
    }
}

//! Where a line enters and leaves a convex body.

use crate::{Real, Span};

/// The two values of t at which a line crosses the surface of a wall, a sphere or a solid:
/// `near` ≤ `far`, equal where it only touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roots<R> {
    /// Where the line enters.
    pub near: R,
    /// Where it leaves.
    pub far: R,
}

impl<R: Real> Roots<R> {
    /// The two roots in order, whichever way they come.
    pub fn sorted(a: R, b: R) -> Self {
        if b < a { Roots { near: b, far: a } } else { Roots { near: a, far: b } }
    }

    /// The smallest root that lies in `span`: the nearest hit. `None` where neither does, as for a
    /// body entirely behind the origin.
    ///
    /// A ray that starts inside has near < 0, so what it hits is the way out. Minus zero is returned
    /// as zero.
    pub fn first_within(&self, span: Span<R>) -> Option<R> {
        let positive_zero = R::from(0.0);
        [self.near, self.far].into_iter().find(|&t| span.contains(t)).map(|t| t + positive_zero)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_root_ahead_is_the_hit() {
        let ahead = Span::ahead();
        let roots = |near, far| Roots { near, far };
        assert_eq!(roots(1.0, 3.0).first_within(ahead), Some(1.0));
        assert_eq!(roots(-1.0, 3.0).first_within(ahead), Some(3.0), "inside: the way out");
        assert_eq!(roots(-3.0, -1.0).first_within(ahead), None, "behind");
        assert_eq!(
            roots(-3.0, -0.0).first_within(ahead).map(f64::to_bits),
            Some(0.0_f64.to_bits()),
            "touching"
        );
        assert_eq!(roots(f64::NAN, f64::NAN).first_within(ahead), None);
    }
}

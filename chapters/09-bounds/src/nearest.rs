//! The nearest hit so far.

use math::{Real, Span};

use crate::slab::Reach;

/// The nearest hit so far. It does not depend on the order in which the hits come, for of two at the same t
/// the earlier object wins: so every search agrees with going through all objects one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Nearest<R> {
    /// Where a hit is still of interest: no farther than the nearest one.
    pub span: Span<R>,
    /// The same for boxes.
    pub reach: Reach,
    /// Which object, if there is one.
    pub index: Option<usize>,
}

impl<R: Real> Nearest<R> {
    /// No hit yet.
    #[inline(always)]
    pub fn new(span: Span<R>) -> Nearest<R> {
        Nearest { span, reach: Reach::of(span), index: None }
    }

    /// One more hit. What lies outside of the span is none.
    #[inline(always)]
    pub fn put(&mut self, index: usize, t: R) {
        let wins_tie = self.index.is_none_or(|nearest| index < nearest);
        if self.span.contains(t) && (t < self.span.max || wins_tie) {
            self.span.max = t;
            self.reach.max = Reach::of(self.span).max;
            self.index = Some(index);
        }
    }

    /// Which object, and its t; `None` where there is no hit yet.
    #[inline(always)]
    pub fn hit(&self) -> Option<(usize, R)> {
        self.index.map(|index| (index, self.span.max))
    }
}
